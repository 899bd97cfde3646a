//! The verdict on a stack, and what it means.

use super::standing::standing;
use super::words::{DIGITS, at, margin};
use dolmen::stability::Verdict;
use dolmen::stability::stack::Standing;
use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::state::StackAnswer;

messages! {
    /// The verdict on a stack.
    pub(crate) enum Judged in "stack.verdict" {
        Moves { margin: Sentence, at: Sentence } => {
            en: "Margin without shaking {margin}; it begins to move at {at} horizontal.",
            ko: "지진이 없을 때의 여유도 {margin}; 수평 가속도 {at}에서 움직이기 시작한다.",
        },
        MovesUnknown { margin: Sentence } => {
            en: "Margin without shaking {margin}; what moves it first is not known.",
            ko: "지진이 없을 때의 여유도 {margin}; 최초 거동은 알 수 없다.",
        },
        Falls { why: Sentence } => {
            en: "It does not stand without shaking: {why}.",
            ko: "지진이 없어도 서 있지 못한다: {why}.",
        },
        Thresholds { limit: Quantity, below: Quantity } => {
            en: "stable: margin ≥ {limit} · marginal: below {below} · unstable: it does not stand. The margin is what is left, without shaking, of the way from the middle of a joint to its edge, or of friction. An earthquake is not in this verdict.",
            ko: "안정: 여유도 ≥ {limit} · 여유 부족: {below} 미만 · 불안정: 서 있지 못함. 여유도는 지진이 없을 때 접합면 중심에서 모서리까지의 거리(또는 마찰) 중 남은 비율이다. 이 판정에 지진은 포함되지 않는다.",
        },
    }
}

/// The sentence of the banner.
pub(crate) fn banner(answer: &StackAnswer) -> Sentence {
    let limits = &answer.check.limits;
    let margin = margin(limits.gravity_margin);
    let said = match (&limits.standing, &answer.check.capacity) {
        (Standing::Stands, Some(capacity)) => Judged::Moves {
            margin,
            at: at(capacity),
        },
        (Standing::Stands, None) => Judged::MovesUnknown { margin },
        (falls, _) => Judged::Falls { why: standing(falls) },
    };
    said.into()
}

/// What the verdicts on a stack mean.
pub(crate) fn thresholds() -> Sentence {
    let limit = Quantity::ratio(Verdict::MARGINAL_BELOW_MARGIN, DIGITS);
    Judged::Thresholds {
        below: limit.clone(),
        limit,
    }
    .into()
}
