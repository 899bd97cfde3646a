//! Earthquakes as rows.

use crate::rows::{EarthquakeRow, StatedEarthquakeRow};
use dolmen_project::EarthquakePart;

fn finite(value: Option<f64>) -> Option<f64> {
    value.filter(|value| value.is_finite())
}

/// An earthquake that an analysis found.
pub(crate) fn found(analysis: String, of: &EarthquakePart) -> EarthquakeRow {
    EarthquakeRow {
        analysis,
        peak_m_s2: finite(of.peak_m_s2),
        changed: finite(of.changed),
        changed_sd: finite(of.changed_sd),
    }
}

/// An earthquake that a survey states.
pub(crate) fn stated(survey: &str, of: &EarthquakePart) -> StatedEarthquakeRow {
    StatedEarthquakeRow {
        survey: survey.to_owned(),
        peak_m_s2: finite(of.peak_m_s2),
        changed: finite(of.changed),
        changed_sd: finite(of.changed_sd),
    }
}
