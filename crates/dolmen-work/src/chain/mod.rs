//! Chains: poles of rigid links on rotational joints.

mod all_round;
pub(crate) mod check;
pub(crate) mod limits;
pub(crate) mod loads;
mod planes;
pub(crate) mod simulate;
mod simulation;
pub(crate) mod stiffness;
pub(crate) mod study;
mod wind;

pub use simulation::{ChainSimulation, ChainTogether, SupportMet};
