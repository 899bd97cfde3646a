//! A simulation of a frame, as JSON.

use super::simulation::motion_json;
use crate::as_json;
use crate::limits::parts_json;
use dolmen::dynamics::{
    ColumnOutcome, FrameOutcome, FrictionActsOn, RockingOutcome, StoreyFriction, TenonFace,
};
use dolmen_work::frame::{
    ColumnsInMotion, ColumnsOnBeds, FrameBeside, FrameSimulation, FrameTogether, SensorBeside,
};
use serde_json::Value;

/// A simulation without its histories.
pub fn frame_simulation_json(simulation: &FrameSimulation) -> Value {
    let (history, options) = (&simulation.history, &simulation.options);
    let end = history.energy.last().copied().unwrap_or_default();
    let storeys = simulation.storeys.iter().enumerate().map(|(i, name)| {
        let (drift, level) = (history.drift_peaks[i], history.displacement_peaks[i]);
        let below = i.checked_sub(1).map_or(0.0, |j| history.rest_m[j]);
        as_json!({
            "name": name,
            "stiffness_n_m": simulation.frame.stiffness_n_m()[i],
            "friction": friction(&simulation.frame.friction()[i]),
            "tenons": tenons(simulation, i),
            "peak_drift_m": drift.value_m, "peak_drift_at_s": drift.at_s, "peak_drift_at_samples_m": drift.at_samples_m,
            "peak_displacement_m": level.value_m, "peak_displacement_at_s": level.at_s,
            "peak_displacement_at_samples_m": level.at_samples_m,
            "residual_drift_m": history.rest_m[i] - below,
            "residual_displacement_m": history.rest_m[i],
            "displacement_at_end_m": history.residual_m[i],
            "slipped_way_m": history.slipped_way_m(i),
            "slipping_share": history.slipping_share(i),
        })
    });
    as_json!({
        "file": simulation.file,
        "name": { "en": simulation.name.en, "ko": simulation.name.ko },
        "variant": simulation.variant,
        "direction": simulation.direction,
        "component": simulation.component.name(),
        "motion": motion_json(&simulation.motion),
        "friction_acts_on": match simulation.frame.acts_on() {
            FrictionActsOn::Drift => "drift",
            FrictionActsOn::Displacement => "displacement",
        },
        "output_step_s": options.output_step_s,
        "undamped": simulation.undamped.is_some(),
        "measured": simulation.beside.as_ref().map(beside),
        "carried_weight_n": simulation.carried_n,
        "loads_left_out": simulation.loads_left_out,
        "leaves_columns_out": simulation.columns != ColumnsInMotion::Absent && simulation.on_beds().is_none(),
        "columns_alone": columns_alone(&simulation.columns),
        "beds_beside_joints": beside_joints(&simulation.columns),
        "all_stiffness_in_beds": simulation.all_in_beds.as_ref().map(|of| columns_on_beds(&of.run)),
        "softening_not_followed": simulation.unfollowed.iter().filter(|of| of.lifts_off()).map(|of| as_json!({
            "storey": of.name,
            "is_bed_stiffness_given": of.beds.is_file(),
            "drift_linear": of.drift,
            "lift_off_drift": of.uplift,
        })).collect::<Vec<_>>(),
        "together": simulation.together.as_ref().map(together),
        "lean": simulation.lean.as_ref().map(|lean| as_json!({
            "survey": lean.survey, "tilt": lean.written, "tilt_in_direction": simulation.tilt,
        })),
        "duration_s": history.time_s.last(),
        "outcome": outcome(simulation),
        "limits": parts_json(&simulation.parts(), simulation.drift_limit.as_ref()),
        "at_rest": history.at_rest,
        "events": history.events,
        "steps": history.steps,
        "storeys": storeys.collect::<Vec<_>>(),
        "energy": {
            "input_j": end.input_j, "kinetic_j": end.kinetic_j, "stored_j": end.stored_j, "friction_j": end.friction_j,
            "crushing_j": end.crushing_j,
            "damping_j": end.damping_j, "left_over_ratio": history.energy_left_over_ratio(),
        },
    })
}

/// The tenons of a storey, as built and at the end.
fn tenons(simulation: &FrameSimulation, storey: usize) -> Value {
    let built = simulation.frame.tenons().get(storey).copied().flatten();
    let Some(tenon) = built else {
        return Value::Null;
    };
    let faces = simulation.history.tenons.get(storey).copied().flatten();
    let face = |face: TenonFace| as_json!({ "slack_m": face.gap_m, "crushed_m": face.crushed_m, "stiffness_n_m": face.stiffness_n_m });
    as_json!({
        "slack_m": tenon.slack_m,
        "stiffness_n_m": tenon.stiffness_n_m,
        "crushing_force_n": tenon.crushing_force_n,
        "half_stiffness_depth_m": tenon.half_stiffness_depth_m,
        "faces_at_end": faces.map(|faces| faces.map(face)),
    })
}

/// The run compared with the measurement of a survey.
fn beside(of: &FrameBeside) -> Value {
    let sensor = |sensor: &SensorBeside| {
        let beside = &sensor.beside;
        as_json!({
            "channel": sensor.channel,
            "height_m": sensor.height_m,
            "follows": sensor.follows(),
            "peak_measured_m_s2": beside.peak_measured,
            "peak_simulated_m_s2": beside.peak_simulated,
            "rms_measured_m_s2": beside.rms_measured,
            "rms_simulated_m_s2": beside.rms_simulated,
            "correlation": beside.correlation,
            "residual_ratio": Some(beside.residual_ratio).filter(|ratio| ratio.is_finite()),
            "frequency_measured_hz": beside.frequency_measured_hz,
            "frequency_simulated_hz": beside.frequency_simulated_hz,
        })
    };
    as_json!({
        "survey": of.survey,
        "follows": of.follows(),
        "left_out": of.left_out,
        "sensors": of.sensors.iter().map(sensor).collect::<Vec<_>>(),
    })
}

