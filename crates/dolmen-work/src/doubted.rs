//! Withholds stiffness from a record whose shapes contradict the model, or whose sensors contradict each other.

use crate::kinds;
use crate::surveyed::{StiffnessDoubt, SurveyAnswer, SurveyColumns};
use dolmen::modal::{Modes, Note};
use dolmen::structure::{ColumnsTogether, columns_together};
use dolmen_project::{Project, Structure, Survey};

/// Directions for which records give stiffness, in the order of the axes.
const AXES: [&str; 2] = ["x", "y"];
/// Relative difference of frequencies of one mode: those of joined setups differ a little from those of each. Our choice.
const SAME_MODE: f64 = 0.005;

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
    let on_machines_hz = on_machines_hz(answer);
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
            _ => stiffness.doubted.or_else(|| {
                let mut used = stiffness.frequencies_hz.iter();
                let is_on = |hz: &&f64| on_machines_hz.iter().any(|on| (*hz / on - 1.0).abs() < SAME_MODE);
                used.find(is_on)
                    .map(|hz| StiffnessDoubt::Machine { mode_hz: *hz })
            }),
        };
    }
    answer.shape_doubt = doubt;
}

/// Frequencies of modes at which machines run, Hz: their sines move the frequency and take damping away.
fn on_machines_hz(answer: &SurveyAnswer) -> Vec<f64> {
    let setups = answer.setups.iter().flat_map(|setups| &setups.records);
    let records = answer.records.iter().chain(setups);
    let notes = records.flat_map(|record| &record.analysis.notes);
    notes
        .flat_map(|note| match note {
            Note::TonesOnModes { tones } => tones.iter().map(|tone| tone.mode_hz).collect(),
            _ => Vec::new(),
        })
        .collect()
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
