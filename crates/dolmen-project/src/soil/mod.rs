//! The soil under a chain or a stack.

mod file;
mod part;
mod read;

pub(crate) use file::HalfSpaceRaw;
pub use part::{FootingPart, SoilBelowPart, SoilPart};
pub(crate) use read::{judge_soil, soil_below, soil_under_footing};
