//! The limits of the joints of a stack.

use super::words::{DIGITS, direction, in_g, moves_together, place};
use crate::document::{Block, Cell, Column, Document, Series, Table, table_series};
use dolmen::assess::{StackCheck, StackNote};
use dolmen::stability::stack::{CutLimits, Threshold};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Limits of the joints.
    pub(crate) enum Limits in "stack.limits" {
        Caption => { en: "Limits of each joint.", ko: "접합면별 한계." },
        CaptionMeaning => {
            en: "Horizontal acceleration at which what stands on it begins to rock or slide, in the worst direction.",
            ko: "접합면 상부가 로킹 또는 미끄러지기 시작하는 수평 가속도(가장 불리한 방향).",
        },
        Joint => { en: "What stands on", ko: "접합면 (아래 부재)" },
        RocksTowards => { en: "rocks to", ko: "로킹 방향" },
        SlidesTowards => { en: "slides to", ko: "미끄러짐 방향" },
        Height => { en: "z", ko: "높이 z" },
        Weight => { en: "weight", ko: "상부 무게" },
        Area => { en: "area", ko: "면적" },
        Pressure => { en: "p", ko: "평균 압력 p" },
        Margin => { en: "margin", ko: "여유도" },
        RocksAt => { en: "rocks at", ko: "로킹" },
        SlidesAt => { en: "slides at", ko: "미끄러짐" },
        TiedRocksAt => { en: "with ties: rocks at", ko: "연결재 포함: 로킹" },
        TiedSlidesAt => { en: "slides at", ko: "미끄러짐" },
        Together => { en: "several stones together (limit analysis)", ko: "여러 부재가 함께 (한계해석)" },
        Meaning => {
            en: "The margin is what is left, without shaking, of the way from the middle of the joint to its edge, or of friction. Rocks to and slides to give the direction in which the part moves; the ground then accelerates the other way. z is the height of the joint, p the mean pressure of weight and static loads on it.",
            ko: "여유도는 지진이 없을 때 접합면 중심에서 모서리까지의 거리(또는 마찰) 중 남은 비율이다. 방향은 접합면 상부가 움직이는 방향이며, 지반 가속도는 그 반대 방향이다. z는 접합면의 높이, p는 접합면의 평균 압력이다.",
        },
        FirstMotion => {
            en: "Thresholds are those of first motion, not of collapse; a vertical acceleration a_z of the ground, upwards, makes them 1 + a_z/g times as much.",
            ko: "한계값은 최초 거동에 대한 값이며 붕괴에 대한 값이 아니다. 지반의 연직 가속도 a_z(위 방향)가 작용하면 한계값은 1 + a_z/g배가 된다.",
        },
        NotPlanarOne => {
            en: "One part rests on joints of different planes or leans on stones beside it, so it has no row here: only the limit analysis judges it.",
            ko: "부재 묶음 1곳은 서로 다른 평면의 접합면 위에 놓이거나 옆의 부재에 기대어 있어 한계해석으로만 판정한다.",
        },
        NotPlanar { parts: usize } => {
            en: "{parts} groups of stones rest on joints of different planes or lean on stones beside them, so they have no row here: only the limit analysis judges them.",
            ko: "부재 묶음 {parts}곳은 서로 다른 평면의 접합면 위에 놓이거나 옆의 부재에 기대어 있어 한계해석으로만 판정한다.",
        },
    }
}

/// The limits of each joint, and of several stones together if lower.
pub(super) fn section(document: &mut Document<'_>, check: &StackCheck) {
    document.put(Block::Table(table(check)));
    document.note(Limits::Meaning);
    document.note(Limits::FirstMotion);
    match check.limits.undecided.len() {
        0 => {}
        1 => document.note(Limits::NotPlanarOne),
        parts => document.note(Limits::NotPlanar { parts }),
    }
}

/// The limits as numbers of the figures.
pub(super) fn series(check: &StackCheck) -> Vec<Series> {
    table_series(&table(check))
}

