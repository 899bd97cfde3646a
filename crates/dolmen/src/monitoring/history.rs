//! History of a structure: surveys in time, and works.

use crate::modal::ObservedMode;

/// One survey of a history.
#[derive(Clone, Debug, PartialEq)]
pub struct HistorySurvey {
    /// Its name.
    pub name: String,
    /// The day it was made, counted from any day that is the same for all.
    pub day: f64,
    /// Temperature, °C; `None` if not known.
    pub temperature_c: Option<f64>,
    /// Its modes.
    pub modes: Vec<ObservedMode>,
    /// Tilts that it read.
    pub tilts: Vec<TiltReading>,
}

/// A tilt as it was read.
#[derive(Clone, Debug, PartialEq)]
pub struct TiltReading {
    /// The direction in which it leans.
    pub direction: String,
    /// The mark that it refers to; tilts of two marks are never one series.
    pub datum: Option<String>,
    /// Horizontal over vertical.
    pub ratio: f64,
}

/// Something that was done to the structure, or befell it.
#[derive(Clone, Debug, PartialEq)]
pub struct Work {
    /// When, as the days of the surveys are counted.
    pub day: f64,
    /// Whether the structure was changed on purpose: its levels begin anew.
    pub splits: bool,
    /// Whether somebody inspected the structure: this answers alarms before it.
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
