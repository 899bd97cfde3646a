//! The check of a chain.

use crate::error::WorkError;
use dolmen::assess::{ChainCheck, check_chain, check_one_stone};
use dolmen::stability::{chain_limits, chain_stability};
use dolmen_project::{ChainPart, Pick};

/// What is known of a chain, each input with the value that `pick` chooses.
pub(crate) fn check(part: &ChainPart, pick: Pick<'_>) -> Result<ChainCheck, WorkError> {
    let stiffness = part.stiffness_n_m_rad(pick);
    let chain = part.build(pick)?;
    let mut check = check_chain(&chain, stiffness.as_deref())?;
    if let Some(stone) = &part.stone {
        let beside = check_one_stone(&chain, stone.build(pick), stiffness.as_deref(), &check.modes)?;
        check.one_stone = Some(beside);
    }
    check.on_soil = part.on_soil(pick);
    Ok(check)
}

/// The load factor; `None` unless every joint is known.
pub(crate) fn load_factor(part: &ChainPart, pick: Pick<'_>) -> Result<Option<f64>, WorkError> {
    Ok(match part.stiffness_n_m_rad(pick) {
        Some(stiffness) => Some(chain_stability(&part.build(pick)?, &stiffness)?.load_factor),
        None => None,
    })
}

/// Stiffness that equal joints need, N m/rad.
pub(crate) fn equal_joints_n_m_rad(part: &ChainPart, pick: Pick<'_>) -> Result<f64, WorkError> {
    Ok(chain_limits(&part.build(pick)?)?.equal_joints_n_m_rad)
}

/// Least tilt at which a joint reaches its uplift limit.
pub(crate) fn uplift_tilt(check: &ChainCheck) -> Option<f64> {
    let joints = check.stability.iter().flat_map(|stability| &stability.joints);
    joints
        .filter_map(|joint| joint.uplift_tilt_rad)
        .min_by(f64::total_cmp)
}
