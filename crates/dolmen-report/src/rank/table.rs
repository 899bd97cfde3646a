//! The places of a portfolio.

use crate::document::{Block, Cell, Column, Document, Table};
use crate::score::{range_cell, state_name};
use dolmen::assess::{Known, KnownCapacity, Place, RankedBy};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::portfolio::{
    PortfolioAnswer, PortfolioEntry, basis_words, capacity_words, probability_in_years, reason_words,
};

/// Number of rows shown; ranking.csv has all.
const ROWS_MOST: usize = 200;

messages! {
    /// The table of a ranking.
    pub(crate) enum Ranking in "rank.table" {
        Caption => { en: "Ranking, the worst first.", ko: "우선순위, 취약한 순서." },
        Structure => { en: "structure", ko: "구조물" },
        Name(name: String) => { en: "{name}", ko: "{name}" },
        Damaged(name: String) => { en: "{name} (damaged)", ko: "{name}(심한 손상)" },
        RestsOn => { en: "rests on", ko: "근거" },
        Words(words: Both) => { en: "{words}", ko: "{words}" },
        Lowers => { en: "what lowers it", ko: "주된 저하 요인" },
        Place => { en: "place", ko: "순위" },
        Ninety => { en: "90 %", ko: "90 %" },
        State(state: Both) => { en: "{state}", ko: "{state}" },
        AYear => { en: "a year", ko: "연간 초과율" },
        FiftyYears => { en: "in 50 years", ko: "50년 초과확률" },
        WorstTenth => { en: "worst tenth", ko: "최취약 10 %에 들 확률" },
        ByFalls => { en: "by falls alone", ko: "낙하·전도 순위" },
        AtLeast(value: Quantity) => { en: "≥ {value}", ko: "≥ {value}" },
        AtMost(value: Quantity) => { en: "≤ {value}", ko: "≤ {value}" },
        More(more: usize) => {
            en: "and {more} more, in ranking.csv (-o DIR).",
            ko: "나머지 {more}기는 ranking.csv 참조(-o DIR).",
        },
        WorstTenthMeaning => {
            en: "Worst tenth: in how many of the draws of what is not known it is among the worst tenth.",
            ko: "최취약 10 %에 들 확률: 불확실성을 추출한 표본 가운데 가장 취약한 10분의 1에 드는 비율.",
        },
    }
}

type Row<'a> = (&'a Place, &'a PortfolioEntry, &'a KnownCapacity);

