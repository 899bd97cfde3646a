//! The verdict on a stack, and its meaning.

use super::mechanism::moving;
use super::standing::standing;
use super::words::{DIGITS, at, in_g, known_g, margin};
use dolmen::assess::{MARGINAL_BELOW_G, StackNote};
use dolmen::stability::Verdict;
use dolmen::stability::stack::{LimitAnalysisStatus, Standing, Threshold};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::state::StackAnswer;

messages! {
    /// The verdict on a stack.
    pub(crate) enum Judged in "stack.verdict" {
        Moves { margin: Sentence, at: Sentence } => {
            en: "Margin without shaking {margin}; it begins to move at {at} horizontal.",
            ko: "지진이 없을 때의 여유도는 {margin}이며, 수평 가속도 {at}에서 움직이기 시작한다.",
        },
        MovesUnknown { margin: Sentence } => {
            en: "Margin without shaking {margin}; what moves it first is not known.",
            ko: "지진이 없을 때의 여유도는 {margin}이며, 거동 시작 가속도는 알 수 없다.",
        },
        Weight => { en: "the weight", ko: "자중" },
        WeightAndLoads => { en: "the weight and the static loads", ko: "자중·정하중" },
        OrTilt { tilt: Quantity } => { en: ", or on ground that tilts by {tilt}", ko: " 또는 지반 기울기 {tilt}" },
        AsTilt { tilt: Quantity } => { en: " (a tilt of the ground of {tilt})", ko: "(지반 기울기 {tilt})" },
        Loaded => { en: "", ko: "" },
        Admissible { what: Sentence, at: Sentence, tilt: Sentence } => {
            en: "An admissible state exists: forces in the joints balance {what}. It begins to move at {at} horizontal{tilt}.",
            ko: "{what}와(과) 평형을 이루는 접합력이 존재한다(한계해석). 수평 가속도 {at}{tilt}에서 움직이기 시작한다.",
        },
        AdmissibleBetween { what: Sentence, at: Sentence, most: Quantity, tilt: Sentence } => {
            en: "Forces in the joints can balance {what}. It begins to move between {at} and {most} horizontal, by how its joints are pressed; {at} counts{tilt}.",
            ko: "{what}와(과) 평형을 이루는 접합력이 존재한다. 접합면이 눌린 상태에 따라 수평 가속도 {at}~{most}에서 움직이기 시작하며, {at}을(를) 기준으로 판정한다{tilt}.",
        },
        AdmissibleAtMost { what: Sentence, at: Sentence, tilt: Sentence } => {
            en: "Forces in the joints can balance {what}. It begins to move at {at} horizontal{tilt}, or less: an upper bound.",
            ko: "{what}와(과) 평형을 이루는 접합력이 존재한다. 수평 가속도 {at}{tilt} 또는 그 이하에서 움직이기 시작한다(상한값).",
        },
        IfFriction { what: Sentence, at: Sentence, tilt: Sentence } => {
            en: "Forces in the joints can balance {what}, but friction would have to hold it at rest. Only if it does, it begins to move at {at} horizontal{tilt}, or less.",
            ko: "{what}와(과) 평형을 이루는 접합력은 존재하나 마찰이 지탱하여야 한다. 마찰이 지탱하는 경우에만 수평 가속도 {at}{tilt} 또는 그 이하에서 움직이기 시작한다.",
        },
        FallsTogether { what: Sentence, moving: Sentence } => {
            en: "It does not stand without shaking: no forces in the joints balance {what}; {moving}.",
            ko: "지진이 없어도 서 있지 못한다: {what}와(과) 평형을 이루는 접합력이 존재하지 않는다. {moving}.",
        },
        FallsSomehow { what: Sentence } => {
            en: "It does not stand without shaking: no forces in the joints balance {what}.",
            ko: "지진이 없어도 서 있지 못한다: {what}와(과) 평형을 이루는 접합력이 존재하지 않는다.",
        },
        Falls { why: Sentence } => {
            en: "It does not stand without shaking: {why}.",
            ko: "지진이 없어도 서 있지 못한다: {why}.",
        },
        Thresholds { limit: Quantity, below: Quantity, least: Quantity } => {
            en: "stable: margin ≥ {limit}, and where friction carries stones that share their load, a run under their own weight that stood · marginal: below {below}, or moves below {least} · unstable: it does not stand. The margin is what is left, without shaking, of the way from the middle of a joint to its edge, or of friction. An earthquake is not in this verdict.",
            ko: "안정: 여유도 ≥ {limit}(하중을 나누어 지지하는 부재가 마찰로 지지되면 자중 시간이력해석에서도 안정하여야 함) · 여유 부족: {below} 미만이거나 {least} 미만에서 움직임 · 불안정: 서 있지 못함. 여유도는 지진이 없을 때 접합면 중심에서 모서리까지의 거리(또는 마찰) 중 남은 비율이다. 이 판정에 지진은 포함되지 않는다.",
        },
    }
}

