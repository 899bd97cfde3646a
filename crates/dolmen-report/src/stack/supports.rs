//! A stack with moving supports.

use super::mechanism::{joint_rows, joints_moving, moving_columns};
use super::words::DIGITS;
use crate::document::{Block, Cell, Column, Document, Figure, Finding, Table, Tone};
use crate::figures::{moved_series, moved_supports};
use dolmen::assess::StackCheck;
use dolmen::stability::stack::{MovedStack, MovedSupports, MovementEnding, SupportJump};
use dolmen::structure::stack::{Body, Stack, SupportMovement};
use dolmen_words::message::Run;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::state::StackAnswer;

messages! {
    /// Supports that move.
    pub(crate) enum Supports in "stack.supports" {
        Head => { en: "Supports that move", ko: "지점 변위" },
        Name { name: String } => { en: "{name}", ko: "{name}" },
        Under { name: String, along: Sentence } => {
            en: "the ground under {name} moves {along}",
            ko: "{name} 아래 지반이 {along} 움직인다",
        },
        Along { by: Quantity, axis: Sentence } => { en: "{by} towards {axis}", ko: "{axis} 방향으로 {by}" },
        Up { by: Quantity } => { en: "{by} up", ko: "위로 {by}" },
        Down { by: Quantity } => { en: "{by} down", ko: "아래로 {by}" },
        StandsUpTo { movements: Sentence, factor: Quantity, length: Quantity } => {
            en: "Supports that move: {movements}. It stands under that, and up to {factor} times as much ({length}).",
            ko: "지점 변위: {movements}. 이 변위에서 서 있으며 그 {factor}배({length})까지 서 있다.",
        },
        StandsBeyond { movements: Sentence, factor: Quantity, length: Quantity } => {
            en: "Supports that move: {movements}. It stands under that; followed up to {factor} times as much ({length}), it still stood.",
            ko: "지점 변위: {movements}. 이 변위에서 서 있으며, 그 {factor}배({length})까지 추적한 결과에서도 안정을 유지하였다.",
        },
        StandsNear { movements: Sentence, factor: Quantity, length: Quantity, needed: Quantity } => {
            en: "Supports that move: {movements}. It stands under that; followed up to {factor} times as much ({length}), it still stood. Nothing is known beyond, and “stable” needs {needed} times.",
            ko: "지점 변위: {movements}. 이 변위에서 서 있으며, 그 {factor}배({length})까지 추적한 결과에서도 서 있었다. 그 이후는 알 수 없으며, ‘안정’이려면 {needed}배까지 서 있어야 한다.",
        },
        NotSeen => {
            en: "Stones that slide or meet anew as the supports move are not followed: «`dolmen simulate`|a simulation in time» follows them, and may find less. The acceleration at which it begins to move is that before the supports moved.",
            ko: "지점이 움직일 때 미끄러지거나 새로 맞닿는 부재는 추적하지 않으며, 이를 추적하는 «`dolmen simulate`|지진응답 검토»의 값은 더 작을 수 있다. 움직이기 시작하는 가속도는 지점이 움직이기 전의 값이다.",
        },
        FallsBefore { movements: Sentence, factor: Quantity, length: Quantity } => {
            en: "Supports that move: {movements}. It does not stand under that: beyond {factor} of it ({length}) no forces in the joints balance the weight.",
            ko: "지점 변위: {movements}. 이 변위에서 서 있지 못한다: 그 {factor}배({length})를 넘으면 자중과 평형을 이루는 접합력이 존재하지 않는다.",
        },
        NotFollowed { movements: Sentence, factor: Quantity, length: Quantity } => {
            en: "Supports that move: {movements}. It was followed to {factor} of it ({length}), where it stood; nothing is known of the movement beyond.",
            ko: "지점 변위: {movements}. 그 {factor}배({length})까지 추적하였고 그때까지 서 있었으나, 그 이후는 알 수 없다.",
        },
        Hinges { joints: Sentence } => {
            en: "As the supports begin to move, {joints}.",
            ko: "지점이 움직이기 시작할 때 {joints}.",
        },
        NoHinges => {
            en: "As the supports begin to move, no joint opens or slides.",
            ko: "지점이 움직이기 시작할 때 벌어지거나 미끄러지는 접합면이 없다.",
        },
        Slips { slip: Quantity } => {
            en: "On the way stones slide in closed joints by up to {slip}. Which joint slides first depends on friction that nobody measured, so the movement at which it falls is not reliable: measure the friction, or hold the stones.",
            ko: "그 사이에 닫힌 접합면에서 부재가 최대 {slip} 미끄러진다. 먼저 미끄러지는 접합면은 측정하지 않은 마찰에 따라 달라지므로 붕괴 변위는 신뢰할 수 없다. 마찰을 측정하거나 부재를 고정한다.",
        },
        Jumps { length: Quantity, moved: Quantity, degrees: Quantity } => {
            en: "At {length} stones jump by up to {moved} and {degrees} to another rest: open joints close, and others open. The speed that they gain is left out; «`dolmen simulate`|a simulation in time» follows it.",
            ko: "{length}에서 열린 접합면이 닫히고 다른 접합면이 벌어지면서 부재가 최대 {moved}, {degrees}만큼 갑자기 움직여 다시 멈춘다. 이때 생기는 속도는 고려하지 않으며 «`dolmen simulate`|지진응답 검토»에서 추적한다.",
        },
        Caption => { en: "What the supports bear.", ko: "지점 반력." },
        CaptionMeaning => {
            en: "Forces of the ground on the stack. A stack that gives way bears the least thrust that balances it; one that is pushed together, the largest.",
            ko: "지반이 적층 구조에 작용하는 힘. 지점이 벌어지면 평형을 이루는 최소 추력, 좁혀지면 최대 추력이 작용한다.",
        },
        Support => { en: "Ground under", ko: "지반 (위의 부재)" },
        State => { en: "supports moved", ko: "지점 상태" },
        Small => { en: "hardly", ko: "움직이기 시작" },
        Given => { en: "as given", ko: "주어진 변위" },
        Last => { en: "the most", ko: "최대 변위" },
        Times => { en: "times", ko: "배율" },
        ForceX => { en: "Fx", ko: "x 방향 힘" },
        ForceY => { en: "Fy", ko: "y 방향 힘" },
        ForceZ => { en: "Fz", ko: "z 방향 힘" },
        First => { en: "Joints as the supports begin to move.", ko: "지점이 움직이기 시작할 때의 접합면." },
        AtTheEnd => {
            en: "Joints at the largest movement in which it stood.",
            ko: "서 있는 최대 변위에서의 접합면.",
        },
        Shape => {
            en: "The largest movement in which it stood.",
            ko: "서 있는 최대 변위에서의 형상.",
        },
        ShapeMeaning { factor: Quantity } => {
            en: "To scale, displacements as they are, at {factor} times the movement given.",
            ko: "축척에 맞으며 변위를 확대하지 않음. 주어진 변위의 {factor}배.",
        },
        Limits => {
            en: "The movement counts from the shape in the file. Stone is rigid and infinitely strong; bond, ties and side supports bear nothing here, and stones that come to touch anew are not seen. Accelerations at which it moves are those of the shape in the file.",
            ko: "변위는 파일의 형상을 기준으로 한다. 부재는 강체이며 강도는 무한대로 보았다. 부착, 연결재, 측면 지지는 고려하지 않으며, 새로 맞닿는 부재는 고려하지 않는다. 움직이기 시작하는 가속도는 파일의 형상에 대한 값이다.",
        },
    }
}

