//! How a frame with dry friction behaves as the shaking grows: apparent frequency and damping against amplitude, and maps of
//! sticking and slipping over frequency and amplitude of a harmonic motion of the ground.

use super::excitation::{FrameLoad, TimeFunction};
use super::frame_friction::{FrictionFrame, Sliders};
use super::frame_motion::{FrameRun, simulate_frame};
use super::{DynamicsError, FrameOutcome};
use dolmen_linalg::generalized_symmetric_eigen;
use std::f64::consts::{PI, TAU};

/// Swings that a release is followed for, at the lowest frequency. Chosen here.
const RELEASE_SWINGS: f64 = 60.0;
/// Cycles before the steady state is read, of the ground and of the frame's slowest swing alike, and cycles of the ground that it is
/// read from. Chosen here: at a damping ratio of 2 % the free part is down to 1/150 by then, by friction it dies out sooner, and what
/// is left shows in `steady`.
const CYCLES_BEFORE: f64 = 40.0;
const CYCLES_READ: f64 = 5.0;
/// Most cycles of the ground before the steady state is read: memory and time end. Chosen here.
const CYCLES_MOST: f64 = 2000.0;
/// A swing that loses less, as ln of the amplitudes, loses nothing.
const LOSS_LEAST: f64 = 1e-9;
/// Samples a cycle of the harmonic maps.
const SAMPLES_A_CYCLE: f64 = 40.0;
/// Change of the peak between the cycles read, above which a point is not called steady. Chosen here.
const STEADY_MOST: f64 = 0.01;

/// One swing of a frame that was let go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AtAmplitude {
    /// Half the way between the two turns at the top level, m.
    pub amplitude_m: f64,
    /// 1 / (twice the time between the turns), Hz.
    pub apparent_frequency_hz: f64,
    /// Damping ratio of a viscous oscillator that loses as much in half a swing: ln(A_j/A_{j+1})/√(π² + ln²).
    pub equivalent_damping_ratio: f64,
}

/// Apparent frequency and equivalent damping as they change with amplitude: the frame is drawn in its first shape to
/// `displacement_m` at the top, let go, and each half swing is read until it rests.
///
/// # Errors
/// [`DynamicsError::Argument`] for a displacement that is not positive; [`DynamicsError::NoSwing`] for a frame that falls by itself
/// and [`DynamicsError::SwingFalls`] for one that leans too far when it is let go; those of [`simulate_frame`].
///
/// # Limits
/// The first shape of the frame with all sliders stuck (Coulomb: slipping) starts the release; where the shape changes with
/// amplitude, higher modes swing with it and the values scatter.
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
    // the middle shifts with every stop: half the way between two turns is an amplitude of its own
    let half_ways: Vec<(f64, f64)> = turns
        .windows(2)
        .map(|pair| (pair[1].0 - pair[0].0, 0.5 * (pair[0].1 - pair[1].1).abs()))
        .collect();
    let mut found = Vec::new();
    for pair in half_ways.windows(2) {
        let ((time_s, first), (_, second)) = (pair[0], pair[1]);
        if second <= 0.0 {
            continue;
        }
        let loss = (first / second).ln();
        found.push(AtAmplitude {
            amplitude_m: first,
            apparent_frequency_hz: 0.5 / time_s,
            equivalent_damping_ratio: loss / PI.hypot(loss),
        });
        if loss.abs() < LOSS_LEAST {
            break; // every further swing is like it
        }
    }
    Ok(found)
}

/// One point of a harmonic map.
#[derive(Clone, Debug, PartialEq)]
pub struct HarmonicPoint {
    /// Frequency of the ground, Hz.
    pub frequency_hz: f64,
    /// Amplitude of its acceleration, m/s².
    pub ground_acceleration_m_s2: f64,
    /// Largest drift of each storey over the cycles read, m; of a run that ended early, over all of it.
    pub drift_m: Vec<f64>,
    /// Share of the cycles read in which the slider of each storey slips, –; of a run that ended early, of all of it.
    pub slipping_share: Vec<f64>,
    /// The peaks of the cycles read agree to a hundredth: they tell the steady state.
    pub steady: bool,
    /// A storey leaned beyond what the model of small drifts can tell of.
    pub beyond_drift_limit: bool,
}

/// Steady response to harmonic motions of the ground, one point for each frequency and acceleration, rows of one frequency.
///
/// `progress` gets the share done, and stops the map by returning false: points not done are missing.
///
/// # Errors
/// Those of [`simulate_frame`].
///
/// # Limits
/// 40 cycles from rest, of the ground and of the slowest swing of the frame alike, then 5 of the ground are read. A response that is not steady by then (beating, or chaotic) is marked.
pub fn harmonic_map(
    frame: &FrictionFrame,
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
            points.push(harmonic_point(frame, frequency_hz, amplitude)?);
        }
    }
    Ok(points)
}

