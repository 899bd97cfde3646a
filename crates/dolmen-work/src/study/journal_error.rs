//! Why a journal cannot be used.

/// Why a journal cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum JournalError {
    /// It has no header, or another program's.
    #[error(
        "it is no journal of a study of this program: its first line is another's, or of an older one that judged runs otherwise; --restart throws \
         it away"
    )]
    Header,
    /// A line that is not the last is damaged.
    #[error("line {line} is damaged: restore the file, or start anew with --restart")]
    Line {
        /// Which, from 1.
        line: usize,
    },
}
