//! A project from one scan: its mesh is cut at the beds into stones.

mod answer;
mod error;
mod project;
mod stones;

pub use answer::{ScanAnswer, ScanRequest, ScanUnit, ScannedStone};
pub use error::{ScanError, listed_steps};
pub use stones::stones_of_scan;
