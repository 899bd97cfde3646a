//! A stack as it is compared with its variants.

use super::words::{DIGITS, in_g, moves_together, place, title, verdict_word};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::stability::Verdict;
use dolmen::stability::stack::{DemandVerdict, Governing, LimitKind};
use dolmen_words::{Quantity, Sentence, Unit, messages};
use dolmen_work::state::{Check, StackAnswer, State, VariantAnswer};

messages! {
    /// Variants of a stack.
    pub(crate) enum Variants in "stack.variants" {
        Head => { en: "Variants compared", ko: "대안 비교" },
        Caption => { en: "Variants.", ko: "대안별 결과." },
        CaptionMeaning => { en: "The same check on each.", ko: "모두 같은 방법으로 검토하였다." },
        Variant => { en: "Variant", ko: "대안" },
        AsGiven => { en: "as given", ko: "현 상태" },
        Verdict => { en: "verdict", ko: "판정" },
        MovesFirst => { en: "moves first", ko: "최초 거동" },
        Demand => { en: "demand", ko: "지진 요구" },
        FirstAt => { en: "moves first at", ko: "거동 시작 가속도" },
        Margin => { en: "margin", ko: "여유도" },
        RocksAt => { en: "rocks at", ko: "로킹" },
        Borne => { en: "loads borne ×", ko: "하중 저항 배수" },
        SlidesAt => { en: "slides at", ko: "미끄러짐" },
        Rocks { above: Sentence } => { en: "rocks on {above}", ko: "{above} 위 로킹" },
        Slides { above: Sentence } => { en: "slides on {above}", ko: "{above} 위 미끄러짐" },
        Several => { en: "several stones", ko: "여러 부재" },
        AboveDemand => { en: "above demand", ko: "기준 만족" },
        NearDemand => { en: "near demand", ko: "기준에 근접" },
        BelowDemand => { en: "below demand", ko: "기준 불만족" },
        DemandUnknown => { en: "unknown", ko: "판정 불가" },
    }
}

/// The stack as given compared with its variants; empty without variants, or for other kinds.
pub(crate) fn comparison<'a>(state: &State, variants: &[VariantAnswer]) -> Document<'a> {
    let mut document = Document::default();
    if variants.is_empty() || !matches!(state.check, Check::Stack(_)) {
        return document;
    }
    let others = variants.iter().map(|variant| (title(variant), &variant.state));
    let all: Vec<(Sentence, &State)> = std::iter::once((Variants::AsGiven.into(), state))
        .chain(others)
        .collect();
    let with_demand = all.iter().any(|(_, state)| state.demand.is_some());
    let with_loads = all.iter().any(|(_, state)| borne(state).is_some());
    let with = With {
        demand: with_demand,
        loads: with_loads,
    };
    let rows = all.into_iter().filter_map(|(name, state)| match &state.check {
        Check::Stack(answer) => Some(row(name, state, answer, with)),
        Check::Chain(_) | Check::Frame(_) | Check::Building(_) => None,
    });
    document.heading(Variants::Head);
    document.put(Block::Table(Table {
        caption: vec![Variants::Caption.into(), Variants::CaptionMeaning.into()],
        columns: columns(with),
        rows: rows.collect(),
    }));
    document
}

/// Columns that not every stack needs.
#[derive(Clone, Copy)]
struct With {
    demand: bool,
    loads: bool,
}

/// Smallest factor on wind and static loads that a stack bears; `None` without loads, or if nothing moves it.
fn borne(state: &State) -> Option<f64> {
    let factor = state.loads.as_ref().and_then(|loads| loads.factor());
    factor.filter(|factor| factor.is_finite())
}

fn columns(with: With) -> Vec<Column> {
    let mut columns = vec![
        Column::words(Variants::Variant),
        Column::words(Variants::Verdict),
        Column::words(Variants::MovesFirst),
    ];
    if with.demand {
        columns.push(Column::words(Variants::Demand));
    }
    if with.loads {
        columns.push(Column::numbers(Variants::Borne, Unit::ratio()));
    }
    columns.extend([
        Column::numbers(Variants::FirstAt, Unit::si("g")),
        Column::numbers(Variants::Margin, Unit::ratio()),
        Column::numbers(Variants::RocksAt, Unit::si("g")),
        Column::numbers(Variants::SlidesAt, Unit::si("g")),
    ]);
    columns
}

fn row(name: Sentence, state: &State, answer: &StackAnswer, with: With) -> Vec<Cell> {
    let limits = &answer.check.limits;
    // a stack that falls under its weight has no capacity, whatever single joints would resist
    let falls = state.verdict() == Verdict::Unstable;
    let at = |acceleration_g: Option<f64>| Cell::Number(acceleration_g.filter(|_| !falls).map(in_g));
    let of = |first: &Option<Governing>| at(first.map(|first| first.threshold.acceleration_g));
    let mut cells = vec![
        Cell::words(name),
        Cell::words(verdict_word(state.verdict())),
        Cell::words(moves_first(answer)),
    ];
    if with.demand {
        let none = || Sentence::of_symbol("–");
        cells.push(Cell::words(
            state
                .demand_verdict()
                .map_or_else(none, |of| demand_word(of).into()),
        ));
    }
    if with.loads {
        let factor = |factor: f64| Quantity::beside_one(factor, 4);
        cells.push(match borne(state) {
            Some(borne) if borne <= 1.0 => Cell::Bad(factor(borne)),
            borne => Cell::Number(borne.map(factor)),
        });
    }
    cells.extend([
        at(answer.check.capacity.map(|capacity| capacity.acceleration_g)),
        Cell::Number(
            limits
                .gravity_margin
                .filter(|_| !falls)
                .map(|margin| Quantity::ratio(margin, DIGITS)),
        ),
        of(&limits.uplift),
        of(&limits.sliding),
    ]);
    cells
}

fn moves_first(answer: &StackAnswer) -> Sentence {
    let limits = &answer.check.limits;
    match (&limits.governing, answer.check.capacity) {
        (_, None) => Sentence::of_symbol("–"),
        (Some(first), Some(_)) if moves_together(&answer.check).is_none() => {
            let above = place(limits.cuts.get(first.cut).map_or("", |cut| &cut.above));
            match first.kind {
                LimitKind::Uplift => Variants::Rocks { above }.into(),
                LimitKind::Sliding => Variants::Slides { above }.into(),
            }
        }
        (_, Some(_)) => Variants::Several.into(),
    }
}

fn demand_word(verdict: DemandVerdict) -> Variants {
    match verdict {
        DemandVerdict::Above => Variants::AboveDemand,
        DemandVerdict::Near => Variants::NearDemand,
        DemandVerdict::Below => Variants::BelowDemand,
        DemandVerdict::Unknown => Variants::DemandUnknown,
    }
}
