//! Why a table of designs is refused.

use dolmen_words::message::Both;

/// Why a table of designs is refused.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ScoreDesignsError {
    /// A column is missing.
    Column {
        /// Which.
        column: String,
    },
    /// A value cannot be read.
    Value {
        /// Line in the file, from 1.
        line: usize,
        /// Column.
        column: String,
        /// What is there.
        given: String,
        /// What should be.
        wanted: Both,
    },
    /// The text is no table.
    Table {
        /// What the reader says.
        why: String,
    },
}
