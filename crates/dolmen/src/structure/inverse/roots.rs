//! All stiffnesses for as many measured frequencies as springs.

use super::SpringModel;
use super::continuation::{Pencil, continue_all};
use super::newton::stiffness_by_newton;
use crate::structure::{StiffnessNote, StructureError};
use dolmen_linalg::{Matrix, solve};

/// Two roots are the same if every stiffness agrees within this: √ε, the resolution of a double root.
const SAME_ROOT: f64 = 1e-6;
/// Largest imaginary part, relative to the modulus, of a solution that may be real after refinement: two real roots
/// that nearly meet are found with an error of √ε.
const NEARLY_REAL: f64 = 1e-3;

/// All stiffnesses that give a structure exactly its measured frequencies.
#[derive(Clone, Debug, PartialEq)]
pub struct FrequencyRoots {
    /// One stiffness per spring, N/m or N m/rad, lowest first; sorted by the first.
    pub stiffness: Vec<Vec<f64>>,
    /// Number of complex solutions, n!, all of which were followed.
    pub solutions_complex: usize,
    /// Whether all of them were reached. If not, real solutions may be missing.
    pub complete: bool,
    /// Notes: why there is no solution, or fewer than expected.
    pub notes: Vec<StiffnessNote>,
}

/// Finds all complex solutions, then refines and verifies the real ones.
///
/// # Errors
/// [`StructureError::Linalg`] if some coordinate has no spring.
pub(crate) fn roots_by_continuation(
    model: &SpringModel,
    lambda: &[f64],
) -> Result<FrequencyRoots, StructureError> {
    let found = continue_all(&pencil(model, lambda)?);
    let mut stiffness: Vec<Vec<f64>> = Vec::new();
    for solution in &found.solutions {
        if solution.iter().any(|k| k.im.abs() > NEARLY_REAL * k.norm()) {
            continue;
        }
        let start: Vec<f64> = solution.iter().map(|k| k.re).collect();
        if start.iter().any(|&k| k <= 0.0) {
            continue; // what else is known of the structure would have to be undone
        }
        let Some(exact) = stiffness_by_newton(model, lambda, start) else {
            continue;
        };
        let same = |other: &Vec<f64>| {
            let pairs = other.iter().zip(&exact);
            pairs
                .into_iter()
                .all(|(a, b)| (a - b).abs() <= SAME_ROOT * b.abs())
        };
        if !stiffness.iter().any(same) {
            stiffness.push(exact);
        }
    }
    stiffness.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let (separated, expected) = (found.solutions.len(), found.expected);
    let mut notes = Vec::new();
    if separated < expected {
        notes.push(StiffnessNote::NotAllSeparated { separated, expected });
    } else if stiffness.is_empty() {
        notes.push(StiffnessNote::NoneReal {
            frequencies: lambda.len(),
            solutions_complex: expected,
        });
    }
    Ok(FrequencyRoots {
        stiffness,
        solutions_complex: expected,
        complete: separated == expected,
        notes,
    })
}

/// det(diag(k) + H − λ W) = 0: in spring coordinates, δ = Bᵀ φ, each k_i is a single diagonal entry.
///
/// ```text
/// H = B⁻¹ K_0 B⁻ᵀ,   W = B⁻¹ M B⁻ᵀ                                                      n × n
/// ```
fn pencil(model: &SpringModel, lambda: &[f64]) -> Result<Pencil, StructureError> {
    let turned = |a: &Matrix| -> Result<Matrix, StructureError> {
        let half = solve(&model.springs, a)?;
        Ok(solve(&model.springs, &half.transpose())?)
    };
    Ok(Pencil {
        h: turned(&model.rest)?,
        w: turned(&model.mass)?,
        lambda: lambda.to_vec(),
    })
}