/// Findings of the check on moving supports.
pub(super) fn findings(answer: &StackAnswer) -> Vec<Finding> {
    let Some(supports) = &answer.check.supports else {
        return Vec::new();
    };
    let mut all = vec![Finding::answer(tone(supports), said(&answer.stack, supports))];
    if supports.given.is_some() {
        all.push(Finding::qualifies(Tone::Warn, Supports::NotSeen));
    }
    let begins = match joints_moving(&answer.stack, supports.small.mechanism.as_ref()) {
        Some(joints) => Supports::Hinges { joints },
        None => Supports::NoHinges,
    };
    all.push(Finding::new(Tone::Plain, begins));
    all.extend(jump(&answer.stack, supports));
    if slips(&answer.stack, supports) {
        let slip = millimetres(supports.last.slip_m);
        all.push(Finding::qualifies(Tone::Warn, Supports::Slips { slip }));
    }
    all
}

/// The largest jump; part of a short answer if it comes before the movement that a stable stack needs.
fn jump(stack: &Stack, supports: &MovedSupports) -> Option<Finding> {
    let by_turn = |a: &&SupportJump, b: &&SupportJump| a.turned_rad.total_cmp(&b.turned_rad);
    let is_early = |jump: &&SupportJump| jump.factor < MovedSupports::MARGINAL_BELOW;
    let early = supports.jumps.iter().filter(is_early).max_by(by_turn);
    let largest = early.or_else(|| supports.jumps.iter().max_by(by_turn))?;
    let said = Supports::Jumps {
        length: millimetres(largest.factor * largest_m(stack)),
        moved: millimetres(largest.moved_m),
        degrees: Quantity::new(
            largest.turned_rad.to_degrees(),
            Unit::si("°"),
            Digits::Significant(DIGITS),
        ),
    };
    Some(match early {
        Some(_) => Finding::qualifies(Tone::Warn, said),
        None => Finding::new(Tone::Plain, said),
    })
}

