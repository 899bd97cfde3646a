//! How numbers and names are printed, in English and Korean.

mod language;
pub mod number;

pub use language::Language;
