//! The motion of a chain, its end, and all data to draw, check and repeat it.

use super::chain_rigid::ChainRigidJoint;

/// End of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ChainOutcome {
    /// The chain stood until the end, and no joint opened.
    Stood,
    /// The chain stood until the end, but a joint opened.
    Uplifted {
        /// The first joint that opened, 0 the lowest.
        joint: usize,
        /// Time of opening, s.
        at_s: f64,
    },
    /// A link reached the angle of a fall; the run ends there.
    Fell {
        /// The link, 0 the lowest.
        link: usize,
        /// Time of the fall, s.
        at_s: f64,
    },
    /// At the end a link leaned further than before and still moved outwards, so it is unknown whether it falls.
    StillLeaning {
        /// The link, 0 the lowest.
        link: usize,
        /// The end of the run, s.
        at_s: f64,
    },
    /// The caller stopped the run.
    Stopped {
        /// Time of the stop, s.
        at_s: f64,
    },
}

/// A largest rotation, including times between samples.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ChainPeak {
    /// The rotation with its sign, rad.
    pub rotation_rad: f64,
    /// Its time, s.
    pub at_s: f64,
}

/// One interval in which a joint was open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainUplift {
    /// The joint, 0 the lowest.
    pub joint: usize,
    /// Time of opening, s.
    pub from_s: f64,
    /// Time of closing, s; the end of the run if it stayed open.
    pub to_s: f64,
}

/// The largest displacement at a side support, including times between samples.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ChainSupportPeak {
    /// Displacement from the stress-free position, with its sign, m.
    pub displacement_m: f64,
    /// Force of the support at that time, with the same sign, N; 0 within its gap.
    pub force_n: f64,
    /// Its time, s.
    pub at_s: f64,
}

/// One interval of contact with a side support.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainTouch {
    /// The support, 0 the first.
    pub support: usize,
    /// Start of the contact, s.
    pub from_s: f64,
    /// End of the contact, s; the end of the run if it lasted.
    pub to_s: f64,
}

/// One interval in which a joint rotated against its friction, in one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainSlip {
    /// The joint, 0 the lowest.
    pub joint: usize,
    /// Start of the rotation, s.
    pub from_s: f64,
    /// Stop or reversal, s; the end of the run if it lasted.
    pub to_s: f64,
    /// Rotation across the joint during the interval, rad.
    pub slip_rad: f64,
}

/// The energy balance at one time, J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ChainEnergy {
    /// Kinetic energy of motion relative to the ground, J.
    pub kinetic_j: f64,
    /// Potential energy of the weight: 0 if upright, otherwise negative.
    pub gravity_j: f64,
    /// Energy in the springs of the joints and the side supports.
    pub springs_j: f64,
    /// Energy dissipated by the dashpots.
    pub damping_j: f64,
    /// Energy dissipated by dry friction.
    pub friction_j: f64,
    /// Energy at the start, and the work of the ground's inertia forces.
    pub input_j: f64,
}

impl ChainEnergy {
    /// The residual of the balance: the error of the computation.
    pub fn left_over_j(&self) -> f64 {
        self.input_j - self.kinetic_j - self.gravity_j - self.springs_j - self.damping_j - self.friction_j
    }
}

