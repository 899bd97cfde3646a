//! What a study adds: releases from a large displacement, and maps of harmonic ground motions.

use super::words::{Words, count, labelled, name, same, some};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen_words::{Digits, Quantity, Unit, messages};
use dolmen_work::study::{ResponseMaps, StudyAnswer, StudyKind};

messages! {
    /// Releases and maps.
    pub(crate) enum Releases in "study.releases" {
        LetGo => {
            en: "Let go: apparent frequency and equivalent damping, swing by swing.",
            ko: "자유진동: 진폭별 겉보기 고유진동수와 등가감쇠비.",
        },
        Swing => { en: "swing", ko: "진폭" },
        Frequency => { en: "frequency", ko: "진동수" },
        Damping => { en: "damping ratio", ko: "감쇠비" },
        OfStoreys => {
            en: "Harmonic ground: at how many points of the map each storey slips.",
            ko: "조화 지반운동: 층별로 미끄러지는 계산점의 수.",
        },
        OfJoints => {
            en: "Harmonic ground: at how many points of the map each joint opens or slips.",
            ko: "조화 지반운동: 접합면별로 벌어지거나 미끄러지는 계산점의 수.",
        },
        Storey => { en: "storey", ko: "층" },
        JointBelow => { en: "joint below", ko: "하부 접합면(부재)" },
        Points => { en: "points", ko: "계산점" },
        Slips => { en: "slips", ko: "미끄러짐" },
        Moves => { en: "moves", ko: "거동" },
        DriftLimit => { en: "drift limit", ko: "층간변위 한계" },
        Falls => { en: "falls", ko: "전도" },
        NotSteady => { en: "not steady", ko: "정상상태 아님" },
    }
}

/// The tables of releases and of maps.
pub(super) fn section(document: &mut Document<'_>, answer: &StudyAnswer) {
    let released = answer.maps.iter().filter(|map| map.release.len() > 1);
    let released: Vec<&ResponseMaps> = released.collect();
    if !released.is_empty() {
        document.put(Block::Table(swings(&released)));
    }
    let mapped = answer.maps.iter().filter(|map| !map.harmonic.is_empty());
    let mapped: Vec<&ResponseMaps> = mapped.collect();
    if !mapped.is_empty() {
        document.put(Block::Table(points(answer.kind, &mapped)));
    }
}

fn swings(released: &[&ResponseMaps]) -> Table {
    let mm = Unit {
        symbol: "mm".to_owned(),
        factor: 1e3,
    };
    let mut rows = Vec::new();
    for map in released {
        for (i, swing) in some(&map.release).into_iter().enumerate() {
            let number = |value: f64, unit: Unit, digits| Cell::number(Quantity::new(value, unit, digits));
            rows.push(vec![
                label(map, i),
                number(swing.amplitude_m, mm.clone(), Digits::Significant(3)),
                number(swing.apparent_frequency_hz, Unit::si("Hz"), Digits::Fixed(3)),
                number(swing.equivalent_damping_ratio, Unit::percent(), Digits::Fixed(2)),
            ]);
        }
    }
    Table {
        caption: vec![Releases::LetGo.into()],
        columns: vec![
            Column::words(Words::Case),
            Column::numbers(Releases::Swing, mm),
            Column::numbers(Releases::Frequency, Unit::si("Hz")),
            Column::numbers(Releases::Damping, Unit::percent()),
        ],
        rows,
    }
}

fn points(kind: StudyKind, mapped: &[&ResponseMaps]) -> Table {
    let (caption, part, moves, fell) = match kind {
        StudyKind::Chain => (
            Releases::OfJoints,
            Releases::JointBelow,
            Releases::Moves,
            Releases::Falls,
        ),
        StudyKind::Stack | StudyKind::Frame | StudyKind::Building => (
            Releases::OfStoreys,
            Releases::Storey,
            Releases::Slips,
            Releases::DriftLimit,
        ),
    };
    let mut rows = Vec::new();
    for map in mapped {
        let fell = map.harmonic.iter().filter(|point| point.fell).count();
        let unsteady = map.harmonic.iter().filter(|p| !p.steady && !p.fell).count();
        for (part, own) in map.parts.iter().enumerate() {
            let share = map
                .harmonic
                .iter()
                .filter_map(|point| point.moving_share.get(part));
            let moves = share.filter(|share| **share > 0.0).count();
            let mut row = vec![Cell::words(labelled(name(own), &map.label))];
            row.extend([map.harmonic.len(), moves, fell, unsteady].map(count));
            rows.push(row);
        }
    }
    let numbers = [Releases::Points, moves, fell, Releases::NotSteady];
    let mut columns = vec![Column::words(part)];
    columns.extend(numbers.map(|head| Column::numbers(head, Unit::ratio())));
    Table {
        caption: vec![caption.into()],
        columns,
        rows,
    }
}

/// The case, in its first row alone.
fn label(map: &ResponseMaps, row: usize) -> Cell {
    match row {
        0 => Cell::words(name(&map.label)),
        _ => same(),
    }
}
