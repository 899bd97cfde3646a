//! A root of one function between two points.

use super::NumericError;

/// Stopping criterion of a bracketed search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bracketing {
    /// Width of the bracket at which the search ends, in the unit of x; 0 (the default) continues to adjacent
    /// floating-point numbers.
    pub width_most: f64,
    /// Largest number of evaluations, default 200 (our choice): bisection alone needs 53 if the root is as large as
    /// the bracket, and 3.3 more for each power of ten by which it is smaller.
    pub evaluations_most: usize,
}

impl Default for Bracketing {
    fn default() -> Self {
        Bracketing {
            width_most: 0.0,
            evaluations_most: 200,
        }
    }
}

/// A point where `f` changes sign between `a` and `b`.
///
/// Inverse quadratic interpolation through the last three points if that is safe, otherwise bisection. The bracket
/// always contains the root, so the search never leaves [a, b].
///
/// # Errors
/// [`NumericError::NoSignChange`] unless f(a) and f(b) differ in sign; [`NumericError::NotANumber`] if f gives NaN;
/// [`NumericError::Evaluations`] if the largest number of evaluations is reached first.
///
/// # Limits
/// Finds one of several roots. A pole at which the sign changes counts as a root.
///
/// # Source
/// Chandrupatla (1997) Adv. Eng. Software 28(3):145-149, doi:10.1016/S0965-9978(96)00051-8.
///
/// # Example
/// ```
/// use dolmen::numeric::{bracketed_root, Bracketing};
/// let root = bracketed_root(|x| x * x - 2.0, 0.0, 2.0, &Bracketing::default())?;
/// assert!((root - 2.0_f64.sqrt()).abs() < 1e-15);
/// # Ok::<(), dolmen::numeric::NumericError>(())
/// ```
pub fn bracketed_root(
    mut f: impl FnMut(f64) -> f64,
    a: f64,
    b: f64,
    options: &Bracketing,
) -> Result<f64, NumericError> {
    let mut value = |x: f64| {
        let y = f(x);
        if y.is_nan() {
            Err(NumericError::NotANumber { x })
        } else {
            Ok(y)
        }
    };
    let (mut x1, mut x2) = (a, b); // newest point; the other end of the bracket
    let (mut y1, mut y2) = (value(x1)?, value(x2)?);
    if y1 == 0.0 {
        return Ok(x1);
    }
    if y2 == 0.0 {
        return Ok(x2);
    }
    if y1.signum() == y2.signum() {
        return Err(NumericError::NoSignChange {
            a,
            b,
            at_a: y1,
            at_b: y2,
        });
    }
    let mut part = 0.5; // of the way from x1 to x2
    for _ in 2..options.evaluations_most {
        let x = x1 + part * (x2 - x1);
        let y = value(x)?;
        let (x3, y3);
        if y.signum() == y1.signum() {
            (x3, y3) = (x1, y1);
        } else {
            (x3, y3) = (x2, y2);
            (x2, y2) = (x1, y1);
        }
        (x1, y1) = (x, y);
        let (best, best_y) = if y2.abs() < y1.abs() { (x2, y2) } else { (x1, y1) };
        let width_least = f64::EPSILON * best.abs() + f64::MIN_POSITIVE;
        let share = (0.5 * options.width_most).max(width_least) / (x2 - x1).abs();
        if best_y == 0.0 || share > 0.5 {
            return Ok(best);
        }
        // eq. 2 of the source: the interpolation through the three points is monotone in the bracket
        let xi = (x1 - x2) / (x3 - x2);
        let phi = (y1 - y2) / (y3 - y2);
        part = if phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi {
            let to_second = y1 / (y2 - y1) * y3 / (y2 - y3);
            let to_third = (x3 - x1) / (x2 - x1) * y1 / (y3 - y1) * y2 / (y3 - y2);
            (to_second + to_third).clamp(share, 1.0 - share)
        } else {
            0.5
        };
    }
    Err(NumericError::Evaluations {
        most: options.evaluations_most,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root(f: impl FnMut(f64) -> f64, a: f64, b: f64) -> Result<f64, NumericError> {
        bracketed_root(f, a, b, &Bracketing::default())
    }

    #[test]
    fn exact_roots_to_the_last_bits() {
        let mut calls = 0;
        let cosine = |x: f64| {
            calls += 1;
            x.cos() - x
        };
        assert!((root(cosine, 0.0, 1.0).unwrap() - 0.739_085_133_215_160_6).abs() < 2e-16);
        assert!(calls <= 12, "{calls} evaluations");
        assert_eq!(root(|x| x - 3.0, 3.0, 4.0), Ok(3.0));
        // contact of ninth order: interpolation fails, bisection does not
        assert!(root(|x| (x - 1.0).powi(9), -3.0, 4.0).unwrap() - 1.0 < 1e-15);
        // a step
        let step = root(|x| if x < 0.3 { -1.0 } else { 1.0 }, 0.0, 1.0).unwrap();
        assert!((step - 0.3).abs() < 1e-15);
        // a root forty powers of ten below the bracket
        assert!((root(|x| x.ln() + 92.0, 1e-300, 1.0).unwrap().ln() + 92.0).abs() < 1e-13);
    }

    #[test]
    fn refuses_and_says_why() {
        let message = |r: Result<f64, NumericError>| r.unwrap_err().to_string();
        assert_eq!(
            message(root(|x| x * x + 1.0, -1.0, 1.0)),
            "no sign change: the function is 2 at -1 and 2 at 1; choose ends where it differs in sign"
        );
        assert_eq!(
            message(root(f64::sqrt, -1.0, 1.0)),
            "the function is not a number at -1"
        );
        let few = Bracketing {
            evaluations_most: 3,
            ..Bracketing::default()
        };
        assert_eq!(
            message(bracketed_root(|x| x * x - 2.0, 0.0, 2.0, &few)),
            "no root within 3 evaluations: raise evaluations_most or width_most"
        );
    }
}
