//! Factors on the springs of the joints of a stack, from its measured modes.

mod alike;
mod bounds;
mod error;
mod families;
mod joint_factors;
mod loosened;
mod measured;
mod model;
mod motions;
mod pairing;
mod ranges;
mod result;
mod sight;
mod stack_motion;
mod unknowns;

pub use error::JointFactorsError;
pub use joint_factors::{JointFactorsOptions, joint_factors};
pub use loosened::LooseningStack;
pub use measured::MeasuredStackMode;
pub use result::{
    CommonFactor, FactorRange, JointFactor, JointFactors, PairedBy, PairedMode, StiffnessOf, UnusedMode,
    WhyUnused,
};
pub use stack_motion::StackMotion;
