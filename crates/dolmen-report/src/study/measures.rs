//! Scatter of the capacity by each measure of the shaking.

use super::words::{Words, count, fixed, same, state};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen_words::{Sentence, Unit, messages};
use dolmen_work::study::StudyAnswer;

messages! {
    /// Measures of the shaking.
    pub(crate) enum Measures in "study.measures" {
        Caption => {
            en: "Scatter β of the capacity by each measure of the shaking: the one with the least tells most.",
            ko: "지반운동 세기 척도별 내력의 대수 표준편차 β. 작을수록 내력을 잘 설명한다.",
        },
        NoCurve => {
            en: "–: no curve, as where the scatter is below the steps of the scan.",
            ko: "–는 산포가 증분 간격보다 작은 경우처럼 곡선이 없는 경우이다.",
        },
        Combinations => { en: "combinations", ko: "입력 조합" },
        EachOf { some: usize, all: usize } => { en: "each of {some} of {all}", ko: "{all}개 중 {some}개 각각" },
        AsOne { all: usize } => { en: "all {all} as one", ko: "{all}개 전체" },
    }
}

/// The table; empty without a curve.
pub(super) fn section(document: &mut Document<'_>, answer: &StudyAnswer) {
    let all = answer.fragilities().len();
    let number = |beta: &Option<f64>| Cell::Number(beta.map(|beta| fixed(beta, 2)));
    let mut rows = Vec::new();
    for own in answer.compare_measures() {
        let of = match all {
            1 => count(1),
            all => Cell::words(Measures::EachOf {
                some: own.combinations,
                all,
            }),
        };
        let mut row = vec![Cell::words(state(answer, own.state)), of];
        row.extend(own.within.iter().map(number));
        rows.push(row);
        if all > 1 {
            let mut row = vec![same(), Cell::words(Measures::AsOne { all })];
            row.extend(own.together.iter().map(number));
            rows.push(row);
        }
    }
    if rows.is_empty() {
        return;
    }
    let names = answer.measures().into_iter().map(|measure| measure.words());
    let mut columns = vec![Column::words(Words::State), Column::words(Measures::Combinations)];
    let names = std::iter::once("PGA".to_owned()).chain(names);
    columns.extend(names.map(|name| Column::numbers(Sentence::of_symbol(&name), Unit::ratio())));
    document.put(Block::Table(Table {
        caption: vec![Measures::Caption.into(), Measures::NoCurve.into()],
        columns,
        rows,
    }));
}
