//! What is said of a study: findings, and its section.

mod capacities;
mod doubts;
mod drawn;
mod findings;
mod fragility;
mod growth;
mod hazard;
mod joints;
mod measures;
mod releases;
mod run;
mod scatter;
mod trends;
mod words;

pub(crate) use findings::findings;

use crate::document::Document;
use dolmen_words::{Sentence, Template, messages};
use dolmen_work::study::StudyAnswer;

messages! {
    /// The head of a study.
    pub(crate) enum Study in "study" {
        Head { title: Sentence } => { en: "Study: {title}", ko: "변수 연구: {title}" },
    }
}

/// The sentences on studies as they are written.
pub(crate) const TEMPLATES: [&[Template]; 15] = [
    findings::Found::TEMPLATES,
    Study::TEMPLATES,
    run::Done::TEMPLATES,
    capacities::Capacities::TEMPLATES,
    doubts::LeftOut::TEMPLATES,
    growth::Growth::TEMPLATES,
    trends::Trends::TEMPLATES,
    fragility::Curves::TEMPLATES,
    scatter::Scatter::TEMPLATES,
    hazard::Hazard::TEMPLATES,
    measures::Measures::TEMPLATES,
    joints::Joints::TEMPLATES,
    releases::Releases::TEMPLATES,
    drawn::Drawn::TEMPLATES,
    words::Words::TEMPLATES,
];

/// The section of a study with its figures.
pub(crate) fn sections(answer: &StudyAnswer) -> Document<'_> {
    let mut document = tables(answer);
    drawn::section(&mut document, answer);
    document
}

/// The same without figures, which take long to draw.
pub(crate) fn tables(answer: &StudyAnswer) -> Document<'_> {
    let mut document = Document::default();
    document.heading(Study::Head { title: title(answer) });
    if answer.study.scan.is_some() {
        run::section(&mut document, answer);
        capacities::section(&mut document, answer);
        doubts::section(&mut document, answer);
        growth::section(&mut document, answer);
        trends::section(&mut document, answer);
        fragility::section(&mut document, answer);
    } else {
        run::unscanned(&mut document, answer);
    }
    releases::section(&mut document, answer);
    document
}

fn title(answer: &StudyAnswer) -> Sentence {
    match &answer.study.title {
        Some(names) => words::both(|language| language.pick(names.english(), names.korean()).to_owned()),
        None => words::name(&answer.study.name),
    }
}
