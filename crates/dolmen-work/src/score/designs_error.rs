//! Errors of a table of designs.

use dolmen_words::message::Both;

/// Why a table of designs is refused.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ScoreDesignsError {
    /// A column is missing.
    Column {
        /// The column.
        column: String,
    },
    /// A value cannot be read.
    Value {
        /// Line in the file, from 1.
        line: usize,
        /// Column.
        column: String,
        /// The text found there.
        given: String,
        /// The expected content.
        wanted: Both,
    },
    /// The text is not a table.
    Table {
        /// The reader's error.
        why: String,
    },
}
