//! Damped Gauss–Newton method for small least-squares problems with bounds on the unknowns.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | r, J | `residual`, `jacobian` | residuals (m) and dr/dx (m × n) |
//! | μ | `damping` | damping of the step; increases when the linear model fails |

use super::levenberg_marquardt::Residuals;
use dolmen_linalg::{Matrix, solve_least_squares};

/// First damping, relative to the largest diagonal entry of JᵀJ, as in the unbounded method.
const DAMPING_FIRST: f64 = 1e-3;
/// Damping at which the search ends: no step improves the point, which is a minimum to rounding.
const DAMPING_MOST: f64 = 1e10;
/// Largest step of one unknown. The unknowns are logarithms, so this is a factor of e².
const STEP_MOST: f64 = 2.0;
/// Length of a step below which it is only rounding.
const STEP_LEAST: f64 = 1e-13;

#[derive(Clone, Copy, Debug)]
pub(crate) struct BoundedStop {
    pub(crate) evaluations_most: usize,
    /// Sum of squares at which the fit ends; 0 to continue to the minimum.
    pub(crate) enough: f64,
    /// Relative decrease of the sum of squares in one step below which the fit ends.
    pub(crate) decrease_least: f64,
}

pub(crate) struct BoundedFit {
    pub(crate) x: Vec<f64>,
    pub(crate) at: Residuals,
    pub(crate) squares: f64,
}

/// A local minimum of ‖r(x)‖² with lower ≤ x ≤ upper. The search begins at the start point, moved into the bounds; `None` if `at`
/// refuses this point.
///
/// In each step, unknowns at a bound that they would leave are fixed, and the step of the other unknowns is limited by their
/// bounds. An unknown with equal bounds is always fixed.
pub(crate) fn bounded_least_squares(
    start: &[f64],
    [lower, upper]: [&[f64]; 2],
    stop: &BoundedStop,
    mut at: impl FnMut(&[f64]) -> Option<Residuals>,
) -> Option<BoundedFit> {
    let into_box = |i: usize, x: f64| x.max(lower[i]).min(upper[i]);
    let mut x: Vec<f64> = start.iter().enumerate().map(|(i, x)| into_box(i, *x)).collect();
    let mut here = at(&x)?;
    let mut squares = sum_of_squares(&here.residual);
    let mut damping = DAMPING_FIRST;
    let mut growth = 2.0;
    for _ in 1..stop.evaluations_most {
        if squares <= stop.enough {
            break;
        }
        let free: Vec<usize> = (0..x.len())
            .filter(|&i| {
                let slope: f64 = products(here.jacobian.column(i), &here.residual);
                let leaves = (x[i] <= lower[i] && slope > 0.0) || (x[i] >= upper[i] && slope < 0.0);
                lower[i] < upper[i] && !leaves
            })
            .collect();
        let scale = free.iter().map(|&i| sum_of_squares(here.jacobian.column(i)));
        let scale = scale.fold(0.0, f64::max);
        if free.is_empty() || scale == 0.0 {
            break;
        }
        let Some(step) = damped_step(&here, &free, (damping * scale).sqrt()) else {
            break;
        };
        let longest = step.iter().fold(0.0_f64, |most, d| most.max(d.abs()));
        if longest < STEP_LEAST {
            break;
        }
        let shortened = (STEP_MOST / longest).min(1.0);
        let mut trial = x.clone();
        for (&i, d) in free.iter().zip(&step) {
            trial[i] = into_box(i, x[i] + shortened * d);
        }
        let there = at(&trial).map(|there| (sum_of_squares(&there.residual), there));
        match there {
            Some((less, there)) if less < squares => {
                let is_done = squares - less < stop.decrease_least * squares;
                (x, here, squares) = (trial, there, less);
                damping = (damping / 5.0).max(1e-15);
                growth = 2.0;
                if is_done {
                    break;
                }
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
    Some(BoundedFit { x, at: here, squares })
}

fn products(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn sum_of_squares(v: &[f64]) -> f64 {
    products(v, v)
}

/// The step d of the free unknowns that minimises ‖J d + r‖² + μ ‖d‖².
fn damped_step(here: &Residuals, free: &[usize], root_damping: f64) -> Option<Vec<f64>> {
    let (m, n) = (here.jacobian.rows(), free.len());
    let stacked = Matrix::from_fn(m + n, n, |i, j| match i.checked_sub(m) {
        None => here.jacobian[(i, free[j])],
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

    const STOP: BoundedStop = BoundedStop {
        evaluations_most: 300,
        enough: 0.0,
        decrease_least: 0.0,
    };

    fn rosenbrock(x: &[f64]) -> Option<Residuals> {
        Some(Residuals {
            residual: vec![10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]],
            jacobian: Matrix::from_rows(&[[-20.0 * x[0], 10.0], [-1.0, 0.0]]),
        })
    }

    #[test]
    fn exact_rosenbrock_valley_in_a_wide_box() {
        let fit = bounded_least_squares(&[-1.2, 1.0], [&[-5.0; 2], &[5.0; 2]], &STOP, rosenbrock).unwrap();
        assert!(fit.x.iter().all(|x| (x - 1.0).abs() < 1e-9), "{:?}", fit.x);
    }

    #[test]
    fn exact_rosenbrock_valley_cut_by_a_bound() {
        // on x ≤ 1/2 the minimum is at (1/2, 1/4), where r = (0, 1/2)
        let fit = bounded_least_squares(&[-1.2, 1.0], [&[-5.0; 2], &[0.5, 5.0]], &STOP, rosenbrock).unwrap();
        assert_eq!(fit.x[0], 0.5);
        assert!((fit.x[1] - 0.25).abs() < 1e-9, "{:?}", fit.x);
        assert!((fit.squares - 0.25).abs() < 1e-9);
    }

    #[test]
    fn holds_an_unknown_between_equal_bounds_stays() {
        let fit = bounded_least_squares(&[0.0, 0.0], [&[2.0, -5.0], &[2.0, 5.0]], &STOP, rosenbrock).unwrap();
        assert_eq!(fit.x[0], 2.0);
        assert!((fit.x[1] - 4.0).abs() < 1e-9, "{:?}", fit.x);
    }
}
