//! Frames: timber gates of rigid storeys on lateral springs.

pub(crate) mod check;
mod columns;
mod columns_alone;
pub(crate) mod limits;
pub(crate) mod simulate;
mod simulation;
pub(crate) mod stiffness;
pub(crate) mod study;

pub use columns::{ColumnSwing, Springs, StoreyColumns};
pub use columns_alone::{ColumnsAlone, ColumnsInMotion};
pub use simulation::FrameSimulation;
