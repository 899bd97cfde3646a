//! Why a document cannot be written.

/// A document that could not be written.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PaperFault {
    /// A figure could not be painted.
    #[error("a figure of the document could not be painted: {0}")]
    Figure(String),
    /// The archive could not be packed.
    #[error("the document could not be packed: {0}")]
    Archive(String),
}
