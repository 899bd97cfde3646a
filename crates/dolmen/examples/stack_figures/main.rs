//! Every measured number of `docs/stack-engine.md`, a line each: `cargo run --release -p dolmen --example stack_figures`.
//!
//! A word as argument runs only the cases whose name begins with it.
#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    clippy::disallowed_methods,
    reason = "a measurement that fails loudly and reads its own processor time"
)]

mod rocking;
mod sliding;
mod standing;
mod turning;

use dolmen::blocks::{
    AfterFall, ContactRule, Outcome, Springs, StackHistory, Start, simulate_springs, stack_modes,
};
use dolmen::comparisons::p10;
use dolmen::known::overturning::{Equation, Pulse, first_overturning};
use dolmen::known::rocking::{
    amplitude_rad, frequency_parameter_rad_s, impact_times_s, quarter_period_s, slenderness_rad,
    velocity_ratio,
};
use dolmen::known::sliding::{Friction, record_slip, sine_slip};
use dolmen::known::twisting::{
    disc_final_speed_ratio, rectangle_spin_deceleration_rad_s2, spin_down_angle_rad,
};
use dolmen::signal::{Component, GroundMotion};
use dolmen::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};

const GRAVITY_M_S2: f64 = 9.81;
const STONE_M: [f64; 3] = [0.3, 0.2, 0.1];
const HALF_WIDTH_M: f64 = 0.2;
const HALF_HEIGHT_M: f64 = 1.0;

fn main() {
    let wanted = std::env::args().nth(1).unwrap_or_default();
    let cases: [(&str, fn()); 12] = [
        ("rocking", rocking::rocking),
        ("step", rocking::step),
        ("restitution", rocking::restitution),
        ("overturning", rocking::overturning),
        ("sine", sliding::sine),
        ("record", sliding::record),
        ("twist", turning::twist),
        ("disc", turning::disc),
        ("frequency", turning::frequency),
        ("rest", standing::rest),
        ("yaw", standing::yaw),
        ("ramp", standing::ramp),
    ];
    for (name, case) in cases.into_iter().filter(|(name, _)| name.starts_with(&wanted)) {
        println!("# {name}");
        case();
    }
    if "wall".starts_with(&wanted) {
        println!("# wall");
        standing::wall();
    }
}

fn material(normal_stiffness_pa_m: f64, friction: f64) -> JointMaterial {
    JointMaterial {
        normal_stiffness_pa_m,
        shear_stiffness_pa_m: 0.4 * normal_stiffness_pa_m,
        ..JointMaterial::with_friction(friction)
    }
}

fn stone(size: [f64; 3], position_m: [f64; 3]) -> Block {
    let place = Placement {
        position_m,
        ..Placement::default()
    };
    Block {
        name: format!("stone at {position_m:?}"),
        solid: Solid::cuboid(size[0], size[1], size[2]).unwrap().placed(&place),
        density_kg_m3: 2600.0,
    }
}

fn pile(count: usize, material: JointMaterial, gravity_m_s2: f64) -> Stack {
    let blocks = (0..count).map(|i| stone(STONE_M, [0.0, 0.0, 0.1 * i as f64]));
    Stack::new(blocks.collect(), material, gravity_m_s2).unwrap()
}

fn run(stack: &Stack, motion: Option<&GroundMotion>, options: &Springs) -> StackHistory {
    simulate_springs(stack, motion, options, &mut |_| true).unwrap()
}

fn quality(history: &StackHistory) -> String {
    format!(
        "step {:.4} ms, made {:.1e}, {:?}",
        1e3 * history.time_step_s,
        history.energy_made_ratio(),
        history.outcome
    )
}

// Rocking: the block .4 × 2.0 m of Housner (1963).
