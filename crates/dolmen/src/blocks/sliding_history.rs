//! Result of a run of the sliding model.

use super::history::{JointHistory, Pose};

/// The end of a run of [`super::simulate_sliding`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SlidingOutcome {
    /// No joint was released: all blocks moved with the ground.
    Stuck,
    /// At least one joint slid or twisted.
    Slid,
    /// The pressure left a bed: the blocks above begin to rock, which the model does not include. The run ends there.
    Rocks {
        /// The joint, as an index of the stack's joints.
        joint: usize,
        /// Time, s.
        at_s: f64,
    },
    /// The ground accelerated downwards faster than gravity, which the model does not include. The run ends there.
    LeftTheGround {
        /// Time, s.
        at_s: f64,
    },
    /// The caller stopped the run.
    Stopped {
        /// Time, s.
        at_s: f64,
    },
}

/// A period in which a joint slid or twisted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlidingSpell {
    /// The joint, as an index of the stack's joints.
    pub joint: usize,
    /// Start, s.
    pub from_s: f64,
    /// End, s; the end of the run if it still moved.
    pub to_s: f64,
}

/// Motion of a sliding pile.
#[derive(Clone, Debug, PartialEq)]
pub struct SlidingHistory {
    /// The end of the run.
    pub outcome: SlidingOutcome,
    /// Times of the samples, s.
    pub time_s: Vec<f64>,
    /// Number of blocks, the row length of `poses`.
    pub blocks: usize,
    /// Pose of each block: samples × blocks, row by row.
    pub poses: Vec<Pose>,
    /// One history per joint of the stack; no joint opens.
    pub joints: Vec<JointHistory>,
    /// Periods of motion of the joints, in the order in which they stopped.
    pub spells: Vec<SlidingSpell>,
    /// Work of the shaking in the frame of the ground, J.
    pub input_j: f64,
    /// Energy dissipated by friction, J.
    pub friction_j: f64,
    /// Largest error of the energy balance at any step: |motion + friction − input − start|, J.
    pub energy_error_j: f64,
    /// Number of steps.
    pub steps: usize,
}
