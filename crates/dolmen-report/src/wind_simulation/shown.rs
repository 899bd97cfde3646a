//! The section of a building in histories of the wind.

use super::said::findings;
use crate::building::{
    InWind, axis_words, damper_table, kilonewtons, millimetres, scaled, significant, stroke_words,
};
use crate::document::{
    Block, Cell, Column, Document, Figure, Table, TextStyle, document_text, findings_text,
};
use crate::figures::WindPlot;
use crate::simulated::seconds_whole;
use dolmen_project::strokes_of;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::building::{InTime, MotionInTime, WindSimulation};

messages! {
    /// Heads, tables and notes of histories of the wind.
    pub(crate) enum Histories in "wind-simulation" {
        Head => { en: "In histories of the wind", ko: "바람의 시간이력" },
        RunOnce { length: Quantity, step: Quantity, seed: usize } => {
            en: "One history of the wind along x and one along y, {length} each in steps of {step}, seed {seed}; with and without dampers in the same gusts.",
            ko: "x 방향과 y 방향 바람의 시간이력 각 1개(길이 {length}, 간격 {step}, 난수 씨앗 {seed})이며 감쇠기가 있을 때와 없을 때의 난류는 같다.",
        },
        Run { histories: usize, length: Quantity, step: Quantity, first: usize, last: usize } => {
            en: "{histories} histories of the wind along x and as many along y, {length} each in steps of {step}, seeds {first} to {last}; with and without dampers in the same gusts.",
            ko: "x 방향과 y 방향 바람의 시간이력 각 {histories}개(길이 {length}, 간격 {step}, 난수 씨앗 {first}~{last})이며 감쇠기가 있을 때와 없을 때의 난류는 같다.",
        },
        Method => {
            en: "Gusts are sums of cosines with normal amplitudes whose cross spectra are those of the mean square; each moves building and dampers steadily, so that a history has no beginning.",
            ko: "난류는 정규분포 진폭을 가진 코사인의 합이며 교차 스펙트럼은 평균제곱법과 같다. 각 성분에 대한 건물과 감쇠기의 정상응답을 더하므로 초기 과도응답이 없다.",
        },
        Peaks => {
            en: "A peak is the largest size within a history, to either side. g σ counts one side, and takes each swing for a new one, which those of a lightly damped building are not: the two differ by some per cent, either way.",
            ko: "최댓값은 시간이력에서 양쪽 방향을 통틀어 가장 큰 값이다. g σ는 한쪽만 세고 매 진동을 독립으로 보지만 감쇠가 작은 건물은 그렇지 않아 두 값은 몇 % 다를 수 있다.",
        },
        LeftOut => {
            en: "Not in it: gusts and vortices across the wind, their torque, galloping, aerodynamic damping, stops of dampers.",
            ko: "풍직각방향 난류·와류, 그 비틀림, 갤로핑, 공력감쇠, 감쇠기의 스토퍼는 포함하지 않았다.",
        },
        Meaning => {
            en: "σ and peak by the mean square, then in the histories: σ of all together, the mean of their peaks, its scatter, the largest.",
            ko: "평균제곱법의 표준편차와 최댓값, 이어서 시간이력 전체의 표준편차, 최댓값의 평균·산포·최대이다.",
        },
        What => { en: "Value", ko: "값" },
        Mean => { en: "mean", ko: "평균" },
        MeanSquareRms => { en: "σ, mean square", ko: "표준편차(평균제곱)" },
        Rms => { en: "σ, in time", ko: "표준편차(시간이력)" },
        MeanSquarePeak => { en: "peak, mean square", ko: "최댓값(평균제곱)" },
        Peak => { en: "peak, in time", ko: "최댓값(시간이력)" },
        Scatter => { en: "scatter", ko: "산포" },
        Largest => { en: "largest", ko: "최대" },
        Top => { en: "displacement of the top, mm", ko: "최상층 변위, mm" },
        Drift(floor: String) => { en: "edge drift below {floor}, mm", ko: "{floor} 아래 단부 층간변위, mm" },
        TopAcceleration => { en: "acceleration of the top, m/s²", ko: "최상층 가속도, m/s²" },
        Corner => { en: "of its worst corner, m/s²", ko: "최상층 모서리 가속도, m/s²" },
        BaseShear => { en: "base shear, kN", ko: "밑면전단력, kN" },
        BaseTorque => { en: "base torque, kN·m", ko: "밑면 비틀림모멘트, kN·m" },
        Stroke(damper: Sentence) => { en: "stroke of {damper}, mm", ko: "{damper} 행정, mm" },
        TopInTime(axis: Sentence) => {
            en: "Displacement of the top floor, the wind along {axis}.",
            ko: "최상층 변위({axis} 방향 바람).",
        },
        CornerInTime(axis: Sentence) => {
            en: "Acceleration of the worst corner of the top floor, the wind along {axis}.",
            ko: "최상층의 가장 불리한 모서리 가속도({axis} 방향 바람).",
        },
        StrokesInTime(axis: Sentence) => {
            en: "Strokes of the dampers, the wind along {axis}.",
            ko: "감쇠기의 행정({axis} 방향 바람).",
        },
        First => { en: "The first history.", ko: "첫 번째 시간이력." },
    }
}

