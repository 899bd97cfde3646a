//! Sufficiency of an intensity measure: whether the residuals of capacities also depend on another property of the earthquake.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | ε_i | `residuals` | ln of the capacity of motion i by the measure, minus the mean of all | – |
//! | x_i | `predictor` | property of motion i: magnitude, ln of the distance or ln of the duration | |
//! | c | `slope` | slope of the line ε = a + c x | – per unit of x |

use crate::assess::AssessError;
use crate::numeric::student_two_sided;

/// Fewest motions for a slope. Our choice: with fewer, a single motion determines the slope.
pub const SUFFICIENCY_MOTIONS_LEAST: usize = 10;

/// Least-squares line through residuals of capacities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sufficiency {
    /// c, change of ln of the capacity per unit of the predictor.
    pub slope: f64,
    /// Standard error of the slope, s_c.
    pub slope_error: f64,
    /// Probability of a slope at least this steep by chance, if the true slope is zero, –. A small value speaks against the measure.
    pub p_value: f64,
    /// Number of motions.
    pub motions: usize,
}

/// Least-squares line of residuals over a predictor, with one value of each per motion.
///
/// ```text
/// c = Σ (x_i − x̄)(ε_i − ε̄) / Σ (x_i − x̄)²     s² = Σ (ε_i − ε̄ − c (x_i − x̄))² / (n − 2)     s_c² = s² / Σ (x_i − x̄)²
/// p = P(|t| ≥ |c| / s_c),   t of Student with n − 2 degrees of freedom
/// ```
///
/// # Errors
/// [`AssessError::TooFewForSufficiency`] below [`SUFFICIENCY_MOTIONS_LEAST`] motions; [`AssessError::SameForEveryMotion`] if the predictor does not
/// vary, or if a value is not finite.
///
/// # Limits
/// A large p does not prove a measure sufficient: with few motions a slope remains hidden. The motions are assumed independent.
///
/// # Source
/// Luco, N. and Cornell, C. A. (2007) Structure-specific scalar intensity measures for near-source and ordinary earthquake ground motions. Earthq.
/// Spectra 23(2):357–392, their test of sufficiency. Differs from the source: the residuals are those of capacities by the measure, because
/// incremental scans give capacities; the source takes residuals of the demand at a given shaking.
///
/// # Example
/// ```
/// use dolmen::assess::sufficiency;
/// let magnitude: Vec<f64> = (0..12).map(|i| 5.5 + 0.15 * f64::from(i)).collect();
/// let residuals: Vec<f64> = magnitude.iter().enumerate().map(|(i, m)| 0.2 * m + [0.05, -0.05, -0.05, 0.05][i % 4]).collect();
/// let found = sufficiency(&residuals, &magnitude)?;
/// assert!((found.slope - 0.2).abs() < 1e-12 && found.p_value < 1e-4);
/// # Ok::<(), dolmen::assess::AssessError>(())
/// ```
pub fn sufficiency(residuals: &[f64], predictor: &[f64]) -> Result<Sufficiency, AssessError> {
    let motions = residuals.len();
    if motions < SUFFICIENCY_MOTIONS_LEAST || predictor.len() != motions {
        return Err(AssessError::TooFewForSufficiency {
            given: motions.min(predictor.len()),
            least: SUFFICIENCY_MOTIONS_LEAST,
        });
    }
    let n = motions as f64;
    let mean = |values: &[f64]| values.iter().sum::<f64>() / n;
    let (mean_x, mean_e) = (mean(predictor), mean(residuals));
    let (mut s_xx, mut s_xe) = (0.0, 0.0);
    for (x, e) in predictor.iter().zip(residuals) {
        s_xx += (x - mean_x).powi(2);
        s_xe += (x - mean_x) * (e - mean_e);
    }
    let spread = predictor.iter().fold(0.0, |most, x| f64::max(most, x.abs()));
    // the comparison is false for NaN
    if !(s_xx > n * (f64::EPSILON * spread).powi(2) && s_xx.is_finite() && s_xe.is_finite()) {
        return Err(AssessError::SameForEveryMotion { value: mean_x });
    }
    let slope = s_xe / s_xx;
    let each = predictor.iter().zip(residuals);
    let left: f64 = each
        .map(|(x, e)| (e - mean_e - slope * (x - mean_x)).powi(2))
        .sum();
    let slope_error = (left / (n - 2.0) / s_xx).sqrt();
    let p_value = match slope == 0.0 {
        true => 1.0,
        false => student_two_sided(slope / slope_error, n - 2.0)?,
    };
    Ok(Sufficiency {
        slope,
        slope_error,
        p_value,
        motions,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_few_motions_and_a_predictor_that_does_not_vary() {
        let message = |n: usize, x: f64| {
            let predictor: Vec<f64> = (0..n).map(|i| 6.0 + x * i as f64).collect();
            let residuals: Vec<f64> = (0..n).map(|i| 0.1 * (i % 3) as f64).collect();
            sufficiency(&residuals, &predictor).unwrap_err().to_string()
        };
        assert!(
            message(9, 0.1).starts_with("9 motions are too few to tell"),
            "{}",
            message(9, 0.1)
        );
        assert!(
            message(12, 0.0).contains("6 for every motion"),
            "{}",
            message(12, 0.0)
        );
        assert!(message(12, f64::NAN).contains("NaN for every motion"));
    }

    #[test]
    fn exact_a_line_without_scatter_has_its_slope_and_no_chance() {
        let x: Vec<f64> = (0..10).map(f64::from).collect();
        let e: Vec<f64> = x.iter().map(|x| 1.0 - 0.5 * x).collect();
        let found = sufficiency(&e, &x).unwrap();
        assert!(
            (found.slope + 0.5).abs() < 1e-14 && found.p_value < 1e-60,
            "{found:?}"
        );
    }
}
