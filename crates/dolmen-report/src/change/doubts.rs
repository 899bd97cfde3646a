//! Data that were not compared, and other possible pairs of modes.

use super::notes::note;
use super::quantities::{hertz, percent};
use crate::document::{Finding, Tone};
use dolmen::assess::{ChangeNote, NotCompared, SurveyChange};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Doubts about the pairing of modes.
    pub(crate) enum Doubted in "change.doubts" {
        OtherPairing { pairs: Vec<Sentence> } => {
            en: "Which mode is which is not sure: more of them find a partner by {pairs}. What follows rests on the nearest pairs.",
            ko: "모드의 대응이 확실하지 않다. 다음과 같이 대응시키면 더 많은 모드가 짝을 이룬다: {pairs}. 아래 결과는 가장 가까운 대응에 따른다.",
        },
        Pair { before: Quantity, after: Quantity, change: Quantity } => {
            en: "{before} → {after} ({change})",
            ko: "{before} → {after} ({change})",
        },
        Lost { which: Sentence } => {
            en: "{which} was not found again and is not compared.",
            ko: "{which}이(가) 다시 확인되지 않아 비교하지 못하였다.",
        },
        LostMayBe { which: Sentence, candidate: Sentence, moved: Sentence } => {
            en: "{which} was not found again and is not compared. A new one lies at {candidate}: if it is the same mode, {moved}.",
            ko: "{which}이(가) 다시 확인되지 않아 비교하지 못하였다. 새로 확인된 {candidate} 모드가 같은 모드라면 {moved}.",
        },
        Lowest { before: Quantity } => { en: "The lowest mode ({before})", ko: "최저차 모드({before})" },
        Mode { before: Quantity } => { en: "A mode ({before})", ko: "모드({before})" },
        Like { after: Quantity, mac: Quantity } => {
            en: "{after}, its shape alike (MAC {mac})",
            ko: "{after}(형상 유사, MAC {mac})",
        },
        At { after: Quantity } => { en: "{after}", ko: "{after}" },
        Fell { by: Quantity, stiffness: Quantity } => {
            en: "it fell by {by} ({stiffness} of stiffness)",
            ko: "진동수가 {by} 낮아진 것이다(강성 {stiffness} 감소)",
        },
        Rose { by: Quantity, stiffness: Quantity } => {
            en: "it rose by {by} ({stiffness} of stiffness)",
            ko: "진동수가 {by} 높아진 것이다(강성 {stiffness} 증가)",
        },
    }
}

/// The doubts, each a finding.
pub(super) fn doubts(change: &SurveyChange) -> Vec<Finding> {
    let pair = |[before, after]: &[f64; 2]| {
        let said = Doubted::Pair {
            before: hertz(*before),
            after: hertz(*after),
            change: percent(after / before - 1.0, 1),
        };
        said.into()
    };
    let pairs: Vec<Sentence> = change.other_pairing_hz.iter().map(pair).collect();
    let other = (!pairs.is_empty()).then_some(Doubted::OtherPairing { pairs });
    // a rotated or exchanged sensor explains apparently lost modes: it comes first, and no other mode is offered in their place
    let sensors: Vec<Finding> = change
        .notes
        .iter()
        .filter(|of| is_of_sensors(of))
        .map(|of| Finding::key(Tone::Warn, note(of)))
        .collect();
    let lost = change.not_compared.iter().map(|of| lost(of, sensors.is_empty()));
    let all: Vec<Doubted> = other.into_iter().chain(lost).collect();
    let all = all.into_iter().map(|doubt| Finding::key(Tone::Warn, doubt));
    sensors.into_iter().chain(all).collect()
}

/// Whether a note says that a sensor, a direction, a sampling rate or a unit changed.
pub(super) fn is_of_sensors(note: &ChangeNote) -> bool {
    matches!(
        note,
        ChangeNote::Turned(_)
            | ChangeNote::Swapped(_)
            | ChangeNote::DirectionsExchanged(_)
            | ChangeNote::RateRatio { .. }
            | ChangeNote::Reciprocals { .. }
            | ChangeNote::OneFactor { .. }
    )
}

fn lost(lost: &NotCompared, offers_another: bool) -> Doubted {
    let before = hertz(lost.from.frequency_hz);
    let which = match lost.is_lowest {
        true => Doubted::Lowest { before }.into(),
        false => Doubted::Mode { before }.into(),
    };
    let may_be = lost.may_be.as_ref().filter(|_| offers_another);
    let (Some(may_be), Some([by, stiffness])) = (may_be, lost.change()) else {
        return Doubted::Lost { which };
    };
    let after = hertz(may_be.frequency_hz);
    let candidate = match lost.assurance {
        Some(mac) => Doubted::Like {
            after,
            mac: Quantity::new(mac, Unit::ratio(), Digits::Fixed(2)),
        },
        None => Doubted::At { after },
    };
    let fell = by < 0.0;
    let (by, stiffness) = (percent(by.abs(), 0), percent(stiffness.abs(), 0));
    let moved = match fell {
        true => Doubted::Fell { by, stiffness },
        false => Doubted::Rose { by, stiffness },
    };
    Doubted::LostMayBe {
        which,
        candidate: candidate.into(),
        moved: moved.into(),
    }
}
