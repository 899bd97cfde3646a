//! Newton search for the root near a given stiffness.

use super::SpringModel;
use dolmen_linalg::{Matrix, solve};

/// Relative error of ω² at which a root is found: 1e-10 in frequency.
const REACHED: f64 = 2e-10;
const ITERATIONS_MOST: usize = 40;

/// Stiffness with these ω², by Newton's method in ln k from `start`; `None` if the search finds no positive
/// stiffness.
///
/// ```text
/// dλ_j/dk_i = (b_iᵀ φ_j)²,   φ_jᵀ M φ_j = 1
/// ```
pub(super) fn stiffness_by_newton(model: &SpringModel, lambda: &[f64], start: Vec<f64>) -> Option<Vec<f64>> {
    let n = lambda.len();
    let mut k = start;
    let mut best: Option<(f64, Vec<f64>)> = None;
    for _ in 0..ITERATIONS_MOST {
        let modes = model.modes(&k)?;
        let relative: Vec<f64> = modes
            .values
            .iter()
            .zip(lambda)
            .map(|(c, l)| c / l - 1.0)
            .collect();
        let error = relative.iter().fold(0.0_f64, |most, e| most.max(e.abs()));
        let least = best.as_ref().map_or(f64::INFINITY, |(least, _)| *least);
        if error < least {
            best = Some((error, k.clone()));
        } else if least < REACHED {
            break; // no further gain: rounding
        }
        let jacobian = Matrix::from_fn(n, n, |j, i| {
            model.extension(i, modes.vectors.column(j)).powi(2) / lambda[j] * k[i]
        });
        let right = Matrix::from_fn(n, 1, |j, _| -relative[j]);
        let Ok(step) = solve(&jacobian, &right) else {
            break;
        };
        for (k, d) in k.iter_mut().zip(step.column(0)) {
            *k *= d.clamp(-0.5, 1.0) + 1.0; // stays positive
        }
    }
    best.filter(|(error, _)| *error < REACHED).map(|(_, k)| k)
}
