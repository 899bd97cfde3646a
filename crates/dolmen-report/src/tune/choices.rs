//! A damper compared with the rule and the optimum: the choices of place and tuning, and their effect.

use super::words::{choice_words, goal_words, load_words, of_none, part};
use crate::building::{direction_words, fixed, name};
use crate::document::{Block, Cell, Column, Document, Figure, Table};
use crate::figures::{TuneFigure, tune_series};
use dolmen::damper::{Choice, Compared, Goal};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::building::TuneAnswer;
use std::f64::consts::TAU;

messages! {
    /// Choices of place and tuning.
    pub(crate) enum Choices in "tune.choices" {
        InFile { mass: Quantity, floor: usize, x: Quantity, y: Quantity, direction: Sentence } => {
            en: "In the file it has {mass} on floor {floor} at x = {x}, y = {y}, along {direction}.",
            ko: "입력: {floor}번 바닥 x = {x}, y = {y}, 질량 {mass}, {direction} 방향.",
        },
        InVariant { variant: String, mass: Quantity, floor: usize, x: Quantity, y: Quantity, direction: Sentence } => {
            en: "In variant “{variant}” it has {mass} on floor {floor} at x = {x}, y = {y}, along {direction}.",
            ko: "대안 ‘{variant}’의 입력: {floor}번 바닥 x = {x}, y = {y}, 질량 {mass}, {direction} 방향.",
        },
        Mode { mode: usize, frequency: Quantity, circular: Quantity, damping: Quantity, modal_mass: Quantity, ratio: Quantity } => {
            en: "Mode {mode} at {frequency} ({circular}), damping ratio {damping}; modal mass {modal_mass} at the damper, mass ratio {ratio}.",
            ko: "{mode}차 모드 {frequency} ({circular}), 감쇠비 {damping}, 감쇠기 위치의 모드질량 {modal_mass}, 질량비 {ratio}.",
        },
        Centre { x: Quantity, y: Quantity } => {
            en: "The mode turns that floor about x = {x}, y = {y}.",
            ko: "이 층에서 모드의 회전 중심은 x = {x}, y = {y}이다.",
        },
        NoCentre => { en: "The mode does not turn that floor.", ko: "이 모드에서 그 층은 회전하지 않는다." },
        Load { load: Sentence, direction: Sentence } => {
            en: "Load: {load}, along {direction}.",
            ko: "하중: {load}, {direction} 방향.",
        },
        Goal { goal: Sentence, points: Vec<Sentence>, direction: Sentence } => {
            en: "Made small: {goal}. Points: {points}, along {direction}.",
            ko: "최소화하는 값: {goal}. 관측점: {points}, {direction} 방향.",
        },
        OneOther => {
            en: "The other damper of the file is left out here: each is judged alone first, and both together below.",
            ko: "여기서는 입력한 다른 감쇠기 1개를 제외하였다. 먼저 하나씩 따로 평가하고 전체는 아래에서 평가한다.",
        },
        Others { count: usize } => {
            en: "The other {count} dampers of the file are left out here: each is judged alone first, and all together below.",
            ko: "여기서는 입력한 다른 감쇠기 {count}개를 제외하였다. 먼저 하나씩 따로 평가하고 전체는 아래에서 평가한다.",
        },
        StrokeMost { most: Quantity } => {
            en: "What is designed keeps to {most} of the stroke of the file's damper.",
            ko: "설계한 감쇠기의 행정은 입력한 감쇠기 행정의 {most}배 이내로 제한하였다.",
        },
        OffBy { share: Quantity } => {
            en: "What is designed is the best with its frequency off by {share} either way, the goal at its own.",
            ko: "설계한 감쇠기는 진동수가 ±{share} 어긋나는 경우까지 고려한 최적이며, 표의 목적함수값은 어긋나지 않은 진동수의 값이다.",
        },
        Caption => {
            en: "What each choice of place and tuning does.",
            ko: "위치와 동조에 따른 제어 효과.",
        },
        OfDeviations => {
            en: "Standard deviations of the points and the goal over those without a damper; the stroke over that of the damper as in the file.",
            ko: "감쇠기가 없을 때에 대한 관측점 표준편차의 비와 목적함수값의 비이며 행정은 입력한 감쇠기에 대한 비이다.",
        },
        OfAmplitudes => {
            en: "Largest amplitudes of the points under a harmonic load and the goal over those without a damper; the stroke over that of the damper as in the file.",
            ko: "조화하중에 대한 감쇠기가 없을 때에 대한 관측점 최대 진폭의 비와 목적함수값의 비이며 행정은 입력한 감쇠기에 대한 비이다.",
        },
        Damper => { en: "Damper", ko: "감쇠기" },
        Frequency => { en: "frequency", ko: "진동수" },
        DampingRatio => { en: "damping ratio", ko: "감쇠비" },
        GoalHead => { en: "goal", ko: "목적함수값" },
        Stroke => { en: "stroke", ko: "행정" },
        Position => {
            en: "Motion of the points against the place of the damper.",
            ko: "감쇠기 위치에 따른 관측점의 RMS.",
        },
        PositionMeaning => {
            en: "As Figure 5 of Hwang, Min & Hong, tuned as in the file and tuned anew at each place.",
            ko: "논문의 그림 5에 해당하며 입력한 동조와 위치마다 새로 동조한 경우이다.",
        },
        Plan => {
            en: "The goal for each place of the damper, tuned best there.",
            ko: "위치마다 최적 동조한 경우의 목적함수값.",
        },
        PlanMeaning => { en: "Lighter is better; crosses are the points.", ko: "밝을수록 좋으며 ×는 관측점이다." },
        Robustness => { en: "What being out of tune costs.", ko: "동조 오차의 영향." },
        RobustnessMeaning => {
            en: "Frequency and damping of the damper off by so much.",
            ko: "감쇠기의 진동수와 감쇠가 어긋난 경우이다.",
        },
    }
}

