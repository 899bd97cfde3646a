//! A simulation, as JSON.

use super::judgement::judgement;
use super::stack::lean;
use super::with::with;
use crate::as_json;
use crate::stack_simulation::points_a_side;
use dolmen::blocks::{Outcome, PeakBearing, SlidingOutcome, StackHistory};
use dolmen::signal::{Component, GroundMotion, Processing};
use dolmen::structure::stack::{Body, Stack};
use dolmen_work::judgement::judge_stack_run;
use dolmen_work::motion::MotionAnswer;
use dolmen_work::stack::{LeftOut, Repeat, Repeats, SlidingMode, SlidingRun, StackRuns, StackSimulation};
use serde_json::Value;

/// The decisive run, as [`simulation_json`], with that of the other contact law.
pub fn stack_runs_json(runs: &StackRuns) -> Value {
    let left_out = runs.left_out.as_ref().map(|why| match why {
        LeftOut::TooLong { updates, most } => {
            as_json!({ "kind": "too_long", "updates": updates, "updates_most": most })
        }
        LeftOut::Refused { why } => as_json!({ "kind": "refused", "why": why }),
        LeftOut::NoSolution { at_s } => as_json!({ "kind": "no_solution", "at_s": at_s }),
    });
    let mut value = simulation_json(&runs.deciding);
    if let (falls @ 1.., Some(of)) = (runs.falls_in_repeats(), &runs.repeats) {
        value["outcome"] = as_json!({
            "kind": "fell", "runs": falls, "of_runs": of.runs.len(), "as_given": outcome(&runs.deciding),
        });
    }
    value["other_law"] = runs.other.as_ref().map(simulation_json).into();
    value["law_left_out"] = left_out.into();
    value["repeats"] = runs.repeats.as_ref().map(repeats).into();
    value["sliding_model"] = runs.sliding.as_ref().map(|run| sliding(run, runs)).into();
    value["laws_differ"] = runs
        .other
        .is_some()
        .then(|| runs.differing_states().is_some())
        .into();
    value
}

/// The sliding model, bed by bed.
fn sliding(run: &SlidingRun, runs: &StackRuns) -> Value {
    let history = &run.history;
    let (outcome, at_s) = match history.outcome {
        SlidingOutcome::Stuck => ("stuck", None),
        SlidingOutcome::Slid => ("slid", None),
        SlidingOutcome::Rocks { at_s, .. } => ("rocks", Some(at_s)),
        SlidingOutcome::LeftTheGround { at_s } => ("left_the_ground", Some(at_s)),
        SlidingOutcome::Stopped { at_s } => ("stopped", Some(at_s)),
    };
    let beds = history.joints.iter().enumerate().map(|(i, joint)| {
        as_json!({
            "above": runs.deciding.joint_names(i)[0],
            "mode": match run.mode(i) {
                SlidingMode::Stick => "stick",
                SlidingMode::Slide => "slide",
                SlidingMode::Twist => "twist",
                SlidingMode::SlideTwist => "slide_twist",
            },
            "peak_slip_m": joint.peak_slip_m,
            "residual_slip_m": joint.residual_slip_m(),
            "peak_turn_rad": joint.peak_yaw_rad,
            "residual_turn_rad": joint.residual_yaw_rad(),
            "moving_s": run.moving_s(i),
        })
    });
    as_json!({
        "outcome": outcome,
        "ended_at_s": at_s,
        "beds": beds.collect::<Vec<_>>(),
        "input_j": history.input_j,
        "friction_j": history.friction_j,
        "energy_error_j": history.energy_error_j,
        "steps": history.steps,
    })
}

