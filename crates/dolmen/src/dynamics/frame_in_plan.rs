//! A frame under two components of ground motion. Without friction in both directions of a joint, each direction is computed separately;
//! otherwise both together in time steps.
//!
//! A storey with friction in both directions slides on the same faces: it has one slip force for all directions. The direction of slip changes
//! during the motion, so the solution has no power series, and the run uses equal time steps.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | u, v | `State::y`, `State::v` | displacements and velocities of the levels in one direction | m, m/s |
//! | B | `across` | levels → drifts | – |
//! | q | `friction_n` | force of the friction element of a storey in one direction | N |
//! | f | `limit_n` | slip force in that direction | N |
//! | s | `share` | q / f; \|s\| ≤ 1 in both directions together | – |
//! | Δ | | slip of the slider in a step | m |
//! | λ | `work_j` | work of friction in a slip, f·Δ along s | J |

use super::DynamicsError;
use super::excitation::FrameLoad;
use super::frame_friction::{FrictionActsOn, FrictionFrame};
use super::frame_history::{FrameHistory, FrameOutcome};
use super::frame_model::Model;
use super::frame_motion::{load_step_most_s, simulate_frame};
use super::frame_plan_record::run;
use super::frame_plan_steps::{BothDirections, Steps};
use super::frame_run::FrameRun;

/// Number of steps per radian of the fastest elastic oscillation of a storey. Our choice: elastic oscillations are then accurate to 4e-5.
const STEPS_A_RADIAN: f64 = 50.0;
/// Longest step, s. Our choice: records have steps of 0.005 to 0.02 s.
const STEP_MOST_S: f64 = 5e-4;
/// Largest allowed relative change of a peak drift when the step is halved. Our choice: a tenth of the uncertainty of a friction coefficient.
const CHANGE_MOST: f64 = 0.005;
/// Largest number of halvings of the step before the run is refused. Our choice.
const HALVINGS_MOST: usize = 5;

/// Time steps of a run in which both directions share their slip forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SharedFriction {
    /// Length of a step, s.
    pub step_s: f64,
    /// Change of the peak drifts at the last halving of the step, relative to the largest of them.
    pub change: f64,
}

/// Histories of a frame in two directions.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameInPlan {
    /// The history in each direction.
    pub histories: [FrameHistory; 2],
    /// The time steps, if a storey has friction in both directions; `None` if the directions are independent and each is exact.
    pub shared: Option<SharedFriction>,
}

/// Indices of the storeys with friction in both directions, 0 the lowest.
pub fn storeys_that_rub_both_ways(frames: [&FrictionFrame; 2]) -> Vec<usize> {
    let rubs = |of: &FrictionFrame, storey: usize| of.friction[storey].limits_n().is_some();
    let storeys = 0..frames[0].friction.len().min(frames[1].friction.len());
    storeys
        .filter(|storey| frames.iter().all(|of| rubs(of, *storey)))
        .collect()
}