/// The largest of the given movements, m.
fn largest_m(stack: &Stack) -> f64 {
    let each = stack.support_movements().iter().map(SupportMovement::length_m);
    each.fold(0.0, f64::max)
}

/// Whether slips before the fall are large enough to affect it.
fn slips(stack: &Stack, supports: &MovedSupports) -> bool {
    supports.last.slip_m > MovedSupports::SLIP_TELLS * stack.height_m()
}

fn tone(supports: &MovedSupports) -> Tone {
    match (supports.ending, &supports.given) {
        (MovementEnding::Falls { .. }, None) => Tone::Bad,
        (MovementEnding::NotFollowed, _) | (_, None) => Tone::Unknown,
        (MovementEnding::Falls { .. }, _) if supports.is_near() => Tone::Warn,
        (MovementEnding::Stands, _) if supports.is_near() => Tone::Unknown,
        _ => Tone::Good,
    }
}

fn said(stack: &Stack, supports: &MovedSupports) -> Supports {
    let length = millimetres(supports.last.factor * largest_m(stack));
    let (movements, factor) = (movements(stack), times(supports.last.factor));
    match (supports.ending, &supports.given) {
        (MovementEnding::Falls { .. }, Some(_)) => Supports::StandsUpTo {
            movements,
            factor,
            length,
        },
        (MovementEnding::Falls { .. }, None) => Supports::FallsBefore {
            movements,
            factor,
            length,
        },
        (MovementEnding::Stands, _) if supports.is_near() => Supports::StandsNear {
            movements,
            factor,
            length,
            needed: times(MovedSupports::MARGINAL_BELOW),
        },
        (MovementEnding::Stands, _) => Supports::StandsBeyond {
            movements,
            factor,
            length,
        },
        (MovementEnding::NotFollowed, _) => Supports::NotFollowed {
            movements,
            factor,
            length,
        },
    }
}

fn times(factor: f64) -> Quantity {
    Quantity::ratio(factor, DIGITS)
}

fn millimetres(length_m: f64) -> Quantity {
    let unit = Unit {
        symbol: "mm".to_owned(),
        factor: 1e3,
    };
    Quantity::new(length_m, unit, Digits::Significant(DIGITS))
}

