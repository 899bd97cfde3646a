//! Which sensors measure a direction at a level, and the real part of a shape.

use dolmen_linalg::Complex64;

/// A sensor within 15° (cosine) of the direction measures it. Our choice: the error of the cosine is 3 %.
pub(super) const ALONG_LEAST: f64 = 0.966;
/// Heights closer than this, m, are one level. Our choice: less than any storey or stone.
pub(super) const LEVEL_M: f64 = 0.05;

/// Common phase rotation that makes the components as real as possible.
pub(super) fn real_turn(shape: &[Complex64]) -> Complex64 {
    Complex64::from_polar(1.0, -0.5 * shape.iter().map(|z| z * z).sum::<Complex64>().arg())
}

/// Components after this rotation, real parts.
pub(super) fn real_shape(shape: &[Complex64]) -> Vec<f64> {
    let turn = real_turn(shape);
    shape.iter().map(|z| (z * turn).re).collect()
}
