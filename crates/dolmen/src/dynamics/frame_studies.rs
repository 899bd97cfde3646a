//! The behaviour of a frame with dry friction at different amplitudes: apparent frequency and damping, and maps of stick and slip under harmonic
//! ground motion.

use super::excitation::FrameLoad;
use super::frame_friction::{FrictionFrame, Sliders};
use super::frame_motion::simulate_frame;
use super::frame_run::FrameRun;
use super::harmonic_map::{HarmonicPoint, harmonic_ground};
use super::{DynamicsError, FrameOutcome};
use dolmen_linalg::generalized_symmetric_eigen;
use std::f64::consts::{PI, TAU};

/// Number of cycles after a release, at the lowest frequency. Our choice.
const RELEASE_SWINGS: f64 = 60.0;
/// Logarithmic decrement below which a cycle has no loss.
const LOSS_LEAST: f64 = 1e-9;
/// One cycle of a released frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AtAmplitude {
    /// Half the distance between two turning points of the top level, averaged over two successive half cycles, m.
    pub amplitude_m: f64,
    /// Reciprocal of the duration of both half cycles, Hz.
    pub apparent_frequency_hz: f64,
    /// Damping ratio of a viscous oscillator with the same loss from one half cycle to the next: ln(A_j/A_{j+1})/√(π² + ln²).
    pub equivalent_damping_ratio: f64,
}

/// Apparent frequency and equivalent damping against amplitude. The frame is displaced in its first mode shape to `displacement_m` at the top
/// and released; each half cycle is measured until the frame rests.
///
/// # Errors
/// [`DynamicsError::Argument`] for a displacement that is not positive; [`DynamicsError::NoSwing`] for an unstable frame and
/// [`DynamicsError::SwingFalls`] for one that leans too far after the release; the errors of [`simulate_frame`].
///
/// # Limits
/// The release starts from the first mode shape of the frame with all sliders stuck (Coulomb: slipping). If the shape depends on amplitude,
/// higher modes take part and the values scatter.
pub fn amplitude_dependence(
    frame: &FrictionFrame,
    displacement_m: f64,
) -> Result<Vec<AtAmplitude>, DynamicsError> {
    if !(displacement_m > 0.0 && displacement_m.is_finite()) {
        return Err(DynamicsError::Argument {
            argument: "displacement_m",
            given: displacement_m,
            allowed: "a positive number",
        });
    }
    let k = frame.stiffness_matrix(Sliders::Stuck)?;
    let eigen = generalized_symmetric_eigen(&k, &frame.frame().mass_matrix())?;
    let Some(&lowest) = eigen.values.first().filter(|w| **w > 0.0) else {
        return Err(DynamicsError::NoSwing { displacement_m });
    };
    let shape = eigen.vectors.column(0);
    let top = shape[shape.len() - 1];
    let options = FrameRun {
        duration_s: Some(RELEASE_SWINGS * TAU / lowest.sqrt()),
        output_step_s: TAU / lowest.sqrt(),
        start_displacement_m: shape.iter().map(|x| x / top * displacement_m).collect(),
        ..FrameRun::default()
    };
    let history = simulate_frame(frame, &FrameLoad::none(), &options, &mut |_| true)?;
    if let FrameOutcome::DriftLimit { storey, at_s } = history.outcome {
        return Err(DynamicsError::SwingFalls {
            displacement_m,
            storey: storey + 1,
            at_s,
        });
    }
    let mut turns = vec![(0.0, displacement_m)];
    turns.extend(history.turns.iter().map(|t| (t.at_s, t.displacement_m)));
    // every stop shifts the middle position, so half the distance between two turning points is the amplitude
    let half_ways: Vec<(f64, f64)> = turns
        .windows(2)
        .map(|pair| (pair[1].0 - pair[0].0, 0.5 * (pair[0].1 - pair[1].1).abs()))
        .collect();
    let mut found = Vec::new();
    for pair in half_ways.windows(2) {
        let ((time_s, first), (next_s, second)) = (pair[0], pair[1]);
        if second <= 0.0 {
            continue;
        }
        let loss = (first / second).ln();
        found.push(AtAmplitude {
            amplitude_m: 0.5 * (first + second),
            apparent_frequency_hz: 1.0 / (time_s + next_s),
            equivalent_damping_ratio: loss / PI.hypot(loss),
        });
        if loss.abs() < LOSS_LEAST {
            break; // all further cycles are equal
        }
    }
    Ok(found)
}

