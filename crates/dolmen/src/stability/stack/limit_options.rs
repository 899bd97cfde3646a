//! What a limit analysis is asked, and what it answers.

use super::mechanism::Mechanism;
use super::{StackLoads, Threshold};

/// What holds besides friction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Holding {
    /// Nothing: every joint is dry and every tie is gone. Default.
    #[default]
    FrictionOnly,
    /// Cohesion against sliding, in full in every joint at once, as if it could slip without breaking. Ties are gone.
    Cohesion,
    /// Cohesion, and ties at their strengths all at once, as if each could stretch without breaking.
    CohesionAndTies,
}

/// Which way a stack is shaken.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Shaking {
    /// Whichever horizontal way moves it soonest. Default.
    #[default]
    AnyWay,
    /// Along one direction of the inertia forces; need not be of unit length.
    Along([f64; 2]),
}

/// How a limit analysis is made.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LimitAnalysis {
    /// What acts before any horizontal shaking. Default nothing.
    pub loads: StackLoads,
    /// Direction of the inertia forces. Default the one that moves it soonest.
    pub shaking: Shaking,
    /// What holds besides friction. Default nothing.
    pub holding: Holding,
    /// Forces of shaking on each block, if they are not its mass times one acceleration. Default `None`.
    pub swaying: Option<Vec<SwayingForces>>,
}

/// Forces of shaking on one block, for shaking of 1 g in name: the accelerations that a limit analysis gives are then factors on these, over g.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SwayingForces {
    /// Force at its centroid along x when shaken along x, and along y when shaken along y, N.
    pub force_n: [f64; 2],
    /// Moment about its centroid that goes with each: about y, and about −x, N m.
    pub moment_n_m: [f64; 2],
}

/// What a limit analysis found.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitAnalysisResult {
    /// How it ended.
    pub status: LimitAnalysisStatus,
    /// How it begins to move: at the limit, or at once if it does not stand. `None` if nothing moves it, or it stands on an edge.
    pub mechanism: Option<Mechanism>,
    /// Acceleration below which forces in the joints were found for every direction looked at, over gravity.
    pub at_least_g: f64,
    /// Largest error of any solution, over the weight (times the size) of what it balances: balance of forces and moments,
    /// friction beyond the cone, a mechanism that enters a stone, the difference between what forces and mechanism say.
    pub residual: f64,
    /// Programmes solved.
    pub solved: usize,
    /// Unknown forces of all pieces together.
    pub variables: usize,
    /// Equations of balance of all pieces together.
    pub equations: usize,
}

/// How a limit analysis ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LimitAnalysisStatus {
    /// The least acceleration for which a mechanism was found that no forces balance, and its direction.
    Limited(Threshold),
    /// No forces in the joints balance the weight and static loads: it does not stand.
    DoesNotStand,
    /// Every acceleration up to 10 g can be balanced: the stack is wedged.
    Unlimited,
}
