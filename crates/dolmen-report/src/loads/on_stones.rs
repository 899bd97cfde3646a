//! Effect of the worst combination on a stack: the wind on it, and how the stones begin to move.

use crate::document::{Block, Cell, Column, Document, Figure, Table, table_series};
use crate::figures::{stack_pushed, stone_series};
use crate::stack::{joint_rows, moving_columns};
use dolmen::assess::StackUnderLoads;
use dolmen::stability::stack::BlownBlock;
use dolmen::structure::stack::Stack;
use dolmen_project::LoadsPart;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

/// Digits in the table.
const DIGITS: usize = 3;
/// Largest number of stones in the table of the wind. Our choice: a page of a report.
const STONES_MOST: usize = 40;

messages! {
    /// What a combination does to a stack.
    pub(crate) enum OnStones in "loads.stones" {
        Mechanism { what: Sentence } => { en: "{what}: how it begins to move.", ko: "{what}: 거동 시작." },
        MechanismMeaning => {
            en: "The joints that open and slide when wind and static loads have grown to what is borne.",
            ko: "풍하중과 정하중이 저항 배수에 이를 때 벌어지거나 미끄러지는 접합면.",
        },
        Met => { en: "What the wind meets.", ko: "석재별 풍하중." },
        MetMeaning => {
            en: "The outline of each stone across the wind, less what other stones hide, without the factor of the combination.",
            ko: "풍향에 수직한 각 석재의 투영 면적에서 다른 석재에 가려진 부분을 뺀 값이며 하중조합의 계수는 곱하지 않았다.",
        },
        Stone => { en: "Stone", ko: "석재" },
        Name { name: String } => { en: "{name}", ko: "{name}" },
        Area => { en: "area", ko: "면적" },
        Hidden => { en: "hidden", ko: "가려진 비율" },
        Force => { en: "force", ko: "풍력" },
        Height => { en: "at height", ko: "작용 높이" },
        Figure => { en: "Loads and first motion.", ko: "하중과 거동 시작." },
        FigureMeaning => {
            en: "Arrows: wind on each stone and static loads, to one scale. Rings: where joints that open stay closed.",
            ko: "화살표는 석재별 풍하중과 정하중(같은 축척), 원은 벌어지는 접합면에서 닿아 있는 곳이다.",
        },
    }
}

pub(super) fn section<'a>(
    document: &mut Document<'a>,
    what: Sentence,
    under: &'a StackUnderLoads,
    stack: &'a Stack,
    given: &LoadsPart,
) {
    if let Some(mechanism) = &under.found.mechanism {
        document.put(Block::Table(Table {
            caption: vec![
                OnStones::Mechanism { what }.into(),
                OnStones::MechanismMeaning.into(),
            ],
            columns: moving_columns(),
            rows: joint_rows(stack, mechanism),
        }));
    }
    if !under.blown.is_empty() && under.blown.len() <= STONES_MOST && given.wind().is_some() {
        document.put(Block::Table(met(&under.blown, stack)));
    }
    let caption = vec![OnStones::Figure.into(), OnStones::FigureMeaning.into()];
    let drawn = Figure::drawn(caption, move |language| stack_pushed(stack, under, language));
    document.charted(drawn.with_series(move || match under.blown.is_empty() {
        true => stone_series(stack),
        false => table_series(&met(&under.blown, stack)),
    }));
}

fn met(blown: &[BlownBlock], stack: &Stack) -> Table {
    let largest = blown.iter().map(|of| of.force_n).fold(0.0, f64::max);
    let newton = Unit::of(&[largest], "N");
    let row = |of: &BlownBlock| {
        let name = stack.blocks()[of.block].name.clone();
        let number =
            |value: f64, unit: Unit| Cell::number(Quantity::new(value, unit, Digits::Significant(DIGITS)));
        vec![
            Cell::words(OnStones::Name { name }),
            number(of.area_m2, Unit::si("m²")),
            Cell::number(Quantity::new(100.0 * of.hidden, Unit::si("%"), Digits::Fixed(0))),
            number(of.force_n, newton.clone()),
            number(of.position_m[2], Unit::si("m")),
        ]
    };
    Table {
        caption: vec![OnStones::Met.into(), OnStones::MetMeaning.into()],
        columns: vec![
            Column::words(OnStones::Stone),
            Column::numbers(OnStones::Area, Unit::si("m²")),
            Column::numbers(OnStones::Hidden, Unit::si("%")),
            Column::numbers(OnStones::Force, newton.clone()),
            Column::numbers(OnStones::Height, Unit::si("m")),
        ],
        rows: blown.iter().map(row).collect(),
    }
}
