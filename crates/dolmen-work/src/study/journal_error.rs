//! Why a journal cannot be used.

/// Why a journal cannot be used.
#[derive(Clone, Debug, PartialEq)]
pub enum JournalError {
    /// It has no header, or another program's.
    Header,
    /// A line that is not the last is damaged.
    Line {
        /// Number of the line, from 1.
        line: usize,
    },
}
