//! Local mechanisms of a stack by Circolare 7/2019: the moving part and its capacity.

use super::words::{DIGITS, Words, direction, in_g};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::assess::demand::LocalMechanismCapacity;
use dolmen::structure::stack::{Body, Stack};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::state::{LocalMechanismRow, StackAnswer};

messages! {
    /// Local mechanisms as a code requires.
    pub(crate) enum Local in "stack.local_mechanisms" {
        Caption => {
            en: "Local mechanisms by Circolare 7/2019 (C8.7.1.2.1, to NTC 2018).",
            ko: "Circolare 7/2019(NTC 2018 해설, C8.7.1.2.1)에 따른 국부 메커니즘.",
        },
        CaptionMeaning => {
            en: "What moves first each way, each rigid part as one weight, as an oscillator of mass M*.",
            ko: "방향별로 가장 먼저 움직이는 부분. 강체로 함께 움직이는 부분을 하나의 무게로 보고 질량 M*의 진동계로 나타낸다.",
        },
        Towards => { en: "Towards", ko: "방향" },
        Moves => { en: "moves", ko: "움직이는 부분" },
        Parts { parts: usize } => { en: "{parts} parts", ko: "강체 {parts}개" },
        Motion => { en: "motion", ko: "거동" },
        Turns => { en: "turns", ko: "회전" },
        Slides => { en: "slides", ko: "미끄러짐" },
        None => { en: "not found", ko: "없음" },
        Pressed => {
            en: "Local mechanisms of codes are not given: they move what presses on the stones as masses, and static loads have none.",
            ko: "국부 메커니즘은 제시하지 않는다. 기준은 석재를 누르는 것을 질량으로 보고 함께 움직이지만 정하중에는 질량이 없다.",
        },
        GroundByForce => { en: "ground", ko: "지반" },
        Meaning => {
            en: "α0 is the acceleration over gravity at which it moves, a0* = α0 g/(e* FC) with FC = 1.35, d0* the way of the oscillator until it overturns, d_SLV = 0.4 d0*, T_SLV the period for its check. Ground is the peak of the ground that the check by forces allows, 2 a0*: after a code's factor q = 2, not a first motion.",
            ko: "α0은 움직이기 시작하는 가속도의 중력가속도비, a0* = α0 g/(e* FC)(FC = 1.35), d0*는 전도할 때까지의 진동계 변위, d_SLV = 0.4 d0*, T_SLV는 변위 검토용 주기이다. 지반은 힘에 의한 검토가 허용하는 최대지반가속도 2 a0*로, 기준의 계수 q = 2를 적용한 값이며 거동 시작 가속도가 아니다.",
        },
        LeftOut => {
            en: "It stands beside the dynamic answer« (`dolmen simulate`)» and decides nothing. The formulas have not been held against the text of the code; the amplification that it asks for of parts at a height is left out. What slides has no check, and several parts that move against each other no d0*. α0 lets sliding joints rise, so it is an upper bound where they slide. Of mechanisms with the same α0 the part that slides as one is taken; if there is none, another may have a larger e* and a smaller a0*.",
            ko: "동적 해석«(`dolmen simulate`)»과 나란히 제시하는 값이며 판정에 쓰지 않는다. 식은 기준 원문과 대조하지 않았고, 높은 곳에 있는 부분에 대한 기준의 증폭은 반영하지 않았다. 미끄러지는 부분은 검토하지 않으며, 여러 강체가 서로 다르게 움직이는 경우에는 d0*를 구하지 않는다. α0은 미끄러지는 접합면이 들리는 것을 허용하므로 미끄러지는 경우에는 상한이다. α0이 같은 메커니즘 중에서는 하나의 강체로 미끄러지는 것을 택하며, 없으면 e*가 더 크고 a0*가 더 작은 다른 메커니즘이 있을 수 있다.",
        },
    }
}

