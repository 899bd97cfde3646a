//! Fisher's F distribution: the ratio of two mean squares.

use super::error::NumericError;
use super::roots::{Bracketing, bracketed_root};
use super::statistics::beta_probability;

/// The value that F with degrees of freedom `above` and `below` exceeds with a probability.
///
/// ```text
/// P(F > x) = I_y(m/2, p/2),   y = m/(m + p x)
/// ```
///
/// # Errors
/// [`NumericError::Range`] unless 0 < probability < 1 and both degrees of freedom are above 0.
///
/// # Source
/// DLMF 8.17; Abramowitz & Stegun 26.6.2.
///
/// # Example
/// ```
/// use dolmen::numeric::fisher_quantile;
/// assert!((fisher_quantile(0.05, 3.0, 10.0)? - 3.708264820).abs() < 1e-7); // tables: 3.71
/// # Ok::<(), dolmen::numeric::NumericError>(())
/// ```
pub fn fisher_quantile(probability: f64, above: f64, below: f64) -> Result<f64, NumericError> {
    let refused = |quantity, given, allowed| {
        Err(NumericError::Range {
            quantity,
            given,
            allowed,
        })
    };
    if !(probability > 0.0 && probability < 1.0) {
        return refused("probability", probability, "above 0 and below 1");
    }
    for degrees in [above, below] {
        if !(degrees > 0.0 && degrees.is_finite()) {
            return refused("degrees of freedom", degrees, "above 0 and finite");
        }
    }
    // I_y increases with y from 0 to 1
    let excess = |y: f64| beta_probability(y, 0.5 * below, 0.5 * above) - probability;
    let y = bracketed_root(excess, 0.0, 1.0, &Bracketing::default())?;
    Ok(below * (1.0 - y) / (above * y.max(f64::MIN_POSITIVE)))
}
