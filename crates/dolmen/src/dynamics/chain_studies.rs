//! Maps of opening and slipping of a chain over frequency and amplitude of a harmonic motion of the ground.

use super::chain_history::ChainOutcome;
use super::harmonic_map::{HarmonicPoint, harmonic_ground};
use super::{ChainModel, ChainRun, DynamicsError, simulate_chain};

/// Steady response of a chain to harmonic ground motions: one point for each frequency and acceleration, in rows of equal frequency.
///
/// `progress` receives the finished fraction. If it returns false, the map stops and the remaining points are missing.
///
/// # Errors
/// As for [`simulate_chain`].
///
/// # Limits
/// As for [`harmonic_map`](super::harmonic_map): 40 cycles from rest, both of the ground and of the slowest mode of the chain with all joints as
/// springs. An unstable chain has no such mode: its point gives the time of its fall.
pub fn chain_harmonic_map(
    model: &ChainModel,
    frequencies_hz: &[f64],
    ground_accelerations_m_s2: &[f64],
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<Vec<HarmonicPoint>, DynamicsError> {
    let stiffness: Vec<f64> = model
        .joints()
        .iter()
        .map(|joint| joint.stiffness_n_m_rad)
        .collect();
    let modes = model.chain().natural_modes(&stiffness);
    let slowest_hz = modes.ok().and_then(|modes| Some(modes.first()?.frequency_hz));
    let whole = frequencies_hz.len() * ground_accelerations_m_s2.len();
    let mut points = Vec::with_capacity(whole);
    for &frequency_hz in frequencies_hz {
        for &amplitude_m_s2 in ground_accelerations_m_s2 {
            if !progress(points.len() as f64 / whole as f64) {
                return Ok(points);
            }
            let slowest_hz = slowest_hz.map_or(frequency_hz, |slowest| slowest.min(frequency_hz));
            points.push(point(model, [frequency_hz, amplitude_m_s2], slowest_hz)?);
        }
    }
    Ok(points)
}

fn point(
    model: &ChainModel,
    [frequency_hz, amplitude_m_s2]: [f64; 2],
    slowest_hz: f64,
) -> Result<HarmonicPoint, DynamicsError> {
    let (ground, window) = harmonic_ground(frequency_hz, amplitude_m_s2, slowest_hz);
    let options = ChainRun {
        duration_s: Some(window.to_s),
        output_step_s: window.step_s,
        ..ChainRun::default()
    };
    let history = simulate_chain(model, &ground, &options, &mut |_| true)?;
    let fell = matches!(history.outcome, ChainOutcome::Fell { .. });
    let ended_s = history.times_s.last().copied().unwrap_or_default();
    let window = window.of_run(!fell, ended_s);
    let joints = (0..model.joints().len()).map(|joint| {
        let open = history.uplifts.iter().filter(|open| open.joint == joint);
        let slips = history.slips.iter().filter(|slip| slip.joint == joint);
        let moving_s: Vec<[f64; 2]> = open
            .map(|open| [open.from_s, open.to_s])
            .chain(slips.map(|slip| [slip.from_s, slip.to_s]))
            .collect();
        let most = history.joint_peaks[joint].rotation_rad.abs();
        window.part(
            (&history.across_rad(joint), &history.across_rad_s(joint)),
            most,
            &moving_s,
        )
    });
    Ok(window.point(joints.collect()))
}
