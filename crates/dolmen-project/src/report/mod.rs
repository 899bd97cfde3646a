//! The report's own contents: given by the engineer, never computed.

mod date;
mod file;
mod part;
mod parts_named;
mod read;

pub use date::{calendar_day, is_day};
pub(crate) use file::ReportRaw;
pub use part::{
    Author, Grade, GradeScale, Location, MaterialMethod, MaterialTest, PeriodicGrade, PhotoPart, ReportPart,
    SensorPart,
};
pub(crate) use parts_named::PartNames;
pub(crate) use read::{a_part, report, words};
