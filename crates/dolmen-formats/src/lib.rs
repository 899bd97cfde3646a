//! Bytes to values and back: records, project files, results, figures, reports. Opens no file.

pub mod answer;
pub mod building;
pub mod change;
pub mod explain;
pub mod figures;
pub mod json;
mod language;
pub mod meshes;
pub mod motions;
pub mod number;
pub mod portfolio;
pub mod project;
pub mod records;
pub mod report;
pub mod score;
pub mod simulation;
pub mod study;
pub mod text;
pub mod tune;
mod without_stiffness;

pub use language::Language;

/// The listings of the book are compiled and run as tests.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/library.md")]
pub struct LibraryPage;

/// The same of fragility.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/fragility.md")]
pub struct FragilityPage;
