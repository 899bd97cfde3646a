//! Studies with unusable results.

use dolmen_words::message::Both;

/// A study with unusable results.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOutStudy {
    /// The study.
    pub study: String,
    /// Reason.
    pub why: Both,
}
