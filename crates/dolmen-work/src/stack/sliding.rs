//! The sliding model of a pile beside its simulation by contact: blocks that slide and twist, and do not rock.

use crate::error::WorkError;
use crate::progress::{Progress, simulating};
use dolmen::blocks::{Sliding, SlidingHistory, SlidingOutcome, simulate_sliding};
use dolmen::signal::GroundMotion;
use dolmen::structure::stack::Stack;

/// Slip of a bed from which it counts as sliding, m. Chosen here: a hundred times what the run is exact to.
const SLIP_LEAST_M: f64 = 1e-6;
/// Turn of a bed from which it counts as twisting, rad. Chosen here, likewise for a bed a metre wide.
const TURN_LEAST_RAD: f64 = 1e-6;

/// What a bed did: the modes of Hwang & Kim (2002). The fifth, a jump, ends the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlidingMode {
    /// It never let go.
    Stick,
    /// It slid.
    Slide,
    /// It turned about the vertical.
    Twist,
    /// It slid and turned.
    SlideTwist,
}

/// A run of the sliding model.
#[derive(Clone, Debug, PartialEq)]
pub struct SlidingRun {
    /// What happened.
    pub history: SlidingHistory,
}

impl SlidingRun {
    /// What the bed of a joint did.
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

    /// How long the bed of a joint moved, s.
    pub fn moving_s(&self, joint: usize) -> f64 {
        let own = self.history.spells.iter().filter(|spell| spell.joint == joint);
        own.map(|spell| spell.to_s - spell.from_s).sum()
    }

    /// The bed that slipped farthest, if any let go.
    pub fn farthest(&self) -> Option<usize> {
        let moved = (0..self.history.joints.len()).filter(|joint| self.mode(*joint) != SlidingMode::Stick);
        let slip = |joint: &usize| self.history.joints[*joint].peak_slip_m;
        moved.max_by(|a, b| slip(a).total_cmp(&slip(b)))
    }

    /// How many beds let go.
    pub fn moved(&self) -> usize {
        let joints = 0..self.history.joints.len();
        joints
            .filter(|joint| self.mode(*joint) != SlidingMode::Stick)
            .count()
    }

    /// Whether it reached its end.
    pub fn is_whole(&self) -> bool {
        matches!(self.history.outcome, SlidingOutcome::Stuck | SlidingOutcome::Slid)
    }
}

/// The pile under the motion by the sliding model.
///
/// # Errors
/// [`WorkError`] for a stack that is no single pile of dry level beds.
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