/// The compared choices.
pub(super) fn lead(document: &mut Document<'_>, answer: &TuneAnswer) {
    let names = answer.points.iter().map(|point| name(&point.name)).collect();
    let mut said: Vec<Sentence> = in_file(answer).into_iter().map(Sentence::from).collect();
    said.extend(mode(answer).map(Sentence::from));
    document.put(Block::Paragraph(said));
    document.put(Block::Paragraph(vec![
        Choices::Load {
            load: load_words(answer.load),
            direction: direction_words(answer.load_direction_degrees),
        }
        .into(),
        Choices::Goal {
            goal: goal_words(answer.goal),
            points: names,
            direction: direction_words(answer.direction_degrees),
        }
        .into(),
    ]));
    match answer.others {
        0 => {}
        1 => document.paragraph(Choices::OneOther),
        count => document.paragraph(Choices::Others { count }),
    }
    if let Some(most) = answer.stroke_most {
        document.paragraph(Choices::StrokeMost { most: part(most) });
    }
    if answer.off_by > 0.0 {
        let share = fixed(answer.off_by, Unit::percent(), 1);
        document.paragraph(Choices::OffBy { share });
    }
}

fn in_file(answer: &TuneAnswer) -> Option<Choices> {
    let damper = &answer.comparison.row(Choice::Given)?.damper;
    let mass = fixed(damper.mass_kg, Unit::si("kg"), 1);
    let metres = |value: f64| Quantity::new(value, Unit::si("m"), Digits::Trimmed(6));
    let [x, y] = damper.place_m.map(metres);
    let direction = direction_words(damper.direction_degrees);
    let floor = answer.floor;
    Some(match answer.variant.clone() {
        None => Choices::InFile {
            mass,
            floor,
            x,
            y,
            direction,
        },
        Some(variant) => Choices::InVariant {
            variant,
            mass,
            floor,
            x,
            y,
            direction,
        },
    })
}

fn mode(answer: &TuneAnswer) -> [Choices; 2] {
    let metres = |value: f64| fixed(value, Unit::si("m"), 3);
    let mode = Choices::Mode {
        mode: answer.mode,
        frequency: fixed(answer.mode_frequency_hz, Unit::si("Hz"), 4),
        circular: fixed(TAU * answer.mode_frequency_hz, Unit::si("rad/s"), 5),
        damping: of_none(answer.mode_damping_ratio, 4),
        modal_mass: fixed(answer.comparison.modal_mass_kg, Unit::si("kg"), 1),
        ratio: of_none(answer.comparison.mass_ratio, 5),
    };
    let centre = answer
        .mode_centre_m
        .map_or(Choices::NoCentre, |[x, y]| Choices::Centre {
            x: metres(x),
            y: metres(y),
        });
    [mode, centre]
}

/// The effect of each choice, and figures.
pub(super) fn section<'a>(document: &mut Document<'a>, answer: &'a TuneAnswer) {
    document.put(Block::Table(table(answer)));
    for figure in TuneFigure::of(answer) {
        let caption = match figure {
            TuneFigure::Position => vec![Choices::Position.into(), Choices::PositionMeaning.into()],
            TuneFigure::Plan => vec![Choices::Plan.into(), Choices::PlanMeaning.into()],
            TuneFigure::Robustness => vec![Choices::Robustness.into(), Choices::RobustnessMeaning.into()],
            TuneFigure::Floors => continue, // stands with its table
        };
        let drawn = Figure::drawn(caption, move |language| figure.draw(answer, language));
        document.charted(drawn.with_series(move || tune_series(answer, figure)));
    }
}

fn table(answer: &TuneAnswer) -> Table {
    let numbers = |head: Sentence, unit: &str| Column::numbers(head, Unit::si(unit));
    let mut columns = vec![
        Column::words(Choices::Damper),
        numbers(Sentence::of_symbol("x"), "m"),
        numbers(Sentence::of_symbol("y"), "m"),
        numbers(Choices::Frequency.into(), "Hz"),
        numbers(Choices::DampingRatio.into(), ""),
    ];
    columns.extend(answer.points.iter().map(|point| numbers(name(&point.name), "")));
    columns.push(numbers(Choices::GoalHead.into(), ""));
    columns.push(numbers(Choices::Stroke.into(), ""));
    let row = |row: &Compared| {
        let damper = &row.damper;
        let number = |value: f64, unit: &str, decimals| Cell::number(fixed(value, Unit::si(unit), decimals));
        let mut cells = vec![
            Cell::words(choice_words(row.choice, answer.mode)),
            number(damper.place_m[0], "m", 3),
            number(damper.place_m[1], "m", 3),
            number(damper.frequency_hz, "Hz", 5),
            number(damper.damping_ratio, "", 5),
        ];
        cells.extend(answer.ratios(row).into_iter().map(|ratio| match ratio > 1.0 {
            true => Cell::Bad(of_none(ratio, 4)),
            false => Cell::number(of_none(ratio, 4)),
        }));
        cells.push(number(row.cost / answer.comparison.cost_without, "", 4));
        cells.push(number(answer.stroke_ratio(row), "", 3));
        cells
    };
    let of = match answer.goal {
        Goal::LargestPeak => Choices::OfAmplitudes,
        Goal::LargestRms | Goal::MeanSquare => Choices::OfDeviations,
    };
    Table {
        caption: vec![Choices::Caption.into(), of.into()],
        columns,
        rows: answer.comparison.rows.iter().map(row).collect(),
    }
}
