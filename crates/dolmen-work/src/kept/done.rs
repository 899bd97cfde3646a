//! Results of actions on a store.

use super::survey::KeptEarthquake;
use dolmen_words::message::Both;
use serde::{Serialize, Serializer};

/// A survey whose records gave no modes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Unidentified {
    /// The survey.
    pub survey: String,
    /// Reason.
    #[serde(serialize_with = "in_english")]
    pub why: Both,
}

/// Serializes the English text: JSON is the same in every language.
fn in_english<S: Serializer>(why: &Both, to: S) -> Result<S::Ok, S::Error> {
    why.english.serialize(to)
}

/// Result of `add`, once it is on disk.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Added {
    /// The structure.
    pub structure: String,
    /// BLAKE3 over the text of the project and its files.
    pub project: String,
    /// Whether this state of the project is new.
    pub is_new_state: bool,
    /// Surveys of the project.
    pub surveys: usize,
    /// New or changed surveys.
    pub new_surveys: usize,
    /// Files of the project.
    pub files: usize,
    /// Number of new files.
    pub new_files: usize,
    /// Number of new analyses.
    pub new_analyses: usize,
    /// Surveys whose records gave no modes.
    pub unidentified: Vec<Unidentified>,
    /// Surveys whose content differs from that of the same name in the previous state.
    pub changed_surveys: Vec<String>,
    /// For a structure that is new to the store: another one whose name differs only in case or in spaces at its ends.
    pub named_like: Option<String>,
    /// Surveys of the previous state that this one lacks.
    pub gone_surveys: Vec<String>,
    /// Earthquakes at the structure, including those from watched folders.
    pub earthquakes: Vec<AddedEarthquake>,
}

/// An earthquake of a structure that was added.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AddedEarthquake {
    /// The survey.
    pub survey: String,
    /// Its data.
    #[serde(flatten)]
    pub of: KeptEarthquake,
    /// Whether a repair or an inspection followed.
    pub is_answered: bool,
}

/// Result of `import`, once it is on disk.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Imported {
    /// Structures of the source.
    pub structures: usize,
    /// Number of new rows.
    pub new_rows: usize,
    /// Number of new raw files.
    pub new_files: usize,
}

/// One fault of a store.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "fault", rename_all = "snake_case")]
pub enum Fault {
    /// A raw file is missing.
    Missing {
        /// Its hash.
        hash: String,
    },
    /// The bytes of a raw file have changed.
    Changed {
        /// Its hash.
        hash: String,
    },
    /// The contents of a row do not fit its key.
    Row {
        /// The table.
        table: String,
        /// The name of the row.
        name: String,
    },
    /// The database itself is damaged, or a row refers to a missing row.
    Database {
        /// Message of the database.
        why: String,
    },
}

/// Result of `verify`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Verified {
    /// Structures.
    pub structures: i64,
    /// Surveys; each version counts.
    pub surveys: i64,
    /// Analyses.
    pub analyses: i64,
    /// Raw files whose bytes were read and compared with their hash.
    pub raw_files: i64,
    /// Their bytes, uncompressed.
    pub raw_bytes: i64,
    /// Files in the folder that no row names: left by a killed process, and harmless.
    pub unnamed_files: i64,
    /// BLAKE3 over all rows: equal for stores with equal contents.
    pub content: String,
    /// The faults.
    pub faults: Vec<Fault>,
}
