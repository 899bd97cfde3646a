//! Effect of crushing edges on a stack.

use super::words::{in_g, megapascals};
use crate::document::{Finding, Tone};
use dolmen::assess::Crushing;
use dolmen::stability::Verdict;
use dolmen_words::{Quantity, messages};
use dolmen_work::state::StackAnswer;

messages! {
    /// Crushing of edges.
    pub(crate) enum Crushes in "stack.crushing" {
        Unstable { strength: Quantity } => {
            en: "Crushing governs: with a compressive strength of {strength} it does not stand; it would if no edge crushed.",
            ko: "압괴가 지배한다: 압축강도 {strength}에서는 서 있지 못하며, 모서리가 압괴하지 않는다면 서 있다.",
        },
        Sooner { strength: Quantity, with: Quantity, without: Quantity } => {
            en: "Crushing governs: with a compressive strength of {strength} it begins to move at {with}, at {without} if no edge crushed.",
            ko: "압괴가 지배한다: 압축강도 {strength}에서 {with}에 움직이기 시작하며, 모서리가 압괴하지 않는다면 {without}이다.",
        },
        Little { strength: Quantity, with: Quantity, without: Quantity } => {
            en: "Edges crush little: with a compressive strength of {strength} it begins to move at {with}, at {without} if no edge crushed.",
            ko: "모서리 압괴의 영향은 작다: 압축강도 {strength}에서 {with}에 움직이기 시작하며, 모서리가 압괴하지 않는다면 {without}이다.",
        },
        AnyhowFalls { strength: Quantity } => {
            en: "A compressive strength of {strength} is given; it does not stand without crushing, either.",
            ko: "압축강도 {strength}이(가) 주어졌으나, 모서리가 압괴하지 않아도 서 있지 못한다.",
        },
        NotInMovement => {
            en: "How far the supports can move is found with edges that do not crush, which is not on the safe side.",
            ko: "지점이 이동할 수 있는 범위는 모서리가 압괴하지 않는 것으로 구하였다(불안전측).",
        },
    }
}

/// The effect of crushing, if a strength is given.
pub(super) fn findings(answer: &StackAnswer) -> Vec<Finding> {
    let check = &answer.check;
    let Some(crushing) = &check.crushing else {
        return Vec::new();
    };
    let mut all = vec![of(crushing)];
    if check.supports.is_some() {
        all.push(Finding::key(Tone::Warn, Crushes::NotInMovement));
    }
    all
}

fn of(crushing: &Crushing) -> Finding {
    let strength = megapascals(crushing.strength_pa);
    let falls = crushing.verdict == Verdict::Unstable;
    match (crushing.moves_at_g, crushing.uncrushed_g) {
        _ if falls && crushing.uncrushed_verdict != Verdict::Unstable => {
            Finding::key(Tone::Bad, Crushes::Unstable { strength })
        }
        (Some(with), Some(without)) => {
            let (with, without) = (in_g(with), in_g(without));
            match crushing.governs() {
                true => Finding::key(
                    Tone::Warn,
                    Crushes::Sooner {
                        strength,
                        with,
                        without,
                    },
                ),
                false => Finding::new(
                    Tone::Plain,
                    Crushes::Little {
                        strength,
                        with,
                        without,
                    },
                ),
            }
        }
        _ => Finding::new(Tone::Plain, Crushes::AnyhowFalls { strength }),
    }
}
