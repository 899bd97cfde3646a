//! A closed mesh of a whole tower cut at the heights of its beds into stones.

mod cap;
mod error;
mod half;
mod ledge;
mod pieces;
mod section;
mod slice;

pub use error::SliceError;
pub use slice::{Sliced, SlicedBed, SlicedStone, slice};
