//! A building as JSON: its check, its simulation.

use super::building_wind::building_wind;
use super::simulation::motion_json;
use super::with::with;
use crate::as_json;
use crate::limits::parts_json;
use dolmen::assess::demand::TorsionCode;
use dolmen::damper::DamperKind;
use dolmen::dynamics::{BuildingPeaks, HistoryMethod};
use dolmen_project::BuiltDamper;
use dolmen_words::Language;
use dolmen_work::building::BuildingSimulation;
use dolmen_work::building::{
    AccidentalTorsion, BuildingAnswer, BuildingSpectral, DampedSpectral, MINOR_RATIO, StandingBuilding,
};
use serde_json::Value;

/// The check of a building.
pub(super) fn building(answer: &BuildingAnswer) -> Value {
    let storeys = answer.elastic.storeys().iter().zip(&answer.falls).enumerate();
    let storeys = storeys.map(|(i, (storey, fall))| {
        let floor = &answer.elastic.floors()[i];
        let centre = storey.stiffness.centre_of_rigidity_m();
        as_json!({
            "floor": answer.floors[i],
            "mass_kg": floor.mass_kg, "centre_of_mass_m": floor.centre_m, "gyration_m": floor.gyration_m,
            "height_m": storey.height_m,
            "centre_of_rigidity_m": centre,
            "stiffness_about_it": centre.map(|centre| storey.stiffness.matrix_about(centre)),
            "weight_above_n": fall.weight_n, "load_factor": fall.load_factor, "falls_by": fall.motion().name(),
            "falling_drift": fall.drift,
        })
    });
    as_json!({
        "load_factor": answer.load_factor(),
        "storeys": storeys.collect::<Vec<_>>(),
        "standing": answer.stands.as_ref().map(|standing| self::standing(standing)),
    })
}

fn standing(standing: &StandingBuilding) -> Value {
    let modes = standing.modes.modes.iter().zip(&standing.damping_ratios);
    let modes = modes.map(|(mode, damping_ratio)| with(mode, as_json!({ "damping_ratio": damping_ratio })));
    as_json!({
        "modes": modes.collect::<Vec<_>>(),
        "total_mass": standing.modes.total_mass,
        "modes_with_dampers": standing.damped_modes.iter().map(|mode| as_json!({
            "frequency_hz": mode.frequency_hz, "damping_ratio": mode.damping_ratio, "share_of_own_modes": mode.share,
        })).collect::<Vec<_>>(),
        "dampers": standing.dampers.iter().map(damper).collect::<Vec<_>>(),
        "spectral": standing.spectral.as_ref().map(spectral),
        "spectral_refused": standing.spectral_refused,
        "wind": standing.wind.as_ref().map(|wind| building_wind(standing, wind)),
        "wind_refused": standing.wind_refused.as_ref().map(|why| why.text(Language::English)),
        "spectral_with_dampers": standing.damped.as_ref().map(damped),
        "spectral_with_dampers_refused": standing.damped_refused,
        "accidental_torsion": accidental_torsion(&standing.accidental),
        "against_without": standing.against_without().iter().map(|of| as_json!({
            "what": of.what[0], "ratio": of.ratio,
        })).collect::<Vec<_>>(),
        "beyond_room": standing.beyond_room().iter().map(|beyond| as_json!({
            "damper": beyond.name, "stroke_m": beyond.stroke_m, "room_m": beyond.room_m,
        })).collect::<Vec<_>>(),
    })
}

fn accidental_torsion(of: &AccidentalTorsion) -> Value {
    let state = |word: &str, code: Option<TorsionCode>| {
        as_json!({
            "state": word, "code": code.map(TorsionCode::name),
        })
    };
    match of {
        AccidentalTorsion::NotAsked => state("not_asked", None),
        AccidentalTorsion::LeftOut { code } => state("left_out", *code),
        AccidentalTorsion::NoOutline { code } => state("no_outline", *code),
        AccidentalTorsion::Refused { code, why } => with(
            &state("refused", *code),
            as_json!({ "why": why.text(Language::English) }),
        ),
        AccidentalTorsion::Included(of) => with(
            &state("included", of.code),
            as_json!({
                "eccentricity": of.fraction,
                "centre_displaced_m": of.by_m,
                "cases": of.cases.iter().map(|case| as_json!({
                    "signs": case.signs, "edge_drift_m": case.edge_drift_m, "strokes_m": case.strokes_m,
                })).collect::<Vec<_>>(),
            }),
        ),
    }
}

