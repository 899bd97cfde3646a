//! The lowest frequencies from the records of surveys.

use crate::judgement::{FrequencyAndDeviation, RecordFrequency};
use crate::more_modes::near;
use crate::surveyed::SurveyAnswer;
use dolmen::structure::{MeasuredMode, directional_modes};
use dolmen_project::{Project, Structure};

/// Least motion on both sides of a node, as a share of the largest. Our choice: noise of shapes is less.
const NODE_LEAST: f64 = 0.1;

/// The lowest frequency along x and y from the records of surveys, where the file states none.
pub(crate) fn lowest_of_records(project: &Project, surveys: &[SurveyAnswer]) -> Vec<RecordFrequency> {
    let parts = match &project.structure {
        Structure::Chain(part) => part.links.len(),
        Structure::Frame(part) => part.storeys.len(),
        Structure::Stack(_) | Structure::Building(_) | Structure::Survey => usize::MAX,
    };
    let mut all = Vec::new();
    for answer in surveys {
        let is_written = |direction: &str| {
            let mut own = project.surveys.iter().filter(|survey| survey.name == answer.name);
            own.any(|survey| survey.modes.contains_key(direction))
        };
        let Some((modes, _)) = answer.modes().filter(|_| !answer.is_shaken()) else {
            continue;
        };
        for (direction, vector) in [("x", [1.0, 0.0, 0.0]), ("y", [0.0, 1.0, 0.0])] {
            let mut along = directional_modes(modes, vector);
            let beyond = along.keep(modes, parts);
            let further = near(&along.modes, &beyond).len();
            let each = along.modes.iter().chain(&beyond);
            let others = each.skip(1).take(further).map(|mode| FrequencyAndDeviation {
                frequency_hz: mode.frequency_hz,
                sd_hz: mode.frequency_sd_hz,
            });
            let lowest = along.modes.first();
            if let Some(mode) = lowest.filter(|_| !is_written(direction)) {
                all.push(RecordFrequency {
                    survey: answer.name.clone(),
                    direction,
                    frequency_hz: mode.frequency_hz,
                    sd_hz: mode.frequency_sd_hz,
                    has_node: has_node(mode),
                    others: others.collect(),
                });
            }
        }
    }
    all
}

/// Whether parts of a shape move against each other.
fn has_node(mode: &MeasuredMode) -> bool {
    let each = || mode.shape.iter().map(|point| point.displacement);
    let least = NODE_LEAST * each().map(f64::abs).fold(0.0, f64::max);
    each().any(|u| u > least) && each().any(|u| u < -least)
}
