//! The χ² distribution, for testing whether several numbers agree within their standard deviations.

use super::{Bracketing, NumericError, bracketed_root};

/// Largest number of terms of the series and of the continued fraction, and the relative size at which they are truncated.
const TERMS_MOST: usize = 100_000;
const PART_LEAST: f64 = 1e-16;

/// P(χ² ≥ value) with this number of degrees of freedom, which need not be an integer; 1 for zero degrees of freedom.
///
/// ```text
/// Q(ν/2, value/2),   Q the upper regularised incomplete gamma function: by series (1 − P) below ν/2 + 1, by continued fraction above
/// ```
///
/// # Errors
/// [`NumericError::Range`] for a value or degrees of freedom below 0 or not a number; [`NumericError::Evaluations`] for more than 1e9
/// degrees of freedom.
///
/// # Source
/// DLMF 8.11.4, 8.9.2.
///
/// # Example
/// ```
/// use dolmen::numeric::chi_squared_above;
/// assert!((chi_squared_above(5.991464547107979, 2.0)? - 0.05).abs() < 1e-14);
/// # Ok::<(), dolmen::numeric::NumericError>(())
/// ```
pub fn chi_squared_above(value: f64, degrees_of_freedom: f64) -> Result<f64, NumericError> {
    for (quantity, given) in [
        ("the sum of squares", value),
        ("degrees_of_freedom", degrees_of_freedom),
    ] {
        if given.is_nan() || given < 0.0 {
            return Err(NumericError::Range {
                quantity,
                given,
                allowed: "0 or more",
            });
        }
    }
    if degrees_of_freedom == 0.0 || value == 0.0 {
        return Ok(1.0);
    }
    if value.is_infinite() {
        return Ok(0.0);
    }
    let (a, x) = (0.5 * degrees_of_freedom, 0.5 * value);
    // x^a e^-x / Γ(a)
    let front = (a * x.ln() - x - libm::lgamma(a)).exp();
    if x < a + 1.0 {
        let (mut term, mut sum) = (1.0 / a, 1.0 / a);
        for n in 1..TERMS_MOST {
            term *= x / (a + n as f64);
            sum += term;
            if term <= PART_LEAST * sum {
                return Ok((1.0 - front * sum).clamp(0.0, 1.0));
            }
        }
    } else {
        // modified Lentz
        let mut b = x + 1.0 - a;
        let (mut c, mut d) = (f64::MAX, 1.0 / b);
        let mut h = d;
        for n in 1..TERMS_MOST {
            let an = n as f64 * (a - n as f64);
            b += 2.0;
            d = 1.0 / (an * d + b);
            c = b + an / c;
            h *= c * d;
            if (c * d - 1.0).abs() <= 4.0 * PART_LEAST {
                return Ok((front * h).clamp(0.0, 1.0));
            }
        }
    }
    Err(NumericError::Evaluations { most: TERMS_MOST })
}

/// The quantile of χ² with this number of degrees of freedom.
///
/// # Errors
/// [`NumericError::Range`] unless 0 < probability < 1 and the degrees of freedom are above 0.
///
/// # Example
/// ```
/// use dolmen::numeric::chi_squared_quantile;
/// assert!((chi_squared_quantile(0.95, 2.0)? - 5.991464547107979).abs() < 1e-9);
/// # Ok::<(), dolmen::numeric::NumericError>(())
/// ```
pub fn chi_squared_quantile(probability: f64, degrees_of_freedom: f64) -> Result<f64, NumericError> {
    for (quantity, given, allowed, is_in) in [
        (
            "probability",
            probability,
            "between 0 and 1",
            probability > 0.0 && probability < 1.0,
        ),
        (
            "degrees_of_freedom",
            degrees_of_freedom,
            "above 0",
            degrees_of_freedom > 0.0 && degrees_of_freedom.is_finite(),
        ),
    ] {
        if !is_in {
            return Err(NumericError::Range {
                quantity,
                given,
                allowed,
            });
        }
    }
    let off = |value: f64| {
        chi_squared_above(value, degrees_of_freedom).map_or(f64::NAN, |above| 1.0 - above - probability)
    };
    let mut most = degrees_of_freedom.max(1.0);
    while off(most) < 0.0 {
        most *= 2.0;
    }
    bracketed_root(off, 0.0, most, &Bracketing::default())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_scipy() {
        // scipy 1.17.1: chi2.sf(value, nu)
        for (value, nu, p) in [
            (3.841458820694124, 1.0, 0.04999999999999989),
            (11.2, 1.0, 0.0008179733199943964),
            (7.3, 3.0, 0.06292623645904312),
            (20.0, 8.0, 0.010336050675925726),
            (40.0, 5.0, 1.493367900050393e-07),
        ] {
            let found = chi_squared_above(value, nu).unwrap();
            assert!((found / p - 1.0).abs() < 1e-12, "{value} {nu}: {found:e}");
        }
        assert_eq!(chi_squared_above(3.0, 0.0), Ok(1.0));
        // scipy 1.17.1: chi2.sf with fractional degrees of freedom, chi2.ppf
        for (value, nu, p) in [
            (0.4, 1.7, 0.7539579824924723),
            (9.0, 2.5, 0.01871895092743785),
            (30.0, 29.3, 0.42944769075888845),
        ] {
            let found = chi_squared_above(value, nu).unwrap();
            assert!((found / p - 1.0).abs() < 1e-11, "{value} {nu}: {found:e}");
        }
        assert_eq!(chi_squared_above(f64::INFINITY, 3.0), Ok(0.0));
        for (p, nu, value) in [
            (0.025, 4.3, 0.5812421572694526),
            (0.975, 1.2, 5.549546642432809),
            (0.5, 0.7, 0.21473897172368658),
            (0.975, 38.0, 56.895520535055965),
        ] {
            let found = chi_squared_quantile(p, nu).unwrap();
            assert!((found / value - 1.0).abs() < 1e-9, "{p} {nu}: {found}");
        }
    }

    #[test]
    fn refuses_what_is_no_sum_of_squares() {
        let message = chi_squared_above(f64::NAN, 2.0).unwrap_err().to_string();
        assert_eq!(message, "the sum of squares is NaN, but must be 0 or more");
    }
}
