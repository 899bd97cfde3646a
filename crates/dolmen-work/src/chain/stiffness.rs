//! Stiffness of a chain from measured modes.

use crate::error::WorkError;
use crate::stiffness::MeasuredDirection;
use crate::surveyed::StiffnessAnswer;
use dolmen::stability::chain_stability;
use dolmen::structure::{ChainStiffness, chain_stiffness};
use dolmen_project::{ChainPart, Pick};

/// Every stiffness that explains the modes, with the weights of the loads on the chain; for a chain with two directions, in the direction
/// of the modes.
pub(crate) fn stiffness(
    part: &ChainPart,
    measured: &MeasuredDirection<'_>,
    pick: Pick<'_>,
) -> Result<Vec<StiffnessAnswer>, WorkError> {
    let axis = part.axis_of(measured.direction);
    let chain = part.build_loaded(axis, measured.loads, pick)?;
    let found = chain_stiffness(&chain, measured.modes, &ChainStiffness::default())?;
    let load_factor = |k: &[f64]| Ok(chain_stability(&chain, k)?.load_factor);
    Ok(vec![measured.answer(None, found, load_factor)?])
}
