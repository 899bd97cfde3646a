//! The fragility of one joint of a stack.

use dolmen::assess::{FragilityFit, Observation};

/// One state of one joint of one combination of inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct JointState {
    /// The state, 0 to 2: DS1 to DS3.
    pub state: usize,
    /// The observations; intensities are peak accelerations of the ground, m/s².
    pub observations: Vec<Observation>,
    /// Bounds of the median peak, m/s²: the median over scans of the largest peak below the state, and of the smallest peak that reached
    /// it; `None` where unknown.
    pub median_between: [Option<f64>; 2],
    /// The curve over peak acceleration, m/s²; `None` without one, and if a stone fell elsewhere first in more than a tenth of the scans.
    /// Such falls depend on the joint, and a curve would lie too far right.
    pub fit: Option<FragilityFit>,
}

/// One joint of one combination of inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct JointFragility {
    /// The combination, from 0.
    pub combination: usize,
    /// One of its jobs, from which its inputs are read.
    pub job: usize,
    /// The joint, from 0.
    pub joint: usize,
    /// The stones of the joint.
    pub name: String,
    /// Its states, the mildest first.
    pub states: Vec<JointState>,
    /// Number of scans in which this joint gave way at the first fall.
    pub gave_way: usize,
}
