//! A simulation of a chain, as JSON.

use super::simulation::motion_json;
use crate::as_json;
use crate::limits::parts_json;
use dolmen::dynamics::{ChainOutcome, ChainRotations, JointFriction};
use dolmen_work::chain::ChainSimulation;
use serde_json::Value;

/// A simulation without its histories.
pub fn chain_simulation_json(simulation: &ChainSimulation) -> Value {
    let (history, model) = (&simulation.history, &simulation.model);
    let end = history.energy.last().copied().unwrap_or_default();
    let links = simulation.links.iter().enumerate().map(|(i, name)| {
        let (peak, across, joint) = (
            history.rotation_peaks[i],
            history.joint_peaks[i],
            model.joints()[i],
        );
        let most = model.moment_most_n_m()[i];
        as_json!({
            "name": name,
            "stiffness_n_m_rad": joint.stiffness_n_m_rad,
            "damping_n_m_s_rad": joint.damping_n_m_s_rad,
            "opening_moment_n_m": most.is_finite().then_some(most),
            "friction": match joint.friction {
                JointFriction::None => Value::Null,
                JointFriction::Coulomb { static_moment_n_m, kinetic_moment_n_m } => as_json!({
                    "static_moment_n_m": static_moment_n_m, "kinetic_moment_n_m": kinetic_moment_n_m,
                }),
            },
            "peak_rotation_rad": peak.rotation_rad, "peak_rotation_at_s": peak.at_s,
            "peak_joint_rotation_rad": across.rotation_rad, "peak_joint_rotation_at_s": across.at_s,
            "peak_moment_at_samples_n_m": simulation.joint_moment_peak_n_m(i),
            "taken_as_rigid": history.rigid_joints.iter().any(|rigid| rigid.joint == i),
            "open_s": simulation.history.open_s(i),
            "slipped_rad": simulation.history.slipped_rad(i),
            "residual_rotation_rad": history.rotation_rad[i].last(),
        })
    });
    as_json!({
        "file": simulation.file,
        "name": { "en": simulation.name.en, "ko": simulation.name.ko },
        "variant": simulation.variant,
        "motion": simulation.motion.as_ref().map(|(motion, _)| motion_json(motion)),
        "component": simulation.motion.as_ref().map(|(_, component)| component.name()),
        "direction": simulation.direction.map(|axis| axis.name()),
        "together": simulation.together.map(|of| as_json!({
            "peak_rotation_rad": of.lean_rad, "link": simulation.links.get(of.link), "at_s": of.at_s, "top_peak_m": of.top_m,
        })),
        "push_rad": simulation.push_rad,
        "pushed_from_link": simulation.links[simulation.pushed_from],
        "lean_as_surveyed": simulation.lean.as_ref().map(|lean| as_json!({
            "survey": lean.survey, "written": lean.written, "lean_rad": lean.lean_rad,
        })),
        "rotations": match model.rotations() {
            ChainRotations::Large => "large",
            ChainRotations::Small => "small",
        },
        "output_step_s": simulation.options.output_step_s,
        "fall_rad": simulation.options.fall_rad,
        "undamped": simulation.undamped.is_some(),
        "carried_weight_n": simulation.carried_n,
        "loads_left_out": simulation.loads_left_out,
        "duration_s": simulation.duration_s(),
        "first_frequency_hz": simulation.first_frequency_hz,
        "growth": simulation.growth.as_ref().map(|growth| as_json!({
            "linear_rate_per_s": growth.linear_rate_per_s,
            "rate_per_s": growth.measured.map(|m| m.rate_per_s),
            "from_s": growth.measured.map(|m| m.from_s),
            "to_s": growth.measured.map(|m| m.to_s),
        })),
        "outcome": outcome(simulation),
        "limits": parts_json(&simulation.parts(), None),
        "at_rest": history.at_rest,
        "friction_events": history.friction_events,
        "steps": history.steps,
        "links": links.collect::<Vec<_>>(),
        "side_supports": simulation.supports_met().iter().map(|met| as_json!({
            "height_m": met.support.height_m, "gap_m": met.support.gap_m, "stiffness_n_m": met.support.stiffness_n_m,
            "times_met": met.times, "first_met_s": met.first_s,
            "peak_displacement_m": met.peak.displacement_m, "peak_force_n": met.peak.force_n, "peak_at_s": met.peak.at_s,
        })).collect::<Vec<_>>(),
        "top_peak_m": history.top_peak_m, "top_peak_at_s": history.top_peak_at_s,
        "energy": {
            "input_j": end.input_j, "kinetic_j": end.kinetic_j, "gravity_j": end.gravity_j, "springs_j": end.springs_j,
            "friction_j": end.friction_j, "damping_j": end.damping_j, "left_over_ratio": history.energy_left_over_ratio,
        },
    })
}

fn outcome(simulation: &ChainSimulation) -> Value {
    let until_then = ending(simulation);
    match simulation.ended_before_the_motion_s() {
        Some(end_s) => {
            as_json!({ "kind": "ended_before_the_motion", "at_s": end_s, "until_then": until_then })
        }
        None => until_then,
    }
}

fn ending(simulation: &ChainSimulation) -> Value {
    match simulation.history.outcome {
        ChainOutcome::Stood => as_json!({ "kind": "stood" }),
        ChainOutcome::Uplifted { joint, at_s } => {
            as_json!({ "kind": "opened", "joint_below": simulation.links.get(joint), "at_s": at_s })
        }
        ChainOutcome::Fell { link, at_s } => {
            as_json!({ "kind": "fell", "link": simulation.links.get(link), "at_s": at_s })
        }
        ChainOutcome::StillLeaning { link, at_s } => {
            as_json!({ "kind": "still leaning", "link": simulation.links.get(link), "at_s": at_s })
        }
        ChainOutcome::Stopped { at_s } => as_json!({ "kind": "stopped", "at_s": at_s }),
    }
}
