//! The frame while every joint slips.

use crate::document::{Block, Document};
use dolmen::assess::FrameCheck;
use dolmen::stability::{FrameStability, Verdict};
use dolmen_words::{Digits, Quantity, Sentence, Unit, Values, messages};

messages! {
    /// While every joint slips.
    pub(crate) enum Slipping in "frame.slipping" {
        Stands { factor: Quantity, verdict: Sentence } => {
            en: "While every joint slips, the load factor is {factor}: {verdict}.",
            ko: "모든 접합부가 미끄러지는 동안 하중배율은 {factor}이다({verdict}).",
        },
        Frequencies(frequencies: Values) => {
            en: "Its natural frequencies are then {frequencies}.",
            ko: "이때 고유진동수는 {frequencies}이다.",
        },
        Frequency(frequencies: Values) => {
            en: "Its natural frequency is then {frequencies}.",
            ko: "이때 고유진동수는 {frequencies}이다.",
        },
        NoFrequency => {
            en: "It does not vibrate then, it falls.",
            ko: "이때 진동하지 않고 안정을 잃는다.",
        },
        Stable => { en: "stable", ko: "안정" },
        Marginal => { en: "marginal", ko: "여유 부족" },
        Unstable => { en: "unstable", ko: "불안정" },
        Unknown => { en: "unknown", ko: "판정 불가" },
    }
}

/// Its load factor and frequencies, in two sentences.
pub(super) fn section(document: &mut Document<'_>, check: &FrameCheck) {
    let stands = check.stability.as_ref().map(stands);
    let said = stands.into_iter().chain([frequencies(check)]);
    document.put(Block::Paragraph(said.map(Sentence::from).collect()));
}

fn stands(stability: &FrameStability) -> Slipping {
    let verdict = match stability.verdict {
        Verdict::Stable => Slipping::Stable,
        Verdict::Marginal => Slipping::Marginal,
        Verdict::Unstable => Slipping::Unstable,
        Verdict::Unknown => Slipping::Unknown,
    };
    Slipping::Stands {
        factor: Quantity::beside_one(stability.load_factor, 4),
        verdict: verdict.into(),
    }
}

fn frequencies(check: &FrameCheck) -> Slipping {
    let swaying = check.modes.iter().filter(|mode| mode.omega_squared > 0.0);
    let frequency = |hz| Quantity::new(hz, Unit::si("Hz"), Digits::Significant(4));
    let all: Vec<Quantity> = swaying.map(|mode| frequency(mode.frequency_hz)).collect();
    match all.len() {
        0 => Slipping::NoFrequency,
        1 => Slipping::Frequency(Values(all)),
        _ => Slipping::Frequencies(Values(all)),
    }
}
