//! What a history of surveys says.

use dolmen::monitoring::Watched;
use dolmen_project::{Project, WorkPart};
use std::sync::Arc;

/// What a history of surveys says.
#[derive(Clone, Debug)]
pub struct WatchAnswer {
    /// Path of the project file as the user named it.
    pub file: String,
    /// What the file says.
    pub project: Arc<Project>,
    /// The surveys that were watched, by time.
    pub surveys: Vec<WatchedSurvey>,
    /// Names of surveys that were left out: no date, no modes and no tilt, or the day of another.
    pub left_out: Vec<String>,
    /// Works by time, each with its day.
    pub works: Vec<(f64, WorkPart)>,
    /// What they say.
    pub watched: Watched,
}

/// A survey in time.
#[derive(Clone, Debug, PartialEq)]
pub struct WatchedSurvey {
    /// Its name.
    pub name: String,
    /// Its day, from 1970-01-01.
    pub day: f64,
    /// Its temperature, °C.
    pub temperature_c: Option<f64>,
    /// Frequencies of its modes, Hz, as the history numbers them.
    pub frequencies_hz: Vec<f64>,
}

impl WatchAnswer {
    /// Confirmed alarms that no repair and no inspection answered.
    pub fn open_alarms(&self) -> usize {
        self.watched
            .alarms
            .iter()
            .filter(|alarm| !alarm.is_answered)
            .count()
    }

    /// Whether a tilt is beyond its limit on the day of its last reading.
    pub fn is_tilt_beyond(&self) -> bool {
        let slopes = self.watched.tilts.iter().filter_map(|trend| trend.slope);
        slopes
            .filter_map(|slope| slope.share_of_limit())
            .any(|share| share >= 1.0)
    }
}
