//! Frames: rigid storeys on lateral springs.

mod columns;
mod doubts;
mod file;
mod friction;
mod lean;
mod part;
mod read;
mod slips;
mod tenons;

pub(crate) use doubts::doubt_frame;
pub(crate) use file::{AxialRaw, ConventionRaw, DirectionRaw, StoreyRaw};
pub(crate) use lean::lean_frame;
pub use part::{
    Axial, ColumnsPart, DirectionPart, FootPart, FrameLean, FramePart, FrictionPart, SlipForces, StoreyPart,
    TenonsPart,
};
pub(crate) use read::frame;
pub(crate) use slips::judge_frame;