/// The mechanism in each direction, as the code requires.
pub(super) fn section(document: &mut Document<'_>, answer: &StackAnswer) {
    let found = answer.local_mechanisms.as_deref().unwrap_or_default();
    if found.is_empty() {
        if answer.local_mechanisms.is_some() && answer.stack.is_pressed() {
            document.note(Local::Pressed);
        }
        return;
    }
    let unit = |symbol: &str, factor: f64| Unit {
        symbol: symbol.to_owned(),
        factor,
    };
    let symbol = Sentence::of_symbol;
    let table = Table {
        caption: vec![Local::Caption.into(), Local::CaptionMeaning.into()],
        columns: vec![
            Column::words(Local::Towards),
            Column::words(Local::Moves),
            Column::words(Local::Motion),
            Column::numbers(symbol("α0"), Unit::ratio()),
            Column::numbers(symbol("M*"), unit("t", 1e-3)),
            Column::numbers(symbol("e*"), Unit::ratio()),
            Column::numbers(symbol("a0*"), Unit::si("g")),
            Column::numbers(symbol("d0*"), unit("mm", 1e3)),
            Column::numbers(symbol("d_SLV"), unit("mm", 1e3)),
            Column::numbers(symbol("T_SLV"), Unit::si("s")),
            Column::numbers(Local::GroundByForce, Unit::si("g")),
        ],
        rows: found.iter().map(|of| row(&answer.stack, of)).collect(),
    };
    document.put(Block::Table(table.without_empty_columns()));
    document.note(Local::Meaning);
    document.note(Local::LeftOut);
}

/// The moving part: its lowest stone, or the number of parts.
fn what_moves(stack: &Stack, capacity: &LocalMechanismCapacity) -> Sentence {
    let [part] = &capacity.mechanism.parts[..] else {
        let parts = capacity.mechanism.parts.len();
        return Local::Parts { parts }.into();
    };
    let first = part.blocks.first();
    let name = first
        .map_or("", |block| stack.name(Body::Block(*block)))
        .to_owned();
    match part.blocks.len() {
        0 | 1 => Words::Name { name },
        count => Words::NameAndMore {
            name,
            more: count - 1,
        },
    }
    .into()
}

fn row(stack: &Stack, of: &LocalMechanismRow) -> Vec<Cell> {
    let mut cells = vec![Cell::words(direction(of.direction))];
    let Some(capacity) = &of.capacity else {
        cells.push(Cell::words(Local::None));
        cells.push(Cell::words(Sentence::of_symbol("–")));
        cells.extend((0..8).map(|_| Cell::Number(None)));
        return cells;
    };
    let mechanism = &capacity.mechanism;
    let gravity = stack.gravity_m_s2();
    let scaled = |value: f64, symbol: &str, factor: f64| {
        let unit = Unit {
            symbol: symbol.to_owned(),
            factor,
        };
        Quantity::new(value, unit, Digits::Significant(DIGITS))
    };
    let displacement = capacity.displacement;
    cells.extend([
        Cell::words(what_moves(stack, capacity)),
        Cell::words(match mechanism.slides {
            true => Local::Slides,
            false => Local::Turns,
        }),
        Cell::number(Quantity::ratio(mechanism.multiplier, DIGITS)),
        Cell::number(scaled(mechanism.mass_kg, "t", 1e-3)),
        Cell::number(Quantity::ratio(mechanism.mass_ratio, DIGITS)),
        Cell::number(in_g(capacity.activation_m_s2 / gravity)),
        Cell::Number(displacement.map(|of| scaled(of.overturning_m, "mm", 1e3))),
        Cell::Number(displacement.map(|of| scaled(of.limit_m, "mm", 1e3))),
        Cell::Number(displacement.map(|of| scaled(of.period_s, "s", 1.0))),
        Cell::Number(capacity.by_force_m_s2.map(|of| in_g(of / gravity))),
    ]);
    cells
}