/// "the ground under right abutment moves 30 mm towards +x, 10 mm down; …".
pub(crate) fn movements(stack: &Stack) -> Sentence {
    let each = stack.support_movements().iter().map(|movement| -> Sentence {
        let [x, y, z] = movement.movement_m;
        let level = |value: f64, plus: &str, minus: &str| {
            let axis = Sentence::of_symbol(if value > 0.0 { plus } else { minus });
            let by = millimetres(value.abs());
            (value != 0.0).then(|| Sentence::from(Supports::Along { by, axis }))
        };
        let by = millimetres(z.abs());
        let upright = match z {
            z if z > 0.0 => Some(Sentence::from(Supports::Up { by })),
            z if z < 0.0 => Some(Sentence::from(Supports::Down { by })),
            _ => None,
        };
        let parts = [level(x, "+x", "-x"), level(y, "+y", "-y"), upright];
        Supports::Under {
            name: stack.name(Body::Block(movement.block)).to_owned(),
            along: joined(parts.into_iter().flatten(), ", "),
        }
        .into()
    });
    joined(each, "; ")
}

fn joined(sentences: impl Iterator<Item = Sentence>, between: &str) -> Sentence {
    let mut all = Sentence::of_symbol("");
    for (i, sentence) in sentences.enumerate() {
        let mark = (i > 0).then(|| Run::Text(between.to_owned()));
        all.english.extend(mark.iter().cloned().chain(sentence.english));
        all.korean.extend(mark.iter().cloned().chain(sentence.korean));
    }
    all
}

/// The section on moving supports.
pub(super) fn section<'a>(document: &mut Document<'a>, answer: &'a StackAnswer) {
    let (stack, check) = (&answer.stack, &answer.check);
    let Some(supports) = &check.supports else { return };
    document.subheading(Supports::Head);
    document.put(Block::Table(reactions(stack, supports)));
    let caption = vec![
        Supports::Shape.into(),
        Supports::ShapeMeaning {
            factor: times(supports.last.factor),
        }
        .into(),
    ];
    let drawn = Figure::drawn(caption, move |language| {
        moved_supports(stack, &supports.last, language)
    });
    document.charted(drawn.with_series(move || moved_series(stack, &supports.last.solids)));
    for (caption, state) in [
        (Supports::First, &supports.small),
        (Supports::AtTheEnd, &supports.last),
    ] {
        if let Some(mechanism) = &state.mechanism {
            document.put(Block::Table(Table {
                caption: vec![caption.into()],
                columns: moving_columns(),
                rows: joint_rows(stack, mechanism),
            }));
        }
    }
    document.note(Supports::Limits);
}

fn reactions(stack: &Stack, supports: &MovedSupports) -> Table {
    let kilonewtons = || Unit {
        symbol: "kN".to_owned(),
        factor: 1e-3,
    };
    let mut states: Vec<(Supports, &MovedStack)> = vec![(Supports::Small, &supports.small)];
    states.extend(supports.given.iter().map(|state| (Supports::Given, state)));
    states.push((Supports::Last, &supports.last));
    let mut rows = Vec::new();
    for (place, support) in supports.small.reactions.iter().enumerate() {
        for (word, state) in &states {
            let Some(reaction) = state.reactions.get(place) else {
                continue;
            };
            let name = stack.name(Body::Block(support.block)).to_owned();
            let mut row = vec![
                Cell::words(Supports::Name { name }),
                Cell::words(word.clone()),
                Cell::number(times(state.factor)),
            ];
            // rounding relative to the weight is shown as 0
            let least = 1e-6 * stack.mass_kg() * stack.gravity_m_s2();
            row.extend(reaction.force_n.map(|force| {
                let force = if force.abs() < least { 0.0 } else { force };
                Cell::number(Quantity::new(force, kilonewtons(), Digits::Fixed(2)))
            }));
            rows.push(row);
        }
    }
    Table {
        caption: vec![Supports::Caption.into(), Supports::CaptionMeaning.into()],
        columns: vec![
            Column::words(Supports::Support),
            Column::words(Supports::State),
            Column::numbers(Supports::Times, Unit::ratio()),
            Column::numbers(Supports::ForceX, kilonewtons()),
            Column::numbers(Supports::ForceY, kilonewtons()),
            Column::numbers(Supports::ForceZ, kilonewtons()),
        ],
        rows,
    }
}

/// Whether the supports decide the verdict: then the banner says so.
pub(super) fn decide(check: &StackCheck) -> bool {
    let supports = check.supports.as_ref();
    supports.is_some_and(|supports| matches!(tone(supports), Tone::Bad))
}
