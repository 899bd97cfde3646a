//! A building as JSON: its check, its simulation.

use super::simulation::motion_json;
use crate::building::{BuildingAnswer, BuildingSpectral, StandingBuilding};
use crate::project::BuiltDamper;
use crate::simulation::BuildingSimulation;
use dolmen::dynamics::{BuildingPeaks, HistoryMethod, Peak};
use serde_json::{Value, json};

/// The check of a building.
pub(super) fn building(answer: &BuildingAnswer) -> Value {
    let storeys = answer.elastic.storeys().iter().zip(&answer.falls).enumerate();
    let storeys = storeys.map(|(i, (storey, fall))| {
        let floor = &answer.elastic.floors()[i];
        let centre = storey.stiffness.centre_of_rigidity_m();
        json!({
            "floor": answer.floors[i],
            "mass_kg": floor.mass_kg, "centre_of_mass_m": floor.centre_m, "gyration_m": floor.gyration_m,
            "height_m": storey.height_m,
            "centre_of_rigidity_m": centre,
            "stiffness_about_it": centre.map(|centre| storey.stiffness.matrix_about(centre)),
            "weight_above_n": fall.weight_n, "load_factor": fall.load_factor, "falls_by": fall.motion(),
            "falling_drift": fall.drift,
        })
    });
    json!({
        "load_factor": answer.load_factor(),
        "storeys": storeys.collect::<Vec<_>>(),
        "standing": answer.stands.as_ref().map(|standing| self::standing(standing)),
    })
}

fn standing(standing: &StandingBuilding) -> Value {
    let modes = standing.modes.modes.iter().zip(&standing.damping_ratios);
    let modes = modes.map(|(mode, damping_ratio)| {
        json!({
            "frequency_hz": mode.frequency_hz, "omega_rad_s": mode.omega_rad_s, "damping_ratio": damping_ratio,
            "shape": mode.shape, "participation": mode.participation, "effective_mass": mode.effective_mass,
            "energy_shares": mode.energy_shares, "coupling": mode.coupling, "repeated": mode.repeated,
            "centres": mode.centres.iter().map(|centre| centre.map(|c| json!({
                "r_x_m": c.r_x_m, "r_y_m": c.r_y_m, "x_m": c.x_m, "y_m": c.y_m,
            }))).collect::<Vec<_>>(),
        })
    });
    json!({
        "modes": modes.collect::<Vec<_>>(),
        "total_mass": standing.modes.total_mass,
        "dampers": standing.dampers.iter().map(damper).collect::<Vec<_>>(),
        "spectral": standing.spectral.as_ref().map(spectral),
    })
}

fn damper(damper: &BuiltDamper) -> Value {
    let tuned = &damper.tuned;
    json!({
        "name": damper.name, "floor": tuned.floor, "x_m": tuned.x_m, "y_m": tuned.y_m, "direction": tuned.direction.unit(),
        "mode": damper.mode, "mass_ratio": damper.mass_ratio, "mass_kg": tuned.mass_kg,
        "frequency_hz": tuned.frequency_hz, "damping_ratio": tuned.damping_ratio,
        "tuning": damper.tuning.map(|tuning| tuning.word()),
    })
}

fn spectral(spectral: &BuildingSpectral) -> Value {
    let [sum, srss, cqc] = spectral.base_shear_n;
    json!({
        "modes": spectral.modes.iter().map(|mode| json!({
            "period_s": mode.period_s, "damping_ratio": mode.damping_ratio, "acceleration_m_s2": mode.acceleration_m_s2,
        })).collect::<Vec<_>>(),
        "base_shear_n": { "absolute_sum": sum, "srss": srss, "cqc": cqc },
        "base_torque_n_m": spectral.base_torque_n_m,
        "displacement_m": spectral.displacement_m,
        "edge_drift_m": spectral.edge_drift_m,
        "points": spectral.points_m.iter().map(|(name, at)| json!({ "name": name, "displacement_m": at })).collect::<Vec<_>>(),
    })
}

/// Everything of a simulation but its histories.
pub fn building_simulation_json(simulation: &BuildingSimulation) -> Value {
    let history = &simulation.history;
    let points = simulation.points.iter().map(|point| {
        let largest = |values: &Vec<f64>| values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        json!({
            "name": point.name, "floor": point.floor, "place_m": point.place_m,
            "peak_displacement_m": point.displacement_m.each_ref().map(largest),
        })
    });
    json!({
        "file": simulation.file,
        "name": { "en": simulation.name.en, "ko": simulation.name.ko },
        "variant": simulation.variant,
        "motion": motion_json(&simulation.motion),
        "method": match history.method {
            HistoryMethod::ComplexModes => "complex_modes",
            HistoryMethod::MatrixExponential => "matrix_exponential",
        },
        "time_step_s": history.time_step_s,
        "steps": history.length() - 1,
        "dampers": simulation.dampers.iter().map(damper).collect::<Vec<_>>(),
        "peaks": peaks(&history.peaks, simulation),
        "peaks_without_dampers": simulation.without_dampers.as_ref().map(|other| peaks(&other.peaks, simulation)),
        "points": points.collect::<Vec<_>>(),
        "drift_ratio": simulation.drift_ratio().1,
    })
}

fn peak(peak: &Peak) -> Value {
    json!({ "value": peak.value, "at_s": peak.at_s })
}

fn peaks(peaks: &BuildingPeaks, simulation: &BuildingSimulation) -> Value {
    let floors = peaks.floors.iter().zip(&peaks.storeys).zip(&simulation.floors);
    let floors = floors.map(|((floor, storey), name)| {
        json!({
            "floor": name,
            "displacement_x_m": peak(&floor.displacement_x_m), "displacement_y_m": peak(&floor.displacement_y_m),
            "rotation_rad": peak(&floor.rotation_rad),
            "drift_x_m": peak(&storey.drift_x_m), "drift_y_m": peak(&storey.drift_y_m), "twist_rad": peak(&storey.twist_rad),
            "edge_drift_x_m": peak(&storey.edge_drift_x_m), "edge_drift_y_m": peak(&storey.edge_drift_y_m),
        })
    });
    json!({
        "floors": floors.collect::<Vec<_>>(),
        "strokes_m": peaks.strokes_m.iter().map(peak).collect::<Vec<_>>(),
        "base_shear_x_n": peak(&peaks.base_shear_n[0]), "base_shear_y_n": peak(&peaks.base_shear_n[1]),
        "base_torque_n_m": peak(&peaks.base_torque_n_m),
    })
}
