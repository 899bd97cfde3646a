//! The sections of simulated buildings.

use super::moved::{alarms, of_all, own, variant};
use super::tables::{floors, points, strokes};
use crate::building::{beside, damper_table, direction_words, kilonewtons};
use crate::document::{Block, Document, Figure, TextStyle, document_text, findings_text};
use crate::figures::BuildingPlot;
use crate::limits;
use crate::simulated::{Simulated, capitalised, kilo, motion_section, seconds};
use dolmen::dynamics::HistoryMethod;
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::building::BuildingSimulation;

messages! {
    /// Heads, figures and notes of simulated buildings.
    pub(crate) enum Shown in "building-simulation" {
        Head => { en: "Simulated earthquake", ko: "지진응답 시뮬레이션" },
        Across { damper: String, along: Sentence } => {
            en: "The ground shakes across damper {damper}, which moves along {along}: this run does not show what it does; turn the motion« (--turn)».",
            ko: "지반운동이 감쇠기 {damper}의 작동 방향({along})과 직각이므로 이 해석은 그 효과를 보여 주지 않는다. 지반운동의 방향을 돌려«(--turn)» 해석한다.",
        },
        Base { x: Quantity, x_share: Quantity, x_at: Quantity, y: Quantity, y_share: Quantity, y_at: Quantity } => {
            en: "Shear in the walls of the lowest storey: along x {x} ({x_share} of the weight) at {x_at}, along y {y} ({y_share}) at {y_at}.",
            ko: "최하층 벽체의 전단력은 x 방향 {x}(전체 무게의 {x_share}, {x_at}), y 방향 {y}({y_share}, {y_at})이다.",
        },
        Torque { torque: Quantity, at: Quantity } => {
            en: "Torque there about the vertical through the centre of all mass: {torque} at {at}.",
            ko: "전체 질량중심을 지나는 연직축에 대한 비틀림 모멘트는 {torque}({at})이다.",
        },
        TopX => { en: "Displacement of the top floor along x.", ko: "최상층 x 방향 변위." },
        TopY => { en: "Displacement of the top floor along y.", ko: "최상층 y 방향 변위." },
        TopMeaning => { en: "Its centre of mass, relative to the ground.", ko: "질량중심의 지반에 대한 변위." },
        Rotation => { en: "Rotation of the top floor.", ko: "최상층의 회전." },
        RotationMeaning => {
            en: "Times the distance from the centre of mass it adds to the displacement.",
            ko: "질량중심에서의 거리를 곱한 값이 변위에 더해진다.",
        },
        BaseShear => { en: "Base shear.", ko: "밑면전단력." },
        BaseShearMeaning => { en: "What the walls of the lowest storey carry.", ko: "최하층 벽체가 부담하는 힘." },
        Strokes => { en: "Travel of the dampers.", ko: "감쇠기의 행정." },
        StrokesMeaning => {
            en: "Relative to the floor: the room that they need.",
            ko: "바닥에 대한 상대변위로서 필요한 여유 공간이다.",
        },
        Point { name: String } => { en: "Displacement of point {name}.", ko: "{name} 지점의 변위." },
        PointMeaning => { en: "Relative to the ground.", ko: "지반에 대한 값." },
        Acceleration { name: String } => { en: "Acceleration of point {name}.", ko: "{name} 지점의 가속도." },
        AccelerationMeaning => {
            en: "With that of the ground: what stands there feels it.",
            ko: "지반 가속도를 포함한 절대가속도.",
        },
        RunModes { steps: usize, step: Quantity, length: Quantity } => {
            en: "Linear, mode by mode, exact between the samples of the motion; {steps} steps of {step}, to {length}, peaks between the steps.",
            ko: "모드별 선형 해석이며 지진파 표본 사이에서 엄밀해이다. {step} 간격 {steps}단계, {length}까지 해석하였고 최댓값은 단계 사이까지 찾은 값이다.",
        },
        RunExponential { steps: usize, step: Quantity, length: Quantity } => {
            en: "Linear, by the matrix exponential, exact between the samples of the motion; {steps} steps of {step}, to {length}, peaks between the steps.",
            ko: "행렬 지수함수에 의한 선형 해석이며 지진파 표본 사이에서 엄밀해이다. {step} 간격 {steps}단계, {length}까지 해석하였고 최댓값은 단계 사이까지 찾은 값이다.",
        },
    }
}

/// The response; in full the floors, dampers and points.
pub fn building_simulation_text(simulation: &BuildingSimulation, style: TextStyle) -> String {
    let found = findings_text(&own(simulation), style);
    if !style.is_full {
        return found;
    }
    let mut document = Document::default();
    moved(&mut document, simulation);
    details(&mut document, simulation);
    found + &document_text(&document, style)
}