fn table(check: &StackCheck) -> Table {
    let mut rows: Vec<Vec<Cell>> = check.limits.cuts.iter().map(row).collect();
    rows.extend(moves_together(check).map(|together| together_row(&together)));
    let mut with_ties = Vec::new();
    if check.notes.contains(&StackNote::TiesLeftOut) {
        with_ties.extend(
            [Limits::TiedRocksAt, Limits::TiedSlidesAt].map(|head| Column::numbers(head, Unit::si("g"))),
        );
        for (at, row) in rows.iter_mut().enumerate() {
            let cut = check.limits.cuts.get(at);
            let of_cut = |of: fn(&CutLimits) -> Option<Threshold>| {
                Cell::Number(cut.and_then(of).map(|of| in_g(of.acceleration_g)))
            };
            row.extend([
                of_cut(|cut| cut.uplift_with_ties),
                of_cut(|cut| cut.sliding_with_ties),
            ]);
        }
    }
    let unit = |symbol: &str, factor: f64| Unit {
        symbol: symbol.to_owned(),
        factor,
    };
    Table {
        caption: vec![Limits::Caption.into(), Limits::CaptionMeaning.into()],
        columns: vec![
            Column::words(Limits::Joint),
            Column::words(Limits::RocksTowards),
            Column::words(Limits::SlidesTowards),
            Column::numbers(Limits::Height, unit("m", 1.0)),
            Column::numbers(Limits::Weight, unit("kN", 1e-3)),
            Column::numbers(Limits::Area, unit("m²", 1.0)),
            Column::numbers(Limits::Pressure, unit("kPa", 1e-3)),
            Column::numbers(Limits::Margin, Unit::ratio()),
            Column::numbers(Limits::RocksAt, unit("g", 1.0)),
            Column::numbers(Limits::SlidesAt, unit("g", 1.0)),
        ]
        .into_iter()
        .chain(with_ties)
        .collect(),
        rows,
    }
}

fn row(cut: &CutLimits) -> Vec<Cell> {
    let area_m2 = cut.area_m2;
    let kilo = |value: f64, digits| {
        let unit = Unit {
            symbol: String::new(),
            factor: 1e-3,
        };
        Cell::number(Quantity::new(value, unit, digits))
    };
    let margin = Quantity::ratio(cut.gravity_margin, DIGITS);
    let at = |threshold: &Option<Threshold>| {
        Cell::Number(threshold.map(|threshold| in_g(threshold.acceleration_g)))
    };
    vec![
        Cell::words(place(&cut.above)),
        towards(cut.uplift.as_ref()),
        towards(cut.sliding.as_ref()),
        Cell::number(Quantity::new(cut.origin_m[2], Unit::si("m"), Digits::Fixed(3))),
        kilo(cut.weight_n, Digits::Significant(4)),
        Cell::number(Quantity::new(area_m2, Unit::si("m²"), Digits::Significant(4))),
        kilo(cut.normal_n / area_m2, Digits::Significant(DIGITS)),
        match cut.standing.stands() {
            true => Cell::number(margin),
            false => Cell::Bad(margin),
        },
        at(&cut.uplift),
        at(&cut.sliding),
    ]
}

/// The direction in which a part moves; a dash if it never does.
fn towards(threshold: Option<&Threshold>) -> Cell {
    let finite = threshold.filter(|threshold| threshold.acceleration_g.is_finite());
    let none = || Sentence::of_symbol("–");
    Cell::words(finite.map_or_else(none, |threshold| direction(threshold.direction)))
}

fn together_row(together: &Threshold) -> Vec<Cell> {
    let mut cells = vec![
        Cell::BadWords(Limits::Together.into()),
        towards(Some(together)),
        towards(None),
    ];
    cells.extend((0..5).map(|_| Cell::Number(None)));
    cells.push(Cell::Bad(in_g(together.acceleration_g)));
    cells.push(Cell::Number(None));
    cells
}
