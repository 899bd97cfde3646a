//! A simulated motion of a chain, as text.

use super::Table;
use dolmen::dynamics::{ChainOutcome, JointFriction};
use dolmen_words::number;
use dolmen_work::chain::ChainSimulation;
use std::fmt::Write as _;

/// Digits of stiffness and moments.
const DIGITS: usize = 6;

/// What the chain is, how it ended, each link and joint, the balance of energy.
pub fn chain_simulation_text(simulation: &ChainSimulation) -> String {
    let mut out = chain_text(simulation);
    out += &start_text(simulation);
    let _ = writeln!(out, "\n{}", chain_outcome_text(simulation));
    out += &beds_text(simulation);
    out += &growth_text(simulation);
    out += &links_text(simulation);
    out += &energy_text(simulation);
    out
}

/// How it ended, in one sentence that begins with a fixed word.
pub fn chain_outcome_text(simulation: &ChainSimulation) -> String {
    let sentence = ending(simulation);
    match (simulation.ended_before_the_motion_s(), &simulation.motion) {
        (Some(end_s), Some((motion, _))) => motion.cut_words(end_s) + &sentence,
        _ => sentence,
    }
}

/// What beds did that this run does not follow, as lines of notes.
fn beds_text(simulation: &ChainSimulation) -> String {
    let mut out = String::new();
    let held = simulation.held_joints();
    if !held.is_empty() {
        let each: Vec<String> = held
            .iter()
            .map(|(joint, bed_m)| format!("'{}' {:.2} m", simulation.link(*joint), bed_m))
            .collect();
        let _ = writeln!(
            out,
            "note: {} of {} joints have no bed that can open (no bed_width, or opening = \"held\") and pass any moment here. The beds it would take, \
             2 M/N: {}",
            held.len(),
            simulation.links.len(),
            each.join(", ")
        );
    }
    let opened = simulation.opened_beds();
    if !opened.is_empty() {
        let each: Vec<String> = opened
            .iter()
            .map(|joint| format!("'{}'", simulation.link(*joint)))
            .collect();
        let _ = writeln!(
            out,
            "note: beds opened on one side, beyond a third of the moment at their edge, below {}: of stone, springs are softer from there on than \
             this run takes them",
            each.join(", ")
        );
    }
    out
}

fn ending(simulation: &ChainSimulation) -> String {
    let history = &simulation.history;
    let state = || {
        let last = history.rotation_rad.last().and_then(|row| row.last());
        let moving = if history.at_rest {
            "at rest"
        } else {
            "still moving"
        };
        let lean_mrad = 1e3 * last.copied().unwrap_or_default();
        format!("at the end it is {moving}, its top link {lean_mrad:.3} mrad off the vertical")
    };
    match history.outcome {
        ChainOutcome::Stood if simulation.held_joints().len() == simulation.links.len() => {
            format!("STOOD: with joints that cannot open; {}", state())
        }
        ChainOutcome::Stood => format!("STOOD: no bed came to its edge; {}", state()),
        ChainOutcome::Uplifted { joint, at_s } => format!(
            "OPENED: the bed below '{}' came to its edge first, at {at_s:.2} s, and the chain still stands; {}",
            simulation.link(joint),
            state()
        ),
        ChainOutcome::Fell { link, at_s } => format!(
            "FELL: '{}' leaned by {:.0}° at {at_s:.2} s",
            simulation.link(link),
            simulation.options.fall_rad.to_degrees()
        ),
        ChainOutcome::StillLeaning { link, at_s } => format!(
            "STILL LEANING: at the end, {at_s:.2} s, '{}' leans further out than in the time before and goes on: whether the chain falls \
             is not known; give a longer --duration; {}",
            simulation.link(link),
            state()
        ),
        ChainOutcome::Stopped { at_s } => format!(
            "STOPPED at {at_s:.2} s before its end: what follows is of the part that was done, and no verdict"
        ),
    }
}

fn kn_m(moment_n_m: f64) -> String {
    number::trimmed(1e-3 * moment_n_m, DIGITS)
}

