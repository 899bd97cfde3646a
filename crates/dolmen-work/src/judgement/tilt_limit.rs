//! A measured tilt compared with the limit in the file.

use crate::near_limit::is_near;
use crate::survey_dates::date;
use dolmen_project::{Project, Structure, Survey};

/// A measured tilt and the limit of the file.
#[derive(Clone, Debug, PartialEq)]
pub struct TiltAgainstLimit {
    /// The survey.
    pub survey: String,
    /// Its directions.
    pub directions: Vec<String>,
    /// Horizontal / vertical, all directions together.
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
        is_near(self.tilt / self.limit)
    }
}

/// The comparison with `tilt_limit`, if the tilt is beyond it.
pub fn tilt_beyond_limit(project: &Project) -> Option<TiltAgainstLimit> {
    tilt_against_limit(project).filter(TiltAgainstLimit::is_beyond)
}

/// Whether the measured tilt exceeds the limit of the file, or the allowable drift of storeys in an earthquake.
pub(crate) fn is_tilt_beyond(project: &Project) -> bool {
    tilt_beyond_limit(project).is_some() || is_beyond_drift(project)
}

/// Whether the lean of storeys, before any earthquake, already reaches the allowable drift.
fn is_beyond_drift(project: &Project) -> bool {
    lean_over_drift(project).is_some_and(|(_, share)| share >= 1.0)
}

/// The share of the allowable drift that a tilt outside the model leaves to an earthquake; 0 or less beyond it. `None` if the model has the tilt,
/// or without a tilt or an allowable drift.
pub fn drift_left(project: &Project) -> Option<f64> {
    let (survey, share) = lean_over_drift(project)?;
    let is_left_out = match &project.structure {
        Structure::Frame(part) => match &part.lean {
            Some(lean) => lean.survey != survey.name,
            None => !part.takes_no_tilt,
        },
        _ => true,
    };
    is_left_out.then_some(1.0 - share)
}

/// The survey of [`last_tilt`] and its tilt over the allowable drift of storeys.
fn lean_over_drift(project: &Project) -> Option<(&Survey, f64)> {
    let has_storeys = matches!(project.structure, Structure::Frame(_) | Structure::Building(_));
    let limit = project.drift_limit.as_ref().filter(|_| has_storeys)?;
    let (survey, tilt) = last_tilt(project)?;
    Some((survey, tilt / limit.ratio()))
}

/// The comparison of [`last_tilt`] with `tilt_limit`; `None` if either is missing.
pub fn tilt_against_limit(project: &Project) -> Option<TiltAgainstLimit> {
    let limit = project.watch.tilt_limit?;
    let (survey, tilt) = last_tilt(project)?;
    Some(TiltAgainstLimit {
        survey: survey.name.clone(),
        directions: survey.tilt.keys().cloned().collect(),
        tilt,
        limit,
    })
}

/// The latest dated survey with a tilt, or one without a date if its tilt is larger, and its resultant tilt, horizontal / vertical. A survey
/// without a date may be the latest.
pub fn last_tilt(project: &Project) -> Option<(&Survey, f64)> {
    let tilted = || project.surveys.iter().filter(|survey| !survey.tilt.is_empty());
    let dated = tilted().filter_map(|survey| Some((date(&survey.name)?, survey)));
    let last = dated.max_by_key(|(day, _)| *day).map(|(_, survey)| survey);
    let undated = tilted().filter(|survey| date(&survey.name).is_none());
    let all = undated.chain(last).map(|survey| (survey, survey.tilt_together()));
    all.max_by(|a, b| a.1.total_cmp(&b.1))
}
