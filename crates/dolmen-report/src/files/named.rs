//! A file that is to be written.

use crate::figures::Figure;
use serde_json::Value;

/// A file: its path below the folder that it goes into, with slashes, and its bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedFile {
    /// Its path: "histories.csv", "weak/slips.csv".
    pub name: String,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

impl NamedFile {
    /// A file of these bytes.
    pub(crate) fn new(name: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Self {
        NamedFile {
            name: name.into(),
            bytes: bytes.into(),
        }
    }

    /// A value as JSON.
    pub(crate) fn json(name: &str, value: &Value) -> Self {
        NamedFile::new(name, format!("{value:#}\n"))
    }

    /// A figure as SVG.
    pub(crate) fn figure(figure: Figure) -> Self {
        NamedFile::new(format!("{}.svg", figure.name), figure.svg)
    }

    /// The same one folder deeper.
    pub(crate) fn within(self, folder: &str) -> Self {
        NamedFile {
            name: format!("{folder}/{}", self.name),
            bytes: self.bytes,
        }
    }
}
