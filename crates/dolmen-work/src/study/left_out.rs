//! Studies whose results cannot be used.

use dolmen_words::message::Both;

/// A study whose results cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOutStudy {
    /// The study.
    pub study: String,
    /// Why.
    pub why: Both,
}
