//! What was done to a store.

use super::survey::KeptEarthquake;
use dolmen_words::message::Both;
use serde::{Serialize, Serializer};

/// A survey whose records gave no modes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Unidentified {
    /// The survey.
    pub survey: String,
    /// Why.
    #[serde(serialize_with = "in_english")]
    pub why: Both,
}

/// Keys and values of JSON never follow the language.
fn in_english<S: Serializer>(why: &Both, to: S) -> Result<S::Ok, S::Error> {
    why.english.serialize(to)
}

/// What `add` did, once it is on disk.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Added {
    /// The structure.
    pub structure: String,
    /// BLAKE3 over the text of the project and its files.
    pub project: String,
    /// Whether this state of the project was not there yet.
    pub is_new_state: bool,
    /// Surveys of the project.
    pub surveys: usize,
    /// Surveys that were not there yet, or not in this form.
    pub new_surveys: usize,
    /// Files of the project.
    pub files: usize,
    /// Files whose bytes were not there yet.
    pub new_files: usize,
    /// Analyses that were not there yet.
    pub new_analyses: usize,
    /// Surveys whose records gave no modes.
    pub unidentified: Vec<Unidentified>,
    /// Surveys that the state before had under the same name with other content.
    pub changed_surveys: Vec<String>,
    /// Surveys that the state before had, and this one has not.
    pub gone_surveys: Vec<String>,
    /// Earthquakes that the structure felt, those that came by themselves among them.
    pub earthquakes: Vec<AddedEarthquake>,
}

/// An earthquake of a structure that was added.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AddedEarthquake {
    /// The survey.
    pub survey: String,
    /// What is known of it.
    #[serde(flatten)]
    pub of: KeptEarthquake,
    /// Whether a repair or an inspection was entered since.
    pub is_answered: bool,
}

/// What `import` did, once it is on disk.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Imported {
    /// Structures of the source.
    pub structures: usize,
    /// Rows that were not there yet.
    pub new_rows: usize,
    /// Raw files that were not there yet.
    pub new_files: usize,
}

/// One thing that is wrong.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "fault", rename_all = "snake_case")]
pub enum Fault {
    /// A raw file is not there.
    Missing {
        /// Its hash.
        hash: String,
    },
    /// A raw file does not have the bytes that it was kept for.
    Changed {
        /// Its hash.
        hash: String,
    },
    /// A row says something else than its name.
    Row {
        /// The table.
        table: String,
        /// The name of the row.
        name: String,
    },
    /// The database itself is damaged, or a row refers to one that is not there.
    Database {
        /// What it says.
        why: String,
    },
}

/// What `verify` found.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Verified {
    /// Structures.
    pub structures: i64,
    /// Surveys, each form of one counted.
    pub surveys: i64,
    /// Analyses.
    pub analyses: i64,
    /// Raw files whose bytes were read and compared with their hash.
    pub raw_files: i64,
    /// Their bytes, uncompressed.
    pub raw_bytes: i64,
    /// Files in the folder that no row names: left by a process that was killed, and harmless.
    pub unnamed_files: i64,
    /// BLAKE3 over all rows: two stores with the same one hold the same.
    pub content: String,
    /// What is wrong.
    pub faults: Vec<Fault>,
}
