//! The fragility of one joint of a stack.

use dolmen::assess::{FragilityFit, Observation};

/// One state of one joint of one combination of inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct JointState {
    /// The state, 0 to 2: DS1 to DS3.
    pub state: usize,
    /// What was seen, intensities as peak accelerations of the ground, m/s².
    pub observations: Vec<Observation>,
    /// Half of the scans reach it between these peaks, m/s²: medians of what each is known to have been without it up to, and to have reached it
    /// by; `None` where that is not known.
    pub median_between: [Option<f64>; 2],
    /// The curve over peak acceleration, m/s²; `None` where there is none, and where a stone fell elsewhere first in more than a tenth of the scans: what
    /// would have come of the joint is not independent of that, and a curve would be too far right.
    pub fit: Option<FragilityFit>,
}

/// One joint of one combination of inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct JointFragility {
    /// The combination, from 0.
    pub combination: usize,
    /// One of its jobs, to read its inputs from.
    pub job: usize,
    /// The joint, from 0.
    pub joint: usize,
    /// What lies on what.
    pub name: String,
    /// Its states, the mildest first.
    pub states: Vec<JointState>,
    /// Scans in which it was the joint that gave way at the first fall.
    pub gave_way: usize,
}
