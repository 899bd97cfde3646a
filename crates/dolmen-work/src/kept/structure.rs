//! Structures as a store lists and shows them.

use super::survey::KeptSurvey;
use serde::Serialize;

/// A structure in a list.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ListedStructure {
    /// Its name in the store.
    pub name: String,
    /// "chain", "stack".
    pub kind: String,
    /// Its English name.
    pub english: String,
    /// Its Korean name.
    pub korean: String,
    /// Degrees north.
    pub latitude_deg: Option<f64>,
    /// Degrees east.
    pub longitude_deg: Option<f64>,
    /// Number of surveys.
    pub surveys: i64,
    /// Date of the first survey that has one.
    pub first_survey: Option<String>,
    /// Date of the last survey that has one.
    pub last_survey: Option<String>,
    /// When its project was last stored, s since 1970 (UTC).
    pub stored_s: f64,
    /// Name of the person.
    pub who: String,
    /// Whether it is out of use.
    pub is_removed: bool,
}

/// A survey in a list.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ListedSurvey {
    /// The structure.
    pub structure: String,
    /// The survey.
    pub survey: String,
    /// Its date, if it has one.
    pub date: Option<String>,
    /// Air temperature, °C.
    pub temperature_c: Option<f64>,
    /// Record files.
    pub records: i64,
    /// Lowest frequency that was identified or is stated, Hz.
    pub lowest_frequency_hz: Option<f64>,
    /// Whether its records hold an earthquake, or the file states one.
    pub has_earthquake: bool,
    /// Largest acceleration of that earthquake, m/s².
    pub earthquake_peak_m_s2: Option<f64>,
}

/// A state of the project.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct KeptState {
    /// BLAKE3 over its text and files.
    pub hash: String,
    /// Time of storage, s since 1970 (UTC).
    pub stored_s: f64,
    /// Name of the person.
    pub who: String,
    /// Version of Dolmen.
    pub dolmen: String,
    /// Its files, without the project file.
    pub files: i64,
}

/// A line of the log.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct KeptLog {
    /// Time, s since 1970 (UTC).
    pub at_s: f64,
    /// Name of the person.
    pub who: String,
    /// "add", "import", "remove".
    pub verb: String,
    /// Its result.
    pub detail: String,
}

/// A structure with all its data in the store.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct KeptStructure {
    /// Its line in the list.
    pub structure: ListedStructure,
    /// The surveys of its latest state, in the order of the file.
    pub surveys: Vec<KeptSurvey>,
    /// States of its project, the latest first.
    pub states: Vec<KeptState>,
    /// The log, the latest line first.
    pub log: Vec<KeptLog>,
}
