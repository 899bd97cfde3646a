//! Restitution of rocking and of falling stones.

use super::{Case, ValidationError};
use crate::blocks::{Rigid, Springs, StackHistory, Start, simulate_rigid, simulate_springs};
use crate::structure::stack::{Block, JointMaterial, Solid, Stack};

const SOURCE: &str = "Restitution";
const NOTE: &str = "Rocking: a block of 0.4 × 1.0 × 2.0 m let go at half its slenderness angle, the ratio of its angular velocities about the first impact from \
                    the energies of its swings; published: the rocking_restitution given. Falls: a stone that falls flat by 0.1 m, the root of rebound over \
                    fall; published: the closed form of spring and dashpot, and the normal_restitution given.";
const GRAVITY_M_S2: f64 = 9.81;
const DENSITY_KG_M3: f64 = 2600.0;
const BLOCK_M: [f64; 3] = [0.4, 1.0, 2.0];
const STONE_M: [f64; 3] = [0.3, 0.2, 0.1];
const FALL_M: f64 = 0.1;

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let case = |what: String, published: f64, computed: f64, tolerance: f64| Case {
        source: SOURCE,
        what,
        unit: "",
        published,
        computed,
        tolerance,
        corrected: None,
        note: NOTE,
    };
    let mut cases = Vec::new();
    for given in [0.6, 0.9, 0.97] {
        let kept = rocking_kept(given)?;
        cases.push(case(
            format!("rigid law, rocking_restitution {given}"),
            given,
            kept,
            1e-3,
        ));
    }
    for damping_ratio in [0.05, 0.15] {
        let what = format!("springs law, fall on springs with a damping ratio of {damping_ratio}");
        let closed = JointMaterial::restitution_of(damping_ratio);
        let material = JointMaterial {
            damping_ratio,
            normal_restitution: closed,
            ..JointMaterial::default()
        };
        let options = Springs {
            duration_s: Some(0.5),
            output_step_s: 1e-3,
            starts: vec![dropped()],
            ..Springs::default()
        };
        let history = simulate_springs(&stone(STONE_M, material)?, None, &options, &mut |_| true)?;
        cases.push(case(what, closed, rebound(&history), 0.02));
    }
    let material = JointMaterial {
        normal_restitution: 0.6,
        ..JointMaterial::default()
    };
    let options = Rigid {
        duration_s: Some(0.5),
        output_step_s: 1e-3,
        starts: vec![dropped()],
        ..Rigid::default()
    };
    let history = simulate_rigid(&stone(STONE_M, material)?, None, &options, &mut |_| true)?;
    let what = "rigid law, fall with a normal_restitution of 0.6".to_owned();
    cases.push(case(what, 0.6, rebound(&history), 2e-3));
    Ok(cases)
}

fn stone([width, depth, height]: [f64; 3], material: JointMaterial) -> Result<Stack, ValidationError> {
    let block = Block {
        name: "stone".to_owned(),
        solid: Solid::cuboid(width, depth, height)?,
        density_kg_m3: DENSITY_KG_M3,
    };
    Ok(Stack::new(vec![block], material, GRAVITY_M_S2)?)
}

fn dropped() -> Start {
    Start {
        shift_m: [0.0, 0.0, FALL_M],
        ..Start::of(0)
    }
}

/// Square root of the height of the first rebound over the height of the fall.
fn rebound(history: &StackHistory) -> f64 {
    let landed_s = (2.0 * FALL_M / GRAVITY_M_S2).sqrt();
    let after = (0..history.time_s.len()).filter(|&sample| history.time_s[sample] > landed_s);
    let heights = after.map(|sample| history.pose(sample, 0).centroid_m[2] - 0.5 * STONE_M[2]);
    (heights.fold(0.0, f64::max) / FALL_M).sqrt()
}

/// Angular velocity after the first impact of free rocking over that before it.
///
/// ```text
/// E ∝ cos(α − θ) at rest, minus the value when upright:   r² = E_after / E_before
/// ```
fn rocking_kept(given: f64) -> Result<f64, ValidationError> {
    let [width, _, height] = BLOCK_M;
    let slenderness = width.atan2(height);
    let material = JointMaterial {
        rocking_restitution: Some(given),
        ..JointMaterial::with_friction(5.0)
    };
    let options = Rigid {
        duration_s: Some(1.6),
        output_step_s: 1e-3,
        starts: vec![Start {
            pivot_m: [0.5 * width, 0.0, 0.0],
            turn_rad: [0.0, 0.5 * slenderness, 0.0],
            ..Start::of(0)
        }],
        ..Rigid::default()
    };
    let history = simulate_rigid(&stone(BLOCK_M, material)?, None, &options, &mut |_| true)?;
    let turns = (0..history.time_s.len()).map(|sample| {
        let [w, _, y, _] = history.pose(sample, 0).rotation;
        2.0 * y.atan2(w)
    });
    let other_way = turns.map(|turn| -turn).fold(0.0, f64::max);
    let energy = |turn: f64| (slenderness - turn).cos() - slenderness.cos();
    Ok((energy(other_way) / energy(0.5 * slenderness)).sqrt())
}
