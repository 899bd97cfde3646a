//! A damper on each of several floors: which floor is the best, and how much it gains.

use super::remarks::Remark;
use super::words::{of_none, point_ratio, under_words};
use crate::building::{fixed, millimetres, name, significant};
use crate::document::{Block, Cell, Column, Document, Figure, Finding, Table, Tone};
use crate::figures::{TuneFigure, tune_series};
use dolmen::damper::{DesignEnd, FloorDesign};
use dolmen_words::{Quantity, Sentence, Unit, messages};
use dolmen_work::building::{TuneAnswer, TunedFloors};

/// Number of floors in a short table, beside that of the file.
const SHORT: usize = 5;
/// Relative gain below which another floor is no better than that of the file. Our choice.
const GAIN_LEAST: f64 = 1e-3;
/// Relative difference from which numbers at prepared frequencies are called rough.
const ROUGH: f64 = 1e-3;

messages! {
    /// Floors of a damper.
    pub(crate) enum Floors in "tune.floors" {
        OtherIsBest { damper: String, own: usize, given: Quantity, best: usize, there: Quantity } => {
            en: "Damper {damper}, placed and tuned best on each floor: the file's floor, {own}, gives {given}; floor {best} would give {there}.",
            ko: "감쇠기 {damper}을(를) 층마다 최적 위치와 동조로 두었을 때의 응답비: 입력한 {own}번 바닥 {given}, {best}번 바닥 {there}.",
        },
        OwnIsBest { damper: String, own: usize, given: Quantity, next: usize, there: Quantity } => {
            en: "Damper {damper}, placed and tuned best on each floor: no floor compared is better than the file's, {own}, which gives {given}; floor {next} follows with {there}.",
            ko: "감쇠기 {damper}을(를) 층마다 최적 위치와 동조로 두면 비교한 층 가운데 입력한 {own}번 바닥(응답비 {given})보다 나은 층이 없다. 다음은 {next}번 바닥으로 {there}이다.",
        },
        OnlyOwn { damper: String, own: usize } => {
            en: "Damper {damper} was searched only on its own floor, {own}«: `dolmen tune --floors all` compares the others».",
            ko: "감쇠기 {damper}은(는) 입력한 {own}번 바닥에서만 탐색하였다.« 다른 층과의 비교는 `dolmen tune --floors all`로 한다.»",
        },
        BeyondRoom { damper: String, floor: usize, needed: Quantity, under: Sentence, has: Quantity } => {
            en: "On floor {floor} damper {damper} would be beyond its room: it needs {needed} each way under {under} and has {has}.",
            ko: "{floor}번 바닥에 두면 감쇠기 {damper}의 행정 {needed}이(가) 여유 공간 {has}을(를) 넘는다({under}).",
        },
        BestOn { floor: usize } => {
            en: "placed and tuned best on floor {floor}",
            ko: "{floor}번 바닥의 최적 위치와 동조",
        },
        Head => { en: "On other floors", ko: "다른 층" },
        Caption => {
            en: "The damper placed and tuned best on each floor.",
            ko: "층별 최적 위치와 동조.",
        },
        ShortCaption { count: usize } => {
            en: "The damper placed and tuned best on each floor: the best of {count}, and that of the file.",
            ko: "층별 최적 위치와 동조: {count}개 층 가운데 가장 좋은 층과 입력한 층.",
        },
        Meaning => {
            en: "Mass, direction, loads and points are the same on every floor; the goal is over that without a damper.",
            ko: "질량, 방향, 하중과 관측점은 모든 층에서 같으며 목적함수값은 감쇠기가 없을 때에 대한 비이다.",
        },
        PointsOfOwn { own: usize } => {
            en: "Points: the corners of floor {own}, whichever floor carries the damper. Give the file points to reduce the motion elsewhere.",
            ko: "감쇠기를 두는 층과 관계없이 관측점은 {own}번 바닥의 모서리이다. 다른 곳의 응답을 줄이려면 파일에 points를 쓴다.",
        },
        Floor => { en: "Floor", ko: "바닥" },
        OwnFloor { floor: usize } => { en: "{floor}, as in the file", ko: "{floor} (입력)" },
        BestFloor { floor: usize } => { en: "{floor}, the best", ko: "{floor} (최적)" },
        OwnBestFloor { floor: usize } => { en: "{floor}, as in the file, the best", ko: "{floor} (입력, 최적)" },
        OtherFloor { floor: usize } => { en: "{floor}", ko: "{floor}" },
        Frequency => { en: "frequency", ko: "진동수" },
        DampingRatio => { en: "damping ratio", ko: "감쇠비" },
        MassRatio => { en: "mass ratio", ko: "질량비" },
        Goal => { en: "goal", ko: "목적함수값" },
        WithoutOutline { floors: Vec<Sentence> } => {
            en: "Left out, because they have no outline (sides or outline): floors {floors}.",
            ko: "외곽선(sides, outline)이 없어 제외한 바닥: {floors}.",
        },
        Rigid { floors: Vec<Sentence> } => {
            en: "No damper on floors {floors}: the best damping ratio is above 1, so nothing swings there.",
            ko: "바닥 {floors}에서는 최적 감쇠비가 1을 넘어 감쇠기가 진동하지 않는다.",
        },
        Rough { apart: Quantity } => {
            en: "Rough: the goals of the floors are off by up to {apart}, except for the best three and that of the file: something is damped too lightly for the search.",
            ko: "정밀도 주의: 감쇠가 매우 작은 부분이 있어 가장 좋은 3개 층과 입력한 층을 뺀 층의 목적함수값에 최대 {apart}의 오차가 있다.",
        },
        Figure => { en: "The goal against the floor of the damper.", ko: "감쇠기를 두는 층에 따른 목적함수값." },
        FigureMeaning => {
            en: "On each floor the damper is placed and tuned best.",
            ko: "층마다 최적 위치와 동조로 둔 경우이다.",
        },
    }
}

