//! The check of a chain.

use crate::error::WorkError;
use dolmen::assess::{AcrossOnSoil, ChainCheck, check_chain, check_one_stone};
use dolmen::stability::{chain_limits, chain_stability};
use dolmen::structure::Chain;
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
    if let Some(on_soil) = &mut check.on_soil {
        on_soil.across = across(part, &chain, stiffness, pick)?;
    }
    Ok(check)
}

/// The chain across the motion, where its footing is softer there: own weight knows no direction.
fn across(
    part: &ChainPart,
    chain: &Chain,
    stiffness_along: Option<Vec<f64>>,
    pick: Pick<'_>,
) -> Result<Option<AcrossOnSoil>, WorkError> {
    let Some(along) = part.soil.as_ref().map(|soil| soil.build(pick)) else {
        return Ok(None);
    };
    let across = along.across();
    let soil_n_m_rad = across.rocking_n_m_rad();
    if soil_n_m_rad >= along.rocking_n_m_rad() {
        return Ok(None);
    }
    let load_factor = match stiffness_along {
        None => None,
        Some(mut stiffness) => {
            let bed = stiffness.first().and_then(|lowest| along.joint_n_m_rad(*lowest));
            if let (Some(lowest), Some(bed)) = (stiffness.first_mut(), bed) {
                *lowest = across.in_series_n_m_rad(bed);
            }
            Some(chain_stability(chain, &stiffness)?.load_factor)
        }
    };
    Ok(Some(AcrossOnSoil {
        soil_n_m_rad,
        load_factor,
    }))
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
