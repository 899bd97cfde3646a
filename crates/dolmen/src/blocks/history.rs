//! Result of a simulation: its end, and the data to draw, check and repeat it.

/// Created energy below which it counts as rounding, J. Our choice.
const MADE_OF_NOTHING_J: f64 = 1e-6;

/// The end of a run.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// No joint opened by more than [`StackHistory::UPLIFT_LEAST_M`], and no stone fell.
    Stood,
    /// A joint opened, but no stone fell.
    Uplifted {
        /// The joint that opened first, as an index of the stack's joints.
        joint: usize,
        /// Time, s.
        at_s: f64,
    },
    /// No stone fell, but at the end one is on the brink: it slid by more than half the width of its bed, or less than half of its distance to the
    /// edge of the support remains.
    Slid {
        /// The stone with the smallest remaining distance, as an index of the stack's blocks.
        block: usize,
        /// Distance from its position at rest on the support, m.
        slip_m: f64,
        /// Remaining distance from the vertical through the centroid to the edge of the support, over that at rest, –; negative if the vertical is
        /// outside the support.
        margin_ratio: f64,
    },
    /// There is no verdict: the run ended while stones moved without decreasing amplitude, or with a stone whose centroid is at or beyond the edge of
    /// its support.
    StillMoving {
        /// The stone, as an index of the stack's blocks.
        block: usize,
        /// Time, s.
        at_s: f64,
        /// Remaining distance from the vertical through the centroid to the edge of the support, over that at rest, –.
        margin_ratio: f64,
    },
    /// A stone fell relative to its initial support: its centroid dropped by more than half its least thickness, its bed rotated by more than 45°, it
    /// had no contact with the support for a second or at the end, or it lies on the support with another face.
    Fell {
        /// The first stone that fell, as an index of the stack's blocks.
        block: usize,
        /// The joint that gave way, as an index of the stack's joints: the joint with the largest opening or slip at that time. The stone that falls
        /// first has not always lost its own support.
        joint: usize,
        /// Time, s.
        at_s: f64,
    },
    /// The caller stopped the run.
    Stopped {
        /// Time, s.
        at_s: f64,
    },
    /// A step of the rigid law found no velocities that satisfy the law of every contact: the run ends before this step.
    NotConverged {
        /// Time, s.
        at_s: f64,
        /// Residual of the last attempt, m/s.
        residual_m_s: f64,
    },
    /// Numbers overflowed, or contacts created more than a hundredth of the input energy even with the shortest step. The run is unusable.
    Diverged {
        /// Time, s.
        at_s: f64,
    },
}

/// Position of a block relative to the drawing: a point drawn at x₀ is now at c + R (x₀ − c₀).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// c, its centroid in the axes of the ground, m.
    pub centroid_m: [f64; 3],
    /// R as a unit quaternion, scalar first.
    pub rotation: [f64; 4],
}

/// History of one joint at the sample times.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct JointHistory {
    /// Largest gap at a corner of the patch as drawn, minus that at rest, m; 0 while the joint is closed.
    pub opening_m: Vec<f64>,
    /// Slip of the upper stone on the lower one along the joint's first two axes, at its middle, since settlement, m.
    pub slip_m: Vec<[f64; 2]>,
    /// Rotation of the upper stone on the lower one about the joint's normal, since settlement, rad.
    pub yaw_rad: Vec<f64>,
    /// Largest opening at any observed step, m.
    pub peak_opening_m: f64,
    /// Largest slip, m.
    pub peak_slip_m: f64,
    /// Largest rotation, rad.
    pub peak_yaw_rad: f64,
    /// The largest load at an edge or a corner relative to the strength; `None` for a joint without strength, or without load under its own weight.
    pub bearing: Option<PeakBearing>,
}

/// The load of a joint when it is largest relative to the load that the bed bears there.
///
/// ```text
/// ratio = N/(f A)        A: area of the bed that is symmetric about the resultant of N
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PeakBearing {
    /// N/(f A), –: from 1 on the edge or corner under the resultant crushes.
    pub ratio: f64,
    /// Time, s.
    pub at_s: f64,
    /// N, normal force in the joint, N.
    pub force_n: f64,
    /// f A, the force that the bed bears there, N.
    pub bears_n: f64,
    /// Position of the resultant on the upper or lower stone, m, as drawn.
    pub place_m: [f64; 3],
}

impl PeakBearing {
    /// Whether the stone under the resultant crushes.
    pub fn crushes(&self) -> bool {
        self.ratio >= 1.0
    }
}

impl JointHistory {
    /// Slip at the end, m.
    pub fn residual_slip_m(&self) -> f64 {
        self.slip_m.last().map_or(0.0, |slip| slip[0].hypot(slip[1]))
    }

