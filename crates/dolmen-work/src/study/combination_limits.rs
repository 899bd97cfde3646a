//! What a file compares the results of a study with, and the directions that it leaves out.

use crate::wrong::OfRuns;
use dolmen::assess::demand::DriftLimit;
use dolmen_project::{Project, Structure, StudyPart};
use dolmen_words::message::Both;

/// The allowable drift of a storey over its height in a file.
pub(super) fn drift_limit_of(project: Option<&Project>) -> Option<f64> {
    project?.drift_limit.as_ref().map(DriftLimit::ratio)
}

/// A sentence for each direction of a frame that a study leaves out since its stiffness is unknown.
pub(super) fn unknown_directions(study: &StudyPart, project: &Project) -> Vec<Both> {
    let directions = match &project.structure {
        Structure::Frame(part) if study.direction.is_none() => part.directions.as_slice(),
        _ => &[],
    };
    let unknown = directions.iter().filter(|own| own.stiffness.is_none());
    let each = unknown.map(|own| OfRuns::DirectionLeftOut(own.name.clone()).into());
    each.collect()
}
