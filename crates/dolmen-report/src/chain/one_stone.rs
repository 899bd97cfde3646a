//! The chain compared with a pole of a single stone.

use crate::document::{Block, Cell, Column, Document, Finding, Table, Tone};
use dolmen::assess::{ChainCheck, OneStoneCheck};
use dolmen::structure::Section;
use dolmen_words::{Digits, Quantity, Unit, messages};

messages! {
    /// The pole without joints.
    pub(crate) enum OneStone in "chain.one-stone" {
        Head => { en: "Beside one stone", ko: "한 돌로 된 기둥과의 비교" },
        Share { ratio: Quantity, whole: Quantity } => {
            en: "Its joints leave it {ratio} of the lowest frequency that it would have as one uncracked stone, {whole} (Timoshenko beam, clamped foot).",
            ko: "접합면이 있어 최저 고유진동수는 균열 없는 한 돌로 된 기둥({whole}, 티모셴코 보, 하단 고정)의 {ratio}이다.",
        },
        Whole { whole: Quantity } => {
            en: "As one uncracked stone its lowest frequency would be {whole} (Timoshenko beam, clamped foot): with joints it is below that.",
            ko: "균열 없는 한 돌이라면 최저 고유진동수는 {whole}이다(티모셴코 보, 하단 고정). 접합면이 있으면 그보다 낮다.",
        },
        WholeFalls => {
            en: "Even as one uncracked stone it would fall under its own weight: check «stone.elastic_modulus|the elastic modulus of the stone» and its unit.",
            ko: "균열 없는 한 돌이라도 자중으로 좌굴한다. «stone.elastic_modulus와|석재의 탄성계수와» 그 단위를 확인한다.",
        },
        Table => { en: "Frequencies on its joints and as one stone, Hz.", ko: "접합면이 있을 때와 한 돌일 때의 고유진동수, Hz." },
        TableMeaning => {
            en: "Clamped foot, under its own weight; ratio: rigid links over one stone by Timoshenko.",
            ko: "하단 고정, 자중 포함. 비: 강체 부재/한 돌(티모셴코).",
        },
        Number => { en: "Mode", ko: "모드" },
        Nth { number: usize } => { en: "{number}", ko: "{number}" },
        Rigid => { en: "rigid links", ko: "강체 부재" },
        Bending => { en: "links that bend", ko: "휘는 부재" },
        Bernoulli => { en: "one stone, bending", ko: "한 돌, 휨" },
        Timoshenko => { en: "one stone, Timoshenko", ko: "한 돌, 티모셴코" },
        Ratio => { en: "ratio", ko: "비" },
        Shafts => { en: "The shafts that the links are taken as, m.", ko: "각 부재를 본 돌기둥의 치수, m." },
        ShaftsMeaning => {
            en: "Each tapers evenly and has the weight, the length and the centre of mass of its link; square where no breadth is given.",
            ko: "각각 고르게 가늘어지며 부재의 무게, 길이, 무게중심을 갖는다. 폭이 없으면 정사각형이다.",
        },
        Link => { en: "Link", ko: "부재" },
        Length => { en: "length", ko: "길이" },
        FootAlong => { en: "foot, along", ko: "하단, 진동 방향" },
        FootAcross => { en: "foot, across", ko: "하단, 직각 방향" },
        TopAlong => { en: "top, along", ko: "상단, 진동 방향" },
        TopAcross => { en: "top, across", ko: "상단, 직각 방향" },
    }
}

/// Frequency of the chain relative to that of a single stone.
pub(super) fn finding(check: &ChainCheck) -> Option<Finding> {
    let one = check.one_stone.as_ref()?;
    let Some(whole) = one.timoshenko_hz.first() else {
        return Some(Finding::key(Tone::Bad, OneStone::WholeFalls));
    };
    let whole = Quantity::new(*whole, Unit::si("Hz"), Digits::Significant(3));
    Some(match one.ratios.first() {
        None => Finding::key(Tone::Plain, OneStone::Whole { whole }),
        Some(ratio) => {
            let ratio = Quantity::percent(*ratio, 2);
            Finding::key(Tone::Plain, OneStone::Share { ratio, whole })
        }
    })
}

/// Both theories compared with the joints, and their shafts.
pub(super) fn section(document: &mut Document<'_>, check: &ChainCheck) {
    let Some(one) = &check.one_stone else { return };
    document.heading(OneStone::Head);
    if !one.timoshenko_hz.is_empty() {
        document.put(Block::Table(frequencies(check, one)));
    }
    document.put(Block::Table(shafts(one)));
}

fn frequencies(check: &ChainCheck, one: &OneStoneCheck) -> Table {
    let numbers = |head: OneStone| Column::numbers(head, Unit::ratio());
    let fixed = |value: Option<&f64>| Cell::Number(value.map(|value| Quantity::ratio(*value, 4)));
    let row = |i: usize| {
        let rigid = check.modes.get(i).filter(|mode| mode.omega_squared > 0.0);
        vec![
            Cell::words(OneStone::Nth { number: i + 1 }),
            fixed(rigid.map(|mode| &mode.frequency_hz)),
            fixed(one.jointed_hz.get(i)),
            fixed(one.bernoulli_euler_hz.get(i)),
            fixed(one.timoshenko_hz.get(i)),
            Cell::Number(one.ratios.get(i).map(|ratio| Quantity::ratio(*ratio, 3))),
        ]
    };
    Table {
        caption: vec![OneStone::Table.into(), OneStone::TableMeaning.into()],
        columns: vec![
            Column::words(OneStone::Number),
            numbers(OneStone::Rigid),
            numbers(OneStone::Bending),
            numbers(OneStone::Bernoulli),
            numbers(OneStone::Timoshenko),
            numbers(OneStone::Ratio),
        ],
        rows: (0..one.timoshenko_hz.len()).map(row).collect(),
    }
}

fn shafts(one: &OneStoneCheck) -> Table {
    let numbers = |head: OneStone| Column::numbers(head, Unit::ratio());
    let metres = |value: f64| Cell::number(Quantity::new(value, Unit::ratio(), Digits::Fixed(3)));
    let sizes = |section: Section| [metres(section.depth_m), metres(section.breadth_m)];
    let rows = one.shafts.iter().enumerate().map(|(i, shaft)| {
        let mut row = vec![
            Cell::words(OneStone::Nth { number: i + 1 }),
            metres(shaft.length_m),
        ];
        row.extend(sizes(shaft.foot));
        row.extend(sizes(shaft.top));
        row
    });
    Table {
        caption: vec![OneStone::Shafts.into(), OneStone::ShaftsMeaning.into()],
        columns: vec![
            Column::words(OneStone::Link),
            numbers(OneStone::Length),
            numbers(OneStone::FootAlong),
            numbers(OneStone::FootAcross),
            numbers(OneStone::TopAlong),
            numbers(OneStone::TopAcross),
        ],
        rows: rows.collect(),
    }
}
