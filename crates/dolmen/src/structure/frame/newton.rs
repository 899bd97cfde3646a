//! The root of the frequencies near a given stiffness.

use super::storeys::{Convention, Frame};
use crate::structure::NaturalMode;
use dolmen_linalg::{Matrix, solve};

/// Relative error of ω² up to which a root counts as found: 1e-10 in frequency.
const REACHED: f64 = 2e-10;
const ITERATIONS_MOST: usize = 40;

/// Stiffness with these ω², by Newton's method from `start`; `None` if it leads to none that is positive.
///
/// ```text
/// dλ_j/dk_i = (s_iᵀ φ_j)² / (φ_jᵀ M φ_j),   s_iᵀ φ the drift of storey i (grounded: its displacement)
/// ```
pub(super) fn stiffness_by_newton(frame: &Frame, lambda: &[f64], start: Vec<f64>) -> Option<Vec<f64>> {
    let n = lambda.len();
    let mut k = start;
    let mut best: Option<(f64, Vec<f64>)> = None;
    for _ in 0..ITERATIONS_MOST {
        let modes = frame.natural_modes(&k).ok()?;
        let relative: Vec<f64> = modes
            .iter()
            .zip(lambda)
            .map(|(m, l)| m.omega_squared / l - 1.0)
            .collect();
        let error = relative.iter().fold(0.0_f64, |most, e| most.max(e.abs()));
        if best.as_ref().is_some_and(|(least, _)| error >= *least) && error < REACHED {
            break; // no further gain: rounding
        }
        if best.as_ref().is_none_or(|(least, _)| error < *least) {
            best = Some((error, k.clone()));
        }
        let jacobian = Matrix::from_fn(n, n, |j, i| {
            eigenvalue_derivative(frame, &modes[j], i) / lambda[j] * k[i]
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

/// dω²/dk_i of one mode.
pub(super) fn eigenvalue_derivative(frame: &Frame, mode: &NaturalMode, i: usize) -> f64 {
    let modal_mass: f64 = frame
        .storeys()
        .iter()
        .zip(&mode.displacement)
        .map(|(s, y)| s.mass_kg * y * y)
        .sum();
    extension(frame, &mode.displacement, i).powi(2) / modal_mass
}

/// What the spring of storey i sees: its drift, or its displacement.
pub(super) fn extension(frame: &Frame, displacement: &[f64], i: usize) -> f64 {
    match frame.convention() {
        Convention::Grounded => displacement[i],
        Convention::Drift if i == 0 => displacement[0],
        Convention::Drift => displacement[i] - displacement[i - 1],
    }
}
