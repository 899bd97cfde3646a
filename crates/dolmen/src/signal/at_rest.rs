//! Series that leave the ground at rest: velocity and displacement zero at the end.

use std::f64::consts::PI;

/// Window that reduces a series to zero at both ends: half a cosine over the first and last `ramp` samples.
pub(super) fn edges(i: usize, length: usize, ramp: usize) -> f64 {
    let from_end = i.min(length - 1 - i);
    if from_end >= ramp {
        return 1.0;
    }
    0.5 * (1.0 - (PI * from_end as f64 / ramp as f64).cos())
}

/// Subtracts a straight line times a window so that the sum of the samples and their first moment vanish. The ends are zero, so velocity and
/// displacement of the ground stay zero after the last sample.
///
/// ```text
/// a_i ← a_i − g_i (c_0 + c_1 x_i)      Σ a_i = 0, Σ x_i a_i = 0      x_i = i − centre
/// ```
pub(super) fn bring_to_rest(samples: &mut [f64], first: usize, centre: f64, window: impl Fn(usize) -> f64) {
    let (mut m0, mut m1, mut g0, mut g1, mut g2) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for (k, a) in samples.iter().enumerate() {
        let (x, g) = ((first + k) as f64 - centre, window(first + k));
        m0 += a;
        m1 += a * x;
        g0 += g;
        g1 += g * x;
        g2 += g * x * x;
    }
    let determinant = g0 * g2 - g1 * g1;
    if determinant <= 0.0 || !determinant.is_finite() {
        return; // fewer than two samples within the window: nothing to subtract
    }
    let (c0, c1) = (
        (m0 * g2 - m1 * g1) / determinant,
        (m1 * g0 - m0 * g1) / determinant,
    );
    for (k, a) in samples.iter_mut().enumerate() {
        let x = (first + k) as f64 - centre;
        *a -= window(first + k) * (c0 + c1 * x);
    }
}
