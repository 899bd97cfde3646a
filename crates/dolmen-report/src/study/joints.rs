//! Joints of a stack by the shaking needed for each state.

use super::words::{count, joint as joint_words, of_case, unit_g};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen_words::{Sentence, Unit, messages};
use dolmen_work::study::{CombinationFragility, JointFragility, StudyAnswer};

/// Number of combinations whose joints are shown; joints.csv has all.
const JOINTS_OF_MOST: usize = 2;

messages! {
    /// Joints.
    pub(crate) enum Joints in "study.joints" {
        Caption => {
            en: "Joints: the peak acceleration of the ground at which half of the scans bring each to a state.",
            ko: "접합면별로 증분해석의 절반이 각 손상상태에 이르는 최대지반가속도.",
        },
        Meaning => {
            en: "Gave way: in how many scans it gave way at the first fall. From – to where a stone fell elsewhere first, or too little is known for a curve.",
            ko: "낙하 시작은 최초 낙하가 그 접합면에서 시작된 증분해석의 수이다. 다른 곳에서 부재가 먼저 낙하하였거나 곡선을 정할 자료가 부족하면 범위로 제시한다.",
        },
        Joint => { en: "joint", ko: "접합면" },
        GaveWay => { en: "gave way", ko: "낙하 시작" },
        OneMore => { en: "And of 1 more combination: joints.csv.", ko: "그 밖의 입력 조합 1개는 joints.csv에 있다." },
        More { more: usize } => {
            en: "And of {more} more combinations: joints.csv.",
            ko: "그 밖의 입력 조합 {more}개는 joints.csv에 있다.",
        },
    }
}

/// The table of the first combinations; empty without joints.
pub(super) fn section(document: &mut Document<'_>, answer: &StudyAnswer) {
    let found = answer.fragilities();
    let shown = &found[..found.len().min(JOINTS_OF_MOST)];
    let is_of = |one: &CombinationFragility, joint: &JointFragility| one.combination == joint.combination;
    let mut rows = Vec::new();
    for one in shown {
        let joints = answer.joint_fragilities().iter();
        let joints = joints.filter(|joint| is_of(one, joint));
        rows.extend(joints.map(|joint| row(answer, joint)));
    }
    if rows.is_empty() {
        return;
    }
    let states = answer.kind.states();
    let mut columns = vec![Column::words(Joints::Joint)];
    let heads = states.iter().take(3).map(|state| Sentence::of_symbol(state));
    columns.extend(heads.map(|head| Column::numbers(head, unit_g(answer))));
    columns.push(Column::numbers(Joints::GaveWay, Unit::ratio()));
    document.put(Block::Table(Table {
        caption: vec![Joints::Caption.into(), Joints::Meaning.into()],
        columns,
        rows,
    }));
    match found.len() - shown.len() {
        0 => {}
        1 => document.note(Joints::OneMore),
        more => document.note(Joints::More { more }),
    }
}

fn row(answer: &StudyAnswer, joint: &JointFragility) -> Vec<Cell> {
    let mut row = vec![Cell::words(of_case(answer, joint_words(&joint.name), joint.job))];
    let states = joint.states.iter();
    row.extend(states.map(|state| Cell::words(Sentence::of_symbol(&state.median_words(answer)))));
    row.push(count(joint.gave_way));
    row
}
