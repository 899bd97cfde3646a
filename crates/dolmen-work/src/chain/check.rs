//! The check of a chain.

use crate::error::WorkError;
use dolmen::assess::{
    ChainAcross, ChainCheck, LoadedChain, check_chain, check_chain_across, check_one_stone,
};
use dolmen::stability::{ChainStability, chain_limits, chain_stability};
use dolmen::structure::lowest_frequency_hz;
use dolmen_project::{ChainAxis, ChainPart, LoadsPart, Pick, Quantity};

/// Checks a chain, with the value of each input that `pick` chooses.
pub(crate) fn check(part: &ChainPart, loads: &LoadsPart, pick: Pick<'_>) -> Result<ChainCheck, WorkError> {
    let stiffness = part.stiffness_n_m_rad(pick);
    let chain = part.build(pick)?;
    let mut check = check_chain(&chain, stiffness.as_deref())?;
    if let Some(stone) = &part.stone {
        let beside = check_one_stone(&chain, stone.build(pick), stiffness.as_deref(), &check.modes)?;
        check.one_stone = Some(beside);
    }
    check.on_soil = part.on_soil(pick);
    check.across = across(part, pick)?.map(Box::new);
    check.loaded = loaded(part, loads, pick)?.map(Box::new);
    Ok(check)
}

/// The chain with the weights of its static loads; `None` if they weigh nothing.
fn loaded(part: &ChainPart, loads: &LoadsPart, pick: Pick<'_>) -> Result<Option<LoadedChain>, WorkError> {
    if loads.loads.iter().all(|load| load.weight.is_none()) {
        return Ok(None);
    }
    let mut found = LoadedChain {
        frequency_hz: None,
        frequency_across_hz: None,
        uplift_tilt_rad: None,
    };
    for axis in part.axes() {
        let Some(stiffness) = part.stiffness_towards(*axis, pick) else {
            continue;
        };
        let chain = part.build_loaded(*axis, loads, pick)?;
        let of_axis = check_chain(&chain, Some(&stiffness))?;
        let frequency_hz = lowest_frequency_hz(&of_axis.modes);
        match axis {
            ChainAxis::Along => {
                found.frequency_hz = frequency_hz;
                found.uplift_tilt_rad = uplift_tilt(&of_axis);
            }
            ChainAxis::Across => found.frequency_across_hz = frequency_hz,
        }
    }
    Ok(Some(found))
}

/// The chain across the direction of motion; `None` if the file gives no separate values for it.
fn across(part: &ChainPart, pick: Pick<'_>) -> Result<Option<ChainAcross>, WorkError> {
    if !part.has_two_axes() {
        return Ok(None);
    }
    let stiffness = part.stiffness_towards(ChainAxis::Across, pick);
    let chain = part.build_towards(ChainAxis::Across, pick)?;
    let taken = part.stiffness_taken(pick);
    let found = check_chain_across(&chain, stiffness.as_deref(), taken)?;
    let soil = part.soil_towards(ChainAxis::Across, pick);
    Ok(Some(ChainAcross {
        soil_n_m_rad: soil.map(|soil| soil.rocking_n_m_rad()),
        ..found
    }))
}

/// The load factor, the smaller of its directions; `None` unless every joint is known.
pub(crate) fn load_factor(part: &ChainPart, pick: Pick<'_>) -> Result<Option<f64>, WorkError> {
    let mut least: Option<f64> = None;
    for axis in part.axes() {
        let Some(stiffness) = part.stiffness_towards(*axis, pick) else {
            return Ok(None);
        };
        let factor = chain_stability(&part.build_towards(*axis, pick)?, &stiffness)?.load_factor;
        // a factor that is not a number must not disappear
        least = Some(match least {
            Some(known) if known <= factor || known.is_nan() => known,
            _ => factor,
        });
    }
    Ok(least)
}

/// Stiffness that equal joints need, N m/rad.
pub(crate) fn equal_joints_n_m_rad(part: &ChainPart, pick: Pick<'_>) -> Result<f64, WorkError> {
    Ok(chain_limits(&part.build(pick)?)?.equal_joints_n_m_rad)
}

/// Ratio of the side of a rectangle to the distance from its centre to the edge of its core along that side.
const CORE: f64 = 6.0;

/// Tilts at which a bed opens, and at which it stands on its edge: the smallest over all joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct UpliftTilt {
    pub(crate) edge: f64,
    pub(crate) opens: f64,
}

/// Smallest tilt at which a joint reaches its uplift limit.
pub(crate) fn uplift_tilt(check: &ChainCheck) -> Option<f64> {
    if let Some(loaded) = &check.loaded {
        return loaded.uplift_tilt_rad;
    }
    let joints = check.stability.iter().flat_map(|stability| &stability.joints);
    joints
        .filter_map(|joint| joint.uplift_tilt_rad)
        .min_by(f64::total_cmp)
}

/// The same for a chain with two directions, towards the side to which it leans. `None` without the width of any bed, without stiffness, or
/// if it falls. Beds open where the resultant leaves their core: |e_x|/(b/6) + |e_y|/(w/6) = 1; for a bed of unknown plan only the lean
/// along the chain is considered.
pub(crate) fn uplift_tilt_towards(
    part: &ChainPart,
    check: &ChainCheck,
    towards: [f64; 2],
) -> Option<UpliftTilt> {
    let stabilities = [
        check.stability.as_ref()?,
        check.across.as_ref()?.stability.as_ref()?,
    ];
    let size = towards[0].hypot(towards[1]);
    let mut normal_n = 0.0;
    let mut least: Option<UpliftTilt> = None;
    for (i, link) in part.links.iter().enumerate().rev() {
        normal_n += link.heaviness.mass_kg(part.gravity_m_s2, &mut Quantity::nominal) * part.gravity_m_s2;
        let Some(bed) = part.bed(i, &mut Quantity::nominal) else {
            continue;
        };
        let per_rad = |of: &ChainStability| of.joints[i].lean_moment_n_m_rad;
        let moments = [
            per_rad(stabilities[0])? * towards[0] / size,
            per_rad(stabilities[1])? * towards[1] / size,
        ];
        let core = match bed.depth_m {
            Some(depth_m) => moments[0].abs() / bed.width_m + moments[1].abs() / depth_m,
            None => moments[0].hypot(moments[1]) / bed.width_m,
        };
        let own = UpliftTilt {
            edge: bed.reach(normal_n, [0.0; 2], moments),
            opens: normal_n / (CORE * core),
        };
        least = Some(least.map_or(own, |known| UpliftTilt {
            edge: known.edge.min(own.edge),
            opens: known.opens.min(own.opens),
        }));
    }
    least
}
