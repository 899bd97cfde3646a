//! Findings of a stack's check.

use super::crushing;
use super::lean::lean;
use super::mechanism::moving;
use super::notes::{is_less, note};
use super::verdict::banner;
use super::words::{at, direction, first_with_ties, joint_moves, moves_together, parts_with_ties};
use super::{narrow_beds, soil, supports};
use crate::document::{Finding, Tone};
use dolmen::assess::StackNote;
use dolmen::stability::stack::{Governing, StackLimitStates, Threshold};
use dolmen::structure::stack::{GAP_CLOSED_M, Stack};
use dolmen_words::{Sentence, messages};
use dolmen_work::state::StackAnswer;

/// Relative difference within which a limit analysis and a cut have the same acceleration. Our choice, far above the accuracy of the analysis.
const SAME: f64 = 1e-6;
/// Relative change of the capacity from which the short answer names corners whose exactness cannot be seen. Our choice.
const CORNERS_COUNT: f64 = 0.01;

messages! {
    /// Findings on a stack.
    pub(crate) enum Found in "stack.findings" {
        First { moves: Sentence, at: Sentence } => {
            en: "First {moves}, at {at}. That is the first motion, not collapse: how far it goes needs a time history.",
            ko: "{at}에서 가장 먼저 {moves}. 이는 최초 거동이지 붕괴가 아니며, 그 이후는 시간이력해석이 필요하다.",
        },
        Together { direction: Sentence } => {
            en: "Several stones move together first, towards {direction}; a limit analysis finds it.",
            ko: "가장 먼저 {direction} 방향으로 여러 부재가 함께 움직인다(한계해석 결과).",
        },
        TogetherAt { direction: Sentence, joints: Sentence } => {
            en: "Several stones move together first, towards {direction}: {joints}; a limit analysis finds it.",
            ko: "가장 먼저 {direction} 방향으로 여러 부재가 함께 움직인다: {joints}(한계해석 결과).",
        },
        WithTies { moves: Sentence, at: Sentence } => {
            en: "With every tie at its strength first {moves}, at {at}.",
            ko: "모든 연결재가 강도까지 작용하면 {at}에서 가장 먼저 {moves}.",
        },
        PartWithTies { moves: Sentence, at: Sentence, without: Sentence } => {
            en: "As one part, with every tie at its strength, {moves}, at {at}; without ties at {without}. Stones that share their load may move sooner.",
            ko: "한 부분으로 보고 모든 연결재가 강도까지 작용하면 {at}에서 {moves}(연결재가 없으면 {without}). 하중을 나누어 지지하는 석재는 더 일찍 움직일 수 있다.",
        },
    }
}

/// The findings, the most important first.
pub(crate) fn findings(answer: &StackAnswer) -> Vec<Finding> {
    let check = &answer.check;
    let mut all = Vec::new();
    let (decided, others): (Vec<Finding>, Vec<Finding>) = supports::findings(answer)
        .into_iter()
        .partition(|_| supports::decide(check));
    let own = match supports::decide(check) {
        true => Tone::Plain,
        false => Tone::of(check.verdict),
    };
    all.extend(decided);
    all.push(Finding::answer(own, banner(answer)));
    all.extend(others);
    match (&check.limits.governing, moves_together(check)) {
        (Some(first), None) => {
            let (moves, at) = (joint_moves(&check.limits, first), at(&first.threshold));
            all.push(Finding::key(Tone::Plain, Found::First { moves, at }));
        }
        (_, Some(together)) => {
            let direction = direction(together.direction);
            let found = match moving(answer) {
                Some(joints) => Found::TogetherAt { direction, joints },
                None => Found::Together { direction },
            };
            all.push(Finding::key(Tone::Plain, found));
        }
        // stones share their load, and a cut is what moves at the capacity
        (None, None) => {
            let cuts = [&check.limits.uplift, &check.limits.sliding];
            // the limit analysis finds the same value to its own accuracy
            let moves_first = |cut: &&Governing| {
                let at = cut.threshold.acceleration_m_s2;
                let off = |of: &Threshold| (of.acceleration_m_s2 - at).abs() <= SAME * at;
                check.capacity.as_ref().is_some_and(off)
            };
            if let Some(first) = cuts.into_iter().flatten().find(moves_first) {
                let (moves, at) = (joint_moves(&check.limits, first), at(&first.threshold));
                all.push(Finding::key(Tone::Plain, Found::First { moves, at }));
            }
        }
    }
    all.extend(narrow_beds::finding(&answer.stack));
    all.extend(crushing::findings(answer));
    if !answer.stack.ties().is_empty() {
        all.extend(with_ties(&check.limits));
    }
    all.extend(soil::finding(answer));
    all.extend(answer.lean.as_ref().map(lean));
    all.extend(check.notes.iter().map(|of| noted(of, &answer.stack)));
    all
}

/// What moves with ties at their strength.
fn with_ties(limits: &StackLimitStates) -> Vec<Finding> {
    let mut all = Vec::new();
    if let Some(with) = first_with_ties(limits) {
        let (moves, at) = (joint_moves(limits, with), at(&with.threshold));
        all.push(Finding::new(Tone::Plain, Found::WithTies { moves, at }));
    }
    for (with, without) in parts_with_ties(limits) {
        let said = Found::PartWithTies {
            moves: joint_moves(limits, &with),
            at: at(&with.threshold),
            without: at(&without),
        };
        all.push(Finding::new(Tone::Plain, said));
    }
    all
}

fn noted(of: &StackNote, stack: &Stack) -> Finding {
    let said = note(of, stack);
    match of {
        StackNote::AnalysisFalls | StackNote::FrictionFell { .. } => Finding::key(Tone::Bad, said),
        StackNote::FrictionStood => Finding::key(Tone::Plain, said),
        StackNote::FrictionNoRest | StackNote::FrictionNotRun { .. } => Finding::key(Tone::Unknown, said),
        StackNote::FrictionCarries
        | StackNote::UpperBound
        | StackNote::BondCarries
        | StackNote::CohesionCounted
        | StackNote::KineticFalls
        | StackNote::SliversCarry { .. }
        | StackNote::Gaps { .. } => Finding::key(Tone::Warn, said),
        StackNote::LoadsWithoutMass { with_g, without_g } if is_less(*without_g, *with_g) => {
            Finding::key(Tone::Warn, said)
        }
        // less is only the roughness of dressed stone
        StackNote::SliversLeftOut { width_m, .. } if *width_m > GAP_CLOSED_M => {
            Finding::key(Tone::Warn, said)
        }
        StackNote::OnlyCorners { change, .. } if *change >= CORNERS_COUNT => Finding::key(Tone::Warn, said),
        // what the file gives and the numbers do not count
        StackNote::SideSupportsLeftOut | StackNote::TensionLeftOut | StackNote::TiesLeftOut => {
            Finding::key(Tone::Warn, said)
        }
        // the banner has both bounds of dilatancy
        StackNote::WithoutDilatancy { .. }
        | StackNote::SharedLoad
        | StackNote::SliversLeftOut { .. }
        | StackNote::LoadsWithoutMass { .. }
        | StackNote::AnalysisLower { .. }
        | StackNote::AnalysisBetween { .. }
        | StackNote::StrengthFromInside
        | StackNote::KineticLess { .. }
        | StackNote::KineticShared { .. }
        | StackNote::OnlyCorners { .. }
        | StackNote::PeriodUnknown => Finding::new(Tone::Warn, said),
    }
}
