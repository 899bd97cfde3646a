//! Numbers, names and sentences in English and Korean, names of files, and advice on errors of the library.

pub mod advice;
pub mod errors;
mod file_name;
mod language;
pub mod message;
mod nearest;
pub mod number;
pub mod particles;
mod printed_names;
mod quantity;
mod run;
pub mod science;
mod system;
mod template;

pub use file_name::{composed, file_name, folded_file_name};
pub use language::Language;
pub use message::{Sentence, Template};
pub use nearest::nearest;
pub use printed_names::{PrintedName, keeping_names, print_names, printed_label, printed_name};
pub use quantity::{Digits, Quantity, Unit, Values};
pub use system::{SYSTEM, said_by_system};
