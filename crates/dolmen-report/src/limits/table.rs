//! Every storey and every joint compared with its limit.

use super::words::part_words;
use crate::document::{Block, Cell, Column, Document, Table};
use crate::simulated::kilo;
use dolmen::assess::demand::DriftLimit;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::part_limit::{Limited, PartLimit};

/// Digits of drifts, moments and ratios.
const DIGITS: usize = 3;
/// An excess over 1 below this is rounding: the moment has reached that at the edge of the bed.
const ROUNDING: f64 = 1e-6;

messages! {
    /// Tables of limits.
    pub(crate) enum Limits in "limits.table" {
        Drifts => { en: "Drift of each storey against what is allowed.", ko: "층별 층간변위와 허용 층간변위." },
        DriftsBy(source: String) => {
            en: "Drift of each storey against what is allowed by {source}.",
            ko: "층별 층간변위와 허용 층간변위({source}).",
        },
        DriftsLeft(allowed: Quantity) => {
            en: "Drift of each storey against what its lean as surveyed leaves of the {allowed} allowed.",
            ko: "층별 층간변위와, 허용 층간변위 {allowed}에서 실측 기울기의 몫을 뺀 값.",
        },
        DriftsLeftBy { allowed: Quantity, source: String } => {
            en: "Drift of each storey against what its lean as surveyed leaves of the {allowed} allowed by {source}.",
            ko: "층별 층간변위와, 허용 층간변위 {allowed}({source})에서 실측 기울기의 몫을 뺀 값.",
        },
        DriftsWithout => {
            en: "Drift of each storey; the file gives no allowable drift« ([limits])».",
            ko: "층별 층간변위(입력 파일에 허용 층간변위« [limits]»가 없음).",
        },
        Moments => {
            en: "Moment of each joint against that at which its bed stands on its edge.",
            ko: "접합면별 모멘트와 모서리로만 지지되는 모멘트.",
        },
        MomentsLeft => {
            en: "Moment of each joint by the shaking against what tilt and static loads leave of that at which its bed stands on its edge.",
            ko: "접합면별 지진 모멘트와, 모서리로만 지지되는 모멘트에서 기울기와 정하중의 몫을 뺀 값.",
        },
        UseMeaning => {
            en: "Below 1 it is beyond its limit, below 1.25 near it.",
            ko: "저항/요구가 1 미만이면 기준 불만족, 1.25 미만이면 기준에 근접이다.",
        },
        EdgeMeaning => {
            en: "A bed bears no more than the moment on its edge: one with a ratio of 1.00 stood on its edge.",
            ko: "접합면의 모멘트는 전도 모멘트를 넘을 수 없다. 비가 1.00인 접합면은 모서리로만 지지되었다.",
        },
        PartHead => { en: "Part", ko: "부위" },
        Along => { en: "Along", ko: "방향" },
        Direction(direction: String) => { en: "{direction}", ko: "{direction}" },
        Any => { en: "any", ko: "모든 방향" },
        Drift => { en: "drift / height", ko: "층간변위비" },
        Allowed => { en: "allowed", ko: "허용값" },
        Moment => { en: "moment", ko: "모멘트" },
        Left => { en: "left", ko: "남은 모멘트" },
        Edge => { en: "on its edge at", ko: "전도 모멘트" },
        OverDemand => { en: "capacity / demand", ko: "저항/요구" },
    }
}

/// The tables, one per kind of limit.
pub(crate) fn section(document: &mut Document<'_>, parts: &[PartLimit], limit: Option<&DriftLimit>) {
    let of = |limited: Limited| -> Vec<&PartLimit> {
        parts.iter().filter(|part| part.limited == limited).collect()
    };
    let drifts = of(Limited::Drift);
    if !drifts.is_empty() {
        let leans = drifts.iter().any(|of| of.taken > 0.0);
        let head = limit.map_or(Limits::DriftsWithout, |limit| {
            let allowed = Quantity::percent(limit.ratio(), DIGITS);
            match (leans, limit.source()) {
                (true, Some(source)) => Limits::DriftsLeftBy { allowed, source },
                (true, None) => Limits::DriftsLeft(allowed),
                (false, Some(source)) => Limits::DriftsBy(source),
                (false, None) => Limits::Drifts,
            }
        });
        document.put(Block::Table(table(
            (head, Limits::Drift, Limits::Allowed),
            &drifts,
            &Unit::percent(),
        )));
    }
    let moments = of(Limited::BedEdge);
    if !moments.is_empty() {
        let heads = match moments.iter().any(|of| of.taken > 0.0) {
            true => (Limits::MomentsLeft, Limits::Moment, Limits::Left),
            false => (Limits::Moments, Limits::Moment, Limits::Edge),
        };
        document.put(Block::Table(table(heads, &moments, &kilo("N·m"))));
    }
}

/// Whether a bed had reached the moment at its edge, which a run cannot exceed.
fn is_on_edge(of: &PartLimit) -> bool {
    let ratio = of.ratio().unwrap_or(f64::INFINITY);
    of.limited == Limited::BedEdge && (ratio - 1.0).abs() <= ROUNDING
}

fn table((head, demand, capacity): (Limits, Limits, Limits), parts: &[&PartLimit], unit: &Unit) -> Table {
    let number = |value: f64| Quantity::new(value, unit.clone(), Digits::Significant(DIGITS));
    let row = |of: &&PartLimit| {
        let over_demand = of.ratio().filter(|ratio| ratio.is_finite());
        let ratio = over_demand.map(|ratio| Quantity::ratio(ratio, DIGITS));
        let direction = match &of.direction {
            Some(direction) => Limits::Direction(direction.clone()),
            None => Limits::Any,
        };
        vec![
            Cell::Words(part_words(&of.part)),
            Cell::words(direction),
            Cell::number(number(of.demand)),
            Cell::Number(of.capacity.map(number)),
            match ratio {
                Some(ratio) if over_demand.is_some_and(|ratio| ratio < 1.0) || is_on_edge(of) => {
                    Cell::Bad(ratio)
                }
                known => Cell::Number(known),
            },
        ]
    };
    let is_known = parts.iter().any(|part| part.capacity.is_some());
    let meaning = is_known.then(|| Sentence::from(Limits::UseMeaning));
    let edges = parts.iter().any(|of| is_on_edge(of));
    let edges = edges.then(|| Sentence::from(Limits::EdgeMeaning));
    Table {
        caption: [Sentence::from(head)]
            .into_iter()
            .chain(meaning)
            .chain(edges)
            .collect(),
        columns: vec![
            Column::words(Limits::PartHead),
            Column::words(Limits::Along),
            Column::numbers(demand, unit.clone()),
            Column::numbers(capacity, unit.clone()),
            Column::numbers(Limits::OverDemand, Unit::ratio()),
        ],
        rows: parts.iter().map(row).collect(),
    }
}