/// The runs with small differences.
fn repeats(of: &Repeats) -> Value {
    let spread = |value: fn(&Repeat) -> f64| {
        let found = of.spread(value);
        found.map(|of| as_json!({ "least": of.least, "median": of.median, "most": of.most }))
    };
    let edge_m = if of.moves_edges {
        of.differences.bed_edge_m
    } else {
        0.0
    };
    as_json!({
        "runs": of.runs.len(),
        "is_stopped": of.is_stopped,
        "undecided": of.undecided,
        "seed": of.seed,
        "friction_share": of.differences.friction_share,
        "bed_edge_m": edge_m,
        "motion_share": of.differences.motion_share,
        "peak_opening_m": spread(|run| run.peak_opening_m),
        "peak_slip_m": spread(|run| run.peak_slip_m),
        "residual_slip_m": spread(|run| run.residual_slip_m),
        "damage_states": of.runs.iter().map(|run| run.state.number()).collect::<Vec<_>>(),
    })
}

/// A simulation without its histories: inputs, outcome, peaks and residuals, the energy balance.
pub fn simulation_json(simulation: &StackSimulation) -> Value {
    let (history, law) = (&simulation.history, &simulation.law);
    as_json!({
        "file": simulation.file,
        "name": { "en": simulation.name.en, "ko": simulation.name.ko },
        "variant": simulation.variant,
        "judgement": judgement(&judge_stack_run(simulation)),
        "motion": motion_json(&simulation.motion),
        "lean_as_surveyed": simulation.lean.as_ref().map(lean),
        "law": law.name(),
        "contact_points_a_side": points_a_side(law.contact_rule()),
        "contact_points": history.contact_points,
        "time_step_s": history.time_step_s,
        "longest_step_s": history.longest_step_s,
        "steps": history.steps,
        "output_step_s": law.output_step_s(),
        "duration_s": history.time_s.last(),
        "settlement_m": history.settlement_m,
        "outcome": outcome(simulation),
        "damage_state": simulation.damage.state.number(),
        "joints": joints(simulation),
        "blocks": blocks(simulation),
        "broken_ties": history.broken_ties,
        "energy": energy(simulation),
        "rigid": history.rigid.map(|rigid| as_json!({
            "residual_most_m_s": rigid.residual_most_m_s,
            "penetration_most_m": rigid.penetration_most_m,
            "impacts": rigid.impacts,
            "solutions": rigid.solutions,
            "newton_steps": rigid.newton_steps,
            "interior_solutions": rigid.interior_solutions,
            "softer_solutions": rigid.softer_solutions,
            "steps_at_rest": rigid.steps_at_rest,
            "loose_solutions": rigid.loose_solutions,
            "halvings": rigid.halvings,
        })),
    })
}

/// The motion of the base and its processing.
pub(super) fn motion_json(answer: &MotionAnswer) -> Value {
    let motion = &answer.motion;
    let file = |component: &Component| {
        let found = answer.files.iter().find(|(of, _)| of == component);
        found.map(|(_, file)| file.as_str())
    };
    let read = |component: &Component| {
        let found = answer.peaks_read_m_s2.iter().find(|(of, _)| of == component);
        found.map(|(_, peak)| *peak)
    };
    let components = Component::ALL.iter().filter(|component| motion.has(**component));
    as_json!({
        "name": motion.name(),
        "time_step_s": motion.time_step_s(),
        "samples": motion.length(),
        "duration_s": motion.duration_s(),
        "components": components.map(|component| as_json!({
            "component": component.name(),
            "file": file(component),
            "peak_read_m_s2": read(component),
            "peak_acceleration_m_s2": motion.component_peak_m_s2(*component),
        })).collect::<Vec<_>>(),
        "scale_factor": scale_factor(motion),
        "history": motion.history().iter().map(ToString::to_string).collect::<Vec<_>>(),
    })
}

/// The factor on the motion as read, of all scales together; `null` for two motions in sequence, each with its own.
fn scale_factor(motion: &GroundMotion) -> Option<f64> {
    let factors = motion.history().iter().map(|step| match step {
        Processing::Scaled { factor } => *factor,
        _ => 1.0,
    });
    (!motion.history().is_empty()).then(|| factors.product())
}

fn outcome(simulation: &StackSimulation) -> Value {
    let until_then = ending(simulation);
    match simulation.ended_before_the_motion_s() {
        Some(end_s) => {
            as_json!({ "kind": "ended_before_the_motion", "at_s": end_s, "until_then": until_then })
        }
        None => until_then,
    }
}

