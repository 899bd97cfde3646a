//! All dampers of a building at once.

use super::remarks::of_all;
use super::words::{ROUNDING, goal_words, load_words, of_none, part, point_along, together_words};
use crate::building::{direction_words, fixed, name, rest, tonnes};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen_project::BuiltDamper;
use dolmen_words::{Quantity, Sentence, Unit, messages};
use dolmen_work::building::{TogetherAnswer, TogetherRow};

messages! {
    /// All dampers at once.
    pub(crate) enum Together in "tune.together" {
        Load { load: Sentence, directions: Vec<Sentence> } => {
            en: "Load: {load}, along {directions}.",
            ko: "하중: {load}, {directions} 방향.",
        },
        LoadIndependent { load: Sentence, directions: Vec<Sentence> } => {
            en: "Load: {load}, along {directions}, independently.",
            ko: "하중: {load}, {directions} 방향에 서로 독립적으로 작용.",
        },
        PeaksNotSought => {
            en: "Largest amplitudes were asked for; of several dampers at once they are not sought, and the largest standard deviation stands in their place.",
            ko: "최대 진폭을 목표로 지정하였으나 여러 감쇠기의 동시 설계에서는 이를 구하지 않으며, 대신 최대 표준편차를 최소화하였다.",
        },
        Goal { goal: Sentence } => { en: "Made small: {goal}.", ko: "최소화하는 값: {goal}." },
        StrokeMost { most: Quantity } => {
            en: "What is designed keeps to {most} of the strokes of the file's dampers.",
            ko: "설계한 감쇠기의 행정은 입력한 감쇠기 행정의 {most}배 이내로 제한하였다.",
        },
        Caption => {
            en: "Motion of the points over that without dampers, with all of them at once, with each alone, and designed together.",
            ko: "감쇠기 전체, 개별, 동시 설계에 대한 관측점 응답의 비제어 대비 비.",
        },
        Dampers => { en: "Dampers", ko: "감쇠기" },
        GoalHead => { en: "goal", ko: "목적함수값" },
        Designed { choice: Sentence } => { en: "As designed: {choice}.", ko: "설계한 감쇠기: {choice}." },
        Damper => { en: "Damper", ko: "감쇠기" },
        Besides => { en: "besides", ko: "기타" },
        Mass => { en: "mass", ko: "질량" },
        Frequency => { en: "f", ko: "진동수" },
        Damping => { en: "damping", ko: "감쇠비" },
    }
}

/// The load, the effect of each choice, the designed dampers, and remarks.
pub(super) fn section(document: &mut Document<'_>, answer: &TogetherAnswer) {
    document.put(Block::Paragraph(lead(answer)));
    document.put(Block::Table(table(answer)));
    for row in answer.rows.iter().filter(|row| row.end.is_some()) {
        document.put(Block::Table(designed(row)));
    }
    of_all(document, answer);
}

fn lead(answer: &TogetherAnswer) -> Vec<Sentence> {
    let load = load_words(answer.load);
    let degrees = answer.load_directions_degrees.iter();
    let directions: Vec<Sentence> = degrees.map(|degrees| direction_words(*degrees)).collect();
    let acts = match directions.len() > 1 {
        true => Together::LoadIndependent { load, directions },
        false => Together::Load { load, directions },
    };
    let goal = Together::Goal {
        goal: goal_words(answer.goal),
    };
    let kept = answer
        .stroke_most
        .map(|most| Together::StrokeMost { most: part(most) });
    let peaks = answer.peaks_not_sought.then_some(Together::PeaksNotSought);
    let said = [acts, goal].into_iter().chain(peaks).chain(kept);
    said.map(Sentence::from).collect()
}

fn table(answer: &TogetherAnswer) -> Table {
    let numbers = |head: Sentence| Column::numbers(head, Unit::ratio());
    let mut columns = vec![Column::words(Together::Dampers)];
    let points = answer.points.iter();
    columns.extend(points.map(|(point, degrees)| numbers(point_along(&point.name, *degrees))));
    columns.push(numbers(Together::GoalHead.into()));
    let row = |row: &TogetherRow| {
        let mut cells = vec![Cell::words(together_words(&row.choice))];
        cells.extend(answer.ratios(row).into_iter().map(|ratio| {
            let left = of_none(ratio, 4);
            match ratio > 1.0 + ROUNDING {
                true => Cell::Bad(left),
                false => Cell::number(left),
            }
        }));
        cells.push(Cell::number(of_none(answer.cost_ratio(row), 4)));
        cells
    };
    Table {
        caption: vec![Together::Caption.into()],
        columns,
        rows: answer.rows.iter().map(row).collect(),
    }
}

/// The dampers of an optimised row.
fn designed(row: &TogetherRow) -> Table {
    let has_besides = row.dampers.iter().any(|damper| rest(damper).is_some());
    let symbol = |head: &str| Column::numbers(Sentence::of_symbol(head), Unit::si("m"));
    let mut columns = vec![Column::words(Together::Damper)];
    columns.extend(has_besides.then(|| Column::words(Together::Besides)));
    columns.extend([
        symbol("x"),
        symbol("y"),
        Column::numbers(Together::Mass, tonnes()),
        Column::numbers(Together::Frequency, Unit::si("Hz")),
        Column::numbers(Together::Damping, Unit::percent()),
    ]);
    let cells = |damper: &BuiltDamper| {
        let own = damper.own();
        let metres = |value: f64| Cell::number(fixed(value, Unit::si("m"), 3));
        let mass_kg = Some(damper.kind.mass_kg()).filter(|mass_kg| *mass_kg > 0.0);
        let mut cells = vec![Cell::words(name(&damper.name))];
        cells.extend(has_besides.then(|| rest(damper).map_or(Cell::Number(None), Cell::words)));
        cells.extend([
            metres(damper.place_m[0]),
            metres(damper.place_m[1]),
            Cell::Number(mass_kg.map(|mass_kg| fixed(mass_kg, tonnes(), 4))),
            Cell::Number(own.map(|[hz, _]| fixed(hz, Unit::si("Hz"), 5))),
            Cell::Number(own.map(|[_, ratio]| fixed(ratio, Unit::percent(), 3))),
        ]);
        cells
    };
    let caption = Together::Designed {
        choice: together_words(&row.choice),
    };
    Table {
        caption: vec![caption.into()],
        columns,
        rows: row.dampers.iter().map(cells).collect(),
    }
}