    /// Rotation at the end, rad.
    pub fn residual_yaw_rad(&self) -> f64 {
        self.yaw_rad.last().copied().unwrap_or(0.0)
    }
}

/// Energy balance at one time, since the start, J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Energy {
    /// Kinetic energy, in the frame of the ground, J.
    pub kinetic_j: f64,
    /// Potential energy, J.
    pub potential_j: f64,
    /// Energy stored in springs, bonds and ties, J.
    pub stored_j: f64,
    /// Work of the shaking, which is that of the inertia forces in the frame of the ground, J.
    pub input_j: f64,
    /// Energy dissipated by friction and by failures, J.
    pub friction_j: f64,
    /// Energy dissipated by dashpots: total loss in contacts minus the other losses, J.
    pub damping_j: f64,
    /// Energy lost when patches are computed again and when faces change, J; negative for a gain.
    pub clipping_j: f64,
}

/// A simulated motion of a stack.
#[derive(Clone, Debug, PartialEq)]
pub struct StackHistory {
    /// The end of the run.
    pub outcome: Outcome,
    /// Times of the samples, s.
    pub time_s: Vec<f64>,
    /// Number of blocks, the row length of `poses`.
    pub blocks: usize,
    /// Position of each block: samples × blocks, row by row.
    pub poses: Vec<Pose>,
    /// One history per joint of the stack.
    pub joints: Vec<JointHistory>,
    /// Energy balance at the samples. At the first sample, the start, all energies are zero except the kinetic energy.
    pub energy: Vec<Energy>,
    /// Largest energy that contacts returned beyond their stored energy, between any two samples, J.
    pub energy_made_j: f64,
    /// Indices of ties that broke.
    pub broken_ties: Vec<usize>,
    /// Time step of the run, s.
    pub time_step_s: f64,
    /// The longest stable step, s.
    pub longest_step_s: f64,
    /// Number of steps.
    pub steps: usize,
    /// Number of contact points of all joints at the start.
    pub contact_points: usize,
    /// Settlement of the highest block's centroid under its own weight, before the start, m.
    pub settlement_m: f64,
    /// Accuracy under the rigid law; `None` for the springs law.
    pub rigid: Option<RigidEvidence>,
}

/// Accuracy of the solutions of the rigid law in a run, and their cost.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RigidEvidence {
    /// Largest residual of unilateral contact and Coulomb's law at any contact point, and of the momentum balance of any stone, m/s.
    pub residual_most_m_s: f64,
    /// Largest penetration of any point at the end of a step, m, in addition to overlaps as drawn or of undetected contacts.
    pub penetration_most_m: f64,
    /// Number of impacts located inside steps.
    pub impacts: usize,
    /// Number of solutions of the law: one per step that is not wholly at rest, and up to four per impact.
    pub solutions: usize,
    /// Number of Newton steps in all solutions, with those of the other two methods.
    pub newton_steps: usize,
    /// Number of solutions by the interior-point method, because Newton's method on the law itself did not converge.
    pub interior_solutions: usize,
    /// Number of solutions by softer weights or convex problems, because the interior-point method did not converge either.
    pub softer_solutions: usize,
    /// Number of steps in which all stones moved with the ground.
    pub steps_at_rest: usize,
    /// Number of solutions with a residual above 1e-6 m/s that further iterations did not improve; this is a nanometre in a step of 1 ms.
    pub loose_solutions: usize,
    /// Number of times that a step, or its remainder, was halved because it had no solution.
    pub halvings: usize,
}

impl StackHistory {
    /// Opening from which a joint counts as uplifted, m: a tenth of a millimetre. Our choice.
    pub const UPLIFT_LEAST_M: f64 = 1e-4;

    /// Largest extension of a run without a given duration, s, until the stack is at rest or rocks with decreasing amplitude. Our choice: on springs,
    /// a stone of 6 m rocks for a minute.
    pub const LONGER_MOST_S: f64 = 60.0;

    /// Pose of a block at a sample.
    pub fn pose(&self, sample: usize, block: usize) -> Pose {
        self.poses[sample * self.blocks + block]
    }

    /// Energy created by contacts over the input energy (shaking and start), –; infinite if energy was created without input.
    pub fn energy_made_ratio(&self) -> f64 {
        let mut start = self.energy.first().map_or(0.0, |e| e.kinetic_j + e.potential_j);
        if self.joints.is_empty() {
            // loose stones: the lost height is input energy
            start = self.energy.iter().map(|e| -e.potential_j).fold(start, f64::max);
        }
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