/// Motion of a frame with dry friction in two directions, each with its own load.
///
/// ```text
/// M u_d'' + C_d u_d' + K_d u_d + Bᵀ q_d = −M 1 a_d + F_d,   d = 1, 2
/// (q_1/f_1)² + (q_2/f_2)² ≤ 1;  at 1 it slips with  f_d Δ_d = λ q_d/f_d,  λ > 0
/// ```
/// With equal f the slip is opposite to the force (Coulomb's law in the plane); with different f the friction dissipates the most work (an
/// ellipse). If no storey has friction in both directions, they are independent: [`simulate_frame`] then runs each exactly.
///
/// Shared friction is integrated in time steps: springs, dashpots and inertia by the trapezoidal rule, the friction law at the end of each
/// step. Sweeps over all storeys end when their forces change by less than 1e-11. The energy balances to rounding. The step is halved until the
/// peak drifts change by at most 0.5 %; the result contains the change.
///
/// # Errors
/// The errors of [`simulate_frame`]; [`DynamicsError::Argument`] for sliders that act on displacements; [`DynamicsError::Count`] for frames
/// with different storeys; [`DynamicsError::NotConverged`] if peaks still change.
///
/// # Limits
/// First order in the step while the direction of slip changes. Floors do not twist. Tested by `frame_in_plan`.
///
/// # Source
/// The law is that of maximal dissipation: Moreau, J. J. (1988), Unilateral contact and dry friction in finite freedom dynamics, for the plane.
pub fn simulate_frame_in_plan(
    frames: [&FrictionFrame; 2],
    loads: [&FrameLoad; 2],
    runs: [&FrameRun; 2],
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<FrameInPlan, DynamicsError> {
    let storeys = frames.map(|of| of.friction.len());
    if storeys[0] != storeys[1] {
        return Err(DynamicsError::Count {
            argument: "the second direction",
            given: storeys[1],
            needed: storeys[0],
        });
    }
    if storeys_that_rub_both_ways(frames).is_empty() {
        let first = simulate_frame(frames[0], loads[0], runs[0], progress)?;
        let second = simulate_frame(frames[1], loads[1], runs[1], progress)?;
        return Ok(FrameInPlan {
            histories: [first, second],
            shared: None,
        });
    }
    let on_displacement = frames
        .iter()
        .filter(|of| of.acts_on != FrictionActsOn::Drift)
        .count();
    if on_displacement > 0 {
        return Err(DynamicsError::Argument {
            argument: "directions with sliders",
            given: on_displacement as f64,
            allowed: "0 where both directions rub",
        });
    }
    let with_tenons = frames
        .iter()
        .filter(|of| of.tenons.iter().any(Option::is_some))
        .count();
    if with_tenons > 0 {
        return Err(DynamicsError::TenonsRubBothWays {
            directions: with_tenons,
        });
    }
    let durations = [
        runs[0].check(frames[0], loads[0])?,
        runs[1].check(frames[1], loads[1])?,
    ];
    halved((frames, loads, runs), durations[0].max(durations[1]), progress)
}

/// Halves the step until the peaks agree.
fn halved(
    both: BothDirections<'_>,
    duration_s: f64,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<FrameInPlan, DynamicsError> {
    let longest_s = longest_step_s(both)?;
    let output_step_s = both.2[0].output_step_s;
    // a whole number of steps per sample interval
    let mut each = (output_step_s / longest_s).ceil();
    let mut run = |each: f64| {
        let steps = Steps::new(both, output_step_s / each)?;
        run(steps, (each as usize, duration_s), progress)
    };
    let mut coarse = run(each)?;
    let mut change = f64::INFINITY;
    for _ in 0..HALVINGS_MOST {
        each *= 2.0;
        let fine = run(each)?;
        change = change_of_peaks(&coarse, &fine);
        if change <= CHANGE_MOST || fine[0].outcome != FrameOutcome::Finished {
            return Ok(FrameInPlan {
                histories: fine,
                shared: Some(SharedFriction {
                    step_s: output_step_s / each,
                    change,
                }),
            });
        }
        coarse = fine;
    }
    Err(DynamicsError::NotConverged {
        step_s: output_step_s / each,
        change,
        most: CHANGE_MOST,
    })
}

fn longest_step_s((frames, loads, _): BothDirections<'_>) -> Result<f64, DynamicsError> {
    let mut longest_s = STEP_MOST_S;
    for (frame, load) in frames.into_iter().zip(loads) {
        let radian_s = Model::of(frame)?.step_most_s().min(load_step_most_s(load));
        longest_s = longest_s.min(radian_s / STEPS_A_RADIAN);
    }
    Ok(longest_s)
}

/// Largest change of a peak drift over the largest peak.
fn change_of_peaks(coarse: &[FrameHistory; 2], fine: &[FrameHistory; 2]) -> f64 {
    let (mut change_m, mut largest_m) = (0.0_f64, 0.0_f64);
    for (coarse, fine) in coarse.iter().zip(fine) {
        for (before, after) in coarse.drift_peaks.iter().zip(&fine.drift_peaks) {
            change_m = change_m.max((before.value_m.abs() - after.value_m.abs()).abs());
            largest_m = largest_m.max(after.value_m.abs());
        }
    }
    if largest_m > 0.0 {
        change_m / largest_m
    } else {
        0.0
    }
}
