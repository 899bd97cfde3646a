//! Inputs of a simulated motion.

use crate::brief::notes_text;
use crate::check::{from_surveys_text, made_up_text, project_text, tilt_beyond};
use crate::document::{Document, TextStyle, document_text, findings_text, wrapped};
use crate::simulated::{doubted, motion_section};
use dolmen_project::{Project, Structure};
use dolmen_words::{Sentence, Template, messages};
use dolmen_work::motion::MotionAnswer;

messages! {
    /// What is simulated.
    pub(crate) enum Inputs in "simulated.inputs" {
        SensorsNotCompared => {
            en: "What the sensors of the survey measured above the ground is not compared with this run: Dolmen does that for frames.",
            ko: "조사 센서가 지반 위에서 계측한 값은 이 해석과 비교하지 않는다. 비교는 골조 모델에서만 한다.",
        },
        Variant { name: String } => { en: "variant {name}", ko: "대안 {name}" },
    }
}

/// Templates of the sentences on inputs.
pub(crate) const TEMPLATES: &[Template] = Inputs::TEMPLATES;

/// The inputs before the run: the project, its motions, and their changes.
pub fn simulation_inputs_text(
    project: &Project,
    file: &str,
    variant: Option<&str>,
    motions: &[&MotionAnswer],
    style: TextStyle,
) -> String {
    let mut document = Document::default();
    if let Some(name) = variant {
        let name = name.to_owned();
        document.paragraph(Inputs::Variant { name });
    }
    for motion in motions {
        motion_section(&mut document, motion);
    }
    let mut head = project_text(project, file, style)
        + &made_up_text(project, style)
        + &from_surveys_text(project, style);
    // a survey belongs to the structure as it is
    if variant.is_none() {
        head += &findings_text(&tilt_beyond(project), style);
    }
    let is_measured = motions.iter().any(|motion| motion.measured.is_some());
    if is_measured && !matches!(project.structure, Structure::Frame(_)) {
        let said = Sentence::from(Inputs::SensorsNotCompared).text(style.language);
        head += &wrapped(&said, "  ○ ", "    ", style.columns());
    }
    for doubt in motions.iter().flat_map(|motion| motion.doubts()) {
        let said = Sentence::from(doubted(&doubt)).text(style.language);
        head += &wrapped(&said, "  ! ", "    ", style.columns());
    }
    match style.is_full {
        true => head + &document_text(&document, style) + &notes_text(project, style),
        false => head + "\n",
    }
}
