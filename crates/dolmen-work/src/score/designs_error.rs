//! Why a table of designs is refused.

/// Why a table of designs is refused.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ScoreDesignsError {
    /// A column is missing.
    #[error("the table of designs has no column \"{column}\": write it with `dolmen score --train`")]
    Column {
        /// Which.
        column: String,
    },
    /// A value cannot be read.
    #[error("line {line}, {column}: \"{given}\" is no {wanted}")]
    Value {
        /// Line in the file, from 1.
        line: usize,
        /// Column.
        column: String,
        /// What is there.
        given: String,
        /// What should be.
        wanted: &'static str,
    },
    /// The text is no table.
    #[error("the table of designs cannot be read: {why}")]
    Table {
        /// What the reader says.
        why: String,
    },
}