/// One section per simulation.
pub(crate) fn sections<'a>(simulations: &[&'a BuildingSimulation]) -> Document<'a> {
    let mut document = Document::default();
    for simulation in simulations {
        moved(&mut document, simulation);
        motion_section(&mut document, &simulation.motion);
        details(&mut document, simulation);
    }
    document
}

fn moved(document: &mut Document<'_>, simulation: &BuildingSimulation) {
    match variant(simulation) {
        Some(of) => document.heading(Simulated::Earthquake(of)),
        None => document.heading(Shown::Head),
    }
    for (_, said) in alarms(simulation) {
        document.put(Block::Warning(capitalised(said)));
    }
    document.paragraph(capitalised(of_all(simulation).1));
}

fn details<'a>(document: &mut Document<'a>, simulation: &'a BuildingSimulation) {
    document.blocks.extend(damper_table(&simulation.dampers).blocks);
    document.blocks.extend(strokes(simulation).map(Block::Table));
    for damper in simulation.across_the_motion() {
        let [cos, sin] = damper.direction.unit();
        document.note(Shown::Across {
            damper: damper.name.clone(),
            along: direction_words(sin.atan2(cos).to_degrees()),
        });
    }
    document.put(Block::Table(floors(simulation)));
    limits::section(document, &simulation.parts(), simulation.drift_limit.as_ref());
    document.put(Block::Paragraph(base(simulation)));
    for plot in BuildingPlot::all(simulation) {
        let drawn = Figure::drawn(caption(plot, simulation), move |language| {
            plot.draw(simulation, language).unwrap_or_default()
        });
        document.charted(drawn.with_series(move || plot.numbers(simulation)));
    }
    document.blocks.extend(points(simulation).map(Block::Table));
    document.note(run(simulation));
}

/// Shear and torque under the lowest floor.
fn base(simulation: &BuildingSimulation) -> Vec<Sentence> {
    let peaks = &simulation.history.peaks;
    let weight_n = simulation.building.building().mass_kg() * STANDARD_GRAVITY_M_S2;
    let [x, y] = peaks.base_shear_n;
    let most_n = x.value.abs().max(y.value.abs());
    let force = |value_n: f64| beside(value_n.abs(), most_n, kilonewtons());
    let share = |value_n: f64| beside(value_n.abs() / weight_n, most_n / weight_n, Unit::percent());
    let at = |at_s: f64| Quantity::new(at_s, Unit::si("s"), Digits::Fixed(3));
    let torque = Quantity {
        unit: kilo("N·m"),
        ..beside(peaks.base_torque_n_m.value.abs(), most_n, Unit::ratio())
    };
    vec![
        Shown::Base {
            x: force(x.value),
            x_share: share(x.value),
            x_at: at(x.at_s),
            y: force(y.value),
            y_share: share(y.value),
            y_at: at(y.at_s),
        }
        .into(),
        Shown::Torque {
            torque,
            at: at(peaks.base_torque_n_m.at_s),
        }
        .into(),
    ]
}

fn caption(plot: BuildingPlot, simulation: &BuildingSimulation) -> Vec<Sentence> {
    let point = |i: usize| simulation.points[i].name.clone();
    match plot {
        BuildingPlot::Ground => vec![Simulated::Ground.into(), Simulated::GroundMeaning.into()],
        BuildingPlot::Top(0) => vec![Shown::TopX.into(), Shown::TopMeaning.into()],
        BuildingPlot::Top(_) => vec![Shown::TopY.into(), Shown::TopMeaning.into()],
        BuildingPlot::Rotation => vec![Shown::Rotation.into(), Shown::RotationMeaning.into()],
        BuildingPlot::BaseShear => vec![Shown::BaseShear.into(), Shown::BaseShearMeaning.into()],
        BuildingPlot::Strokes => vec![Shown::Strokes.into(), Shown::StrokesMeaning.into()],
        BuildingPlot::Point(i) => vec![Shown::Point { name: point(i) }.into(), Shown::PointMeaning.into()],
        BuildingPlot::Acceleration(i) => vec![
            Shown::Acceleration { name: point(i) }.into(),
            Shown::AccelerationMeaning.into(),
        ],
    }
}

fn run(simulation: &BuildingSimulation) -> Shown {
    let history = &simulation.history;
    let steps = history.length().saturating_sub(1);
    let step = Quantity::new(history.time_step_s, Unit::si("s"), Digits::Trimmed(6));
    let length = seconds(history.time_s(steps));
    match history.method {
        HistoryMethod::ComplexModes => Shown::RunModes { steps, step, length },
        HistoryMethod::MatrixExponential => Shown::RunExponential { steps, step, length },
    }
}
