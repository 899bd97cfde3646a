//! A project in one line.

use dolmen::structure::{Choice, Convention};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Language, Quantity, Sentence, Template, Unit, messages};
use dolmen_work::answer::ProjectReport;
use dolmen_work::judgement::judge;

messages! {
    /// A project in one line.
    pub(crate) enum Line in "text.line" {
        AsItIs(words: Both) => { en: "as it is: {words}", ko: "현 상태: {words}" },
        Variant { variant: String, words: Both } => { en: "variant ‘{variant}’: {words}", ko: "대안 ‘{variant}’: {words}" },
        Modes(frequencies: Vec<Sentence>) => { en: "modes at {frequencies} Hz", ko: "고유진동수 {frequencies} Hz" },
        Frequency(of: Quantity) => { en: "{of}", ko: "{of}" },
        One(direction: String) => {
            en: "one stiffness explains direction {direction}",
            ko: "{direction} 방향: 계측과 맞는 강성은 하나",
        },
        Bounded(direction: String) => {
            en: "one stiffness, known only between bounds, explains direction {direction}",
            ko: "{direction} 방향: 계측과 맞는 강성은 하나이며 상·하한만 정해짐",
        },
        Several { stiffnesses: usize, direction: String } => {
            en: "{stiffnesses} stiffnesses explain direction {direction}",
            ko: "{direction} 방향: 계측과 맞는 강성이 {stiffnesses}개",
        },
        TooFew(direction: String) => {
            en: "too few data for the stiffness of direction {direction}",
            ko: "{direction} 방향: 강성을 정하기에 자료가 부족함",
        },
        NotChosen(direction: String) => {
            en: "no stiffness chosen in direction {direction}, its record is doubted",
            ko: "{direction} 방향: 기록이 의심스러워 강성을 판정하지 않음",
        },
        NoStiffness(direction: String) => {
            en: "no stiffness explains direction {direction}",
            ko: "{direction} 방향: 계측과 맞는 강성이 없음",
        },
        Drift(said: Sentence) => { en: "{said} (drift)", ko: "{said}(층간 강성 기준)" },
        Grounded(said: Sentence) => { en: "{said} (grounded)", ko: "{said}(지면 기준 강성)" },
    }
}

/// Templates of the sentences of one line.
pub(crate) const TEMPLATES: &[Template] = Line::TEMPLATES;

/// One line on a project: its judgement, measurements, and their explanation.
pub fn project_line(answer: &ProjectReport, language: Language) -> String {
    let mut parts: Vec<Sentence> = Vec::new();
    for version in judge(&answer.answers).versions {
        let words = Both::of(|language| version.words(language).join(", "));
        parts.push(match version.variant {
            None => Line::AsItIs(words).into(),
            Some(variant) => Line::Variant { variant, words }.into(),
        });
    }
    for survey in answer.surveys() {
        if let Some(record) = &survey.records {
            let modes = record.analysis.modes.modes.iter();
            let of = |hz| Quantity::new(hz, Unit::ratio(), Digits::Fixed(3));
            let frequencies = modes
                .map(|mode| Line::Frequency(of(mode.frequency_hz)).into())
                .collect();
            parts.push(Line::Modes(frequencies).into());
        }
        for stiffness in &survey.stiffness {
            let direction = stiffness.direction.clone();
            let found = &stiffness.solutions;
            let said: Sentence = match found.choice {
                Choice::One if !stiffness.is_undoubted() => Line::NotChosen(direction),
                Choice::One => Line::One(direction),
                Choice::Bounded => Line::Bounded(direction),
                Choice::Indistinguishable => Line::Several {
                    stiffnesses: found.solutions.len(),
                    direction,
                },
                Choice::Underdetermined => Line::TooFew(direction),
                Choice::Impossible => Line::NoStiffness(direction),
            }
            .into();
            parts.push(match stiffness.convention {
                Some(Convention::Drift) => Line::Drift(said).into(),
                Some(Convention::Grounded) => Line::Grounded(said).into(),
                None => said,
            });
        }
    }
    let parts = parts.iter().map(|part| part.text(language));
    parts.collect::<Vec<_>>().join("; ")
}
