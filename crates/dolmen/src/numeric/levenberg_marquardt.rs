//! Damped Gauss–Newton method for small problems with a known Jacobian.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | r, J | `residual`, `jacobian` | residuals (m) and dr/dx (m × n) |
//! | μ | `damping` | damping of the step; increases when the linear model fails |
//! | ρ | `gain` | decrease of ½‖r‖² over the decrease that J predicts |

use dolmen_linalg::{Matrix, solve_least_squares};

/// Residuals and their derivatives at one point.
pub(crate) struct Residuals {
    /// r, m values.
    pub(crate) residual: Vec<f64>,
    /// dr/dx, m × n.
    pub(crate) jacobian: Matrix,
}

/// The end of the iteration.
pub(crate) struct LeastSquaresFit {
    pub(crate) x: Vec<f64>,
    pub(crate) at: Residuals,
}

/// First damping, relative to the largest diagonal entry of JᵀJ (Nielsen 1999: 1e-3 for a good start).
const DAMPING_FIRST: f64 = 1e-3;
/// Damping above which no step can be found: the point is a minimum to rounding.
const DAMPING_MOST: f64 = 1e12;
/// Longest step of one unknown; unknowns are logarithms, so this is a factor of e³.
const STEP_MOST: f64 = 3.0;
/// Length of a step below which it is only rounding.
const STEP_LEAST: f64 = 1e-14;

/// A local minimum of ½‖r(x)‖² from the start point; `None` if `at` refuses the start. `at` may refuse any trial
/// point (a structure that falls has no frequency); the step is then shortened.
///
/// # Source
/// Nielsen, H. B. (1999) Damping parameter in Marquardt's method, IMM-REP-1999-05. Differs from the source: steps
/// come from a QR factorization of [J; √μ I] instead of normal equations, which would lose half of the digits.
pub(crate) fn levenberg_marquardt(
    start: Vec<f64>,
    iterations_most: usize,
    mut at: impl FnMut(&[f64]) -> Option<Residuals>,
) -> Option<LeastSquaresFit> {
    let n = start.len();
    let mut x = start;
    let mut here = at(&x)?;
    let steepest = |j: &Matrix| (0..n).map(|i| squares(j.column(i))).fold(0.0, f64::max);
    let mut scale = steepest(&here.jacobian).max(f64::MIN_POSITIVE);
    let mut damping = DAMPING_FIRST;
    let mut growth = 2.0;
    for _ in 0..iterations_most {
        let Some(step) = damped_step(&here, (damping * scale).sqrt()) else {
            break;
        };
        let longest = step.iter().fold(0.0_f64, |most, d| most.max(d.abs()));
        if longest < STEP_LEAST {
            break;
        }
        let shortened = (STEP_MOST / longest).min(1.0);
        let trial: Vec<f64> = x.iter().zip(&step).map(|(x, d)| x + shortened * d).collect();
        let there = at(&trial);
        let before = squares(&here.residual);
        let gain = there.as_ref().map_or(-1.0, |t| {
            let expected = predicted_decrease(&here, &step, shortened);
            (before - squares(&t.residual)) / expected.max(f64::MIN_POSITIVE)
        });
        match there {
            Some(there) if gain > 0.0 => {
                x = trial;
                here = there;
                scale = steepest(&here.jacobian).max(f64::MIN_POSITIVE);
                damping *= (1.0 - (2.0 * gain - 1.0).powi(3)).clamp(0.1, 1.0);
                growth = 2.0;
            }
            _ => {
                damping *= growth;
                growth *= 2.0;
                if damping > DAMPING_MOST {
                    break;
                }
            }
        }
    }
    Some(LeastSquaresFit { x, at: here })
}

fn squares(v: &[f64]) -> f64 {
    v.iter().map(|a| a * a).sum()
}

/// ‖r‖² − ‖r + J t d‖².
fn predicted_decrease(here: &Residuals, step: &[f64], shortened: f64) -> f64 {
    let change = here.jacobian.times(step);
    let after = here.residual.iter().zip(&change);
    squares(&here.residual) - after.map(|(r, c)| (r + shortened * c).powi(2)).sum::<f64>()
}

/// The step d that minimises ‖J d + r‖² + μ ‖d‖².
fn damped_step(here: &Residuals, root_damping: f64) -> Option<Vec<f64>> {
    let (m, n) = (here.jacobian.rows(), here.jacobian.columns());
    let stacked = Matrix::from_fn(m + n, n, |i, j| match i.checked_sub(m) {
        None => here.jacobian[(i, j)],
        Some(row) if row == j => root_damping,
        Some(_) => 0.0,
    });
    let right = Matrix::from_fn(m + n, 1, |i, _| if i < m { -here.residual[i] } else { 0.0 });
    let step = solve_least_squares(&stacked, &right).ok()?;
    Some(step.column(0).to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_rosenbrock_valley() {
        // r = (10 (y − x²), 1 − x): minimum 0 at (1, 1)
        let at = |x: &[f64]| {
            Some(Residuals {
                residual: vec![10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]],
                jacobian: Matrix::from_rows(&[[-20.0 * x[0], 10.0], [-1.0, 0.0]]),
            })
        };
        let fit = levenberg_marquardt(vec![-1.2, 1.0], 200, at).unwrap();
        assert!(
            (fit.x[0] - 1.0).abs() < 1e-12 && (fit.x[1] - 1.0).abs() < 1e-12,
            "{:?}",
            fit.x
        );
        assert!(squares(&fit.at.residual) < 1e-24);
    }

    #[test]
    fn exact_mean_of_inconsistent_data() {
        let at = |x: &[f64]| {
            Some(Residuals {
                residual: [1.0, 2.0, 6.0].map(|d| x[0] - d).to_vec(),
                jacobian: Matrix::from_rows(&[[1.0], [1.0], [1.0]]),
            })
        };
        let fit = levenberg_marquardt(vec![-50.0], 200, at).unwrap();
        assert!((fit.x[0] - 3.0).abs() < 1e-12);
    }

    #[test]
    fn holds_a_refused_region_is_not_entered() {
        let at = |x: &[f64]| {
            (x[0] > 0.0).then(|| Residuals {
                residual: vec![x[0].ln() + 3.0],
                jacobian: Matrix::from_rows(&[[1.0 / x[0]]]),
            })
        };
        let fit = levenberg_marquardt(vec![3.0], 500, at).unwrap();
        assert!((fit.x[0] / (-3.0_f64).exp() - 1.0).abs() < 1e-12, "{}", fit.x[0]);
    }
}
