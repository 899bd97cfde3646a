//! A building in histories of the wind as JSON.

use crate::as_json;
use dolmen_work::building::{InTime, MotionInTime, WindSimulation};
use serde_json::Value;

/// A simulation in the wind without its histories.
pub fn wind_simulation_json(run: &WindSimulation) -> Value {
    let along = |axis: usize| {
        let of = &run.along[axis];
        as_json!({
            "without_dampers": motion(&of.without),
            "with_dampers": of.with.as_ref().map(motion),
        })
    };
    let strokes = dolmen_project::strokes_of(&run.dampers).into_iter();
    as_json!({
        "file": run.file,
        "name": { "en": run.name.en, "ko": run.name.ko },
        "variant": run.variant,
        "floors": run.floors,
        "duration_s": run.duration_s,
        "time_step_s": run.time_step_s,
        "period_s": run.period_s,
        "seeds": run.seeds,
        "eccentricity": run.eccentricity,
        "acceleration_limit_m_s2": run.acceleration_limit_m_s2,
        "drift_limit": run.drift_limit,
        "top_peak_acceleration_m_s2": run.top_acceleration().1.peak(),
        "largest_peak_drift_ratio": run.largest_drift().map(|drift| drift.of_height),
        "stroke_names": strokes.map(|stroke| stroke.name).collect::<Vec<_>>(),
        "along_x": along(0),
        "along_y": along(1),
        "as_long_as_its_wind": run.is_as_long_as_its_wind(),
        "struck_stops": run.struck().iter().map(|of| as_json!({
            "damper": of.name, "histories": of.histories, "largest_stroke_m": of.largest_m, "room_m": of.room_m,
        })).collect::<Vec<_>>(),
        "beyond_room": run.beyond_room().iter().map(|beyond| as_json!({
            "damper": beyond.name, "stroke_m": beyond.stroke_m, "room_m": beyond.room_m,
        })).collect::<Vec<_>>(),
    })
}

fn motion(of: &MotionInTime) -> Value {
    as_json!({
        "top_displacement_m": in_time(&of.top_displacement_m),
        "edge_drifts_m": of.drifts_m.iter().map(in_time).collect::<Vec<_>>(),
        "top_acceleration_m_s2": in_time(&of.top_acceleration_m_s2),
        "corner_m_s2": in_time(&of.corner_m_s2),
        "base_shear_n": in_time(&of.base_shear_n),
        "base_torque_n_m": in_time(&of.base_torque_n_m),
        "strokes_m": of.strokes_m.iter().map(in_time).collect::<Vec<_>>(),
    })
}

fn in_time(of: &InTime) -> Value {
    as_json!({
        "mean": of.mean,
        "rms": of.rms,
        "peaks": of.peaks,
        "peak": of.peak(),
        "peak_rms": of.peak_rms(),
        "mean_square": super::building_wind::peak(&of.mean_square),
    })
}
