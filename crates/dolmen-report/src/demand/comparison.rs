//! A stack compared with the demand of its site, direction by direction.

use super::first::first;
use super::words::{gravities, in_g, verdict_words};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::assess::demand::{ShakenDirection, StackDemandCheck, StackDemandRow};
use dolmen::stability::stack::{DemandVerdict, Threshold};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

/// Digits of accelerations and periods.
const DIGITS: Digits = Digits::Significant(4);
const RATIO_DIGITS: usize = 3;

messages! {
    /// Capacity against demand.
    pub(crate) enum Compared in "demand.comparison" {
        Verdict(verdict: Sentence) => {
            en: "In the worst direction: {verdict}.",
            ko: "가장 불리한 방향의 판정: {verdict}.",
        },
        Caption => { en: "Capacity against demand.", ko: "거동 시작 가속도와 요구 수준." },
        RatioMeaning { vertical: Quantity, near: Quantity, same: Quantity } => {
            en: "Ratio: what is left with {vertical} of vertical acceleration, over the demand; above demand at least {near}, near 1 to {same}, below less than 1.",
            ko: "비: 수직 가속도 {vertical}을(를) 고려한 거동 시작 가속도 / 요구 가속도. {near} 이상이면 기준 만족, 1 이상 {same} 미만이면 근접, 1 미만이면 불만족.",
        },
        ByModesMeaning => {
            en: "By modes: the forces of all modes on what is above each joint against what weight and friction bear there.",
            ko: "모드별: 모든 모드의 관성력이 각 접합면 위쪽에 작용할 때 자중과 마찰이 견디는 비.",
        },
        AlikeMeaning => {
            en: "S_a alike, as published, lets all stones feel S_a: not on the safe side, and it decides nothing.",
            ko: "S_a 균일(논문의 방법): 모든 돌에 S_a를 같게 적용한 비로, 안전측이 아니며 판정에 쓰지 않는다.",
        },
        Along => { en: "Shaken along", ko: "방향" },
        Any => { en: "any", ko: "모든 방향" },
        Rigid => { en: "as rigid blocks", ko: "강체 블록" },
        Elastic => { en: "on elastic joints", ko: "탄성 접합면" },
        MovesAt => { en: "moves at", ko: "거동 시작" },
        LessVertical => { en: "less vertical", ko: "수직 고려" },
        Ground => { en: "ground", ko: "지반" },
        Ratio => { en: "ratio", ko: "비" },
        Alike => { en: "S_a alike", ko: "S_a 균일" },
        ByModes => { en: "by modes", ko: "모드별" },
        BelowMeans => {
            en: "Below demand means that something tips or slides, not that the stack falls: how far it goes needs a time history.",
            ko: "기준 불만족은 돌이 들리거나 미끄러지기 시작한다는 뜻이며 붕괴를 뜻하지 않는다. 그 뒤의 거동은 시간이력해석으로 확인해야 한다.",
        },
        First { first: Sentence, amplification: Quantity } => {
            en: "On elastic joints, by the forces of all modes on what is above each joint, {first}; in the first mode one stone feels {amplification} S_a.",
            ko: "탄성 접합면에서 모든 모드의 관성력을 각 접합면 위쪽에 작용시키면 {first}. 1차 모드에서 돌 하나가 받는 가속도는 최대 {amplification} S_a이다.",
        },
        CornerOpens => {
            en: "A corner of an elastic joint opens before the joint tips, that of a rectangle at a third of that acceleration: «`dolmen simulate`|a simulation in time» says by how much.",
            ko: "탄성 접합면의 모서리는 접합면 전체가 들리기 전에 벌어지기 시작하며, 직사각형 접합면에서는 그 가속도의 1/3에서 시작한다. 벌어지는 크기는 «`dolmen simulate`|지진응답 검토»로 확인한다.",
        },
        ModesUnknown => {
            en: "The modes, or what the spectrum asks at their periods, are not known, or nothing is left to compare with: on elastic joints unknown.",
            ko: "모드 또는 그 주기의 스펙트럼 값을 알 수 없거나 비교할 거동 시작 가속도가 없으므로 탄성 접합면에 대해서는 판정할 수 없다.",
        },
    }
}

