//! The two contact laws against independent methods: one rocking block from event to event, and the sliding model.

use super::{Case, ValidationError};
use crate::blocks::{
    ContactRule, Rigid, Sliding, Springs, StackHistory, Start, simulate_rigid, simulate_sliding,
    simulate_springs,
};
use crate::dynamics::{Rocking, RockingBlock, TimeFunction, rock_block};
use crate::signal::{Component, GroundMotion, SignalError};
use crate::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};
use std::fmt;

const SOURCE: &str = "Second methods";
const GRAVITY_M_S2: f64 = 9.81;
const MM: f64 = 1e-3;
/// Friction of the blocks, from the ground up, chosen so that all joints slide at different times.
const FRICTION: [f64; 3] = [0.20, 0.18, 0.16];

const SLIDING: &str = "Second methods, blocks of 0.3 × 0.2 × 0.1 m, μ 0.20, 0.18, 0.16 from the ground up: El Centro NS at 0.3 g along \
                       x and 0.6 of it backwards along y (the record's other component is not shipped), 10 s. Published: the sliding \
                       model, event by event.";
const RIGID_SLIDES: &str =
    "The rigid law ends slips at the ends of its steps of 1 ms: its error falls in proportion to the step.";
const SPRINGS_SLIDE: &str = "On springs (k_n 1e9, k_s 4e8 Pa/m) a stone that stops rings on its bed, and the next slip begins sooner or \
                             later for it: the difference falls with 1/√k and is physics of springs, not of steps.";
const ROCKING: &str = "Second methods, block of 0.4 × 1 × 2 m: published are the times by events, exact between them. The rigid law's \
                       step is 1 ms. The springs (k_n 1e12 Pa/m, corners, damping 1: Housner's impact) yield under the edge: with 1e11 and \
                       1e10 Pa/m they peak at 0.132 and 0.110 rad under the record.";

fn stone(name: String, solid: &Solid, z: f64) -> Block {
    let place = Placement {
        position_m: [0.0, 0.0, z],
        ..Placement::default()
    };
    Block {
        name,
        solid: solid.placed(&place),
        density_kg_m3: 2600.0,
    }
}

/// El Centro 1940 north-south from the repository, over its peak.
pub(super) fn el_centro() -> Vec<f64> {
    let text = include_str!("../../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");
    let values: Vec<f64> = text
        .lines()
        .skip(1)
        .filter_map(|line| line.split_once(',')?.1.parse().ok())
        .collect();
    let peak = values.iter().fold(0.0, |most: f64, a| most.max(a.abs()));
    values.iter().map(|a| a / peak).collect()
}

/// Its first seconds along x and, reversed in time and multiplied by `across`, along y.
fn shaking(peak_g: f64, across: f64, seconds: f64) -> Result<GroundMotion, SignalError> {
    let x: Vec<f64> = el_centro().iter().map(|a| a * peak_g * GRAVITY_M_S2).collect();
    let y = x.iter().rev().map(|a| across * a).collect();
    GroundMotion::new("El Centro NS", 0.02, vec![(Component::X, x), (Component::Y, y)])?.keep_first(seconds)
}

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let mut cases = rocking()?;
    for blocks in 1..=FRICTION.len() {
        cases.extend(sliding(blocks)?);
    }
    Ok(cases)
}

/// Blocks of paper 003, one to three high: peak slip of each joint, and rotation of the highest block.
fn sliding(blocks: usize) -> Result<Vec<Case>, ValidationError> {
    const RIGID: f64 = 0.001; // of the slip; measured below .05 %
    const SPRINGS: f64 = 0.02; // of the slip; measured below 1.3 %
    let solid = Solid::cuboid(0.3, 0.2, 0.1)?;
    let stones = (0..blocks).map(|i| stone(format!("block {}", i + 1), &solid, 0.1 * i as f64));
    let mut stack = Stack::new(stones.collect(), JointMaterial::default(), GRAVITY_M_S2)?;
    for (joint, mu) in FRICTION.iter().enumerate().take(blocks) {
        stack = stack.with_material(joint, JointMaterial::with_friction(*mu))?;
    }
    let motion = shaking(0.3, 0.6, 10.0)?;
    let by_events = simulate_sliding(&stack, Some(&motion), &Sliding::default(), &mut |_| true)?;
    let rigid = simulate_rigid(&stack, Some(&motion), &Rigid::default(), &mut |_| true)?;
    let springs = simulate_springs(&stack, Some(&motion), &Springs::default(), &mut |_| true)?;
    let mut cases = Vec::new();
    let laws: [(&str, &StackHistory, f64, &'static str); 2] = [
        ("rigid law", &rigid, RIGID, RIGID_SLIDES),
        ("springs", &springs, SPRINGS, SPRINGS_SLIDE),
    ];
    for (law, history, part, note) in laws {
        for joint in 0..blocks {
            let peak_m = by_events.joints[joint].peak_slip_m;
            cases.push(Case {
                source: SOURCE,
                what: format!("{blocks} high, {law}: peak slip of joint {}", joint + 1),
                unit: "mm",
                published: peak_m / MM,
                computed: history.joints[joint].peak_slip_m / MM,
                tolerance: part * peak_m / MM,
                corrected: None,
                note: if joint == 0 { SLIDING } else { note },
            });
        }
    }
    Ok(cases)
}

#[derive(Clone, Copy)]
enum Law {
    Rigid,
    Springs,
}

impl fmt::Display for Law {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Law::Rigid => "rigid law",
            Law::Springs => "springs",
        })
    }
}

