//! Likelihood of a lognormal curve with its derivatives.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | z = a x − c | `[slope, offset]` | probit; x = ln IM minus its midpoint, a = 1/β, c = ln θ/β |
//! | n, k | `motions`, `reached` | motions at an intensity, and how many reached the state |

use super::observation::Observation;
use crate::numeric::{ln_normal_density, ln_normal_probability, normal_hazard};

/// The log-likelihood with its gradient and its Hessian (aa, ac, cc).
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Likelihood {
    pub(super) value: f64,
    pub(super) gradient: [f64; 2],
    pub(super) curvature: [f64; 3],
}

impl Likelihood {
    /// Adds a function of z = a x − c with its first and second derivative.
    fn add(&mut self, x: f64, [value, slope, curve]: [f64; 3]) {
        self.value += value;
        self.gradient[0] += slope * x;
        self.gradient[1] -= slope;
        self.curvature[0] += curve * x * x;
        self.curvature[1] -= curve * x;
        self.curvature[2] += curve;
    }

    /// Inverse of the negative Hessian at the maximum.
    pub(super) fn covariance(&self) -> [f64; 3] {
        let [aa, ac, cc] = self.curvature;
        let determinant = aa * cc - ac * ac;
        [-cc / determinant, ac / determinant, -aa / determinant]
    }

    pub(super) fn newton(&self) -> [f64; 2] {
        let [aa, ac, cc] = self.covariance();
        let [a, c] = self.gradient;
        [aa * a + ac * c, ac * a + cc * c]
    }
}

/// Likelihood of observations for a slope and an offset; the logarithms of intensities are relative to
/// `middle`.
pub(super) fn likelihood(observations: &[Observation], middle: f64, [slope, offset]: [f64; 2]) -> Likelihood {
    let mut sum = Likelihood::default();
    let place = |intensity: f64| {
        let x = intensity.ln() - middle;
        (x, slope * x - offset)
    };
    for observation in observations {
        match *observation {
            Observation::Stripe {
                intensity,
                motions,
                reached,
            } => {
                let (x, z) = place(intensity);
                sum.add(x, below(z).map(|part| reached as f64 * part));
                sum.add(x, above(z).map(|part| (motions - reached) as f64 * part));
            }
            Observation::Above(intensity) => {
                let (x, z) = place(intensity);
                sum.add(x, above(z));
            }
            Observation::Below(intensity) => {
                let (x, z) = place(intensity);
                sum.add(x, below(z));
            }
            Observation::Between(low, high) if low < high => between(&mut sum, place(low), place(high)),
            // ln φ(z) + ln a
            Observation::At(intensity) | Observation::Between(intensity, _) => {
                let (x, z) = place(intensity);
                sum.add(x, [ln_normal_density(z), -z, -1.0]);
                sum.value += slope.ln();
                sum.gradient[0] += 1.0 / slope;
                sum.curvature[0] -= 1.0 / (slope * slope);
            }
        }
    }
    if sum.value.is_nan() {
        sum.value = f64::NEG_INFINITY; // the density needs a positive slope
    }
    sum
}

/// ln Φ(z) with its derivatives: m, −m (z + m), m = φ/Φ.
fn below(z: f64) -> [f64; 3] {
    let m = normal_hazard(z);
    [ln_normal_probability(z), m, -m * (z + m)]
}

/// ln Φ(−z) with its derivatives by z.
fn above(z: f64) -> [f64; 3] {
    let [value, slope, curve] = below(-z);
    [value, -slope, curve]
}

/// ln(Φ(z_high) − Φ(z_low)), where both arguments depend on the parameters.
fn between(sum: &mut Likelihood, (x_low, z_low): (f64, f64), (x_high, z_high): (f64, f64)) {
    // on the side where both tails are small, so that the difference keeps its precision
    let (outer, inner) = if z_low > 0.0 {
        (-z_low, -z_high)
    } else {
        (z_high, z_low)
    };
    let (ln_outer, ln_inner) = (ln_normal_probability(outer), ln_normal_probability(inner));
    let value = ln_outer + (-(ln_inner - ln_outer).exp()).ln_1p();
    let (r_low, r_high) = (
        (ln_normal_density(z_low) - value).exp(),
        (ln_normal_density(z_high) - value).exp(),
    );
    // first derivatives with respect to (a, c), then second derivatives
    let first = [r_high * x_high - r_low * x_low, r_low - r_high];
    let second = [
        -r_high * z_high * x_high * x_high + r_low * z_low * x_low * x_low,
        r_high * z_high * x_high - r_low * z_low * x_low,
        -r_high * z_high + r_low * z_low,
    ];
    sum.value += value;
    sum.gradient[0] += first[0];
    sum.gradient[1] += first[1];
    sum.curvature[0] += second[0] - first[0] * first[0];
    sum.curvature[1] += second[1] - first[0] * first[1];
    sum.curvature[2] += second[2] - first[1] * first[1];
}
