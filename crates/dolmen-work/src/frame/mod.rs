//! Frames: timber gates of rigid storeys on lateral springs.

mod beside;
pub(crate) mod check;
mod columns;
mod columns_alone;
mod lean;
pub(crate) mod limits;
pub(crate) mod loads;
pub(crate) mod simulate;
mod simulation;
mod softening;
pub(crate) mod stiffness;
pub(crate) mod study;
mod tenons;
pub(crate) mod tilts;
pub(crate) mod together;
mod wind;

pub use beside::{FrameBeside, SensorBeside};
pub use columns::{AloneStorey, ColumnSwing, Springs, StoreyColumns};
pub use columns_alone::{AllInBeds, ColumnsAlone, ColumnsInMotion, ColumnsOnBeds};
pub use lean::DirectionLean;
pub use simulation::FrameSimulation;
pub use softening::{BedsFrom, UnfollowedStorey, WhySpringsAlone};
pub use tenons::{SECANT_DRIFT_RATIO, StoreyTenons, TenonsCheck};
pub use together::FrameTogether;
