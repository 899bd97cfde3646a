//! The storeys of a frame: the effect of loads, and the margins of the given stiffness.

use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::assess::FrameCheck;
use dolmen::stability::{FrameStability, StoreyStability};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Storeys.
    pub(crate) enum Storeys in "frame.storeys" {
        Caption(factor: Quantity) => { en: "Storeys, λ = {factor}.", ko: "층별 결과, λ = {factor}." },
        CaptionUnknown => { en: "Storeys, stiffness unknown.", ko: "층별 결과, 층강성 미상." },
        LeastMeaning => {
            en: "Least k is where the frame just stands, the other storeys as they are; the margin is k over it.",
            ko: "최소 k는 다른 층을 그대로 두고 골조가 안정을 유지하는 한계 강성이며, 여유도는 이에 대한 k의 비이다.",
        },
        LoadsAlone => { en: "What the loads alone say.", ko: "하중만으로 알 수 있는 값이다." },
        LowestFirst => {
            en: "N/l is the axial force over the height of the storey; storey 1 is the lowest.",
            ko: "N/l은 층 축력을 층고로 나눈 값이며, 1층이 최하층이다.",
        },
        Storey => { en: "Storey", ko: "층" },
        Number(number: usize) => { en: "{number}", ko: "{number}" },
        Taken => { en: "P-delta takes N/l", ko: "P-델타 감소량 N/l" },
        LoadRatio => {
            en: "load on the level / weight of its mass",
            ko: "층 하중 / 층 질량의 무게",
        },
        Stiffness => { en: "k", ko: "k" },
        Least => { en: "least k", ko: "최소 k" },
        Margin => { en: "margin", ko: "여유도" },
        Falls => { en: "falls", ko: "불안정" },
        Identify => {
            en: "The stiffness is not known: a survey of vibration may give it« (`dolmen identify`)».",
            ko: "층강성을 알 수 없다. 상시진동 계측으로 추정할 수 있다«(`dolmen identify`)».",
        },
    }
}

/// The table of the storeys, and what to do if their stiffness is unknown.
pub(super) fn section(document: &mut Document<'_>, check: &FrameCheck) {
    document.put(Block::Table(table(check)));
    if check.stability.is_none() {
        document.note(Storeys::Identify);
    }
}

fn table(check: &FrameCheck) -> Table {
    let stability = check.stability.as_ref();
    let storeys = stability.map_or(&[][..], |stability| &stability.storeys);
    let given = storeys.iter().map(|storey| storey.stiffness_n_m);
    let all: Vec<f64> = check.geometric_n_m.iter().copied().chain(given).collect();
    let unit = Unit::of(&all, "N/m");
    let mut columns = vec![
        Column::words(Storeys::Storey),
        Column::numbers(Storeys::Taken, unit.clone()),
        Column::numbers(Storeys::LoadRatio, Unit::ratio()),
    ];
    if stability.is_some() {
        columns.push(Column::numbers(Storeys::Stiffness, unit.clone()));
        columns.push(Column::numbers(Storeys::Least, unit.clone()));
        columns.push(Column::numbers(Storeys::Margin, Unit::ratio()));
    }
    let row = |(i, geometric): (usize, &f64)| {
        let ratio = check.level_load_ratios.get(i);
        let mut row = vec![
            Cell::words(Storeys::Number(i + 1)),
            Cell::number(significant(*geometric, &unit, 4)),
            Cell::Number(ratio.map(|ratio| Quantity::ratio(*ratio, 3))),
        ];
        row.extend(
            storeys
                .get(i)
                .into_iter()
                .flat_map(|storey| margin(storey, &unit)),
        );
        row
    };
    Table {
        caption: caption(stability),
        columns,
        rows: check.geometric_n_m.iter().enumerate().map(row).collect(),
    }
}

fn caption(stability: Option<&FrameStability>) -> Vec<Sentence> {
    let [first, meaning] = match stability {
        Some(stability) => [
            Storeys::Caption(Quantity::beside_one(stability.load_factor, 4)),
            Storeys::LeastMeaning,
        ],
        None => [Storeys::CaptionUnknown, Storeys::LoadsAlone],
    };
    vec![first.into(), meaning.into(), Storeys::LowestFirst.into()]
}

pub(super) fn significant(value_si: f64, unit: &Unit, digits: usize) -> Quantity {
    Quantity::new(value_si, unit.clone(), Digits::Significant(digits))
}

/// Stiffness, required stiffness and margin; words if the frame falls for any stiffness of that storey.
fn margin(storey: &StoreyStability, unit: &Unit) -> [Cell; 3] {
    let falls = || Cell::BadWords(Storeys::Falls.into());
    let least = storey.stiffness_least_n_m;
    [
        Cell::number(significant(storey.stiffness_n_m, unit, 4)),
        least.map_or_else(falls, |k| Cell::number(significant(k, unit, 4))),
        match storey.margin {
            Some(margin) if margin > 1.0 => Cell::number(Quantity::beside_one(margin, 4)),
            Some(margin) => Cell::Bad(Quantity::beside_one(margin, 4)),
            None => falls(),
        },
    ]
}
