//! Frames: rigid storeys on lateral springs.

mod columns;
mod doubts;
mod file;
mod friction;
mod part;
mod read;
mod slips;

pub(crate) use doubts::doubt_frame;
pub(crate) use file::{AxialRaw, ConventionRaw, DirectionRaw, StoreyRaw};
pub use part::{
    Axial, ColumnsPart, DirectionPart, FootPart, FramePart, FrictionPart, SlipForces, StoreyPart,
};
pub(crate) use read::frame;
pub(crate) use slips::judge_frame;
