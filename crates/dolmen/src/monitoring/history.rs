//! History of a structure: its surveys and the works on it.

use crate::modal::ObservedMode;

/// One survey of a history.
#[derive(Clone, Debug, PartialEq)]
pub struct HistorySurvey {
    /// Its name.
    pub name: String,
    /// Its day, counted from an origin that is the same for all surveys.
    pub day: f64,
    /// Temperature, °C; `None` if not known.
    pub temperature_c: Option<f64>,
    /// Its modes.
    pub modes: Vec<ObservedMode>,
    /// Its tilt readings.
    pub tilts: Vec<TiltReading>,
}

/// A tilt reading.
#[derive(Clone, Debug, PartialEq)]
pub struct TiltReading {
    /// The direction in which it leans.
    pub direction: String,
    /// The reference mark of the reading; tilts of two marks never form one series.
    pub datum: Option<String>,
    /// Horizontal over vertical.
    pub ratio: f64,
}

/// A work on the structure, or an event.
#[derive(Clone, Debug, PartialEq)]
pub struct Work {
    /// Its day, counted like those of the surveys.
    pub day: f64,
    /// Whether the structure was changed on purpose, so that new levels begin.
    pub splits: bool,
    /// Whether the structure was inspected, which answers earlier alarms.
    pub answers: bool,
}

/// Surveys of one structure, ascending in time, and the works between them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
    /// The surveys.
    pub surveys: Vec<HistorySurvey>,
    /// The works.
    pub works: Vec<Work>,
}
