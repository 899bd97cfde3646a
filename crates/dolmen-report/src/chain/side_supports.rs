//! Side supports of a chain: their role in the check, and in a motion.

use crate::document::{Cell, Column, Finding, Table, Tone};
use crate::simulated::{kilo, milli, seconds};
use dolmen::assess::ChainCheck;
use dolmen::structure::SideSupport;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::chain::{ChainSimulation, SupportMet};

messages! {
    /// Effect of the side supports of a chain.
    pub(crate) enum Supports in "chain.side-supports" {
        Counted { count: usize, without: Quantity } => {
            en: "Load factor and frequencies count its side supports without a gap ({count}); without them the load factor is {without}. Limits from weights and lengths alone, and those of the pole as one stone, do not count them.",
            ko: "하중배율과 고유진동수에는 간격 없는 측면 지지(지주) {count}개가 반영되어 있다. 지지가 없으면 하중배율은 {without}이다. 무게와 길이만으로 구한 한계와 단일 부재 당간의 값에는 반영하지 않았다.",
        },
        CountedAndNeeded { count: usize, without: Quantity } => {
            en: "It leans on its side supports without a gap ({count}): without them the load factor is {without} and it would fall. Are they tight, and do they bear the force? Limits from weights and lengths alone do not count them.",
            ko: "간격 없는 측면 지지(지주) {count}개에 기대어 있다. 지지가 없으면 하중배율이 {without}(으)로 불안정하다. 밀착 여부와 내력을 확인해야 한다. 무게와 길이만으로 구한 한계에는 반영하지 않았다.",
        },
        CountedAlone { count: usize } => {
            en: "Side supports without a gap ({count}) hold it too, once the stiffness of its joints is known; limits from weights and lengths alone do not count them.",
            ko: "간격 없는 측면 지지(지주) {count}개는 접합부 강성을 알면 반영된다. 무게와 길이만으로 구한 한계에는 반영하지 않았다.",
        },
        LeftOut { count: usize, gap: Quantity } => {
            en: "Load factor, frequencies and wind leave its side supports with a gap out ({count}, the least gap {gap}): they do nothing until it has moved so far. «`dolmen simulate`|A simulation in time» counts them.",
            ko: "하중배율, 고유진동수, 바람 검토에는 간격이 있는 측면 지지(지주) {count}개를 반영하지 않았다(최소 간격 {gap}). 그만큼 움직이기 전에는 작용하지 않는다. «`dolmen simulate`|지진응답 검토»에서는 반영한다.",
        },
        Met { height: Quantity, first: Quantity, times: usize, force: Quantity } => {
            en: "It meets the side support at {height} first at {first}, {times} times in all; the support takes up to {force}, which its posts must bear.",
            ko: "높이 {height}의 측면 지지에 {first}에 처음 닿고 모두 {times}회 닿는다. 지지력은 최대 {force}이며 지주가 이를 견뎌야 한다.",
        },
        Held { height: Quantity, force: Quantity } => {
            en: "The side support at {height}, without a gap, takes up to {force}, which its posts must bear.",
            ko: "간격 없는 높이 {height}의 측면 지지가 최대 {force}을(를) 받으며 지주가 이를 견뎌야 한다.",
        },
        NotMet { height: Quantity, gap: Quantity, most: Quantity } => {
            en: "It does not meet the side support at {height}: it moves up to {most} there, and the gap is {gap}.",
            ko: "높이 {height}의 측면 지지에는 닿지 않는다. 그 위치의 최대 변위는 {most}, 간격은 {gap}이다.",
        },
        Table => { en: "Side supports.", ko: "측면 지지." },
        TableMeaning => {
            en: "Displacement from where the pole is without stress; a support loses no energy.",
            ko: "무응력 상태로부터의 변위이며 지지의 에너지 손실은 없는 것으로 하였다.",
        },
        Height => { en: "height", ko: "높이" },
        Gap => { en: "gap", ko: "간격" },
        Stiffness => { en: "stiffness", ko: "강성" },
        Times => { en: "met", ko: "접촉 횟수" },
        First => { en: "first at", ko: "최초 접촉" },
        Displacement => { en: "displacement", ko: "최대 변위" },
        Force => { en: "force", ko: "최대 지지력" },
        InTime => { en: "Force of each side support.", ko: "측면 지지의 반력." },
        InTimeMeaning => {
            en: "Positive where it pushes against a displacement to the right.",
            ko: "오른쪽 변위를 막는 방향이 양이다.",
        },
    }
}