/// A column of the ranking.
struct Shown {
    column: Column,
    /// Whether it is part of a short answer.
    is_key: bool,
    cell: fn(&PortfolioAnswer, &Row<'_>) -> Cell,
}

/// The table and its notes.
pub(super) fn section(document: &mut Document<'_>, answer: &PortfolioAnswer) {
    document.put(Block::Table(table(answer, false)));
    let more = answer.ranked.places.len().saturating_sub(ROWS_MOST);
    if more > 0 {
        document.note(Ranking::More(more));
    }
    document.note(Ranking::WorstTenthMeaning);
}

/// Ranks with their structures; in a short answer only the distinguishing columns.
pub(super) fn table(answer: &PortfolioAnswer, is_brief: bool) -> Table {
    let mut all = columns(answer);
    all.retain(|shown| shown.is_key || !is_brief);
    let row = |row: Row<'_>| all.iter().map(|shown| (shown.cell)(answer, &row)).collect();
    let rows = answer.rows().take(ROWS_MOST).map(row).collect();
    Table {
        caption: vec![Ranking::Caption.into()],
        columns: all.into_iter().map(|shown| shown.column).collect(),
        rows,
    }
}

fn columns(answer: &PortfolioAnswer) -> Vec<Shown> {
    let has_rate = answer.ranked.by == RankedBy::AnnualRate;
    let ratio = |head: Ranking| Column::numbers(head, Unit::ratio());
    let shown = |column: Column, is_key: bool, cell| Shown { column, is_key, cell };
    let state = Ranking::State(state_name(answer.state));
    let mut all = vec![
        shown(Column::words(Ranking::Structure), true, name),
        shown(Column::words(Ranking::RestsOn), true, basis),
        shown(Column::words(Ranking::Lowers), false, reason),
        shown(ratio(Ranking::Place), true, place),
        shown(ratio(Ranking::Ninety), true, interval),
        shown(Column::numbers(state, Unit::si("g")), !has_rate, capacity),
    ];
    if has_rate {
        all.push(shown(ratio(Ranking::AYear), false, annual_rate));
        let column = Column::numbers(Ranking::FiftyYears, Unit::percent());
        all.push(shown(column, true, fifty_years));
    }
    let column = Column::numbers(Ranking::WorstTenth, Unit::percent());
    all.push(shown(column, true, worst_tenth));
    all.push(shown(ratio(Ranking::ByFalls), false, by_falls));
    all
}

fn name(_: &PortfolioAnswer, (_, entry, _): &Row<'_>) -> Cell {
    let name = entry.name.clone();
    Cell::words(match entry.severe_damage.is_empty() {
        true => Ranking::Name(name),
        false => Ranking::Damaged(name),
    })
}

fn basis(_: &PortfolioAnswer, (_, entry, _): &Row<'_>) -> Cell {
    let words = Both::of(|language| basis_words(entry, language));
    Cell::words(Ranking::Words(words))
}

fn reason(_: &PortfolioAnswer, (_, entry, _): &Row<'_>) -> Cell {
    let words = Both::of(|language| reason_words(entry, language));
    Cell::words(Ranking::Words(words))
}

fn place(_: &PortfolioAnswer, (place, ..): &Row<'_>) -> Cell {
    Cell::number(whole(place.rank as f64))
}

fn interval(_: &PortfolioAnswer, (place, ..): &Row<'_>) -> Cell {
    range_cell(&place.rank_interval, whole)
}

fn capacity(answer: &PortfolioAnswer, (.., known): &Row<'_>) -> Cell {
    let theta = known.fragility.theta();
    let theta_g = known.median(theta).unwrap_or(theta) / answer.gravity_m_s2;
    match known.known {
        Known::Found => Cell::number(Quantity::ratio(theta_g, 2)),
        Known::AtLeast | Known::AtMost => {
            Cell::words(Sentence::of_symbol(&capacity_words(known, answer.gravity_m_s2)))
        }
    }
}

fn annual_rate(_: &PortfolioAnswer, (place, _, known): &Row<'_>) -> Cell {
    let rate = place.annual_rate.map(|rate| Quantity::ratio(rate, 2));
    rate.map_or(Cell::Number(None), |rate| of_bound(known, rate))
}

fn fifty_years(_: &PortfolioAnswer, (place, _, known): &Row<'_>) -> Cell {
    let probability = place.annual_rate.map(probability_in_years);
    let share = probability.map(|share| Quantity::percent(share, 2));
    share.map_or(Cell::Number(None), |share| of_bound(known, share))
}

fn worst_tenth(_: &PortfolioAnswer, (place, _, known): &Row<'_>) -> Cell {
    of_bound(known, Quantity::percent(place.worst_tenth, 2))
}

/// A rate or share with the sign of its bound: from an upper bound of the capacity it is the least.
fn of_bound(known: &KnownCapacity, value: Quantity) -> Cell {
    match known.known {
        Known::Found => Cell::number(value),
        Known::AtMost => Cell::words(Ranking::AtLeast(bare(value))),
        Known::AtLeast => Cell::words(Ranking::AtMost(bare(value))),
    }
}

/// Without its unit, which stands in the head of the column.
fn bare(mut value: Quantity) -> Quantity {
    value.unit.symbol.clear();
    value
}

fn by_falls(answer: &PortfolioAnswer, (place, ..): &Row<'_>) -> Cell {
    let rank = answer.by_falls.get(place.candidate).copied().flatten();
    Cell::Number(rank.map(|rank| whole(rank as f64)))
}

fn whole(value: f64) -> Quantity {
    Quantity::new(value, Unit::ratio(), Digits::Fixed(0))
}
