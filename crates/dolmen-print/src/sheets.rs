//! Input and output of printing.

/// The source of a document.
#[derive(Clone, Debug)]
pub struct Sheets {
    /// Its main file.
    pub main: String,
    /// Other files that it names, each with its bytes.
    pub files: Vec<(String, Vec<u8>)>,
}

/// A printed document.
#[derive(Clone, Debug)]
pub struct Printed {
    /// The PDF.
    pub bytes: Vec<u8>,
    /// Whether it conforms to PDF/A-2a: it has a date, and every character has a glyph.
    pub is_archival: bool,
    /// Characters that the fonts lack, each listed once; they print as boxes.
    pub without_glyph: Vec<char>,
}

/// A document that could not be printed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the PDF could not be made: {0}")]
pub struct NotPrinted(pub(crate) String);
