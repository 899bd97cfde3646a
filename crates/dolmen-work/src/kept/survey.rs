//! Surveys as a store shows them.

use dolmen_project::EarthquakePart;
use serde::Serialize;

/// A record file.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct KeptRecord {
    /// Path in the project.
    pub path: String,
    /// BLAKE3 of its bytes.
    pub hash: String,
    /// Its size.
    pub bytes: i64,
    /// Number of channels that the project names; 0 for all columns.
    pub channels: i64,
}

/// A tilt.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct KeptTilt {
    /// Its direction.
    pub direction: String,
    /// Horizontal over vertical.
    pub ratio: f64,
    /// As written.
    pub written: String,
}

/// A mode, identified or stated.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct KeptMode {
    /// The direction of a stated mode; `None` for an identified one.
    pub direction: Option<String>,
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Its standard deviation, Hz.
    pub frequency_sd_hz: Option<f64>,
    /// Damping ratio.
    pub damping_ratio: Option<f64>,
    /// Its standard deviation.
    pub damping_ratio_sd: Option<f64>,
    /// Whether the user accepted it although a test refused it.
    pub accepted: bool,
}

/// Modes that were identified from the records of a survey.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct KeptAnalysis {
    /// BLAKE3 over records, settings and version.
    pub hash: String,
    /// Version of Dolmen.
    pub version: String,
    /// "ssi-cov".
    pub method: String,
    /// Time, s since 1970 (UTC).
    pub at_s: f64,
    /// The modes, ascending.
    pub modes: Vec<KeptMode>,
    /// The earthquake in the records.
    pub earthquake: Option<KeptEarthquake>,
}

/// An earthquake that the structure experienced.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct KeptEarthquake {
    /// Largest acceleration, m/s².
    pub peak_m_s2: Option<f64>,
    /// Relative change of a frequency from before to after.
    pub changed: Option<f64>,
    /// Its standard deviation.
    pub changed_sd: Option<f64>,
}

impl From<EarthquakePart> for KeptEarthquake {
    fn from(of: EarthquakePart) -> Self {
        KeptEarthquake {
            peak_m_s2: of.peak_m_s2,
            changed: of.changed,
            changed_sd: of.changed_sd,
        }
    }
}

/// An entry of an inspection.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct KeptInspection {
    /// The part.
    pub part: String,
    /// Its kind, in English.
    pub what: String,
    /// Its name among others of its kind at the part.
    pub name: Option<String>,
    /// Its size, m.
    pub size_m: Option<f64>,
    /// Standard deviation of the size due to reading errors, m.
    pub size_sd_m: Option<f64>,
    /// Its limit, m.
    pub limit_m: Option<f64>,
    /// "slight", "moderate", "severe".
    pub severity: Option<String>,
    /// The file of a photograph.
    pub photo: Option<String>,
    /// A note.
    pub note: Option<String>,
}

/// A survey.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct KeptSurvey {
    /// Its name in the project.
    pub name: String,
    /// Its date, if its name begins with one.
    pub date: Option<String>,
    /// Air temperature, °C.
    pub temperature_c: Option<f64>,
    /// The datum of levels and tilts.
    pub datum: Option<String>,
    /// Its records.
    pub records: Vec<KeptRecord>,
    /// Tilts.
    pub tilts: Vec<KeptTilt>,
    /// Modes that the file states.
    pub stated_modes: Vec<KeptMode>,
    /// Entries of an inspection, in the order of the file.
    pub inspections: Vec<KeptInspection>,
    /// Whether nobody measured it.
    pub is_made_up: bool,
    /// Analyses, the latest first.
    pub analyses: Vec<KeptAnalysis>,
    /// The earthquake that the file states or the latest analysis found.
    pub earthquake: Option<KeptEarthquake>,
}
