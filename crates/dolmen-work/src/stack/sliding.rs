//! The sliding model of a pile, in addition to its contact simulation: blocks slide and twist, and do not rock.

use crate::error::WorkError;
use crate::progress::{Progress, simulating};
use dolmen::blocks::{Sliding, SlidingHistory, SlidingOutcome, simulate_sliding};
use dolmen::signal::GroundMotion;
use dolmen::structure::stack::Stack;

/// Slip above which a bed slides, m. Our choice: a hundred times the accuracy of the run.
const SLIP_LEAST_M: f64 = 1e-6;
/// Rotation above which a bed twists, rad. Our choice: the same for a bed one metre wide.
const TURN_LEAST_RAD: f64 = 1e-6;

/// The mode of a bed after Hwang & Kim (2002). The fifth, a jump, ends the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlidingMode {
    /// It stuck.
    Stick,
    /// It slid.
    Slide,
    /// It rotated about the vertical.
    Twist,
    /// It slid and rotated.
    SlideTwist,
}

/// A run of the sliding model.
#[derive(Clone, Debug, PartialEq)]
pub struct SlidingRun {
    /// The history.
    pub history: SlidingHistory,
}

impl SlidingRun {
    /// The mode of the bed of a joint.
    pub fn mode(&self, joint: usize) -> SlidingMode {
        let Some(of) = self.history.joints.get(joint) else {
            return SlidingMode::Stick;
        };
        match (of.peak_slip_m >= SLIP_LEAST_M, of.peak_yaw_rad >= TURN_LEAST_RAD) {
            (false, false) => SlidingMode::Stick,
            (true, false) => SlidingMode::Slide,
            (false, true) => SlidingMode::Twist,
            (true, true) => SlidingMode::SlideTwist,
        }
    }

    /// Time in motion of the bed of a joint, s.
    pub fn moving_s(&self, joint: usize) -> f64 {
        let own = self.history.spells.iter().filter(|spell| spell.joint == joint);
        own.map(|spell| spell.to_s - spell.from_s).sum()
    }

    /// The bed that slipped farthest, if any moved.
    pub fn farthest(&self) -> Option<usize> {
        let moved = (0..self.history.joints.len()).filter(|joint| self.mode(*joint) != SlidingMode::Stick);
        let slip = |joint: &usize| self.history.joints[*joint].peak_slip_m;
        moved.max_by(|a, b| slip(a).total_cmp(&slip(b)))
    }

    /// Number of beds that moved.
    pub fn moved(&self) -> usize {
        let joints = 0..self.history.joints.len();
        joints
            .filter(|joint| self.mode(*joint) != SlidingMode::Stick)
            .count()
    }

    /// Whether the run is complete.
    pub fn is_whole(&self) -> bool {
        matches!(self.history.outcome, SlidingOutcome::Stuck | SlidingOutcome::Slid)
    }
}

/// The pile under the motion by the sliding model.
///
/// # Errors
/// [`WorkError`] for a stack that is not a single pile of dry level beds.
pub(super) fn sliding(
    stack: &Stack,
    motion: &GroundMotion,
    duration_s: Option<f64>,
    output_step_s: f64,
    progress: &dyn Progress,
) -> Result<SlidingRun, WorkError> {
    let options = Sliding {
        duration_s,
        output_step_s,
        ..Sliding::default()
    };
    let whole_s = duration_s.unwrap_or(motion.duration_s() + options.rest_s);
    let history = simulating(progress, whole_s, |reached| {
        simulate_sliding(stack, Some(motion), &options, reached)
    })?;
    Ok(SlidingRun { history })
}
