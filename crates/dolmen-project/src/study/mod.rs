//! Studies: varied inputs and expected trends.

mod after;
mod file;
mod part;
mod read;
mod values;

pub(crate) use file::StudyRaw;
pub use part::{
    AfterPart, ArtificialPart, Axis, DRIFT_LIMITS, ExpectedTrend, HarmonicPart, LawPart, Override, Scan,
    StudyPart,
};
pub(crate) use read::studies;