pub(super) fn damper(damper: &BuiltDamper) -> Value {
    let value = as_json!({
        "name": damper.name, "kind": damper.word(),
        "floor": damper.floor, "x_m": damper.place_m[0], "y_m": damper.place_m[1], "direction": damper.direction.unit(),
        "mode": damper.tuned_to.map(|tuned| tuned.mode), "mass_ratio": damper.tuned_to.map(|tuned| tuned.mass_ratio),
        "mass_kg": damper.kind.mass_kg(),
        "frequency_hz": damper.own().map(|own| own[0]), "damping_ratio": damper.own().map(|own| own[1]),
        "tuning": damper.tuning.map(|tuning| tuning.name()), "room_m": damper.room_m, "liquid_room_m": damper.liquid_room_m,
    });
    let rest = match damper.kind {
        DamperKind::TunedMass { .. } => as_json!({}),
        DamperKind::LiquidColumn { length_ratio, .. } => as_json!({ "length_ratio": length_ratio }),
        DamperKind::LiquidColumnMass {
            liquid_mass_kg,
            length_ratio,
            liquid_frequency_hz,
            liquid_damping_ratio,
            ..
        } => as_json!({
            "length_ratio": length_ratio, "liquid_mass_kg": liquid_mass_kg,
            "liquid_frequency_hz": liquid_frequency_hz, "liquid_damping_ratio": liquid_damping_ratio,
        }),
        DamperKind::Viscous { coefficient_n_s_m } => as_json!({
            "coefficient_n_s_m": coefficient_n_s_m,
            "to_floor": damper.to.map(|to| to.0), "to_place_m": damper.to.map(|to| to.1),
        }),
    };
    with(&value, rest)
}

fn spectral(spectral: &BuildingSpectral) -> Value {
    let [sum, srss, cqc] = spectral.base_shear_n;
    as_json!({
        "modes": spectral.modes,
        "base_shear_n": { "absolute_sum": sum, "srss": srss, "cqc": cqc },
        "base_torque_n_m": spectral.base_torque_n_m,
        "base_shear_least_favourable": spectral.least_favourable.map(|of| as_json!({
            "base_shear_n": of.largest, "direction_degrees": of.direction_degrees, "minor_ratio": MINOR_RATIO,
        })),
        "displacement_m": spectral.displacement_m,
        "edge_drift_m": spectral.edge_drift_m,
        "points": spectral.points_m.iter().map(|(name, at)| as_json!({ "name": name, "displacement_m": at })).collect::<Vec<_>>(),
    })
}

fn damped(damped: &DampedSpectral) -> Value {
    as_json!({
        "modes": damped.modes,
        "base_shear_n": damped.base_shear_n,
        "base_torque_n_m": damped.base_torque_n_m,
        "displacement_m": damped.displacement_m,
        "edge_drift_m": damped.edge_drift_m,
        "points": damped.points_m.iter().map(|(name, at)| as_json!({ "name": name, "displacement_m": at })).collect::<Vec<_>>(),
        "strokes_m": damped.strokes_m,
    })
}

/// A simulation without its histories.
pub fn building_simulation_json(simulation: &BuildingSimulation) -> Value {
    let history = &simulation.history;
    let points = simulation.points.iter().map(|point| {
        as_json!({
            "name": point.name, "floor": point.floor, "place_m": point.place_m,
            "peak_displacement_m": point.along.each_ref().map(|along| along.displacement_peak_m.value.abs()),
            "peak_acceleration_m_s2": point.along.each_ref().map(|along| along.acceleration_peak_m_s2.value.abs()),
        })
    });
    as_json!({
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
        "dashpot_forces_n": simulation.dashpot_forces_n(),
        "points": points.collect::<Vec<_>>(),
        "limits": parts_json(&simulation.parts(), simulation.drift_limit.as_ref()),
        "drift_ratio": simulation.drift().ratio,
        "drift_at": if simulation.drift().at_corner { "corner" } else { "centre_of_mass" },
        "against_without": simulation.without_dampers.is_some().then(|| simulation.against_without().iter().map(|of| as_json!({
            "what": of.what[0], "ratio": of.ratio,
        })).collect::<Vec<_>>()),
        "grows_at_the_end": history.grows_at_the_end(),
        "dampers_across_the_motion": simulation.across_the_motion().iter().map(|damper| &damper.name).collect::<Vec<_>>(),
        "beyond_room": simulation.beyond_room().iter().map(|beyond| as_json!({
            "damper": beyond.name, "stroke_m": beyond.stroke_m, "room_m": beyond.room_m,
        })).collect::<Vec<_>>(),
    })
}

fn peaks(peaks: &BuildingPeaks, simulation: &BuildingSimulation) -> Value {
    let floors = peaks.floors.iter().zip(&peaks.storeys).zip(&simulation.floors);
    let floors = floors.map(|((floor, storey), name)| {
        as_json!({
            "floor": name,
            "displacement_x_m": floor.displacement_x_m, "displacement_y_m": floor.displacement_y_m,
            "rotation_rad": floor.rotation_rad,
            "drift_x_m": storey.drift_x_m, "drift_y_m": storey.drift_y_m, "twist_rad": storey.twist_rad,
            "edge_drift_x_m": storey.edge_drift_x_m, "edge_drift_y_m": storey.edge_drift_y_m,
            "resultant_drift": storey.resultant,
        })
    });
    as_json!({
        "floors": floors.collect::<Vec<_>>(),
        "strokes_m": peaks.strokes_m,
        "stroke_rates_m_s": peaks.stroke_rates_m_s,
        "stroke_names": simulation.stroke_names(),
        "base_shear_x_n": peaks.base_shear_n[0], "base_shear_y_n": peaks.base_shear_n[1],
        "base_torque_n_m": peaks.base_torque_n_m,
    })
}