/// Steady response of a plumb frame to harmonic ground motions: [`harmonic_map_of_leaning`] without a lean.
///
/// # Errors
/// As for [`simulate_frame`].
pub fn harmonic_map(
    frame: &FrictionFrame,
    frequencies_hz: &[f64],
    ground_accelerations_m_s2: &[f64],
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<Vec<HarmonicPoint>, DynamicsError> {
    let plumb = HarmonicStart {
        tilt: 0.0,
        drift_ratio_most: FrameRun::default().drift_ratio_most,
    };
    harmonic_map_of_leaning(frame, plumb, frequencies_hz, ground_accelerations_m_s2, progress)
}

/// The lean of a frame before harmonic ground motions, and the drift at which it has fallen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HarmonicStart {
    /// Stress-free lean, horizontal over vertical: as in [`FrictionFrame::leaning`].
    pub tilt: f64,
    /// Drift over height of a storey, beyond the lean, at which it has fallen.
    pub drift_ratio_most: f64,
}

/// Steady response to harmonic ground motions: one point for each frequency and acceleration, in rows of equal frequency. Drifts are relative to
/// the leaning position, and include what the weight adds to the lean.
///
/// `progress` receives the finished fraction. If it returns false, the map stops and the remaining points are missing.
///
/// # Errors
/// As for [`simulate_frame`].
///
/// # Limits
/// Each run has 40 cycles from rest, both of the ground and of the slowest mode of the frame; then 5 cycles of the ground are measured. A
/// response that is not steady by then (beating, or chaotic) is marked.
pub fn harmonic_map_of_leaning(
    frame: &FrictionFrame,
    start: HarmonicStart,
    frequencies_hz: &[f64],
    ground_accelerations_m_s2: &[f64],
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<Vec<HarmonicPoint>, DynamicsError> {
    let whole = frequencies_hz.len() * ground_accelerations_m_s2.len();
    let mut points = Vec::with_capacity(whole);
    for &frequency_hz in frequencies_hz {
        for &amplitude in ground_accelerations_m_s2 {
            if !progress(points.len() as f64 / whole as f64) {
                return Ok(points);
            }
            points.push(harmonic_point(frame, start, [frequency_hz, amplitude])?);
        }
    }
    Ok(points)
}

fn harmonic_point(
    frame: &FrictionFrame,
    start: HarmonicStart,
    [frequency_hz, amplitude]: [f64; 2],
) -> Result<HarmonicPoint, DynamicsError> {
    let frequencies_hz = frame.frequencies_hz(Sliders::Slipping)?;
    let slowest_hz = frequencies_hz.into_iter().flatten().fold(frequency_hz, f64::min);
    let (ground, window) = harmonic_ground(frequency_hz, amplitude, slowest_hz);
    let mut options = FrameRun {
        duration_s: Some(window.to_s),
        output_step_s: window.step_s,
        drift_ratio_most: start.drift_ratio_most,
        ..FrameRun::default()
    };
    let mut load = FrameLoad::of_ground(ground);
    if start.tilt != 0.0 {
        let leaning = frame.leaning(start.tilt)?;
        load.forces_n = leaning.forces_n;
        options.start_displacement_m = leaning.start_displacement_m;
    }
    let history = simulate_frame(frame, &load, &options, &mut |_| true)?;
    let window = window.of_run(history.outcome == FrameOutcome::Finished, history.duration_s);
    let storeys = (0..frame.frame().storeys().len()).map(|storey| {
        let slips = history.slips.iter().filter(|slip| slip.storey == storey);
        let slipping_s: Vec<[f64; 2]> = slips.map(|slip| [slip.from_s, slip.to_s]).collect();
        let most = history.drift_peaks[storey].value_m.abs();
        window.part(
            (&history.drift_m(storey), &history.drift_speed_m_s(storey)),
            most,
            &slipping_s,
        )
    });
    Ok(window.point(storeys.collect()))
}
