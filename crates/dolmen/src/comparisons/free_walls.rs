//! A free wall shaken out of its plane, with both contact laws and with the equation of one rocking body.

use super::second_methods::el_centro;
use super::{Case, ValidationError};
use crate::blocks::{ContactRule, Rigid, Springs, StackHistory, simulate_rigid, simulate_springs};
use crate::dynamics::{Rocking, RockingBlock, TimeFunction, rock_block};
use crate::signal::{Component, GroundMotion};
use crate::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};

const SOURCE: &str = "A free wall under El Centro";
const NOTE: &str = "A wall 0.6 m thick and 3 m high, El Centro 1940 north–south times 1.3 (0.4145 g) out of its plane, first 6 s: largest rotation of its \
                    lowest course over its slenderness angle. Published: Housner's equation of one rocking body, 0.4838 by SciPy too. Springs of 1e10 Pa/m with a \
                    damping ratio of 1 and contact at the corners stand for his impacts.";
const GRAVITY_M_S2: f64 = 9.80665;
const DENSITY_KG_M3: f64 = 2400.0;
const THICKNESS_M: f64 = 0.6;
const LENGTH_M: f64 = 1.6;
const HEIGHT_M: f64 = 3.0;
/// Scaled peak of El Centro, whose own peak is 0.31882 g.
const PEAK_G: f64 = 1.3 * 0.31882;
const STEP_S: f64 = 0.02;
const DURATION_S: f64 = 6.0;

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let published = one_body()?;
    let case = |what: &str, computed: f64, tolerance: f64| Case {
        source: SOURCE,
        what: what.to_owned(),
        unit: "",
        published,
        computed,
        tolerance,
        corrected: None,
        note: NOTE,
    };
    Ok(vec![
        case("rigid law, one stone", rigid(1)?, 5e-4),
        case("springs law, one stone", springs()?, 0.01),
        case("rigid law, five courses", rigid(5)?, 0.015),
    ])
}

fn ground() -> Vec<f64> {
    el_centro().iter().map(|a| a * PEAK_G * GRAVITY_M_S2).collect()
}

/// Largest rotation of one rocking body, over its slenderness angle.
fn one_body() -> Result<f64, ValidationError> {
    let block = RockingBlock::rectangle(THICKNESS_M, HEIGHT_M, GRAVITY_M_S2)?;
    let motion = TimeFunction::Sampled {
        time_step_s: STEP_S,
        values: ground(),
    };
    let options = Rocking {
        duration_s: Some(DURATION_S),
        ..Rocking::default()
    };
    let history = rock_block(&block, &motion, &TimeFunction::Zero, &options)?;
    Ok(history.peak_rotation_rad / block.slenderness_rad)
}

/// The wall in courses of one stone each.
fn wall(courses: usize, material: JointMaterial) -> Result<Stack, ValidationError> {
    let height_m = HEIGHT_M / courses as f64;
    let solid = Solid::cuboid(LENGTH_M, THICKNESS_M, height_m)?;
    let course = |i: usize| Block {
        name: format!("course {}", i + 1),
        solid: solid.placed(&Placement {
            position_m: [0.0, 0.0, height_m * i as f64],
            ..Placement::default()
        }),
        density_kg_m3: DENSITY_KG_M3,
    };
    Ok(Stack::new(
        (0..courses).map(course).collect(),
        material,
        GRAVITY_M_S2,
    )?)
}

fn motion() -> Result<GroundMotion, ValidationError> {
    Ok(GroundMotion::new(
        "El Centro NS",
        STEP_S,
        vec![(Component::Y, ground())],
    )?)
}

fn rigid(courses: usize) -> Result<f64, ValidationError> {
    let options = Rigid {
        duration_s: Some(DURATION_S),
        ..Rigid::default()
    };
    let stack = wall(courses, JointMaterial::with_friction(5.0))?;
    let history = simulate_rigid(&stack, Some(&motion()?), &options, &mut |_| true)?;
    Ok(largest_turn(&history))
}

fn springs() -> Result<f64, ValidationError> {
    let material = JointMaterial {
        normal_stiffness_pa_m: 1e10,
        shear_stiffness_pa_m: 4e9,
        damping_ratio: 1.0,
        ..JointMaterial::with_friction(5.0)
    };
    let options = Springs {
        contact_rule: ContactRule::Corners,
        duration_s: Some(DURATION_S),
        ..Springs::default()
    };
    let history = simulate_springs(&wall(1, material)?, Some(&motion()?), &options, &mut |_| true)?;
    Ok(largest_turn(&history))
}

/// Largest rotation of the lowest course about x, over the slenderness angle of the wall.
fn largest_turn(history: &StackHistory) -> f64 {
    let turns = (0..history.time_s.len()).map(|sample| {
        let [w, x, _, _] = history.pose(sample, 0).rotation;
        (2.0 * x.atan2(w)).abs()
    });
    turns.fold(0.0, f64::max) / THICKNESS_M.atan2(HEIGHT_M)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// SciPy 1.17.1, DOP853 restarted at every sample and event (as in tests/validation/rocking_block_el_centro.py, 0.6 × 3.0 m).
    #[test]
    fn agrees_one_body_with_scipy() {
        assert!(
            (one_body().unwrap() - 0.4838).abs() < 1e-4,
            "{}",
            one_body().unwrap()
        );
    }

    #[test]
    fn holds_both_laws_rock_the_wall_as_one_body() {
        for case in cases().unwrap() {
            assert!(
                case.agrees(),
                "{}: {} {}",
                case.what,
                case.computed,
                case.published
            );
        }
    }
}
