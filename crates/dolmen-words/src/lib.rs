//! How numbers and names are printed, in English and Korean, what a name is as that of a file, and what to do about what the science says.

pub mod advice;
mod file_name;
mod language;
pub mod number;

pub use file_name::{file_name, same_file_name};
pub use language::Language;
