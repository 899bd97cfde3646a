//! A measured tilt against the limit that the file sets.

use crate::survey_dates::date;
use dolmen_project::{Project, Survey};

/// A measured tilt beyond the limit of the file.
#[derive(Clone, Debug, PartialEq)]
pub struct TiltBeyondLimit {
    /// The survey.
    pub survey: String,
    /// Its directions.
    pub directions: Vec<String>,
    /// Horizontal / vertical, by all directions together.
    pub tilt: f64,
    /// `tilt_limit`.
    pub limit: f64,
}

/// The tilt of the last survey that states any, if it is beyond `tilt_limit`.
pub fn tilt_beyond_limit(project: &Project) -> Option<TiltBeyondLimit> {
    let limit = project.watch.tilt_limit?;
    let tilted = |survey: &&Survey| !survey.tilt.is_empty();
    let dated = project.surveys.iter().filter(tilted);
    let last = dated.max_by_key(|survey| date(&survey.name).unwrap_or_default())?;
    let squares = last.tilt.values().map(|tilt| tilt.ratio * tilt.ratio);
    let tilt = squares.sum::<f64>().sqrt();
    (tilt >= limit).then(|| TiltBeyondLimit {
        survey: last.name.clone(),
        directions: last.tilt.keys().cloned().collect(),
        tilt,
        limit,
    })
}