fn chain_text(simulation: &ChainSimulation) -> String {
    let model = &simulation.model;
    let heads = [
        "joint below",
        "spring, kN m/rad",
        "dashpot, kN m s/rad",
        "on its edge at, kN m",
        "friction, kN m",
    ];
    let mut table = Table::new(&heads, 1);
    for (i, joint) in model.joints().iter().enumerate() {
        let most = model.moment_most_n_m()[i];
        table.row(vec![
            simulation.link(i).to_owned(),
            kn_m(joint.stiffness_n_m_rad),
            kn_m(joint.damping_n_m_s_rad),
            if most.is_finite() {
                kn_m(most)
            } else {
                "held".to_owned()
            },
            match joint.friction {
                JointFriction::None => "none".to_owned(),
                JointFriction::Coulomb {
                    static_moment_n_m,
                    kinetic_moment_n_m,
                } if static_moment_n_m == kinetic_moment_n_m => kn_m(kinetic_moment_n_m),
                JointFriction::Coulomb {
                    static_moment_n_m,
                    kinetic_moment_n_m,
                } => format!("{} then {}", kn_m(static_moment_n_m), kn_m(kinetic_moment_n_m)),
            },
        ]);
    }
    format!("\n{}", table.text())
}

fn start_text(simulation: &ChainSimulation) -> String {
    let mut out = String::new();
    if simulation.push_rad != 0.0 {
        let _ = writeln!(
            out,
            "At the start the whole chain leans by {} rad",
            number::trimmed(simulation.push_rad, DIGITS)
        );
    }
    match (simulation.first_frequency_hz, &simulation.growth) {
        (Some(hz), _) => {
            let _ = writeln!(out, "Upright it stands by itself: lowest frequency {hz:.4} Hz");
        }
        (None, Some(growth)) => {
            let _ = writeln!(
                out,
                "Upright it does NOT stand by itself: small leans grow by e every {:.4} s",
                1.0 / growth.linear_rate_per_s
            );
        }
        (None, None) => {}
    }
    out
}

fn growth_text(simulation: &ChainSimulation) -> String {
    let Some(growth) = &simulation.growth else {
        return String::new();
    };
    let linear = growth.linear_rate_per_s;
    match &growth.measured {
        Some(measured) => format!(
            "Growth of the shape that falls fastest, from 10 to 100 times the push ({:.2} to {:.2} s): {:.5} 1/s; linear equations \
             {linear:.5} 1/s ({:+.2} %)\n",
            measured.from_s,
            measured.to_s,
            measured.rate_per_s,
            100.0 * (measured.rate_per_s / linear - 1.0)
        ),
        None => String::new(),
    }
}

fn links_text(simulation: &ChainSimulation) -> String {
    let history = &simulation.history;
    let heads = [
        "link",
        "leaned, mrad",
        "at, s",
        "joint turned, mrad",
        "moment, kN m",
        "open, s",
        "slipped, mrad",
        "at the end, mrad",
    ];
    let mut table = Table::new(&heads, 1);
    for link in 0..simulation.links.len() {
        let peak = history.rotation_peaks[link];
        let last = history.rotation_rad[link].last().copied().unwrap_or_default();
        table.row(vec![
            simulation.link(link).to_owned(),
            format!("{:.3}", 1e3 * peak.rotation_rad.abs()),
            format!("{:.2}", peak.at_s),
            format!("{:.3}", 1e3 * history.joint_peaks[link].rotation_rad.abs()),
            format!("{:.3}", 1e-3 * simulation.joint_moment_peak_n_m(link)),
            format!("{:.2}", simulation.history.open_s(link)),
            format!("{:.3}", 1e3 * simulation.history.slipped_rad(link)),
            format!("{:.3}", 1e3 * last + 0.0),
        ]);
    }
    format!(
        "Each link and the joint below it: peaks between the samples too, moments at the samples\n{}The top moved {:.1} mm at most, at \
         {:.2} s\n",
        table.text(),
        1e3 * history.top_peak_m.abs(),
        history.top_peak_at_s
    )
}

fn energy_text(simulation: &ChainSimulation) -> String {
    let history = &simulation.history;
    let end = history.energy.last().copied().unwrap_or_default();
    let friction = if simulation.model.has_friction() {
        format!(", exact between {} changes of friction", history.friction_events)
    } else {
        String::new()
    };
    format!(
        "Energy, J: at the start and put in {:.3e} = moving {:.3e} + weight {:.3e} + in springs {:.3e} + friction {:.3e} + dashpots {:.3e}; \
         left over at most {:.1e} of the largest moving\nRun: {} steps of Taylor series{friction}, {:.2} s\n",
        end.input_j,
        end.kinetic_j,
        end.gravity_j,
        end.springs_j,
        end.friction_j,
        end.damping_j,
        history.energy_left_over_ratio,
        history.steps,
        simulation.duration_s()
    )
}
