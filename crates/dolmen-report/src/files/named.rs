//! A file to be written.

use crate::figures::Figure;
use crate::mark::FIGURE_MARK;
use dolmen_words::file_name;
use serde_json::Value;

/// A file: its relative path with slashes, and its bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedFile {
    /// Its path: "histories.csv", "weak/slips.csv".
    pub name: String,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

impl NamedFile {
    /// A file with these bytes; any name becomes a single name in one folder.
    pub fn new(name: &str, bytes: impl Into<Vec<u8>>) -> Self {
        NamedFile {
            name: file_name(name),
            bytes: bytes.into(),
        }
    }

    /// A value as JSON.
    pub(crate) fn json(name: &str, value: &Value) -> Self {
        NamedFile::new(name, format!("{value:#}\n"))
    }

    /// An SVG with the mark; `name` has no ending.
    pub(crate) fn svg(name: &str, svg: &str) -> Self {
        let marked = svg.replacen('>', &format!(">{FIGURE_MARK}"), 1);
        NamedFile::new(&format!("{name}.svg"), marked)
    }

    /// A figure as SVG.
    pub(crate) fn figure(figure: Figure) -> Self {
        NamedFile::svg(&figure.name, &figure.svg)
    }

    /// The same file in a subfolder.
    pub(crate) fn within(self, folder: &str) -> Self {
        NamedFile {
            name: format!("{}/{}", file_name(folder), self.name),
            bytes: self.bytes,
        }
    }
}
