//! Stacks: stone pagodas and other blocks on each other.

pub(crate) mod by_velocity;
pub(crate) mod check;
pub(crate) mod factors;
mod factors_answer;
pub(crate) mod frequencies;
pub(crate) mod frequency_by_height;
pub(crate) mod loads;
pub(crate) mod local_mechanisms;
pub(crate) mod moving_supports;
mod repeats;
mod runs;
pub(crate) mod settle;
pub(crate) mod settled;
pub(crate) mod shared_courses;
pub(crate) mod simulate;
mod simulation;
mod sliding;
pub(crate) mod study;
mod supports;

pub use by_velocity::{SpectralVelocity, VelocityDemand};
pub use factors_answer::FactorsAnswer;
pub use frequency_by_height::{FrequencyByHeight, HeightAndFrequency};
pub use repeats::{Repeat, Repeating, Repeats, Spread};
pub use runs::{LeftOut, StackRuns};
pub use settled::{LawsApart, SettledRun, SettledSimulation};
pub use simulate::Law;
pub use simulation::{DrawnGaps, StackSimulation};
pub use sliding::{SlidingMode, SlidingRun};
pub use supports::{RefusedRun, SupportsRun, SupportsSimulation};