/// The floors, where others than that of the file were compared.
fn compared(answer: &TuneAnswer) -> Option<&TunedFloors> {
    answer.floors.as_ref().filter(|of| of.comparison.floors.len() > 1)
}

fn goal(answer: &TuneAnswer, of: &FloorDesign, decimals: usize) -> Quantity {
    of_none(of.cost / answer.comparison.cost_without, decimals)
}

/// What the floors decide.
pub(super) fn findings(answer: &TuneAnswer) -> Vec<Finding> {
    let (damper, own) = (answer.damper.clone(), answer.floor);
    let Some(floors) = compared(answer) else {
        let said = (answer.other_floors > 0).then_some(Floors::OnlyOwn { damper, own });
        return said
            .map(|said| Finding::key(Tone::Plain, said))
            .into_iter()
            .collect();
    };
    let best = answer.best_floors(2);
    let others = best.iter().find(|of| of.floor != own);
    let given = floors.comparison.floors.iter().find(|of| of.floor == own);
    let (Some(given), Some(other)) = (given, others) else {
        return Vec::new();
    };
    let (value, there) = (goal(answer, given, 3), goal(answer, other, 3));
    let said = match other.cost < given.cost * (1.0 - GAIN_LEAST) {
        true => Floors::OtherIsBest {
            damper,
            own,
            given: value,
            best: other.floor,
            there,
        },
        false => Floors::OwnIsBest {
            damper,
            own,
            given: value,
            next: other.floor,
            there,
        },
    };
    let mut all = vec![Finding::key(Tone::Plain, said)];
    all.extend(floors.room.beyond().map(|of| {
        let said = Floors::BeyondRoom {
            damper: answer.damper.clone(),
            floor: other.floor,
            needed: significant(of.stroke_m, millimetres(), 4),
            under: under_words(of),
            has: significant(of.room_m, millimetres(), 4),
        };
        Finding::key(Tone::Bad, said)
    }));
    all
}

/// The best few floors, for a short answer.
pub(super) fn short(document: &mut Document<'_>, answer: &TuneAnswer) {
    if let Some(floors) = compared(answer) {
        let count = floors.comparison.floors.len();
        let caption = match count > SHORT {
            true => Floors::ShortCaption { count },
            false => Floors::Caption,
        };
        let table = table(answer, &answer.best_floors(SHORT));
        document.put(Block::Table(Table {
            caption: vec![caption.into()],
            ..table
        }));
    }
}