/// The response; in full every value, and the first history.
pub fn wind_simulation_text(run: &WindSimulation, style: TextStyle) -> String {
    let found = findings_text(&findings(run), style);
    match style.is_full {
        true => found + &document_text(&section(run), style),
        false => found,
    }
}

fn section(run: &WindSimulation) -> Document<'_> {
    let mut document = Document::default();
    document.heading(Histories::Head);
    let seed = |at: Option<&u64>| at.map_or(0, |seed| *seed as usize);
    let length = seconds_whole(run.duration_s);
    let step = Quantity::new(run.time_step_s, Unit::si("s"), Digits::Trimmed(6));
    let drawn = match run.seeds.len() {
        1 => Histories::RunOnce {
            length,
            step,
            seed: seed(run.seeds.first()),
        },
        histories => Histories::Run {
            histories,
            length,
            step,
            first: seed(run.seeds.first()),
            last: seed(run.seeds.last()),
        },
    };
    document.put(Block::Paragraph(vec![
        drawn.into(),
        Histories::Method.into(),
        Histories::Peaks.into(),
    ]));
    document.blocks.extend(damper_table(&run.dampers).blocks);
    for (axis, along) in run.along.iter().enumerate() {
        let name = || axis_words(axis);
        let caption = match along.with {
            Some(_) => InWind::AlongWithout(name()),
            None => InWind::AlongAxis(name()),
        };
        document.put(Block::Table(table(run, &along.without, caption)));
        if let Some(with) = &along.with {
            document.put(Block::Table(table(run, with, InWind::AlongWith(name()))));
        }
    }
    document.note(Histories::LeftOut);
    for plot in WindPlot::all(run) {
        let drawn = Figure::drawn(caption(plot), move |language| {
            plot.draw(run, language).unwrap_or_default()
        });
        document.charted(drawn.with_series(move || plot.numbers(run)));
    }
    document
}

fn caption(plot: WindPlot) -> Vec<Sentence> {
    let said = match plot {
        WindPlot::Top(axis) => Histories::TopInTime(axis_words(axis)),
        WindPlot::Corner(axis) => Histories::CornerInTime(axis_words(axis)),
        WindPlot::Strokes(axis) => Histories::StrokesInTime(axis_words(axis)),
    };
    vec![said.into(), Histories::First.into()]
}

fn table(run: &WindSimulation, motion: &MotionInTime, caption: InWind) -> Table {
    let mut rows = vec![row(Histories::Top, &motion.top_displacement_m, millimetres())];
    let drifts = run.floors.iter().zip(&motion.drifts_m).rev();
    rows.extend(drifts.map(|(floor, drift)| {
        let floor = floor.clone();
        row(Histories::Drift(floor), drift, millimetres())
    }));
    let acceleration = || Unit::si("m/s²");
    rows.push(row(
        Histories::TopAcceleration,
        &motion.top_acceleration_m_s2,
        acceleration(),
    ));
    rows.push(row(Histories::Corner, &motion.corner_m_s2, acceleration()));
    rows.push(row(Histories::BaseShear, &motion.base_shear_n, kilonewtons()));
    rows.push(row(
        Histories::BaseTorque,
        &motion.base_torque_n_m,
        scaled("kN·m", 1e-3),
    ));
    let strokes = strokes_of(&run.dampers).into_iter().zip(&motion.strokes_m);
    rows.extend(strokes.map(|(of, stroke)| {
        let damper = stroke_words(&of.name);
        row(Histories::Stroke(damper), stroke, millimetres())
    }));
    let numbers = |head: Histories| Column::numbers(head, Unit::ratio());
    Table {
        caption: vec![caption.into(), Histories::Meaning.into()],
        columns: vec![
            Column::words(Histories::What),
            numbers(Histories::Mean),
            numbers(Histories::MeanSquareRms),
            numbers(Histories::Rms),
            numbers(Histories::MeanSquarePeak),
            numbers(Histories::Peak),
            numbers(Histories::Scatter),
            numbers(Histories::Largest),
        ],
        rows,
    }
}

fn row(what: Histories, of: &InTime, unit: Unit) -> Vec<Cell> {
    let number = |value: f64| significant(value, unit.clone(), 3);
    vec![
        Cell::words(what),
        Cell::number(number(of.mean)),
        Cell::number(number(of.mean_square.rms)),
        Cell::number(number(of.rms)),
        Cell::number(number(of.mean_square.peak())),
        Cell::number(number(of.peak())),
        Cell::Number(of.peak_rms().map(number)),
        Cell::number(number(of.largest())),
    ]
}
