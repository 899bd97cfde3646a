//! Bytes to values and back: records, project files, results, figures, reports. Opens no file.

pub mod number;
pub mod project;