fn together(of: &FrameTogether) -> Value {
    let storeys = of.storeys.iter().map(|storey| {
        as_json!({ "peak_drift_m": storey.drift_m, "at_s": storey.at_s, "drift_x_m": storey.parts_m[0], "drift_y_m": storey.parts_m[1] })
    });
    as_json!({
        "directions": of.directions,
        "storeys": storeys.collect::<Vec<_>>(),
        "peak_top_displacement_m": of.top_m,
        "drift_with_lift_off_m": of.softened_m,
        "drift_all_in_beds_m": of.all_in_beds_m,
        "shared_friction": of.shared.map(|shared| as_json!({ "step_s": shared.step_s, "change_of_peaks": shared.change })),
    })
}

fn columns_alone(columns: &ColumnsInMotion) -> Value {
    let alone = match columns {
        ColumnsInMotion::Alone(alone) => alone,
        ColumnsInMotion::OnBeds(run) => return columns_on_beds(run),
        ColumnsInMotion::Absent
        | ColumnsInMotion::SeveralStoreys
        | ColumnsInMotion::JointsOfTheirOwn
        | ColumnsInMotion::SplitAssumed
        | ColumnsInMotion::BesideJoints(_)
        | ColumnsInMotion::BothComponents => return Value::Null,
    };
    let (block, history) = (&alone.rocks_like, &alone.history);
    let (outcome, at_s) = match history.outcome {
        RockingOutcome::Stood => ("stood", None),
        RockingOutcome::Rocked => ("rocked", None),
        RockingOutcome::Fell { at_s } => ("fell", Some(at_s)),
        RockingOutcome::LeftTheGround { at_s } => ("left_the_ground", Some(at_s)),
    };
    as_json!({
        "count": alone.count,
        "width_m": alone.width_m,
        "height_m": alone.height_m,
        "slenderness_rad": block.slenderness_rad,
        "frequency_parameter_rad_s": block.frequency_parameter_rad_s,
        "velocity_ratio": block.velocity_ratio,
        "uplift_m_s2": alone.uplift_m_s2(),
        "outcome": outcome,
        "fell_at_s": at_s,
        "lifted_off_at_s": history.uplift_s,
        "peak_rotation_rad": history.peak_rotation_rad,
        "peak_drift_m": alone.drift_m(history.peak_rotation_rad),
        "impacts": history.impacts.len(),
    })
}

/// The run with the beds that the file gives, and the joints beside them.
fn beside_joints(columns: &ColumnsInMotion) -> Value {
    let ColumnsInMotion::BesideJoints(run) = columns else {
        return Value::Null;
    };
    let mut value = columns_on_beds(run);
    value["bed_stiffness_n_m"] = run.beds_n_m.into();
    value["joint_stiffness_n_m"] = run.run.joints_n_m.into();
    value
}

fn columns_on_beds(of: &ColumnsOnBeds) -> Value {
    let history = &of.history;
    let (outcome, at_s) = match history.outcome {
        ColumnOutcome::Stood => ("stood", None),
        ColumnOutcome::Rocked => ("rocked", None),
        ColumnOutcome::Fell { at_s } => ("fell", Some(at_s)),
        ColumnOutcome::NotConverged => ("not_converged", None),
    };
    as_json!({
        "count": of.count,
        "height_m": of.height_m,
        "outcome": outcome,
        "fell_at_s": at_s,
        "lifted_off_at_s": history.uplift_s,
        "lift_off_drift_m": history.uplift_drift_m,
        "fall_drift_m": history.falls_drift_m,
        "peak_drift_m": history.peak_drift_m,
        "residual_drift_m": history.rest_drift_m,
        "change_of_peak": Some(history.peak_change).filter(|change| change.is_finite()),
        "steps": history.steps,
    })
}

fn outcome(simulation: &FrameSimulation) -> Value {
    let until_then = ending(simulation);
    match simulation.ended_before_the_motion_s() {
        Some(end_s) => {
            as_json!({ "kind": "ended_before_the_motion", "at_s": end_s, "until_then": until_then })
        }
        None => until_then,
    }
}

fn ending(simulation: &FrameSimulation) -> Value {
    match simulation.history.outcome {
        FrameOutcome::Finished => as_json!({ "kind": "finished" }),
        FrameOutcome::DriftLimit { storey, at_s } => {
            as_json!({ "kind": "drift_limit", "storey": simulation.storeys.get(storey), "at_s": at_s })
        }
        FrameOutcome::Stopped { at_s } => as_json!({ "kind": "stopped", "at_s": at_s }),
    }
}

fn friction(friction: &StoreyFriction) -> Value {
    match *friction {
        StoreyFriction::None => Value::Null,
        StoreyFriction::Coulomb {
            static_force_n,
            kinetic_force_n,
        } => {
            as_json!({ "law": "coulomb", "static_force_n": static_force_n, "kinetic_force_n": kinetic_force_n })
        }
        StoreyFriction::Jenkins {
            stuck_stiffness_n_m,
            static_force_n,
            kinetic_force_n,
        } => as_json!({
            "law": "jenkins", "stuck_stiffness_n_m": stuck_stiffness_n_m,
            "static_force_n": static_force_n, "kinetic_force_n": kinetic_force_n,
        }),
    }
}
