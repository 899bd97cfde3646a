//! Result of a simulation: how it ended, and the data to draw, check and repeat it.

/// Energy that counts as none, J: rounding. Chosen here.
const MADE_OF_NOTHING_J: f64 = 1e-6;

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// No joint opened by more than [`StackHistory::UPLIFT_LEAST_M`], and no stone fell.
    Stood,
    /// A joint opened, but every stone stayed up.
    Uplifted {
        /// The joint that opened first, as an index of the stack's joints.
        joint: usize,
        /// When, s.
        at_s: f64,
    },
    /// No stone fell, but one lies on the brink at the end: it slid by more than half the width of its bed, or less than half is
    /// left of the way from its plumb line to the edge of what carries it.
    Slid {
        /// The one with the least left, as an index of the stack's blocks.
        block: usize,
        /// How far it lies from where it lay at rest on what carries it, m.
        slip_m: f64,
        /// Remaining distance from the vertical through the centroid to the edge of the support, over that at rest, –; negative if the vertical is
        /// outside the support.
        margin_ratio: f64,
    },
    /// The run came to its end while stones moved, not less and less, or with a stone whose plumb line lies at or beyond the edge of what carries it: there is
    /// no verdict.
    StillMoving {
        /// The stone, as an index of the stack's blocks.
        block: usize,
        /// When, s.
        at_s: f64,
        /// Remaining distance from the vertical through the centroid to the edge of the support, over that at rest, –.
        margin_ratio: f64,
    },
    /// A stone fell relative to its initial support: its centroid dropped by more than half its least thickness, its bed rotated by more than 45°, it
    /// touched no part of the support for a second or at the end, or it rests there on another face.
    Fell {
        /// The first, as an index of the stack's blocks.
        block: usize,
        /// The joint that gave way, as an index of the stack's joints: at that time it had opened or slipped farthest. The
        /// stone that comes down first may be another than the one that lost its hold.
        joint: usize,
        /// When, s.
        at_s: f64,
    },
    /// The caller stopped it.
    Stopped {
        /// When, s.
        at_s: f64,
    },
    /// A step of the rigid law found no velocities that obey the law of every contact: the run ends before it.
    NotConverged {
        /// When, s.
        at_s: f64,
        /// How far its last try was from the law, m/s.
        residual_m_s: f64,
    },
    /// Numbers overflowed, or contacts created more than a hundredth of the input energy even with the shortest step: the run is unusable.
    Diverged {
        /// When, s.
        at_s: f64,
    },
}

/// Where a block is, against where it was drawn: a point drawn at x₀ is now at c + R (x₀ − c₀).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// c: its centroid, in the frame of the ground, m.
    pub centroid_m: [f64; 3],
    /// R as a unit quaternion, scalar first.
    pub rotation: [f64; 4],
}

/// One joint at the times of the history.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct JointHistory {
    /// Largest gap at a corner of the patch as drawn, beyond that at rest, m; 0 while closed.
    pub opening_m: Vec<f64>,
    /// Shift of the upper stone on the lower along the joint's first two axes, at its middle, from the settled state, m.
    pub slip_m: Vec<[f64; 2]>,
    /// Turn of the upper stone on the lower about the joint's normal, from the settled state, rad.
    pub yaw_rad: Vec<f64>,
    /// Largest opening at any observed step, m.
    pub peak_opening_m: f64,
    /// Largest shift, m.
    pub peak_slip_m: f64,
    /// Largest turn, rad.
    pub peak_yaw_rad: f64,
}

impl JointHistory {
    /// Shift at the end, m.
    pub fn residual_slip_m(&self) -> f64 {
        self.slip_m.last().map_or(0.0, |slip| slip[0].hypot(slip[1]))
    }

    /// Turn at the end, rad.
    pub fn residual_yaw_rad(&self) -> f64 {
        self.yaw_rad.last().copied().unwrap_or(0.0)
    }
}

