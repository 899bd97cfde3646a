//! Time history of a frame with dry friction: exact from event to event, for any number of storeys.
//!
//! Stages of a step: series of the motion while no slider changes → first event in it → record until the event → let sliders slip or stick, and
//! find the states of the others.

use super::DynamicsError;
use super::excitation::{FrameLoad, TimeFunction};
use super::frame_events::{Motion, TOGETHER_S};
use super::frame_friction::FrictionFrame;
use super::frame_history::{FrameHistory, FrameOutcome};
use super::frame_record::Recorder;
use super::frame_run::FrameRun;

/// Motion of a frame with dry friction.
///
/// ```text
/// M Y'' + C Y' + K Y + Σ b_i q_i = −M 1 a_ground + F                              n levels
/// Coulomb:  q = s f_k while the slider moves (s its direction); while it sticks |q| ≤ f_s and b·Y' = 0
/// Jenkins:  q = k_s (b·Y − z), |q| ≤ f_s; at f_s the slider moves with q = s f_k
/// ```
/// Between events the equation is linear, and its solution is a Taylor series accurate to the last digit (the exponential of its matrix, applied
/// to the state); the ground acceleration is linear between its samples. Events are the first roots of these polynomials: no event is missed,
/// however short, and each is located to rounding. At an event the sliders at rest are released one by one, starting with the one that exceeds
/// its force most, until all satisfy the law: a search of order n.
///
/// `progress` receives the simulated time at intervals, and stops the run by returning false.
///
/// # Errors
/// [`DynamicsError`] for options out of range, and if at an event no state of stick and slip satisfies the law. Nothing is regularised or
/// guessed.
///
/// # Limits
/// Drifts are small, springs linear, axial forces constant. Energy balances to about 1e-13 of the input.
///
/// # Source
/// Park, S.-A. and Min, K.-W. (2010), eqs 9 to 11. Differs from the source: friction acts on the drift (eq. 11, on the
/// displacement, by [`FrictionActsOn`](super::FrictionActsOn)), and sticking is part of the law.
pub fn simulate_frame(
    frame: &FrictionFrame,
    load: &FrameLoad,
    options: &FrameRun,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<FrameHistory, DynamicsError> {
    let duration_s = options.check(frame, load)?;
    let mut motion = Motion::start(frame, load, options)?;
    let recorder = Recorder::new(&motion.model, &motion.state, options.output_step_s, duration_s);
    let mut recorder = recorder.under(load.forces_n.iter().map(TimeFunction::constant).collect());
    let step_most_s = motion.model.step_most_s().min(load_step_most_s(load));
    let mut outcome = FrameOutcome::Finished;
    let mut reported = 0;
    if let Some(storey) = motion.leaned {
        let outcome = FrameOutcome::DriftLimit { storey, at_s: 0.0 };
        return Ok(recorder.finish(&motion.model, &motion.state, 0.0, outcome));
    }
    'run: for end_s in ends_s(load, duration_s) {
        while end_s - motion.at_s > TOGETHER_S {
            let h = step_most_s.min(end_s - motion.at_s);
            motion.step(h, end_s, &mut recorder)?;
            let lost = || motion.state.y.iter().position(|y| y.is_nan());
            if let Some(storey) = motion.leaned.or_else(lost) {
                outcome = FrameOutcome::DriftLimit {
                    storey,
                    at_s: motion.at_s,
                };
                break 'run;
            }
            reported += 1;
            if reported % 256 == 0 && !progress(motion.at_s) {
                outcome = FrameOutcome::Stopped { at_s: motion.at_s };
                break 'run;
            }
        }
    }
    Ok(recorder.finish(&motion.model, &motion.state, motion.at_s, outcome))
}

pub(super) fn load_step_most_s(load: &FrameLoad) -> f64 {
    let forces = load.forces_n.iter().map(|f| f.step_most_s());
    forces.fold(load.ground_acceleration_m_s2.step_most_s(), f64::min)
}

/// Ends of the intervals with one load series, in order; the last is the end of the run.
fn ends_s(load: &FrameLoad, duration_s: f64) -> Vec<f64> {
    let mut ends = load.ground_acceleration_m_s2.breaks_s(duration_s);
    for force in &load.forces_n {
        ends.extend(force.breaks_s(duration_s));
    }
    ends.push(duration_s);
    ends.sort_by(f64::total_cmp);
    ends.dedup_by(|later, earlier| *later - *earlier <= TOGETHER_S);
    ends
}
