//! How numbers and names are printed, in English and Korean, and what to do about what the science says.

pub mod advice;
mod language;
pub mod number;

pub use language::Language;
