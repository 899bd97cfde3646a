//! A building in the wind as JSON.

use crate::as_json;
use dolmen::damper::GustPeak;
use dolmen::structure::wind::TurbulenceSpectrum;
use dolmen_work::building::{
    BuildingWind, FloorInWind, FloorMet, StandingBuilding, WIND_DURATION_S, WindAlong, WindMotion,
};
use serde_json::Value;

/// Means, standard deviations and peaks, for wind along x and along y.
pub(super) fn building_wind(standing: &StandingBuilding, wind: &BuildingWind) -> Value {
    as_json!({
        "spectrum": match wind.spectrum {
            TurbulenceSpectrum::Kaimal => "kaimal",
            TurbulenceSpectrum::VonKarman => "von_karman",
        },
        "duration_s": WIND_DURATION_S,
        "eccentricity": wind.eccentricity,
        "acceleration_limit_m_s2": wind.acceleration_limit_m_s2,
        "drift_limit": wind.drift_limit,
        "top_peak_acceleration_m_s2": wind.top_acceleration().map(|(_, top)| top.peak()),
        "largest_peak_drift_ratio": wind.largest_drift(&standing.building).map(|(_, _, ratio)| ratio),
        "along_x": along(&wind.along[0]),
        "along_y": along(&wind.along[1]),
        "beyond_room": wind.beyond_room(&standing.dampers).iter().map(|beyond| as_json!({
            "damper": beyond.name, "stroke_m": beyond.stroke_m, "room_m": beyond.room_m,
        })).collect::<Vec<_>>(),
    })
}

fn along(of: &WindAlong) -> Value {
    as_json!({
        "met": of.met.iter().map(met).collect::<Vec<_>>(),
        "without_dampers": motion(&of.without),
        "with_dampers": of.with.as_ref().map(motion),
    })
}

fn met(of: &FloorMet) -> Value {
    as_json!({
        "height_m": of.height_m, "mean_speed_m_s": of.wind.mean_speed_m_s, "turbulence_intensity": of.wind.intensity,
        "turbulence_length_m": of.wind.length_m, "breadth_m": of.breadth_m, "mean_force_n": of.mean_force_n,
    })
}

fn motion(of: &WindMotion) -> Value {
    as_json!({
        "floors": of.floors.iter().map(floor).collect::<Vec<_>>(),
        "base_shear_n": peak(&of.base_shear_n),
        "base_torque_n_m": peak(&of.base_torque_n_m),
        "strokes_m": of.strokes_m.iter().map(peak).collect::<Vec<_>>(),
        "frequencies": of.frequencies,
    })
}

fn floor(of: &FloorInWind) -> Value {
    as_json!({
        "displacement_m": peak(&of.displacement_m), "edge_drift_m": peak(&of.drift_m),
        "acceleration_m_s2": peak(&of.acceleration_m_s2), "acceleration_across_m_s2": peak(&of.across_m_s2),
        "rotation_rad_s2": peak(&of.rotation_rad_s2), "corner_m_s2": peak(&of.corner_m_s2),
    })
}

pub(super) fn peak(of: &GustPeak) -> Value {
    as_json!({
        "mean": of.mean, "rms": of.rms, "up_crossing_hz": of.up_crossing_hz,
        "peak_factor": of.peak_factor, "peak": of.peak(),
    })
}
