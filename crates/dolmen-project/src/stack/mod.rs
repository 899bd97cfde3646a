//! Stacks: blocks of stone on each other.

mod bed;
mod block;
mod body;
mod build;
mod file;
mod pagoda;
mod part;
mod read;
mod shape;
mod slips;

pub use build::StackFault;
pub(crate) use file::{BedRaw, BlockRaw, ContactRaw, PagodaRaw, SideSupportRaw, TieRaw};
pub use part::{
    BedPart, BlockPart, ContactPart, MeshPart, OpeningPart, PagodaPart, PagodaSlendernessPart, PointsFrame,
    ShapePart, SideSupportPart, StackPart, TiePart, TopPart,
};
pub(crate) use read::stack;
pub(crate) use slips::judge_stack;
