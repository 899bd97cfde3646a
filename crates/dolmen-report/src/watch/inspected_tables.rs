//! Inspections over the years as tables: how many of each kind, and how far each damage grew.

use super::inspected::{damage_name, size};
use super::numbers::{HALF_95, logged, logged_unit, plain};
use crate::document::{Block, Cell, Column, Document, Table};
use crate::engineer::{damage_words, severity_words};
use dolmen_project::{DamageKind, Severity};
use dolmen_words::{Sentence, Unit, messages};
use dolmen_work::inspected::{InspectionOf, WatchedDamage};
use dolmen_work::watched::WatchAnswer;
use std::collections::BTreeSet;

/// Number of kinds of damage with their own column; the others share one.
const KINDS_MOST: usize = 6;

messages! {
    /// Tables of inspections.
    pub(crate) enum InspectedTable in "watch.inspections.table" {
        Counts => {
            en: "What each inspection lists, by kind and by severity.",
            ko: "점검별 손상 항목 수(종류별, 정도별).",
        },
        Sizes => {
            en: "Damage whose size was read more than once. The slope stands beside a yearly wave and repairs; its error holds that of the readings, as written or as their cov says. “seen from” is the slope that would have been seen with 80 % probability.",
            ko: "크기를 두 번 이상 잰 손상. 경향은 연주기 변동과 보수의 영향을 함께 추정하여 구하였고 오차에는 적은 자릿수나 cov에 따른 측정 오차가 포함된다. 검출 한계는 80 %의 확률로 검출되었을 변화 속도이다.",
        },
        Inspection => { en: "inspection", ko: "점검" },
        All => { en: "all", ko: "합계" },
        Others => { en: "others", ko: "그 밖" },
        Damage => { en: "damage", ko: "손상" },
        Readings => { en: "readings", ko: "측정 횟수" },
        From => { en: "from", ko: "시작" },
        To => { en: "to", ko: "끝" },
        First => { en: "first", ko: "처음" },
        Last => { en: "last", ko: "마지막" },
        Limit => { en: "limit", ko: "한계" },
        PerYear => { en: "a year", ko: "연간 변화" },
        Half => { en: "± 95 %", ko: "± 95 %" },
        SeenFrom => { en: "seen from", ko: "검출 한계" },
        Rated => { en: "severity", ko: "정도" },
        Text { text: String } => { en: "{text}", ko: "{text}" },
    }
}

/// The nonempty tables.
pub(super) fn put(document: &mut Document<'_>, answer: &WatchAnswer) {
    let found = &answer.inspected;
    if !found.inspections.is_empty() {
        document.put(Block::Table(counts(&found.inspections)));
    }
    let sized: Vec<&WatchedDamage> = found
        .damages
        .iter()
        .filter(|of| of.readings.len() > 1 || of.is_beyond())
        .collect();
    if !sized.is_empty() {
        document.put(Block::Table(sizes(&sized, &found.inspections)));
    }
}

fn words(text: &str) -> Cell {
    Cell::words(InspectedTable::Text {
        text: text.to_owned(),
    })
}

fn counts(all: &[InspectionOf]) -> Table {
    const SEVERITIES: [Option<Severity>; 4] = [
        Some(Severity::Severe),
        Some(Severity::Moderate),
        Some(Severity::Slight),
        None,
    ];
    let count = |of: usize| Cell::number(plain(of as f64, 0));
    let kinds: BTreeSet<&DamageKind> = all.iter().flat_map(|of| of.counts.keys()).collect();
    let own: Vec<&DamageKind> = kinds.iter().take(KINDS_MOST).copied().collect();
    let of_kinds = |of: &InspectionOf, some: &dyn Fn(&DamageKind) -> bool| -> usize {
        let each = of.counts.iter().filter(|(kind, _)| some(kind));
        each.map(|(_, counts)| counts.iter().sum::<usize>()).sum()
    };
    let severities: Vec<Option<Severity>> = SEVERITIES
        .into_iter()
        .filter(|severity| all.iter().any(|of| of.rated(*severity) > 0))
        .collect();
    let mut columns = vec![
        Column::words(InspectedTable::Inspection),
        Column::numbers(InspectedTable::All, Unit::ratio()),
    ];
    columns.extend(
        own.iter()
            .map(|kind| Column::numbers(damage_words(kind), Unit::ratio())),
    );
    let has_others = kinds.len() > own.len();
    if has_others {
        columns.push(Column::numbers(InspectedTable::Others, Unit::ratio()));
    }
    columns.extend(
        severities
            .iter()
            .map(|severity| Column::numbers(severity_words(*severity), Unit::ratio())),
    );
    let row = |of: &InspectionOf| {
        let mut cells = vec![words(&of.survey), count(of.all())];
        cells.extend(
            own.iter()
                .map(|kind| count(of_kinds(of, &|other| other == *kind))),
        );
        if has_others {
            cells.push(count(of_kinds(of, &|other| !own.contains(&other))));
        }
        cells.extend(severities.iter().map(|severity| count(of.rated(*severity))));
        cells
    };
    Table {
        caption: vec![InspectedTable::Counts.into()],
        columns,
        rows: all.iter().map(row).collect(),
    }
}

fn sizes(damages: &[&WatchedDamage], inspections: &[InspectionOf]) -> Table {
    let lengths = |head: InspectedTable| Column::numbers(head, logged_unit(false));
    let date = |inspection: usize| {
        let of = inspections.get(inspection);
        words(of.map_or("", |of| of.survey.as_str()))
    };
    let row = |of: &&WatchedDamage| {
        let (first, last) = (of.readings.first(), of.readings.last());
        let slope = of.trend.slope.as_ref();
        let rated: Sentence = severity_words(of.severities.last().copied().flatten());
        vec![
            Cell::words(damage_name(of)),
            Cell::number(plain(of.readings.len() as f64, 0)),
            first.map_or_else(|| words(""), |read| date(read.inspection)),
            last.map_or_else(|| words(""), |read| date(read.inspection)),
            Cell::Number(first.map(|read| size(read.size_m))),
            match (of.is_beyond(), last) {
                (true, Some(read)) => Cell::Bad(size(read.size_m)),
                (_, read) => Cell::Number(read.map(|read| size(read.size_m))),
            },
            Cell::Number(of.limit_m.map(size)),
            Cell::Number(slope.map(|slope| logged(slope.per_year, false, 3))),
            Cell::Number(slope.map(|slope| logged(HALF_95 * slope.sd_per_year, false, 3))),
            Cell::Number(slope.map(|slope| logged(slope.seen_from_per_year, false, 3))),
            Cell::words(rated),
        ]
    };
    Table {
        caption: vec![InspectedTable::Sizes.into()],
        columns: vec![
            Column::words(InspectedTable::Damage),
            Column::numbers(InspectedTable::Readings, Unit::ratio()),
            Column::words(InspectedTable::From),
            Column::words(InspectedTable::To),
            lengths(InspectedTable::First),
            lengths(InspectedTable::Last),
            lengths(InspectedTable::Limit),
            lengths(InspectedTable::PerYear),
            lengths(InspectedTable::Half),
            lengths(InspectedTable::SeenFrom),
            Column::words(InspectedTable::Rated),
        ],
        rows: damages.iter().map(row).collect(),
    }
}
