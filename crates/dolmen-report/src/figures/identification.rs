//! All figures of an identification, named for files.

use super::words::{Modal, say};
use super::{
    ShapePanel, channels_over_time, likeness, mode_shapes, model_likeness, moving_shapes, response_coherence,
    response_magnitudes, sensor_shapes, singular_values, spectrogram, stabilization,
};
use dolmen::structure::{Convention, MeasuredMode};
use dolmen_project::{Project, Quantity, Structure};
use dolmen_words::Language;
use dolmen_work::answer::IdentifyAnswer;
use dolmen_work::mode_heights::mode_heights_m;
use dolmen_work::surveyed::StiffnessAnswer;

/// Number of solutions whose shapes are drawn.
const SOLUTIONS_DRAWN: usize = 4;

/// A figure and its file name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Figure {
    /// Name without an ending: "2009-singular-values".
    pub name: String,
    /// The SVG.
    pub svg: String,
}

/// Figures by their names, without those that have nothing to draw.
pub(super) fn drawn(each: impl Iterator<Item = (String, Option<String>)>) -> Vec<Figure> {
    each.filter_map(|(name, svg)| Some(Figure { name, svg: svg? }))
        .collect()
}

/// Every figure of an identification, survey by survey: spectrum, stabilisation and shapes of each record, and the mode
/// shapes of each solution. Empty if nothing was identified.
pub fn identification(answer: &IdentifyAnswer, language: Language) -> Vec<Figure> {
    let mut all = Vec::new();
    for survey in &answer.surveys {
        let mut add = |what: &str, svg: String| {
            all.push(Figure {
                name: format!("{}-{what}", survey.name),
                svg,
            });
        };
        if let Some(record) = &survey.records {
            add("channels", channels_over_time(&record.seen, language));
            if let Some(drawn) = &record.seen.spectrogram {
                let modes = &record.analysis.modes;
                add("spectrogram", spectrogram(&record.seen, drawn, modes, language));
            }
            add("singular-values", singular_values(&record.analysis, language));
            add("stabilization", stabilization(&record.analysis, language));
            let analysis = &record.analysis;
            let responses = analysis.driven.as_ref().and_then(|of| of.responses.as_ref());
            if let (Some(of), Some(driven)) = (responses, &analysis.driven) {
                for input in 0..driven.inputs.len() {
                    let number = input + 1;
                    add(
                        &format!("response-{number}"),
                        response_magnitudes(analysis, (of, input), language),
                    );
                }
                add("coherence", response_coherence(analysis, of, language));
            }
            if !record.analysis.modes.modes.is_empty() {
                add("mode-shapes", sensor_shapes(&record.analysis.modes, language));
            }
            if let Some(alike) = likeness(&record.analysis.modes, language) {
                add("likeness", alike);
            }
            if let Some(moving) = moving_shapes(&record.analysis.modes, language) {
                add("moving-shapes", moving);
            }
        }
        if let Some(setups) = &survey.setups {
            for (i, record) in setups.records.iter().enumerate() {
                add(
                    &format!("setup-{}-singular-values", i + 1),
                    singular_values(&record.analysis, language),
                );
                add(
                    &format!("setup-{}-stabilization", i + 1),
                    stabilization(&record.analysis, language),
                );
            }
            if !setups.modes().modes.is_empty() {
                add("mode-shapes", sensor_shapes(setups.modes(), language));
            }
            if let Some(alike) = likeness(setups.modes(), language) {
                add("likeness", alike);
            }
            if let Some(moving) = moving_shapes(setups.modes(), language) {
                add("moving-shapes", moving);
            }
        }
        if let Some(model) = &survey.model {
            add("likeness-with-model", model_likeness(model, language));
        }
        for stiffness in &survey.stiffness {
            let measured = measured_modes(&answer.project, &survey.name, stiffness);
            let Some(svg) = solution_shapes(&answer.project.structure, stiffness, &measured, language) else {
                continue;
            };
            let convention = match stiffness.convention {
                None => "",
                Some(Convention::Drift) => "-drift",
                Some(Convention::Grounded) => "-grounded",
            };
            add(&format!("{}{convention}-solutions", stiffness.direction), svg);
        }
    }
    all
}

/// The input modes as the project states them; those from records have only a frequency.
pub(crate) fn measured_modes(project: &Project, survey: &str, answer: &StiffnessAnswer) -> Vec<MeasuredMode> {
    let stated = project.surveys.iter().find(|s| s.name == survey);
    let stated = stated
        .map(|s| s.measured_modes(&answer.direction, &mut Quantity::nominal))
        .unwrap_or_default();
    let mode = |&frequency_hz: &f64| {
        let same = stated.iter().find(|m| m.frequency_hz == frequency_hz);
        same.cloned().unwrap_or(MeasuredMode {
            frequency_hz,
            frequency_sd_hz: 0.0,
            frequency_changes_hz: Vec::new(),
            shape: Vec::new(),
        })
    };
    answer.frequencies_hz.iter().map(mode).collect()
}

/// "A" for the first solution, "B" for the second.
pub(crate) fn letter(index: usize) -> String {
    char::from_u32('A' as u32 + index as u32 % 26)
        .map(String::from)
        .unwrap_or_default()
}

/// Mode shapes of the first solutions side by side, with measured points; `None` without a solution or a model.
pub(crate) fn solution_shapes(
    structure: &Structure,
    answer: &StiffnessAnswer,
    measured: &[MeasuredMode],
    language: Language,
) -> Option<String> {
    let heights_m = mode_heights_m(structure).filter(|_| !answer.solutions.solutions.is_empty())?;
    let mut panels = Vec::new();
    for (i, solution) in answer
        .solutions
        .solutions
        .iter()
        .take(SOLUTIONS_DRAWN)
        .enumerate()
    {
        for (j, mode) in solution.modes.iter().enumerate() {
            // a measured mode is drawn over the nearest computed one
            let nearest = measured.iter().find(|m| {
                let apart = |f: f64| (f - m.frequency_hz).abs();
                let others = solution.modes.iter();
                others
                    .clone()
                    .all(|other| apart(mode.frequency_hz) <= apart(other.frequency_hz))
            });
            panels.push(ShapePanel {
                title: format!("{} · {} {}", letter(i), say(Modal::Mode, language), j + 1),
                mode,
                measured: nearest.map_or(&[], |m| m.shape.as_slice()),
            });
        }
    }
    Some(mode_shapes(&heights_m, &panels, language))
}