fn ending(simulation: &StackSimulation) -> Value {
    outcome_of(&simulation.stack, &simulation.history)
}

/// The outcome of a run.
pub(super) fn outcome_of(stack: &Stack, history: &StackHistory) -> Value {
    let name = |block: usize| stack.blocks().get(block).map(|b| b.name.as_str());
    let joint_names = |joint: usize| match stack.joints().get(joint) {
        Some(joint) => [stack.name(Body::Block(joint.upper)), stack.name(joint.lower)],
        None => ["", ""],
    };
    match history.outcome {
        Outcome::Stood => as_json!({ "kind": "stood" }),
        Outcome::Uplifted { joint, at_s } => {
            let [upper, lower] = joint_names(joint);
            as_json!({ "kind": "rocked_and_stood", "joint": joint, "upper": upper, "lower": lower, "at_s": at_s })
        }
        Outcome::Slid {
            block,
            slip_m,
            margin_ratio,
        } => {
            as_json!({ "kind": "slid", "block": name(block), "slip_m": slip_m, "margin_ratio": margin_ratio })
        }
        Outcome::Fell { block, joint, at_s } => {
            let [upper, lower] = joint_names(joint);
            as_json!({ "kind": "fell", "block": name(block), "joint": joint, "upper": upper, "lower": lower, "at_s": at_s })
        }
        Outcome::StillMoving {
            block,
            at_s,
            margin_ratio,
        } => {
            as_json!({ "kind": "still_moving", "block": name(block), "at_s": at_s, "margin_ratio": margin_ratio })
        }
        Outcome::Stopped { at_s } => as_json!({ "kind": "stopped", "at_s": at_s }),
        Outcome::NotConverged { at_s, residual_m_s } => {
            as_json!({ "kind": "not_converged", "at_s": at_s, "residual_m_s": residual_m_s })
        }
        Outcome::Diverged { at_s } => as_json!({ "kind": "diverged", "at_s": at_s }),
    }
}

fn joints(simulation: &StackSimulation) -> Vec<Value> {
    let each = simulation.history.joints.iter().enumerate();
    each.map(|(number, joint)| {
        let [upper, lower] = simulation.joint_names(number);
        as_json!({
            "upper": upper, "lower": lower,
            "peak_opening_m": joint.peak_opening_m,
            "peak_slip_m": joint.peak_slip_m,
            "peak_yaw_rad": joint.peak_yaw_rad,
            "residual_opening_m": joint.opening_m.last(),
            "residual_slip_m": joint.residual_slip_m(),
            "residual_yaw_rad": joint.residual_yaw_rad(),
            "bearing": joint.bearing.map(bearing),
        })
    })
    .collect()
}

/// The largest load of a joint relative to what its bed bears.
fn bearing(of: PeakBearing) -> Value {
    as_json!({
        "ratio": of.ratio,
        "crushes": of.crushes(),
        "at_s": of.at_s,
        "force_n": of.force_n,
        "bears_n": of.bears_n,
        "place_m": of.place_m,
    })
}

fn blocks(simulation: &StackSimulation) -> Vec<Value> {
    let last = simulation.poses(simulation.samples().saturating_sub(1));
    let (rest, each) = (simulation.poses(0), simulation.stack.blocks().iter().zip(last));
    each.zip(rest)
        .map(|((block, now), rest)| {
            let moved: [f64; 3] = std::array::from_fn(|axis| now.centroid_m[axis] - rest.centroid_m[axis]);
            as_json!({ "name": block.name, "residual_displacement_m": moved, "rotation": now.rotation })
        })
        .collect()
}

fn energy(simulation: &StackSimulation) -> Value {
    let history = &simulation.history;
    let end = history.energy.last().copied().unwrap_or_default();
    with(
        &end,
        as_json!({ "made_j": history.energy_made_j, "made_ratio": history.energy_made_ratio() }),
    )
}
