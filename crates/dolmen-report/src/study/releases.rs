//! Further results of a study: releases from a large displacement, and maps of harmonic ground motions.

use super::words::{Words, count, g, labelled, name, same, some};
use crate::document::{Block, Cell, Column, Document, Finding, Table, Tone};
use dolmen::dynamics::HarmonicPoint;
use dolmen_words::{Digits, Quantity, Unit, messages};
use dolmen_work::study::{ResponseMaps, StudyAnswer, StudyKind};

messages! {
    /// Releases and maps.
    pub(crate) enum Releases in "study.releases" {
        LetGo => {
            en: "Let go: apparent frequency and equivalent damping, swing by swing.",
            ko: "자유진동: 진폭별 겉보기 고유진동수와 등가감쇠비.",
        },
        FallsAt { points: usize, fell: usize, least: Quantity, frequency: Quantity, lowest: Quantity, highest: Quantity } => {
            en: "Harmonic ground from {lowest} to {highest}: it falls at {fell} of {points} points, with the least acceleration, {least}, at {frequency}.",
            ko: "조화 지반운동({lowest}~{highest}): 계산점 {points}개 중 {fell}개에서 전도되며, 가속도가 가장 작은 것은 {frequency}의 {least}이다.",
        },
        BeyondAt { points: usize, fell: usize, least: Quantity, frequency: Quantity, lowest: Quantity, highest: Quantity } => {
            en: "Harmonic ground from {lowest} to {highest}: a storey leans beyond its limit at {fell} of {points} points, with the least acceleration, {least}, at {frequency}.",
            ko: "조화 지반운동({lowest}~{highest}): 계산점 {points}개 중 {fell}개에서 층간변위 한계를 넘으며, 가속도가 가장 작은 것은 {frequency}의 {least}이다.",
        },
        NoneFalls { points: usize, largest: Quantity, lowest: Quantity, highest: Quantity } => {
            en: "Harmonic ground from {lowest} to {highest}, up to {largest}: it stays up at all {points} points.",
            ko: "조화 지반운동({lowest}~{highest}, 최대 {largest}): 계산점 {points}개 모두에서 붕괴하지 않는다.",
        },
        Softens { largest: Quantity, from: Quantity, smallest: Quantity, to: Quantity } => {
            en: "Let go: the apparent frequency goes from {from} in swings of {largest} to {to} in swings of {smallest}.",
            ko: "자유진동: 겉보기 고유진동수는 진폭 {largest}에서 {from}, 진폭 {smallest}에서 {to}이다.",
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

/// Findings on maps and releases, each over all cases.
pub(super) fn findings(answer: &StudyAnswer) -> Vec<Finding> {
    let hertz = |value: f64| Quantity::new(value, Unit::si("Hz"), Digits::Significant(3));
    let mm = |value: f64| Quantity::new(value, millimetre(), Digits::Significant(3));
    let mut all = Vec::new();
    let points = || answer.maps.iter().flat_map(|map| &map.harmonic);
    let of = |point: &HarmonicPoint| point.ground_acceleration_m_s2;
    if let Some(largest) = points().map(of).max_by(f64::total_cmp) {
        let each = || points().map(|point| point.frequency_hz);
        let lowest = hertz(each().fold(f64::INFINITY, f64::min));
        let highest = hertz(each().fold(0.0, f64::max));
        let fell = points().filter(|point| point.fell).count();
        let weakest = points()
            .filter(|point| point.fell)
            .min_by(|a, b| of(a).total_cmp(&of(b)));
        let (points, largest) = (points().count(), g(answer, largest));
        let said = match (weakest, answer.kind) {
            (None, _) => Releases::NoneFalls {
                points,
                largest,
                lowest,
                highest,
            },
            (Some(at), kind) => {
                let (least, frequency) = (g(answer, of(at)), hertz(at.frequency_hz));
                match kind {
                    StudyKind::Chain | StudyKind::Stack => Releases::FallsAt {
                        points,
                        fell,
                        least,
                        frequency,
                        lowest,
                        highest,
                    },
                    StudyKind::Frame | StudyKind::Building => Releases::BeyondAt {
                        points,
                        fell,
                        least,
                        frequency,
                        lowest,
                        highest,
                    },
                }
            }
        };
        let tone = if fell > 0 { Tone::Warn } else { Tone::Plain };
        all.push(Finding::key(tone, said));
    }
    let released = answer.maps.iter().find(|map| map.release.len() > 1);
    if let Some((first, last)) = released.and_then(|map| map.release.first().zip(map.release.last())) {
        all.push(Finding::key(
            Tone::Plain,
            Releases::Softens {
                largest: mm(first.amplitude_m),
                from: hertz(first.apparent_frequency_hz),
                smallest: mm(last.amplitude_m),
                to: hertz(last.apparent_frequency_hz),
            },
        ));
    }
    all
}

fn millimetre() -> Unit {
    Unit {
        symbol: "mm".to_owned(),
        factor: 1e3,
    }
}

fn swings(released: &[&ResponseMaps]) -> Table {
    let mm = millimetre();
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

/// The case, only in its first row.
fn label(map: &ResponseMaps, row: usize) -> Cell {
    match row {
        0 => Cell::words(name(&map.label)),
        _ => same(),
    }
}
