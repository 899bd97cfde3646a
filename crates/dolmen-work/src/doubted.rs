//! Withholds stiffness from a record whose shapes contradict the model, or whose sensors contradict each other.

use crate::kinds;
use crate::surveyed::{StiffnessDoubt, SurveyAnswer, SurveyColumns};
use dolmen::modal::Modes;
use dolmen::structure::{ColumnsTogether, columns_together};
use dolmen_project::{Project, Structure, Survey};

/// Directions for which records give stiffness, in the order of the axes.
const AXES: [&str; 2] = ["x", "y"];

/// Marks as doubtful the stiffness from records, in directions for which the survey states no modes.
pub(crate) fn doubt(project: &Project, survey: &Survey, answer: &mut SurveyAnswer) {
    let found = answer.modes().map(|(modes, _)| modes.clone());
    let Some(modes) = found else { return };
    let doubt = kinds::shape_doubt(project, &modes);
    let setups = answer.setups.iter().flat_map(|setups| &setups.records);
    let is_told = answer
        .records
        .iter()
        .chain(setups)
        .any(|record| !record.doubts.is_empty());
    let explains = doubt.as_ref().is_some_and(|doubt| !doubt.changes.is_empty());
    for stiffness in &mut answer.stiffness {
        let is_stated = survey.modes.contains_key(&stiffness.direction);
        let axis = AXES.iter().position(|axis| *axis == stiffness.direction);
        let Some(axis) = axis.filter(|_| !is_stated) else {
            continue;
        };
        stiffness.doubted = match &doubt {
            _ if is_told || explains => Some(StiffnessDoubt::Sensors),
            Some(doubt) if doubt.is_of(axis) => Some(StiffnessDoubt::Shapes {
                unexplained: doubt.unexplained_along[axis],
            }),
            _ => stiffness.doubted,
        };
    }
    answer.shape_doubt = doubt;
}

/// Whether the columns of a frame move as one in the modes of a record; empty for other kinds, and without two sensors on a level.
pub(crate) fn columns(project: &Project, modes: &Modes) -> Vec<SurveyColumns> {
    if !matches!(project.structure, Structure::Frame(_)) {
        return Vec::new();
    }
    let along = [("x", [1.0, 0.0, 0.0]), ("y", [0.0, 1.0, 0.0])];
    let each = along.map(|(direction, vector)| SurveyColumns {
        direction,
        levels: columns_together(modes, vector, &ColumnsTogether::default()),
    });
    each.into_iter().filter(|of| !of.levels.is_empty()).collect()
}
