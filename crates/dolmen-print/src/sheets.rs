//! What is handed in, and what comes back.

/// The source of a document.
#[derive(Clone, Debug)]
pub struct Sheets {
    /// What is compiled.
    pub main: String,
    /// The files that it names, each with its bytes.
    pub files: Vec<(String, Vec<u8>)>,
}

/// A printed document.
#[derive(Clone, Debug)]
pub struct Printed {
    /// The PDF.
    pub bytes: Vec<u8>,
    /// Whether it keeps to PDF/A-2a: it has a date, and every character has a glyph.
    pub is_archival: bool,
    /// Characters of the source that the fonts do not have, each once: they are printed as boxes.
    pub without_glyph: Vec<char>,
}

/// A document that could not be printed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the PDF could not be made: {0}")]
pub struct NotPrinted(pub(crate) String);
