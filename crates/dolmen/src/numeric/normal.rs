//! The normal distribution: probability, logarithm of the probability, and quantile.

use super::NumericError;
use std::f64::consts::{FRAC_1_SQRT_2, LN_2, PI};

/// z below which the error function approaches underflow, and the asymptotic series is exact to rounding.
const FAR: f64 = -20.0;

/// Φ(z), the probability that a standard normal variable is below z.
pub fn normal_probability(z: f64) -> f64 {
    0.5 * libm::erfc(-z * FRAC_1_SQRT_2)
}

/// ln Φ(z), also where Φ(z) underflows.
pub fn ln_normal_probability(z: f64) -> f64 {
    if z > 5.0 {
        return (-normal_probability(-z)).ln_1p();
    }
    if z > FAR {
        return normal_probability(z).ln();
    }
    // Φ(z) = φ(z)/|z| (1 − 1/z² + 3/z⁴ − 15/z⁶ + …): at |z| = 20 the eighth term is 2e-15
    let w = 1.0 / (z * z);
    let series = (1..=8)
        .rev()
        .fold(1.0, |sum, k| 1.0 - f64::from(2 * k - 1) * w * sum);
    ln_normal_density(z) - (-z).ln() + series.ln()
}

/// ln φ(z), the logarithm of the normal density.
pub(crate) fn ln_normal_density(z: f64) -> f64 {
    -0.5 * (z * z + LN_2 + PI.ln())
}

/// φ(z)/Φ(z), the derivative of ln Φ.
pub(crate) fn normal_hazard(z: f64) -> f64 {
    (ln_normal_density(z) - ln_normal_probability(z)).exp()
}

/// The quantile z of the standard normal distribution.
///
/// # Errors
/// [`NumericError::Range`] unless 0 < probability < 1.
///
/// # Example
/// ```
/// use dolmen::numeric::normal_quantile;
/// assert!((normal_quantile(0.975)? - 1.959963984540054).abs() < 1e-14);
/// # Ok::<(), dolmen::numeric::NumericError>(())
/// ```
pub fn normal_quantile(probability: f64) -> Result<f64, NumericError> {
    if !(probability > 0.0 && probability < 1.0) {
        return Err(NumericError::Range {
            quantity: "probability",
            given: probability,
            allowed: "between 0 and 1, both excluded",
        });
    }
    if probability > 0.5 {
        return Ok(-lower_quantile((-probability).ln_1p()));
    }
    Ok(lower_quantile(probability.ln()))
}

/// Solves ln Φ(z) = `ln_probability` for values ≤ ln ½ by Newton's method. ln Φ is concave, so after the first step the iterates increase to the
/// root.
fn lower_quantile(ln_probability: f64) -> f64 {
    const STEPS_MOST: usize = 60;
    let mut z = -(-2.0 * ln_probability).sqrt();
    for _ in 0..STEPS_MOST {
        let step = (ln_probability - ln_normal_probability(z)) / normal_hazard(z);
        z += step;
        if step.abs() <= 1e-15 * z.abs().max(1e-3) {
            break;
        }
    }
    z
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_probabilities_and_quantiles() {
        // Abramowitz & Stegun, tables 26.1 and 26.2; ln Φ in the tail: mpmath with 40 digits
        assert!((normal_probability(1.0) - 0.841_344_746_068_543).abs() < 1e-15);
        assert!((normal_probability(-3.0) / 1.349_898_031_630_095e-3 - 1.0).abs() < 1e-14);
        for (z, ln) in [
            (-10.0, -53.231_285_150_512_47),
            (-19.9, -201.917_167_707_332_63),
            (-20.1, -205.927_118_401_948_2),
            (-50.0, -1_254.831_361_139_419_9),
            (3.0, -1.350_809_964_748_193_8e-3),
            (9.0, -1.128_588_405_953_840_6e-19),
        ] {
            let off = (ln_normal_probability(z) / ln - 1.0).abs();
            assert!(off < 1e-13, "{z}: {off:e} {:.17}", ln_normal_probability(z));
        }
        for (p, z) in [
            (0.5, 0.0),
            (0.05, -1.644_853_626_951_472_7),
            (0.999, 3.090_232_306_167_813_5),
            (1e-10, -6.361_340_902_404_056),
        ] {
            let found = normal_quantile(p).unwrap();
            assert!((found - z).abs() < 1e-13, "{p}: {found:.17}");
        }
    }

    #[test]
    fn refuses_probabilities_that_have_no_quantile() {
        for bad in [0.0, 1.0, f64::NAN, -0.1] {
            assert!(normal_quantile(bad).is_err());
        }
    }
}