/// A motion of a chain. Histories have one row for each link, lowest first.
#[derive(Clone, Debug, PartialEq)]
pub struct ChainHistory {
    /// Its end.
    pub outcome: ChainOutcome,
    /// Times of the samples, s; the last is the end of the run.
    pub times_s: Vec<f64>,
    /// Rotations of the links from the vertical, rad.
    pub rotation_rad: Vec<Vec<f64>>,
    /// Angular velocities of the links, rad/s.
    pub velocity_rad_s: Vec<Vec<f64>>,
    /// Moments of the joints, N m: spring and friction, without dashpots.
    pub joint_moment_n_m: Vec<Vec<f64>>,
    /// Contribution of friction to the joint moments, N m: positive where it resists a rotation to the right.
    pub friction_moment_n_m: Vec<Vec<f64>>,
    /// The balance of energy at the samples.
    pub energy: Vec<ChainEnergy>,
    /// Largest rotation of each link.
    pub rotation_peaks: Vec<ChainPeak>,
    /// Largest rotation across each joint.
    pub joint_peaks: Vec<ChainPeak>,
    /// Largest moment of each joint's spring, N m, absolute.
    pub joint_moment_peaks_n_m: Vec<f64>,
    /// Largest displacement of the top relative to the ground, with its sign, m.
    pub top_peak_m: f64,
    /// Its time, s.
    pub top_peak_at_s: f64,
    /// Intervals of open joints, in order of opening.
    pub uplifts: Vec<ChainUplift>,
    /// Force of each side support at the samples, N, positive against a displacement to the right; one row for each support.
    pub support_force_n: Vec<Vec<f64>>,
    /// Largest displacement at each side support, and its force.
    pub support_peaks: Vec<ChainSupportPeak>,
    /// Contacts with side supports, in order; permanent for a support without a gap.
    pub touches: Vec<ChainTouch>,
    /// Slips of joints against their friction, in the order of their ends.
    pub slips: Vec<ChainSlip>,
    /// Times at which some joint began to rotate against its friction, reversed or stopped; simultaneous changes count once.
    pub friction_events: usize,
    /// Whether everything was at rest at the end, relative to the ground.
    pub at_rest: bool,
    /// Largest residual of the energy balance at the end of any step, over the largest kinetic energy of the run.
    pub energy_left_over_ratio: f64,
    /// Number of steps of the integration.
    pub steps: usize,
    /// Whether a missing moment of inertia was assumed as that of a thin rod.
    pub assumes_thin_rods: bool,
    /// The stress-free lean of all links, rad.
    pub lean_rad: f64,
    /// Joints taken as rigid because they are much stiffer than the others: their rotation is their moment over their stiffness.
    pub rigid_joints: Vec<ChainRigidJoint>,
}

impl ChainHistory {
    /// Total time in which a joint (0 the lowest) was open, s.
    pub fn open_s(&self, joint: usize) -> f64 {
        let of_joint = self.uplifts.iter().filter(|uplift| uplift.joint == joint);
        of_joint.fold(0.0, |time, uplift| time + uplift.to_s - uplift.from_s)
    }

    /// Accumulated rotation of a joint (0 the lowest) against its friction, both directions, rad.
    pub fn slipped_rad(&self, joint: usize) -> f64 {
        let of_joint = self.slips.iter().filter(|slip| slip.joint == joint);
        of_joint.fold(0.0, |way, slip| way + slip.slip_rad.abs())
    }

    /// The link that leans further at the end than at any sample since `from_s`, and moves outwards; if there are several, the one with the
    /// largest lean.
    pub(super) fn leaning_out(&self, from_s: f64) -> Option<usize> {
        let since = self.times_s.partition_point(|at_s| *at_s < from_s);
        let leaning = (0..self.rotation_rad.len()).filter_map(|link| {
            let (angle, rate) = (&self.rotation_rad[link], self.velocity_rad_s[link].last()?);
            let (end, before) = angle.get(since..)?.split_last()?;
            let is_out = end * rate > 0.0 && before.iter().all(|earlier| earlier.abs() < end.abs());
            is_out.then_some((link, end.abs()))
        });
        leaning.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(link, _)| link)
    }

    /// Rotation across a joint (0 the lowest) at every sample, from the stress-free position, rad.
    pub fn across_rad(&self, joint: usize) -> Vec<f64> {
        if let Some(rigid) = self.rigid_joints.iter().find(|rigid| rigid.joint == joint) {
            let moments = self.joint_moment_n_m[joint].iter();
            return moments.map(|moment| moment / rigid.stiffness_n_m_rad).collect();
        }
        let mut across = across(&self.rotation_rad, joint);
        if joint == 0 {
            across.iter_mut().for_each(|angle| *angle -= self.lean_rad);
        }
        across
    }

    /// Rate of the rotation across a joint, rad/s; 0 for a joint taken as rigid.
    pub fn across_rad_s(&self, joint: usize) -> Vec<f64> {
        across(&self.velocity_rad_s, joint)
    }
}

/// Row of a link minus that of the link below.
fn across(rows: &[Vec<f64>], joint: usize) -> Vec<f64> {
    let above = &rows[joint];
    match joint.checked_sub(1) {
        None => above.clone(),
        Some(below) => above.iter().zip(&rows[below]).map(|(a, b)| a - b).collect(),
    }
}
