//! Cuts a closed mesh of a whole tower into stones at the heights of its beds.

mod cap;
mod error;
mod half;
mod ledge;
mod pieces;
mod section;
mod slice;
mod steps;

pub use error::SliceError;
pub use slice::{Sliced, SlicedBed, SlicedStone, slice};
pub use steps::SlicedStep;
