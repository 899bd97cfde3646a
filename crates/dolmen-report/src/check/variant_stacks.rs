//! A variant of a stack compared with the stack as it is: the acceleration of its first motion.

use super::variant_responses::SAME_SHARE;
use crate::document::{Finding, Tone};
use dolmen::stability::Verdict;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Unit, messages};
use dolmen_work::state::{Check, State};

/// Digits of an acceleration.
const DIGITS: usize = 3;

messages! {
    /// The first motion of a variant of a stack.
    pub(crate) enum StackVariant in "check.variant-stacks" {
        Moves { variant: Both, to: Quantity, from: Quantity, verdict: Both } => {
            en: "Variant “{variant}” first moves at {to}, the structure as it is at {from}: own weight {verdict}.",
            ko: "대안 ‘{variant}’의 거동 시작 가속도는 {to}이다(현 상태 {from}): 자중 {verdict}.",
        },
        MovesAlike { variant: Both, at: Quantity, verdict: Both } => {
            en: "Variant “{variant}” leaves the first motion at {at}: own weight {verdict}.",
            ko: "대안 ‘{variant}’에서 거동 시작 가속도는 {at}(으)로 같다: 자중 {verdict}.",
        },
        Stands { variant: Both, to: Quantity, verdict: Both } => {
            en: "Variant “{variant}” first moves at {to}, and the structure as it is falls under its own weight: {verdict}.",
            ko: "대안 ‘{variant}’의 거동 시작 가속도는 {to}이다({verdict}). 현 상태는 자중만으로 붕괴한다.",
        },
        Falls { variant: Both, from: Quantity, verdict: Both } => {
            en: "Variant “{variant}” falls under its own weight, and the structure as it is first moves at {from}: {verdict}.",
            ko: "대안 ‘{variant}’은(는) 자중만으로 붕괴한다({verdict}). 현 상태의 거동 시작 가속도는 {from}이다.",
        },
        FallsAlike { variant: Both, verdict: Both } => {
            en: "Variant “{variant}” falls under its own weight, as does the structure as it is: {verdict}.",
            ko: "대안 ‘{variant}’도 현 상태처럼 자중만으로 붕괴한다: {verdict}.",
        },
    }
}

/// When a stack first moves.
#[derive(Clone, Copy, PartialEq)]
enum First {
    Falls,
    AtG(f64),
}

/// `None` for another kind, or if the acceleration is unknown.
fn first(state: &State) -> Option<First> {
    let Check::Stack(answer) = &state.check else {
        return None;
    };
    match answer.check.verdict {
        Verdict::Unstable => Some(First::Falls),
        _ => answer.check.capacity.map(|of| First::AtG(of.acceleration_g)),
    }
}

/// How a variant of a stack changes its first motion; `verdict`: the word for its weight.
pub(super) fn first_motion(
    variant: &Both,
    (before, after): (&State, &State),
    verdict: Both,
) -> Option<Finding> {
    let variant = variant.clone();
    let at = |first_g: f64| Quantity::new(first_g, Unit::si("g"), Digits::Significant(DIGITS));
    let (tone, said) = match (first(before)?, first(after)?) {
        (First::Falls, First::Falls) => (Tone::Bad, StackVariant::FallsAlike { variant, verdict }),
        (First::AtG(from), First::Falls) => {
            let from = at(from);
            (
                Tone::Bad,
                StackVariant::Falls {
                    variant,
                    from,
                    verdict,
                },
            )
        }
        (First::Falls, First::AtG(to)) => {
            let to = at(to);
            (Tone::Plain, StackVariant::Stands { variant, to, verdict })
        }
        (First::AtG(from), First::AtG(to)) if (to - from).abs() <= SAME_SHARE * from => {
            let at = at(from);
            (Tone::Plain, StackVariant::MovesAlike { variant, at, verdict })
        }
        (First::AtG(from), First::AtG(to)) => {
            let tone = match to < from {
                true => Tone::Warn,
                false => Tone::Plain,
            };
            let (to, from) = (at(to), at(from));
            let said = StackVariant::Moves {
                variant,
                to,
                from,
                verdict,
            };
            (tone, said)
        }
    };
    Some(Finding::key(tone, said))
}
