//! Changes between two surveys: findings, and the sections of the comparison.

mod dampings;
mod doubts;
mod events_between;
mod findings;
mod forces;
mod frequencies;
mod history;
mod notes;
mod parts;
mod quantities;
mod readings;
mod remarks;
mod temperature;

pub(crate) use findings::{findings, undated};
pub(crate) use parts::{findings as part_findings, off as model_off, section as part_section};

use crate::document::{Document, Figure, table_series};
use crate::figures::survey_changes;
use dolmen_words::{Quantity, Template, messages};
use dolmen_work::answer::CompareAnswer;

messages! {
    /// Heading and figure of a comparison, and its limitations.
    pub(crate) enum Compared in "change" {
        Head { from: String, to: String } => {
            en: "What changed: {from} – {to}",
            ko: "조사 사이의 변화: {from} – {to}",
        },
        Drawn => {
            en: "Relative change of each frequency with its 95 % interval.",
            ko: "고유진동수별 상대 변화와 95 % 신뢰구간.",
        },
        Band { power: Quantity } => {
            en: "A change within the grey band is found with less than {power} probability.",
            ko: "회색 띠 안의 변화가 발견될 확률은 {power} 미만이다.",
        },
        NoProof => {
            en: "No change shown is no proof that nothing changed. Frequencies also follow moisture, added mass and the strength of the motion; the stiffness column holds only if stiffness changed alike everywhere and no mass did.",
            ko: "변화가 확인되지 않았다는 것은 변화가 없다는 증명이 아니다. 고유진동수는 습도, 부가 질량, 진동의 세기에 따라서도 변하며, 강성 열은 강성이 전체에서 같은 비율로 변하고 질량이 변하지 않았을 때에만 성립한다.",
        },
    }
}

/// Templates of the sentences on two surveys.
pub(crate) const TEMPLATES: [&[Template]; 13] = [
    findings::Found::TEMPLATES,
    history::Behind::TEMPLATES,
    events_between::Befell::TEMPLATES,
    doubts::Doubted::TEMPLATES,
    forces::Forces::TEMPLATES,
    Compared::TEMPLATES,
    temperature::Weather::TEMPLATES,
    frequencies::Frequencies::TEMPLATES,
    dampings::Dampings::TEMPLATES,
    remarks::Remarks::TEMPLATES,
    notes::Noted::TEMPLATES,
    readings::Readings::TEMPLATES,
    parts::Parted::TEMPLATES,
];

/// The section on two surveys of a project.
pub(crate) fn sections(answer: &CompareAnswer) -> Document<'_> {
    let mut document = Document::default();
    document.heading(Compared::Head {
        from: answer.from.clone(),
        to: answer.to.clone(),
    });
    let Some(change) = &answer.change else {
        readings::section(&mut document, answer);
        return document;
    };
    document.paragraph(temperature::measured(&answer.project, change));
    if !change.modes.is_empty() {
        let power = Quantity::percent(change.power, 2);
        let caption = vec![Compared::Drawn.into(), Compared::Band { power }.into()];
        let drawn = Figure::drawn(caption, |language| survey_changes(change, language));
        document.charted(drawn.with_series(|| table_series(&frequencies::table(change))));
        frequencies::section(&mut document, change);
        temperature::fitted(&mut document, change);
        history::section(&mut document, change);
        dampings::section(&mut document, change);
        parts::section(&mut document, &answer.parts);
    }
    readings::section(&mut document, answer);
    for remark in remarks::remarks(change) {
        document.note(remark);
    }
    for note in change
        .notes
        .iter()
        .filter(|of| !doubts::is_of_sensors(of) && !events_between::is_of_line(of))
    {
        document.note(notes::note(note));
    }
    document.paragraph(Compared::NoProof);
    document
}
