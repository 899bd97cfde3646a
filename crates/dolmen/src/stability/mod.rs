//! Stability: critical stiffness, load factors, margins, verdicts.

mod chain;
mod chain_limits;
mod chain_loads;
mod chain_stability;
mod edge_moment;
mod error;
mod frame;
mod frame_lean;
mod frame_loads;
mod free_columns;
pub mod stack;
mod verdict;

pub use chain::{ChainLimits, ChainStability, JointStability};
pub use chain_limits::chain_limits;
pub use chain_loads::{
    ChainLoading, ChainUnderLoads, JointHold, JointUnderLoads, LinkLoad, chain_under_loads,
};
pub use chain_stability::{chain_stability, failing_joint};
pub use edge_moment::BedEdge;
pub use error::StabilityError;
pub use frame::{FrameStability, StoreyStability, frame_stability};
pub use frame_lean::frame_lean_at_rest;
pub use frame_loads::{
    FramePush, FrameUnderLoads, StoreyEnd, StoreyPoint, StoreyUnderLoads, frame_under_loads,
};
pub use free_columns::{
    ColumnPoint, ColumnStanding, ColumnsBesideJoints, FootPressure, FootSection, FreeColumns,
};
pub use verdict::Verdict;
