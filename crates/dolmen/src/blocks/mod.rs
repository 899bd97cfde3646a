//! Time histories of stacks: blocks that rock, slide, twist and jump, with springs or rigid
//! contacts.

mod after_fall;
mod assembly;
mod beside;
mod block_skyline;
mod bodies;
mod calibrate;
mod contact_law;
mod contact_points;
mod contact_tolerances;
mod crushing;
mod dead_load;
mod ensemble;
mod error;
mod faces;
mod factors;
mod fall;
mod forces;
mod frequencies;
mod history;
mod hulls;
mod links;
mod loose_margin;
mod loose_stones;
mod lowest_modes;
mod matrices;
mod moved_supports;
mod moving_ground;
mod observe;
mod outline;
mod patch;
mod rest;
mod rigid;
mod rigid_bed;
mod rigid_cone;
mod rigid_faces;
mod rigid_ground;
mod rigid_impact;
mod rigid_interior;
mod rigid_loads;
mod rigid_point;
mod rigid_rest;
mod rigid_run;
mod rigid_solve;
mod run_length;
mod set_back;
mod sliding;
mod sliding_bed;
mod sliding_chain;
mod sliding_history;
mod sliding_record;
mod sliding_solve;
mod sliding_state;
mod springs;
mod standing;
mod stillness;
mod support;
mod toppling;
mod watch;

pub use after_fall::AfterFall;
pub use beside::{BesideInSmallMotion, beside_in_small_motion};
pub use calibrate::{MatchedFrequency, SpringCalibration, calibrate_springs};
pub use contact_law::{ContactLaw, simulate_stack};
pub use contact_points::{ContactPoint, ContactRule, contact_points};
pub use ensemble::{StackRun, simulate_springs_many};
pub use error::BlocksError;
pub use factors::{
    CommonFactor, FactorRange, JointFactor, JointFactors, JointFactorsError, JointFactorsOptions,
    LooseningStack, MeasuredStackMode, PairedBy, PairedMode, StackMotion, StiffnessOf, UnusedMode, WhyUnused,
    joint_factors,
};
pub use frequencies::{StackMode, first_sway, lowest_stack_modes, stack_modes, sway_amplification};
pub use history::{Energy, JointHistory, Outcome, PeakBearing, Pose, RigidEvidence, StackHistory};
pub use loose_stones::{LooseEnding, LooseMargin, LooseStone, LooseStones, settle_loose, shake_loose};
pub use moved_supports::{GaveWay, MovedInTime, SlowGround, SlowMovement, move_supports};
pub use moving_ground::MovingGround;
pub use rigid::{Rigid, simulate_rigid};
pub use sliding::{Sliding, simulate_sliding};
pub use sliding_history::{SlidingHistory, SlidingOutcome, SlidingSpell};
pub use springs::{Springs, Start, simulate_springs};
