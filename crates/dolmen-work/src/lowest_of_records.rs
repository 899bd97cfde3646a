//! The lowest frequencies from the records of surveys.

use crate::judgement::RecordFrequency;
use crate::surveyed::SurveyAnswer;
use dolmen::structure::directional_modes;
use dolmen_project::Project;

/// The lowest frequency along x and y from the records of surveys, where the file states none.
pub(crate) fn lowest_of_records(project: &Project, surveys: &[SurveyAnswer]) -> Vec<RecordFrequency> {
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
            let lowest = directional_modes(modes, vector).modes.into_iter().next();
            if let Some(mode) = lowest.filter(|_| !is_written(direction)) {
                all.push(RecordFrequency {
                    survey: answer.name.clone(),
                    direction,
                    frequency_hz: mode.frequency_hz,
                    sd_hz: mode.frequency_sd_hz,
                });
            }
        }
    }
    all
}
