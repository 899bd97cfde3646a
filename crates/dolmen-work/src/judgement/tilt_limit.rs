//! A measured tilt against the limit that the file sets.

use crate::survey_dates::date;
use dolmen_project::{Project, Survey};

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

/// The tilt of the last survey that states any, if it is beyond `tilt_limit`.
pub fn tilt_beyond_limit(project: &Project) -> Option<TiltAgainstLimit> {
    tilt_against_limit(project).filter(TiltAgainstLimit::is_beyond)
}

/// The tilt of the last survey that states any against `tilt_limit`; `None` without either.
pub fn tilt_against_limit(project: &Project) -> Option<TiltAgainstLimit> {
    let limit = project.watch.tilt_limit?;
    let tilted = |survey: &&Survey| !survey.tilt.is_empty();
    let dated = project.surveys.iter().filter(tilted);
    let last = dated.max_by_key(|survey| date(&survey.name).unwrap_or_default())?;
    let squares = last.tilt.values().map(|tilt| tilt.ratio * tilt.ratio);
    let tilt = squares.sum::<f64>().sqrt();
    Some(TiltAgainstLimit {
        survey: last.name.clone(),
        directions: last.tilt.keys().cloned().collect(),
        tilt,
        limit,
    })
}
