//! A chain with two directions under a combination: wind from every side, and beds under the moments of both directions.

use super::planes::Model;
use crate::error::WorkError;
use crate::loads::{AcrossCombination, ChainCombination};
use dolmen::stability::{ChainUnderLoads, JointHold, JointUnderLoads};
use dolmen::structure::Chain;
use dolmen_project::CombinationPart;

/// Number of wind directions, one for each degree. Our choice: the beds of a rectangle are worst along their sides, which are among them.
const DEGREES: u32 = 360;

/// A chain under static loads alone, and under wind alone; the response is linear in both.
struct Parts {
    still: ChainUnderLoads,
    blown: ChainUnderLoads,
}

/// The chain in the wind from its worst side: at angle φ, cos φ of the force along and sin φ of the force across act together.
pub(super) fn all_round(
    model: &Model,
    chains: &[Chain],
    combination: &CombinationPart,
) -> Result<ChainCombination, WorkError> {
    let mut parts = Vec::new();
    for (plane, chain) in model.planes.iter().zip(chains) {
        parts.push(Parts {
            still: plane.under(chain, model, [combination.loads, 0.0])?,
            blown: plane.under(chain, model, [0.0, combination.wind])?,
        });
    }
    let blows = combination.wind > 0.0 && model.planes.iter().all(|plane| plane.met.is_some());
    let directions = if blows { DEGREES } else { 1 };
    let mut worst = (f64::INFINITY, 0);
    for degrees in 0..directions {
        let joints = 0..model.holds.len();
        let factors = joints.filter_map(|joint| factor(&parts, &model.holds, joint, towards(degrees)));
        let least = factors.fold(f64::INFINITY, f64::min);
        if least < worst.0 {
            worst = (least, degrees);
        }
    }
    let wind = towards(worst.1).map(|share| share * combination.wind);
    let mut both = Vec::new();
    for ((plane, chain), wind) in model.planes.iter().zip(chains).zip(wind) {
        let mut under = plane.under(chain, model, [combination.loads, wind])?;
        for (i, joint) in under.joints.iter_mut().enumerate() {
            joint.factor = factor(&parts, &model.holds, i, towards(worst.1));
        }
        both.push(under);
    }
    // beds carry both directions together
    let falls = both
        .iter()
        .any(|of| of.factor == Some(0.0) && of.joints.iter().all(|joint| joint.moment_n_m.is_none()));
    for under in &mut both {
        let known = under.joints.iter().enumerate();
        let least = known
            .filter_map(|(i, joint)| Some((i + 1, joint.factor?)))
            .min_by(|a, b| a.1.total_cmp(&b.1));
        under.governing_joint = least.map(|(joint, _)| joint);
        under.factor = match falls {
            true => Some(0.0),
            false => least.map(|(_, factor)| factor),
        };
    }
    let mut both = both.into_iter();
    let (Some(along), Some(across)) = (both.next(), both.next()) else {
        unreachable!("a chain of two directions has two planes")
    };
    Ok(ChainCombination {
        under: along,
        wind_reversed: false,
        weight_factor: None,
        across: Some(AcrossCombination {
            under: across,
            wind_towards_deg: blows.then_some(f64::from(worst.1)),
        }),
    })
}

fn towards(degrees: u32) -> [f64; 2] {
    let angle = f64::from(degrees).to_radians();
    match degrees % 90 {
        // to the last digit along the sides of the beds
        0 => [angle.cos().round(), angle.sin().round()],
        _ => [angle.cos(), angle.sin()],
    }
}

/// The factor on the loads that a joint resists; the moments of the tilt are added in the worse direction. `None` without a bed.
fn factor(parts: &[Parts], holds: &[JointHold], joint: usize, wind: [f64; 2]) -> Option<f64> {
    let JointHold::Bed(bed) = holds[joint] else {
        return None;
    };
    let acting = |of: &JointUnderLoads| of.moment_n_m.unwrap_or(of.rigid_moment_n_m);
    let of = |axis: usize| (&parts[axis].still.joints[joint], &parts[axis].blown.joints[joint]);
    let loads = [0, 1].map(|axis| {
        let (still, blown) = of(axis);
        (acting(still) + wind[axis] * acting(blown)).abs()
    });
    let tilt = [0, 1].map(|axis| of(axis).0.tilt_moment_n_m.abs());
    Some(bed.reach(of(0).0.axial_n, tilt, loads))
}
