//! Bytes to values and back: records, project files, results, figures, reports. Opens no file.

pub mod answer;
pub mod explain;
pub mod json;
pub mod number;
pub mod project;
pub mod text;
