//! The χ² distribution of a whole number of degrees of freedom: do several numbers agree within their deviations?

use super::NumericError;
use std::f64::consts::PI;

/// P(χ² ≥ value) with so many degrees of freedom; 1 with none.
///
/// ```text
/// y = value/2;   ν even: e^-y Σ_{k<ν/2} y^k/k!      ν odd: erfc √y + e^-y Σ_{k<(ν-1)/2} y^(k+½)/Γ(k + 3/2)
/// ```
///
/// # Errors
/// [`NumericError::Range`] for a value below 0 or not a number.
///
/// # Source
/// Abramowitz & Stegun 26.4.4, 26.4.5.
///
/// # Example
/// ```
/// use dolmen::numeric::chi_squared_above;
/// assert!((chi_squared_above(5.991464547107979, 2)? - 0.05).abs() < 1e-14);
/// # Ok::<(), dolmen::numeric::NumericError>(())
/// ```
pub fn chi_squared_above(value: f64, degrees_of_freedom: usize) -> Result<f64, NumericError> {
    if value.is_nan() || value < 0.0 {
        return Err(NumericError::Range {
            quantity: "the sum of squares",
            given: value,
            allowed: "0 or more",
        });
    }
    if degrees_of_freedom == 0 || value == 0.0 {
        return Ok(1.0);
    }
    let y = 0.5 * value;
    let decay = (-y).exp();
    let odd = degrees_of_freedom % 2 == 1;
    let (mut sum, mut term, mut k) = if odd {
        (libm::erfc(y.sqrt()), 2.0 * decay * (y / PI).sqrt(), 0.5)
    } else {
        (0.0, decay, 0.0)
    };
    for _ in 0..degrees_of_freedom / 2 {
        sum += term;
        k += 1.0;
        term *= y / k;
    }
    Ok(sum.min(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_scipy() {
        // scipy 1.17.1: chi2.sf(value, nu)
        for (value, nu, p) in [
            (3.841458820694124, 1, 0.04999999999999989),
            (11.2, 1, 0.0008179733199943964),
            (7.3, 3, 0.06292623645904312),
            (20.0, 8, 0.010336050675925726),
            (40.0, 5, 1.493367900050393e-07),
        ] {
            let found = chi_squared_above(value, nu).unwrap();
            assert!((found / p - 1.0).abs() < 1e-12, "{value} {nu}: {found:e}");
        }
        assert_eq!(chi_squared_above(3.0, 0), Ok(1.0));
    }

    #[test]
    fn refuses_what_is_no_sum_of_squares() {
        let message = chi_squared_above(f64::NAN, 2).unwrap_err().to_string();
        assert_eq!(message, "the sum of squares is NaN, but must be 0 or more");
    }
}
