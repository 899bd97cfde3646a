//! Stacks: stone pagodas and other blocks on each other.

pub(crate) mod check;
pub(crate) mod frequencies;
pub(crate) mod simulate;
mod simulation;
pub(crate) mod study;

pub use simulate::Law;
pub use simulation::StackSimulation;
