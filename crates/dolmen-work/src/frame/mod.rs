//! Frames: timber gates of rigid storeys on lateral springs.

pub(crate) mod check;
mod columns;
pub(crate) mod limits;
pub(crate) mod simulate;
mod simulation;
pub(crate) mod stiffness;
pub(crate) mod study;

pub use columns::{ColumnSwing, Springs, StoreyColumns};
pub use simulation::FrameSimulation;