/// The block of Housner's cases, released and shaken.
fn rocking() -> Result<Vec<Case>, ValidationError> {
    let block = RockingBlock::rectangle(0.4, 2.0, GRAVITY_M_S2)?;
    let start_rad = 0.5 * block.slenderness_rad;
    let let_go = Rocking {
        start_rad,
        duration_s: Some(4.0),
        ..Rocking::default()
    };
    let free = rock_block(&block, &TimeFunction::Zero, &TimeFunction::Zero, &let_go)?;
    let motion = shaking(0.35, 0.0, 8.0)?;
    let ground = TimeFunction::of_motion(&motion, Component::X);
    let shaken = rock_block(&block, &ground, &TimeFunction::Zero, &Rocking::default())?;
    let material = JointMaterial {
        normal_stiffness_pa_m: 1e12,
        shear_stiffness_pa_m: 4e11,
        damping_ratio: 1.0,
        ..JointMaterial::with_friction(5.0)
    };
    let solid = Solid::cuboid(0.4, 1.0, 2.0)?;
    let stack = Stack::new(
        vec![stone("stone".to_owned(), &solid, 0.0)],
        material,
        GRAVITY_M_S2,
    )?;
    let turned = Start {
        pivot_m: [0.2, 0.0, 0.0],
        turn_rad: [0.0, start_rad, 0.0],
        ..Start::of(0)
    };
    let mut cases = Vec::new();
    for law in [Law::Rigid, Law::Springs] {
        let run = |motion: Option<&GroundMotion>, starts: Vec<Start>| match law {
            Law::Springs => {
                let options = Springs {
                    contact_rule: ContactRule::Corners,
                    duration_s: motion.is_none().then_some(4.0),
                    output_step_s: 1e-3,
                    starts,
                    ..Springs::default()
                };
                simulate_springs(&stack, motion, &options, &mut |_| true)
            }
            Law::Rigid => {
                let options = Rigid {
                    duration_s: motion.is_none().then_some(4.0),
                    output_step_s: 1e-3,
                    starts,
                    ..Rigid::default()
                };
                simulate_rigid(&stack, motion, &options, &mut |_| true)
            }
        };
        let impacts = impact_times_s(&run(None, vec![turned])?);
        for n in [1, 5] {
            cases.push(Case {
                source: SOURCE,
                what: format!("{law}: time of impact {n} of a block let go at α/2"),
                unit: "s",
                published: free.impacts.get(n - 1).map_or(f64::NAN, |impact| impact.at_s),
                computed: impacts.get(n - 1).copied().unwrap_or(f64::NAN),
                tolerance: 0.01,
                corrected: None,
                note: ROCKING,
            });
        }
        let history = run(Some(&motion), Vec::new())?;
        let tilts = tilts_rad(&history);
        cases.push(Case {
            source: SOURCE,
            what: format!("{law}: peak rotation under 8 s of El Centro NS at 0.35 g"),
            unit: "rad",
            published: shaken.peak_rotation_rad,
            computed: tilts.iter().fold(0.0, |most: f64, tilt| most.max(tilt.abs())),
            tolerance: 0.01 * shaken.peak_rotation_rad,
            corrected: None,
            note: ROCKING,
        });
    }
    Ok(cases)
}

/// Rotation of the only block about y, rad.
fn tilts_rad(history: &StackHistory) -> Vec<f64> {
    let samples = 0..history.time_s.len();
    let tilt = |sample| {
        let [w, _, y, _] = history.pose(sample, 0).rotation;
        2.0 * f64::atan2(y, w)
    };
    samples.map(tilt).collect()
}

/// Times at which the rotation changes its sign, by linear interpolation between samples, s.
fn impact_times_s(history: &StackHistory) -> Vec<f64> {
    let tilts = tilts_rad(history);
    let crossing = |i: usize| {
        let (a, b) = (tilts[i], tilts[i + 1]);
        (a * b < 0.0).then(|| history.time_s[i] + (history.time_s[i + 1] - history.time_s[i]) * a / (a - b))
    };
    (0..tilts.len().saturating_sub(1)).filter_map(crossing).collect()
}
