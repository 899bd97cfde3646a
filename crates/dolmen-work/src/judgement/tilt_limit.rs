//! A measured tilt against the limit that the file sets.

use crate::survey_dates::date;
use dolmen_project::Project;

/// Limit over tilt below which a tilt is near its limit. Chosen here, as for a demand.
const NEAR_BELOW: f64 = 1.25;

/// A measured tilt against the limit of the file.
#[derive(Clone, Debug, PartialEq)]
pub struct TiltAgainstLimit {
    /// The survey.
    pub survey: String,
    /// Its directions.
    pub directions: Vec<String>,
    /// Horizontal / vertical, by all directions together.
    pub tilt: f64,
    /// `tilt_limit`.
    pub limit: f64,
}

impl TiltAgainstLimit {
    /// Whether it has reached its limit.
    pub fn is_beyond(&self) -> bool {
        self.tilt >= self.limit
    }

    /// Whether it is near its limit, or beyond.
    pub fn is_near(&self) -> bool {
        self.tilt * NEAR_BELOW >= self.limit
    }
}

/// The tilt held against `tilt_limit`, if it is beyond it.
pub fn tilt_beyond_limit(project: &Project) -> Option<TiltAgainstLimit> {
    tilt_against_limit(project).filter(TiltAgainstLimit::is_beyond)
}

/// The tilt of the last dated survey that states any, or of one without a date where that is larger, against `tilt_limit`; `None` without either.
///
/// When a survey without a date was made is not known: it may be the last.
pub fn tilt_against_limit(project: &Project) -> Option<TiltAgainstLimit> {
    let limit = project.watch.tilt_limit?;
    let (last, tilt) = last_tilt(project)?;
    Some(TiltAgainstLimit {
        survey: worst.name.clone(),
        directions: worst.tilt.keys().cloned().collect(),
        tilt: worst.tilt_together(),
        limit,
    })
}

/// The last survey that states any tilt, and that tilt by all directions together, horizontal / vertical.
pub fn last_tilt(project: &Project) -> Option<(&Survey, f64)> {
    let tilted = |survey: &&Survey| !survey.tilt.is_empty();
    let dated = project.surveys.iter().filter(tilted);
    let last = dated.max_by_key(|survey| date(&survey.name).unwrap_or_default())?;
    let squares = last.tilt.values().map(|tilt| tilt.ratio * tilt.ratio);
    Some((last, squares.sum::<f64>().sqrt()))
}
