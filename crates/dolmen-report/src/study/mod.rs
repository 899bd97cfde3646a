//! Answers about a study: findings, and its section.

mod before;
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
mod sufficiency;
mod tenons;
mod trends;
mod words;

pub(crate) use findings::findings;

use crate::document::Document;
use dolmen_words::{Sentence, Template, messages};
use dolmen_work::study::StudyAnswer;

messages! {
    /// The head of a study.
    pub(crate) enum Study in "study" {
        Head { title: Sentence } => { en: "Study: {title}", ko: "반복 해석: {title}" },
        HeadAfter { title: Sentence, motion: String } => {
            en: "Study: {title}, after {motion}",
            ko: "반복 해석: {title}({motion} 이후)",
        },
    }
}

/// Templates of the sentences on studies.
pub(crate) const TEMPLATES: [&[Template]; 18] = [
    findings::Found::TEMPLATES,
    Study::TEMPLATES,
    run::Done::TEMPLATES,
    before::Preceded::TEMPLATES,
    capacities::Capacities::TEMPLATES,
    doubts::LeftOut::TEMPLATES,
    growth::Growth::TEMPLATES,
    trends::Trends::TEMPLATES,
    fragility::Curves::TEMPLATES,
    scatter::Scatter::TEMPLATES,
    hazard::Hazard::TEMPLATES,
    measures::Measures::TEMPLATES,
    sufficiency::Sufficient::TEMPLATES,
    joints::Joints::TEMPLATES,
    releases::Releases::TEMPLATES,
    drawn::Drawn::TEMPLATES,
    tenons::Crushed::TEMPLATES,
    words::Words::TEMPLATES,
];

/// The section of a study with its figures.
pub(crate) fn sections(answer: &StudyAnswer) -> Document<'_> {
    let mut document = tables(answer);
    drawn::section(&mut document, answer);
    document
}

/// The same without figures, which are slow to draw.
pub(crate) fn tables(answer: &StudyAnswer) -> Document<'_> {
    let mut document = Document::default();
    let title = title(answer);
    document.heading(match &answer.study.after {
        None => Study::Head { title },
        Some(after) => Study::HeadAfter {
            title,
            motion: after.motion.clone(),
        },
    });
    if answer.study.scan.is_some() {
        run::section(&mut document, answer);
        before::section(&mut document, answer);
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
