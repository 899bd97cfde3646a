//! Natural frequencies of a stack on the springs of its joints.

use super::assembly::Assembly;
use super::contact_points::ContactRule;
use super::error::BlocksError;
use super::matrices::{Closed, Part, contact_matrix, mass_matrix};
use super::rest::settle;
use crate::structure::stack::Stack;
use dolmen_linalg::generalized_symmetric_eigen;

/// One natural mode of a stack.
#[derive(Clone, Debug, PartialEq)]
pub struct StackMode {
    /// Natural frequency, Hz.
    pub frequency_hz: f64,
    /// Shape: of each block the displacement of its centroid (x, y, z) and its turn about it (x, y, z), the largest
    /// displacement 1, m and rad.
    pub shape: Vec<[f64; 6]>,
}

/// Natural modes of a stack in contact, lowest first.
///
/// ```text
/// K φ = ω² M φ,   K = Σ Bᵀ diag(k_s, k_s, k_n) a B over the contact points closed at rest        [6n × 6n]
/// ```
///
/// # Errors
/// [`BlocksError`] if the stack finds no rest or a decomposition fails.
///
/// # Limits
/// Small motion: joints that stay closed where they are closed at rest. What gravity takes from the stiffness (P-delta) is
/// left out: .1 % of the first frequency of a ten-stone pagoda.
///
/// # Source
/// Kim, Koo & Hong (2018) Fig. 17 uses K_n 1e9, K_s 4e8 Pa/m, with corner contact.
pub fn stack_modes(stack: &Stack, contact_rule: ContactRule) -> Result<Vec<StackMode>, BlocksError> {
    let mut assembly = Assembly::of(stack, contact_rule);
    settle(&mut assembly, stack)?;
    let eigen = generalized_symmetric_eigen(
        &contact_matrix(&assembly, Part::Springs, Closed::Pressed),
        &mass_matrix(&assembly),
    )?;
    let modes = eigen.values.iter().enumerate().map(|(mode, value)| {
        let column = eigen.vectors.column(mode);
        let largest = column
            .chunks(6)
            .flat_map(|block| &block[..3])
            .fold(0.0_f64, |most, v| most.max(v.abs()));
        let scale = if largest > 0.0 { 1.0 / largest } else { 1.0 };
        let blocks = column.chunks_exact(6);
        StackMode {
            frequency_hz: value.max(0.0).sqrt() / std::f64::consts::TAU,
            shape: blocks
                .map(|block| std::array::from_fn(|i| block[i] * scale))
                .collect(),
        }
    });
    Ok(modes.collect())
}
