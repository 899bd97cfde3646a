//! Answers as text, JSON, figures and pages, in English and Korean. Opens no file.

mod chain;
mod document;
pub mod explain;
pub mod figures;
pub mod files;
pub mod film;
pub mod html;
pub mod json;
mod load_factor;
mod mark;
pub mod sentences;
pub mod tables;
pub mod text;

/// The listings of the book are compiled and run as tests.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/library.md")]
pub struct LibraryPage;

/// The same of fragility.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/fragility.md")]
pub struct FragilityPage;