/// The balance of energy at one time, all from the start, J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Energy {
    /// Kinetic energy, in the frame of the ground, J.
    pub kinetic_j: f64,
    /// Potential energy, J.
    pub potential_j: f64,
    /// In springs, bonds and ties.
    pub stored_j: f64,
    /// Work of the shaking: of the inertia forces in the frame of the ground.
    pub input_j: f64,
    /// Taken by friction and by what broke.
    pub friction_j: f64,
    /// Energy dissipated by dashpots: total loss in contacts minus the other losses, J.
    pub damping_j: f64,
    /// Taken by clipping patches again and by changes of faces; negative if they gave some.
    pub clipping_j: f64,
}

/// A simulated motion of a stack.
#[derive(Clone, Debug, PartialEq)]
pub struct StackHistory {
    /// How it ended.
    pub outcome: Outcome,
    /// Times of the samples, s.
    pub time_s: Vec<f64>,
    /// Number of blocks, the row length of `poses`.
    pub blocks: usize,
    /// Where each block is: samples × blocks, row by row.
    pub poses: Vec<Pose>,
    /// One history a joint of the stack.
    pub joints: Vec<JointHistory>,
    /// Balance of energy at the samples; the first is the start and counts as zero but for motion.
    pub energy: Vec<Energy>,
    /// Largest energy that contacts gave back beyond what they had stored, between any two samples, J.
    pub energy_made_j: f64,
    /// Indices of ties that broke.
    pub broken_ties: Vec<usize>,
    /// The step taken, s.
    pub time_step_s: f64,
    /// The longest stable step, s.
    pub longest_step_s: f64,
    /// Steps taken.
    pub steps: usize,
    /// Contact points of all joints at the start.
    pub contact_points: usize,
    /// Settlement of the highest block's centroid under its own weight, before the start, m.
    pub settlement_m: f64,
    /// How well the rigid law was obeyed; `None` of springs.
    pub rigid: Option<RigidEvidence>,
}

/// Accuracy of the solutions of the rigid law in a run, and their cost.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RigidEvidence {
    /// Largest distance of any contact point from unilateral contact and Coulomb's law, and of any stone from its balance of
    /// momentum, m/s.
    pub residual_most_m_s: f64,
    /// Deepest that any point lay in the other stone at the end of a step, m; beyond what they overlapped as drawn or as they met
    /// unseen.
    pub penetration_most_m: f64,
    /// Impacts found inside steps.
    pub impacts: usize,
    /// Solutions of the law: one a step that is not wholly at rest, and up to four an impact.
    pub solutions: usize,
    /// Newton steps of all solutions.
    pub newton_steps: usize,
    /// Steps in which all stones moved with the ground.
    pub steps_at_rest: usize,
    /// Number of solutions with a residual above 1e-6 m/s that further iterations did not improve: a nanometre in a step of 1 ms.
    pub loose_solutions: usize,
    /// Times that a step, or the rest of one, was halved because the whole found no solution.
    pub halvings: usize,
}

impl StackHistory {
    /// Opening of a joint from which it counts as uplifted, m: a tenth of a millimetre. Chosen here.
    pub const UPLIFT_LEAST_M: f64 = 1e-4;

    /// Largest additional time of a run without a given duration, until the stack is at rest or rocks with decreasing amplitude, s. Chosen here: on
    /// springs a stone of 6 m rocks for a minute.
    pub const LONGER_MOST_S: f64 = 60.0;

    /// Pose of a block at a sample.
    pub fn pose(&self, sample: usize, block: usize) -> Pose {
        self.poses[sample * self.blocks + block]
    }

    /// Energy made by contacts over the work put in (shaking and start), –; infinite if some was made and none put in.
    pub fn energy_made_ratio(&self) -> f64 {
        let start = self.energy.first().map_or(0.0, |e| e.kinetic_j + e.potential_j);
        let input = self
            .energy
            .iter()
            .map(|e| e.input_j.abs())
            .fold(start.abs(), f64::max);
        if input > 0.0 {
            self.energy_made_j / input
        } else if self.energy_made_j > MADE_OF_NOTHING_J {
            f64::INFINITY
        } else {
            0.0
        }
    }
}