/// The table of all directions, and how to read it.
pub(super) fn section(document: &mut Document<'_>, stack: &StackDemandCheck) {
    document.paragraph(Compared::Verdict(verdict_words(stack.verdict)));
    document.put(Block::Table(table(stack)));
    document.note(Compared::BelowMeans);
    if let Some(first) = first_of_worst(stack) {
        document.put(Block::Paragraph(vec![first.into(), Compared::CornerOpens.into()]));
    }
    if stack.rows.iter().any(|row| row.by_modes.is_none()) {
        document.note(Compared::ModesUnknown);
    }
}

fn first_of_worst(stack: &StackDemandCheck) -> Option<Compared> {
    let rows = stack.rows.iter();
    let known = rows.filter_map(|row| Some((row.by_modes.as_ref()?, row.amplification?)));
    let (by_modes, amplification) = known.min_by(|a, b| a.0.ratio.total_cmp(&b.0.ratio))?;
    Some(Compared::First {
        first: first(by_modes),
        amplification: Quantity::new(amplification, Unit::ratio(), Digits::Fixed(2)),
    })
}

fn table(stack: &StackDemandCheck) -> Table {
    let near = Quantity::ratio(DemandVerdict::NEAR_BELOW, RATIO_DIGITS);
    let ratios = Compared::RatioMeaning {
        vertical: in_g(stack.vertical_acceleration_m_s2, Digits::Trimmed(4)),
        near: near.clone(),
        same: near,
    };
    let numbers = |head: Compared| Column::numbers(head, Unit::ratio());
    let accelerations = |head: Compared| Column::numbers(head, gravities());
    Table {
        caption: vec![
            Compared::Caption.into(),
            ratios.into(),
            Compared::ByModesMeaning.into(),
            Compared::AlikeMeaning.into(),
        ],
        columns: vec![
            Column::words(Compared::Along),
            Column::words(Compared::Rigid),
            Column::words(Compared::Elastic),
            accelerations(Compared::MovesAt),
            accelerations(Compared::LessVertical),
            accelerations(Compared::Ground),
            numbers(Compared::Ratio),
            Column::numbers(Sentence::of_symbol("T1"), Unit::si("s")),
            Column::numbers(Sentence::of_symbol("S_a"), gravities()),
            numbers(Compared::Alike),
            numbers(Compared::ByModes),
        ],
        rows: stack.rows.iter().map(row).collect(),
    }
}

fn row(row: &StackDemandRow) -> Vec<Cell> {
    let direction = match row.direction {
        ShakenDirection::X => Sentence::of_symbol("x"),
        ShakenDirection::Y => Sentence::of_symbol("y"),
        ShakenDirection::Any => Compared::Any.into(),
    };
    let rigid = &row.comparison.rigid;
    let by_modes = row.by_modes.as_ref();
    let elastic = by_modes.map_or(DemandVerdict::Unknown, |by_modes| by_modes.verdict);
    let spectral = row.comparison.elastic.as_ref().zip(row.period_s);
    vec![
        Cell::Words(direction),
        verdict(rigid.verdict),
        verdict(elastic),
        threshold(row.capacity.as_ref()),
        threshold(row.capacity_with_vertical.as_ref()),
        Cell::number(in_g(rigid.demand_m_s2, DIGITS)),
        ratio(rigid.ratio, rigid.verdict),
        Cell::Number(spectral.map(|(_, period_s)| Quantity::new(period_s, Unit::si("s"), DIGITS))),
        Cell::Number(spectral.map(|(elastic, _)| in_g(elastic.demand_m_s2, DIGITS))),
        spectral.map_or(Cell::Number(None), |(elastic, _)| {
            ratio(elastic.ratio, elastic.verdict)
        }),
        ratio(by_modes.map(|by_modes| by_modes.ratio), elastic),
    ]
}

fn verdict(verdict: DemandVerdict) -> Cell {
    let words = verdict_words(verdict);
    match verdict {
        DemandVerdict::Below => Cell::BadWords(words),
        DemandVerdict::Above | DemandVerdict::Near | DemandVerdict::Unknown => Cell::Words(words),
    }
}

fn threshold(threshold: Option<&Threshold>) -> Cell {
    Cell::Number(threshold.map(|threshold| in_g(threshold.acceleration_m_s2, DIGITS)))
}

fn ratio(ratio: Option<f64>, verdict: DemandVerdict) -> Cell {
    let ratio = ratio.map(|ratio| Quantity::ratio(ratio, RATIO_DIGITS));
    match ratio {
        Some(ratio) if verdict == DemandVerdict::Below => Cell::Bad(ratio),
        known => Cell::Number(known),
    }
}
