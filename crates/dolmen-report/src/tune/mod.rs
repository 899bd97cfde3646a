//! Answers about dampers compared with the rule and the optimum: findings, a section per damper, and all together.

mod choices;
mod findings;
mod floors;
mod remarks;
mod together;
mod tunings;
mod words;

pub(crate) use findings::{findings, points_at_check};

use crate::document::{Document, Finding, TextStyle, document_text, findings_text, heading_text};
use dolmen_words::{Sentence, Template, messages};
use dolmen_work::building::{TogetherAnswer, TuneAnswer};

messages! {
    /// Heads of the sections.
    pub(crate) enum Heads in "tune.heads" {
        Damper { damper: String } => { en: "Damper: {damper}", ko: "감쇠기: {damper}" },
        Together => { en: "All dampers together", ko: "감쇠기 전체" },
        TogetherOf { variant: String } => { en: "All dampers together: {variant}", ko: "감쇠기 전체: {variant}" },
    }
}

/// Templates of the sentences on dampers.
pub(crate) const TEMPLATES: [&[Template]; 8] = [
    words::Words::TEMPLATES,
    findings::Found::TEMPLATES,
    Heads::TEMPLATES,
    choices::Choices::TEMPLATES,
    tunings::Tunings::TEMPLATES,
    together::Together::TEMPLATES,
    remarks::Remark::TEMPLATES,
    floors::Floors::TEMPLATES,
];

/// A section per damper, then all dampers of a version together.
pub(crate) fn sections<'a>(tunings: &[&'a TuneAnswer], together: &[&TogetherAnswer]) -> Document<'a> {
    let mut document = Document::default();
    for answer in tunings {
        document.heading(head(answer));
        one(&mut document, answer);
    }
    for answer in together {
        document.heading(head_together(answer));
        together::section(&mut document, answer);
    }
    document
}

fn head(answer: &TuneAnswer) -> Heads {
    Heads::Damper {
        damper: answer.damper.clone(),
    }
}

fn head_together(answer: &TogetherAnswer) -> Heads {
    match answer.variant.clone() {
        None => Heads::Together,
        Some(variant) => Heads::TogetherOf { variant },
    }
}

fn one<'a>(document: &mut Document<'a>, answer: &'a TuneAnswer) {
    choices::lead(document, answer);
    choices::section(document, answer);
    floors::section(document, answer);
    tunings::section(document, answer);
    tunings::out_of_tune(document, answer);
    remarks::of_one(document, answer);
}

/// A damper compared with the rule and the optimum, for a terminal.
pub fn tune_text(answer: &TuneAnswer, style: TextStyle) -> String {
    let mut document = Document::default();
    match style.is_full {
        true => one(&mut document, answer),
        false => floors::short(&mut document, answer),
    }
    text(head(answer), &findings(&[answer], &[]), &document, style)
}

/// All dampers of a building at once, for a terminal.
pub fn together_text(answer: &TogetherAnswer, style: TextStyle) -> String {
    let mut document = Document::default();
    if style.is_full {
        together::section(&mut document, answer);
    }
    text(head_together(answer), &findings(&[], &[answer]), &document, style)
}

/// The decisive findings, or all if requested, and the document.
fn text(head: Heads, findings: &[Finding], document: &Document<'_>, style: TextStyle) -> String {
    let shown = findings.iter().filter(|of| of.is_key || style.is_full);
    let head = heading_text(&Sentence::from(head).text(style.language));
    head + &findings_text(shown, style) + &document_text(document, style)
}