/// Whole cycles of the ground in which its own and those of the slowest swing of the frame, slipping, are at least so many.
fn cycles_before(frame: &FrictionFrame, frequency_hz: f64) -> Result<f64, DynamicsError> {
    let frequencies_hz = frame.frequencies_hz(Sliders::Slipping)?;
    let slowest = frequencies_hz.into_iter().flatten().fold(frequency_hz, f64::min);
    if slowest > 0.0 {
        Ok((CYCLES_BEFORE * frequency_hz / slowest).min(CYCLES_MOST).ceil())
    } else {
        Ok(CYCLES_BEFORE)
    }
}

fn harmonic_point(
    frame: &FrictionFrame,
    frequency_hz: f64,
    amplitude: f64,
) -> Result<HarmonicPoint, DynamicsError> {
    let load = FrameLoad::of_ground(TimeFunction::Harmonic {
        amplitude,
        frequency_hz,
        phase_rad: 0.0,
    });
    let cycles_before = cycles_before(frame, frequency_hz)?;
    let (from_s, to_s) = (
        cycles_before / frequency_hz,
        (cycles_before + CYCLES_READ) / frequency_hz,
    );
    let options = FrameRun {
        duration_s: Some(to_s),
        output_step_s: 1.0 / (frequency_hz * SAMPLES_A_CYCLE),
        ..FrameRun::default()
    };
    let history = simulate_frame(frame, &load, &options, &mut |_| true)?;
    let storeys = frame.frame().storeys().len();
    let first = (cycles_before * SAMPLES_A_CYCLE) as usize;
    let last = first + (CYCLES_READ * SAMPLES_A_CYCLE) as usize;
    let finished = history.outcome == FrameOutcome::Finished;
    let (from_s, to_s) = if finished {
        (from_s, to_s)
    } else {
        (0.0, history.duration_s)
    };
    let mut steady = finished;
    let mut drift_m = Vec::with_capacity(storeys);
    for storey in 0..storeys {
        let drift = history.drift_m(storey);
        let speed = history.drift_speed_m_s(storey);
        if !finished || drift.len() <= last {
            drift_m.push(history.drift_peaks[storey].value_m.abs());
            continue;
        }
        let peak_of = |cycle: usize| {
            let from = first + cycle * SAMPLES_A_CYCLE as usize;
            (from..from + SAMPLES_A_CYCLE as usize).fold(0.0_f64, |most, j| {
                let way = [
                    speed[j] * options.output_step_s,
                    speed[j + 1] * options.output_step_s,
                ];
                most.max(largest_of_cubic([drift[j], drift[j + 1]], way))
            })
        };
        let cycles: Vec<f64> = (0..CYCLES_READ as usize).map(peak_of).collect();
        let most = cycles.iter().copied().fold(0.0, f64::max);
        let least = cycles.iter().copied().fold(f64::INFINITY, f64::min);
        steady &= most - least <= STEADY_MOST * most;
        drift_m.push(most);
    }
    let slipping_share = (0..storeys)
        .map(|storey| {
            let of_storey = history.slips.iter().filter(|s| s.storey == storey);
            let slipping_s = of_storey.fold(0.0, |time, s| {
                time + (s.to_s.min(to_s) - s.from_s.max(from_s)).max(0.0)
            });
            slipping_s / (to_s - from_s)
        })
        .collect();
    Ok(HarmonicPoint {
        frequency_hz,
        ground_acceleration_m_s2: amplitude,
        drift_m,
        slipping_share,
        steady,
        beyond_drift_limit: !finished,
    })
}

/// Largest absolute value between two samples, by the cubic through their values and slopes (times the time between them): of
/// a sine with 40 samples a cycle it is right to 2e-6, where the samples alone miss up to 3e-3.
fn largest_of_cubic(values: [f64; 2], slopes: [f64; 2]) -> f64 {
    let ends = values[0].abs().max(values[1].abs());
    if slopes[0] * slopes[1] >= 0.0 {
        return ends;
    }
    // y = y0 + d0 s + b s² + c s³; the slope d0 + 2 b s + 3 c s² has one zero in 0 … 1
    let rise = values[1] - values[0];
    let b = 3.0 * rise - 2.0 * slopes[0] - slopes[1];
    let c = slopes[0] + slopes[1] - 2.0 * rise;
    let q = -(b + (b * b - 3.0 * c * slopes[0]).max(0.0).sqrt().copysign(b));
    let turns = [slopes[0] / q, q / (3.0 * c)];
    turns
        .into_iter()
        .filter(|s| (0.0..=1.0).contains(s))
        .map(|s| (values[0] + s * (slopes[0] + s * (b + s * c))).abs())
        .fold(ends, f64::max)
}
