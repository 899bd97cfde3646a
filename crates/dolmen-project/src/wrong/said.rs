//! Errors of a reader or of the library, as sentences about a project file.

use dolmen_words::Sentence;
use dolmen_words::message::{Argument, Both};

/// The error in both languages.
pub(crate) fn said(error: &impl Argument) -> Both {
    Sentence::of_argument(error).into()
}
