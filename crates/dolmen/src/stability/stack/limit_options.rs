//! Options and results of a limit analysis.

use super::mechanism::Mechanism;
use super::{StackLoads, Threshold};

/// Resistance in addition to friction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Holding {
    /// No resistance: every joint is dry and every tie is absent. Default.
    #[default]
    FrictionOnly,
    /// Cohesion resists sliding, fully in every joint at the same time, as if joints could slip without breaking. Ties are left out.
    Cohesion,
    /// Cohesion, and all ties at their strength at the same time, as if ties could stretch without breaking.
    CohesionAndTies,
}

/// Direction of shaking.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Shaking {
    /// The horizontal direction with the smallest limit. Default.
    #[default]
    AnyWay,
    /// Along one direction of the inertia forces; need not be of unit length.
    Along([f64; 2]),
    /// Near each of these directions and its opposite; they need not be of unit length. The limit is that of the edge of the region of balanced
    /// accelerations that the direction meets: the smallest in its neighbourhood where the edge is straight.
    Near(Vec<[f64; 2]>),
}

/// Options of a limit analysis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LimitAnalysis {
    /// Loads before any horizontal shaking. Default none.
    pub loads: StackLoads,
    /// Direction of the inertia forces. Default: the direction with the smallest limit.
    pub shaking: Shaking,
    /// Resistance in addition to friction. Default none.
    pub holding: Holding,
    /// Shaking forces on each block, if they are not its mass times one acceleration. Default `None`.
    pub swaying: Option<Vec<SwayingForces>>,
}

/// Shaking forces on one block for a nominal 1 g: accelerations in the result are factors on these forces, over g.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SwayingForces {
    /// Force at its centroid along x under shaking along x, and along y under shaking along y, N.
    pub force_n: [f64; 2],
    /// Moment about its centroid under each shaking: about y, and about −x, N m.
    pub moment_n_m: [f64; 2],
}

/// Result of a limit analysis.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitAnalysisResult {
    /// Its status.
    pub status: LimitAnalysisStatus,
    /// The mechanism at the limit; for a stack that does not stand, the mechanism of its fall. `None` if no acceleration moves the stack, or if
    /// it stands on an edge.
    pub mechanism: Option<Mechanism>,
    /// Directions with the smallest limit, within 1e-6 and up to their sense, the best first; empty without a limit.
    pub directions: Vec<[f64; 2]>,
    /// Joints that count without friction because they slide in a mechanism, ascending; see
    /// [`limit_analysis_undilated`](super::limit_analysis_undilated()).
    pub frictionless: Vec<usize>,
    /// Acceleration up to which forces in the joints balance every direction examined, over gravity.
    pub at_least_g: f64,
    /// Largest relative error of any solution, over the weight (times the size) of its piece: equilibrium of forces and moments, friction
    /// beyond the cone, penetration in a mechanism, difference between both bounds.
    pub residual: f64,
    /// Number of solved programmes.
    pub solved: usize,
    /// Number of unknown forces of all pieces.
    pub variables: usize,
    /// Number of equilibrium equations of all pieces.
    pub equations: usize,
}

/// Status of a limit analysis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LimitAnalysisStatus {
    /// The smallest acceleration with a mechanism, which no forces balance, and its direction.
    Limited(Threshold),
    /// No forces in the joints balance the weight and static loads: it does not stand.
    DoesNotStand,
    /// Every acceleration up to 10 g can be balanced: the stack is wedged.
    Unlimited,
}