/// All floors, with a figure and remarks.
pub(super) fn section<'a>(document: &mut Document<'a>, answer: &'a TuneAnswer) {
    let Some(floors) = compared(answer) else { return };
    document.put(Block::Subheading(Floors::Head.into()));
    let all: Vec<&FloorDesign> = floors.comparison.floors.iter().collect();
    document.put(Block::Table(table(answer, &all)));
    let figure = TuneFigure::Floors;
    let caption = vec![Floors::Figure.into(), Floors::FigureMeaning.into()];
    let drawn = Figure::drawn(caption, move |language| figure.draw(answer, language));
    document.charted(drawn.with_series(move || tune_series(answer, figure)));
    if answer.points_are_corners {
        document.note(Floors::PointsOfOwn { own: answer.floor });
    }
    if let Some(best) = floors.comparison.best().filter(|of| of.floor != answer.floor) {
        warnings(document, answer, best);
    }
    let rigid = all.iter().filter(|of| of.damper.damping_ratio > 1.0);
    let rigid = numbers(rigid.map(|of| of.floor));
    if !rigid.is_empty() {
        document.note(Floors::Rigid { floors: rigid });
    }
    let left_out = numbers(floors.without_outline.iter().copied());
    if !left_out.is_empty() {
        document.note(Floors::WithoutOutline { floors: left_out });
    }
    if floors.comparison.apart > ROUGH {
        let apart = fixed(floors.comparison.apart, Unit::percent(), 1);
        document.note(Floors::Rough { apart });
    }
}

fn numbers(floors: impl Iterator<Item = usize>) -> Vec<Sentence> {
    floors.map(|floor| Floors::OtherFloor { floor }.into()).collect()
}

/// Points that move more on the best floor than without a damper, and a search that ended at its bound.
fn warnings(document: &mut Document<'_>, answer: &TuneAnswer, best: &FloorDesign) {
    let choice: Sentence = Floors::BestOn { floor: best.floor }.into();
    let Some(effect) = &best.effect else { return };
    let worse = answer.worse(effect).into_iter();
    let list: Vec<Sentence> = worse
        .map(|(point, ratio)| point_ratio(name(&point.name), ratio, 4))
        .collect();
    if !list.is_empty() {
        let choice = choice.clone();
        document.put(Block::Warning(Remark::Worse { choice, list }.into()));
    }
    match best.end {
        DesignEnd::Limit => document.note(Remark::Bounded {
            choice,
            frequency: fixed(best.damper.frequency_hz, Unit::si("Hz"), 5),
            ratio: of_none(best.damper.damping_ratio, 5),
        }),
        DesignEnd::Stalled => document.note(Remark::Unsettled { choice }),
        DesignEnd::Optimum => {}
    }
}

fn table(answer: &TuneAnswer, floors: &[&FloorDesign]) -> Table {
    let column = |head: Sentence, unit: &str| Column::numbers(head, Unit::si(unit));
    let number = |value: f64, unit: &str, decimals| Cell::number(fixed(value, Unit::si(unit), decimals));
    let best = compared(answer).and_then(|of| of.comparison.best());
    let row = |of: &&FloorDesign| {
        let (floor, damper) = (of.floor, &of.damper);
        let is_best = best.is_some_and(|best| best.floor == floor);
        let named = match (floor == answer.floor, is_best) {
            (true, true) => Floors::OwnBestFloor { floor },
            (true, false) => Floors::OwnFloor { floor },
            (false, true) => Floors::BestFloor { floor },
            (false, false) => Floors::OtherFloor { floor },
        };
        let ratio = of.modal_mass_kg.map(|mass_kg| damper.mass_kg / mass_kg);
        vec![
            Cell::words(named),
            number(damper.place_m[0], "m", 3),
            number(damper.place_m[1], "m", 3),
            number(damper.frequency_hz, "Hz", 5),
            number(damper.damping_ratio, "", 5),
            Cell::Number(ratio.map(|ratio| of_none(ratio, 5))),
            Cell::number(goal(answer, of, 4)),
        ]
    };
    Table {
        caption: vec![Floors::Caption.into(), Floors::Meaning.into()],
        columns: vec![
            Column::words(Floors::Floor),
            column(Sentence::of_symbol("x"), "m"),
            column(Sentence::of_symbol("y"), "m"),
            column(Floors::Frequency.into(), "Hz"),
            column(Floors::DampingRatio.into(), ""),
            column(Floors::MassRatio.into(), ""),
            column(Floors::Goal.into(), ""),
        ],
        rows: floors.iter().map(row).collect(),
    }
}