fn metres(value_m: f64) -> Quantity {
    Quantity::new(value_m, Unit::si("m"), Digits::Significant(3))
}

fn millimetres(value_m: f64) -> Quantity {
    Quantity::new(value_m, milli("m"), Digits::Significant(3))
}

fn kilonewtons(value_n: f64) -> Quantity {
    Quantity::new(value_n, kilo("N"), Digits::Significant(3))
}

/// Their effect in the check.
pub(super) fn findings(check: &ChainCheck) -> Vec<Finding> {
    let mut all = Vec::new();
    let (tight, loose): (Vec<&SideSupport>, Vec<&SideSupport>) =
        check.side_supports.iter().partition(|of| of.acts_linearly());
    let count = tight.len();
    if count > 0 {
        all.push(match check.load_factor_without_supports {
            None => Finding::key(Tone::Plain, Supports::CountedAlone { count }),
            Some(factor) => {
                let without = Quantity::beside_one(factor, 3);
                match factor > 1.0 {
                    true => Finding::key(Tone::Plain, Supports::Counted { count, without }),
                    false => Finding::key(Tone::Warn, Supports::CountedAndNeeded { count, without }),
                }
            }
        });
    }
    if !loose.is_empty() {
        let gaps = loose.iter().map(|of| of.gap_m);
        all.push(Finding::key(
            Tone::Plain,
            Supports::LeftOut {
                count: loose.len(),
                gap: millimetres(gaps.fold(f64::INFINITY, f64::min)),
            },
        ));
    }
    all
}

/// The response at each in a motion.
pub(super) fn met(simulation: &ChainSimulation) -> Vec<Finding> {
    let each = simulation.supports_met().into_iter();
    each.map(|met| Finding::key(Tone::Plain, said(&met))).collect()
}

fn said(met: &SupportMet) -> Supports {
    let height = metres(met.support.height_m);
    let force = kilonewtons(met.peak.force_n.abs());
    match (met.support.acts_linearly(), met.first_s) {
        (true, _) => Supports::Held { height, force },
        (false, Some(first_s)) => Supports::Met {
            height,
            first: seconds(first_s),
            times: met.times,
            force,
        },
        (false, None) => Supports::NotMet {
            height,
            gap: millimetres(met.support.gap_m),
            most: millimetres(met.peak.displacement_m.abs()),
        },
    }
}

/// Each support with its numbers; `None` without supports.
pub(super) fn table(simulation: &ChainSimulation) -> Option<Table> {
    let all = simulation.supports_met();
    let row = |met: &SupportMet| {
        let stiffness = Quantity::new(met.support.stiffness_n_m, kilo("N/m"), Digits::Significant(4));
        vec![
            Cell::number(metres(met.support.height_m)),
            Cell::number(millimetres(met.support.gap_m)),
            Cell::number(stiffness),
            Cell::number(Quantity::new(met.times as f64, Unit::ratio(), Digits::Fixed(0))),
            Cell::Number(met.first_s.map(seconds)),
            Cell::number(millimetres(met.peak.displacement_m.abs())),
            Cell::number(kilonewtons(met.peak.force_n.abs())),
        ]
    };
    (!all.is_empty()).then(|| Table {
        caption: vec![Supports::Table.into(), Supports::TableMeaning.into()],
        columns: vec![
            Column::numbers(Supports::Height, Unit::si("m")),
            Column::numbers(Supports::Gap, milli("m")),
            Column::numbers(Supports::Stiffness, kilo("N/m")),
            Column::numbers(Supports::Times, Unit::ratio()),
            Column::numbers(Supports::First, Unit::si("s")),
            Column::numbers(Supports::Displacement, milli("m")),
            Column::numbers(Supports::Force, kilo("N")),
        ],
        rows: all.iter().map(row).collect(),
    })
}

/// The caption of the forces in time.
pub(super) fn in_time() -> Vec<Sentence> {
    vec![Supports::InTime.into(), Supports::InTimeMeaning.into()]
}
