//! Stiffness of a structure from vibration: findings, and the section of every solution.

mod beside;
mod columns;
mod doubted;
mod findings;
mod joint_modes;
mod joint_tables;
mod joints;
mod left_out;
mod notes;
mod place;
mod plan;
mod plan_centre;
mod plan_values;
mod seen;
mod solutions;
mod words;
mod written;

pub(crate) use findings::{findings, findings_of_latest};
pub(crate) use written::Written;
pub use written::written_back_text;

use crate::document::{Block, Document};
use crate::figures::measured_modes;
use dolmen::structure::MeasuredMode;
use dolmen_project::Project;
use dolmen_words::{Digits, Quantity, Sentence, Template, Unit, messages};
use dolmen_work::surveyed::{StiffnessAnswer, SurveyAnswer};

messages! {
    /// The heading of the stiffness from vibration, and its source.
    pub(crate) enum Stiffness in "identification" {
        Head => { en: "Stiffness from measured vibration", ko: "계측 진동으로부터 추정한 강성" },
        OtherSprings => {
            en: "Stiffness if the springs acted otherwise",
            ko: "스프링의 작용 방식을 달리 본 경우의 강성",
        },
        Survey { survey: String, place: Sentence } => { en: "Survey {survey}, {place}", ko: "{survey} 조사, {place}" },
        Measured(modes: Vec<Sentence>) => { en: "Measured: {modes}.", ko: "계측값: {modes}." },
        Mode(frequency: Quantity) => { en: "{frequency}", ko: "{frequency}" },
        NoShape(frequency: Quantity) => { en: "{frequency} (no shape)", ko: "{frequency} (모드형상 없음)" },
        OnePoint(frequency: Quantity) => {
            en: "{frequency} (1 point of its shape)",
            ko: "{frequency} (측점 1개의 모드형상)",
        },
        Points { frequency: Quantity, points: usize } => {
            en: "{frequency} ({points} points of its shape)",
            ko: "{frequency} (측점 {points}개의 모드형상)",
        },
    }
}

/// Templates of the sentences on stiffness from vibration.
pub(crate) const TEMPLATES: [&[Template]; 17] = [
    beside::Beside::TEMPLATES,
    columns::Columns::TEMPLATES,
    doubted::Doubted::TEMPLATES,
    plan_centre::Centre::TEMPLATES,
    findings::Found::TEMPLATES,
    place::Place::TEMPLATES,
    words::Words::TEMPLATES,
    Stiffness::TEMPLATES,
    solutions::Solutions::TEMPLATES,
    seen::Seen::TEMPLATES,
    plan::Plan::TEMPLATES,
    joints::Joints::TEMPLATES,
    joint_modes::Modes::TEMPLATES,
    joint_tables::Tables::TEMPLATES,
    notes::Notes::TEMPLATES,
    left_out::ModeLeftOut::TEMPLATES,
    Written::TEMPLATES,
];

/// The stiffness for the convention that the file does not use.
pub(crate) fn appendix<'a>(project: &'a Project, all: &[&'a SurveyAnswer]) -> Document<'a> {
    let mut document = Document::default();
    let each = all
        .iter()
        .copied()
        .flat_map(|survey| survey.stiffness.iter().map(move |answer| (survey, answer)));
    for (survey, answer) in each.filter(|(_, answer)| !place::is_asked(project, answer)) {
        if document.blocks.is_empty() {
            document.heading(Stiffness::OtherSprings);
        }
        of_answer(&mut document, project, survey, answer);
    }
    document
}

/// The section of all surveys that give a stiffness.
pub(crate) fn sections<'a>(project: &'a Project, all: &[&'a SurveyAnswer]) -> Document<'a> {
    let mut document = Document::default();
    if all.iter().all(|survey| {
        survey.stiffness.is_empty()
            && survey.plan.is_none()
            && survey.factors.is_none()
            && !columns::is_seen(survey)
    }) {
        return document;
    }
    document.heading(Stiffness::Head);
    for survey in all.iter().copied() {
        for answer in survey
            .stiffness
            .iter()
            .filter(|answer| place::is_asked(project, answer))
        {
            of_answer(&mut document, project, survey, answer);
        }
        columns::section(&mut document, survey);
        if let Some(answer) = &survey.plan {
            plan::section(&mut document, &survey.name, answer);
        }
        if let Some(answer) = &survey.factors {
            joints::section(&mut document, &survey.name, answer);
        }
        if let Some(said) = seen::masses(survey, project) {
            document.note(said);
        }
    }
    document
}

fn of_answer<'a>(
    document: &mut Document<'a>,
    project: &'a Project,
    survey: &SurveyAnswer,
    answer: &'a StiffnessAnswer,
) {
    document.subheading(Stiffness::Survey {
        survey: survey.name.clone(),
        place: place::place(answer),
    });
    let measured = measured_modes(project, &survey.name, answer);
    let modes = measured.iter().map(|mode| mode_words(mode, answer.with_shapes));
    document.paragraph(Stiffness::Measured(modes.collect()));
    solutions::section(document, project, answer, measured);
    if let Some(visibility) = &answer.solutions.visibility {
        document.put(Block::Paragraph(seen::seen(visibility)));
    }
    for note in &answer.solutions.notes {
        document.note(notes::stiffness_note(note));
    }
}

/// An input frequency, and whether its shape was used.
fn mode_words(mode: &MeasuredMode, with_shapes: bool) -> Sentence {
    let frequency = Quantity {
        sd_si: Some(mode.frequency_sd_hz).filter(|sd| *sd > 0.0),
        ..Quantity::new(mode.frequency_hz, Unit::si("Hz"), Digits::Trimmed(5))
    };
    match mode.shape.len() {
        0 if with_shapes => Stiffness::Mode(frequency),
        0 => Stiffness::NoShape(frequency),
        1 => Stiffness::OnePoint(frequency),
        points => Stiffness::Points { frequency, points },
    }
    .into()
}
