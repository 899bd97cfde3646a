//! Chains: poles of rigid links on rotational joints.

pub(crate) mod check;
pub(crate) mod limits;
pub(crate) mod loads;
pub(crate) mod simulate;
mod simulation;
pub(crate) mod stiffness;
pub(crate) mod study;

pub use simulation::{ChainSimulation, SupportMet};
