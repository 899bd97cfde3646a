//! A turbulent wind on one mode: closed form for a narrow band, and Annex B of EN 1991-1-4.

use super::{Case, ValidationError};
use crate::damper::{DamperError, GustMotion, GustQuantity, GustRow, gust_history, gust_motion};
use crate::dynamics::LinearSystem;
use crate::structure::wind::{
    COHERENCE_DECAY, EUROCODE_AIR_KG_M3, EurocodeTerrain, EurocodeWind, GustDraw, GustFace, GustStrip,
    GustTimes, TurbulenceSpectrum, Wind,
};
use dolmen_linalg::Matrix;
use std::f64::consts::{PI, TAU};

/// A building of 60 × 24 m as one mode: mass, kg; frequency, Hz.
const MASS_KG: f64 = 1e6;
const FREQUENCY_HZ: f64 = 0.5;
const HEIGHT_M: f64 = 60.0;
const BREADTH_M: f64 = 24.0;
/// Decay for which the coherence averaged over both lengths equals R_h R_b of the code: 4.6 · 2.
const DECAY_OF_ANNEX_B: f64 = 9.2;

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let wind = Wind::Eurocode(EurocodeWind {
        basic_speed_m_s: 28.0,
        terrain: EurocodeTerrain::Iii,
        orography: 1.0,
        air_density_kg_m3: EUROCODE_AIR_KG_M3,
    });
    let strip = GustStrip {
        bottom_m: 0.0,
        top_m: HEIGHT_M,
        breadth_m: BREADTH_M,
        force_coefficient: 1.3,
        wind: wind.turbulence_at(0.6 * HEIGHT_M)?,
    };
    let face = |coherence_decay| GustFace {
        strips: vec![strip],
        air_density_kg_m3: EUROCODE_AIR_KG_M3,
        spectrum: TurbulenceSpectrum::Kaimal,
        coherence_decay,
    };
    Ok(vec![
        narrow_band(&face(COHERENCE_DECAY))?,
        annex_b(&face(DECAY_OF_ANNEX_B))?,
        variance_of_histories(&face(COHERENCE_DECAY))?,
    ])
}

/// Damping ratio of the mode in time histories, and their number of hours.
const DAMPING_RATIO_IN_TIME: f64 = 0.05;
const HOURS: usize = 50;
const TEN_MINUTES_S: f64 = 600.0;

/// Displacement of the mode over hours of wind, m.
fn hours(face: &GustFace) -> Result<Vec<f64>, ValidationError> {
    let times = GustTimes {
        time_step_s: 0.1,
        samples: HOURS * 36_000,
        looked_at: HOURS * 36_000,
    };
    let draw = GustDraw { seed: 1, stream: 0 };
    let gusts = face.histories(&times, &[draw]).map_err(DamperError::from)?;
    let row = GustRow {
        case: 0,
        row: vec![1.0],
        quantity: GustQuantity::Displacement,
    };
    let system = oscillator(DAMPING_RATIO_IN_TIME)?;
    let mut history = gust_history(&system, &[], &[vec![vec![1.0]]], &[row], &gusts[0])?;
    Ok(history.values.swap_remove(0))
}

fn variance_of_histories(face: &GustFace) -> Result<Case, ValidationError> {
    let values = hours(face)?;
    let moved = mode(face, DAMPING_RATIO_IN_TIME)?.displacement(&[1.0]);
    let squares: f64 = values.iter().map(|x| (x - moved.mean).powi(2)).sum();
    Ok(Case {
        source: "Second methods",
        what: "σ² of one mode in a turbulent wind: 50 hours in time".to_owned(),
        unit: "mm²",
        published: 1e6 * moved.rms * moved.rms,
        computed: 1e6 * squares / values.len() as f64,
        tolerance: 0.02 * 1e6 * moved.rms * moved.rms,
        corrected: None,
        note: "Beside the integral over frequency. The variance of 50 hours scatters by some 1 %.",
    })
}

fn oscillator(damping_ratio: f64) -> Result<LinearSystem, ValidationError> {
    let omega = TAU * FREQUENCY_HZ;
    let one = |value: f64| Matrix::from_diagonal(&[value]);
    Ok(LinearSystem::new(
        one(MASS_KG),
        one(2.0 * damping_ratio * omega * MASS_KG),
        one(omega * omega * MASS_KG),
    )?)
}

fn mode(face: &GustFace, damping_ratio: f64) -> Result<GustMotion, ValidationError> {
    let system = oscillator(damping_ratio)?;
    let mut motions = gust_motion(&system, &[], face, &[vec![vec![1.0]]], TEN_MINUTES_S)?;
    Ok(motions.remove(0))
}

fn narrow_band(face: &GustFace) -> Result<Case, ValidationError> {
    const DAMPING_RATIO: f64 = 1e-4;
    let density = face.force_density_n2_hz(FREQUENCY_HZ)[(0, 0)];
    let variance = PI * FREQUENCY_HZ * density / (4.0 * DAMPING_RATIO * MASS_KG * MASS_KG);
    Ok(Case {
        source: "Closed form of a narrow band",
        what: "σ of the acceleration of one mode in a turbulent wind, ζ = 0.01 %".to_owned(),
        unit: "m/s²",
        published: variance.sqrt(),
        computed: mode(face, DAMPING_RATIO)?.acceleration(&[1.0]).rms,
        tolerance: 2e-3 * variance.sqrt(),
        corrected: None,
        note: "√(π n S_F(n)/(4 ζ m²)): white noise of the density at the natural frequency. The rest of the spectrum adds less than 0.2 %.",
    })
}

fn annex_b(face: &GustFace) -> Result<Case, ValidationError> {
    const DAMPING_RATIO: f64 = 0.004;
    let wind = face.strips[0].wind;
    let f_l = FREQUENCY_HZ * wind.length_m / wind.mean_speed_m_s;
    let spectrum = 6.8 * f_l / (1.0 + 10.2 * f_l).powf(5.0 / 3.0);
    let admitted = |size_m: f64| {
        let eta = 4.6 * size_m * FREQUENCY_HZ / wind.mean_speed_m_s;
        1.0 / eta - (1.0 - (-2.0 * eta).exp()) / (2.0 * eta * eta)
    };
    let resonant =
        PI * PI / (2.0 * TAU * DAMPING_RATIO) * spectrum * admitted(HEIGHT_M) * admitted(BREADTH_M);
    let background = 1.0 / (1.0 + 0.9 * ((BREADTH_M + HEIGHT_M) / wind.length_m).powf(0.63));
    let moved = mode(face, DAMPING_RATIO)?.displacement(&[1.0]);
    Ok(Case {
        source: "EN 1991-1-4:2005, Annex B",
        what: "σ/x̄ of one mode of a building of 60 × 24 m, 2 I_v √(B² + R²)".to_owned(),
        unit: "",
        published: 2.0 * wind.intensity * (background + resonant).sqrt(),
        computed: moved.rms / moved.mean,
        tolerance: 0.05,
        corrected: None,
        note: "By hand from B.2, B.3 and B.6 to B.8. R² is the same resonance; B² is fitted to measurements in the code, and the integral of the gusts here.",
    })
}