/// The sentence of the banner.
pub(crate) fn banner(answer: &StackAnswer) -> Sentence {
    let limits = &answer.check.limits;
    let margin = margin(limits.gravity_margin);
    let analysis = answer.check.analysis.as_ref().map(|analysis| analysis.status);
    let falls = analysis == Some(LimitAnalysisStatus::DoesNotStand);
    let what: Sentence = match answer.stack.static_loads().is_empty() {
        true => Judged::Weight,
        false => Judged::WeightAndLoads,
    }
    .into();
    let said = match (&limits.standing, &answer.check.capacity) {
        (Standing::Stands, _) if falls => match moving(answer) {
            Some(moving) => Judged::FallsTogether { what, moving },
            None => Judged::FallsSomehow { what },
        },
        (Standing::Stands, Some(capacity)) if !limits.statically_determinate => {
            let at = at(capacity);
            let tilt = self::tilt(answer, capacity, |tilt| Judged::OrTilt { tilt });
            let notes = &answer.check.notes;
            let is_bound = notes.iter().any(|note| matches!(note, StackNote::UpperBound));
            match is_bound {
                _ if notes.iter().any(is_in_doubt) => Judged::IfFriction { what, at, tilt },
                true => Judged::AdmissibleAtMost { what, at, tilt },
                false => match notes.iter().find_map(dilating) {
                    Some(most) => {
                        let tilt = self::tilt(answer, capacity, |tilt| Judged::AsTilt { tilt });
                        Judged::AdmissibleBetween { what, at, most, tilt }
                    }
                    None => Judged::Admissible { what, at, tilt },
                },
            }
        }
        (Standing::Stands, Some(capacity)) => Judged::Moves {
            margin,
            at: at(capacity),
        },
        (Standing::Stands, None) => Judged::MovesUnknown { margin },
        (falls, _) => Judged::Falls { why: standing(falls) },
    };
    said.into()
}

/// A tilt of the ground that is equivalent to an acceleration: its tangent times g. Static loads lean with the weight when the ground tilts, but
/// are not shaken, so with them there is none.
fn tilt(answer: &StackAnswer, capacity: &Threshold, said: fn(Quantity) -> Judged) -> Sentence {
    if !answer.stack.static_loads().is_empty() {
        return Judged::Loaded.into();
    }
    let degrees = known_g(capacity.acceleration_g).atan().to_degrees();
    said(Quantity::new(degrees, Unit::si("°"), Digits::Significant(DIGITS))).into()
}

/// The acceleration that friction with dilation would hold, if a note gives it.
fn dilating(note: &StackNote) -> Option<Quantity> {
    match note {
        StackNote::WithoutDilatancy { dilating_g, .. } => Some(in_g(*dilating_g)),
        _ => None,
    }
}

/// Whether a note says that friction may not hold the stones at rest.
fn is_in_doubt(note: &StackNote) -> bool {
    matches!(
        note,
        StackNote::FrictionNoRest | StackNote::FrictionNotRun { .. } | StackNote::FrictionFell { .. }
    )
}

/// The meaning of the verdicts on a stack.
pub(crate) fn thresholds() -> Sentence {
    let limit = Quantity::ratio(Verdict::MARGINAL_BELOW_MARGIN, DIGITS);
    Judged::Thresholds {
        below: limit.clone(),
        limit,
        least: in_g(MARGINAL_BELOW_G),
    }
    .into()
}
