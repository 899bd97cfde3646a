//! The run of a simulated frame: data for a second engineer to repeat and check it.

use crate::document::{Block, Cell, Column, Document, Table};
use crate::simulated::{energy_unit, seconds};
use dolmen_words::{Digits, Quantity, messages};
use dolmen_work::frame::FrameSimulation;

messages! {
    /// Runs of frames.
    pub(crate) enum Run in "frame.simulation.run" {
        Energy => { en: "Balance of energy at the end.", ko: "종료 시의 에너지 수지." },
        EnergyMeaning { left: Quantity } => {
            en: "What the ground put in is the sum of the others; at most {left} of it is left over.",
            ko: "지반이 한 일은 나머지의 합과 같아야 하며, 그 오차는 지반이 한 일의 {left}배 이하이다.",
        },
        Input => { en: "put in", ko: "입력" },
        Kinetic => { en: "moving", ko: "운동" },
        Springs => { en: "in springs", ko: "스프링" },
        Friction => { en: "friction", ko: "마찰 소산" },
        Crushing => { en: "crushed tenons", ko: "장부 압괴" },
        Dashpots => { en: "dashpots", ko: "점성 소산" },
        Exact { events: usize, series: usize, duration: Quantity } => {
            en: "Exact between the changes from sticking to slipping or back, each located, {events} in number: {duration} in {series} Taylor series.",
            ko: "고착·미끄러짐이 바뀌는 {events}개 시각을 찾아 그 사이를 엄밀해로 계산하였다({duration}, 테일러 급수 {series}개).",
        },
        NoEvents { series: usize, duration: Quantity } => {
            en: "Exact, without a change from sticking to slipping or back: {duration} in {series} Taylor series.",
            ko: "고착·미끄러짐의 변화가 없으므로 전 구간을 엄밀해로 계산하였다({duration}, 테일러 급수 {series}개).",
        },
        Stepped { steps: usize, duration: Quantity, events: usize } => {
            en: "Both directions in equal steps, since they share friction: {duration} in {steps} steps, springs, dashpots and inertia by the trapezoidal rule, friction at the end of each step; changes between sticking and slipping: {events}.",
            ko: "두 방향이 마찰을 나누어 쓰므로 같은 시간 간격으로 함께 적분하였다({duration}, {steps}단계). 스프링·감쇠·관성은 사다리꼴 법칙, 마찰은 각 단계의 끝에서 계산하였다. 고착·미끄러짐이 바뀐 횟수: {events}.",
        },
        Assumed => {
            en: "Springs are linear, drifts small, axial forces those at rest. Coefficients of friction are rarely measured: look at several.",
            ko: "강성은 선형, 변형은 미소, 축력은 정적 상태의 값이다. 마찰계수는 대개 측정되지 않으므로 여러 값을 검토한다.",
        },
    }
}

/// The energy balance, the events, the assumptions.
pub(super) fn run(document: &mut Document<'_>, simulation: &FrameSimulation) {
    let history = &simulation.history;
    document.put(Block::Table(energy(simulation)));
    let duration = seconds(history.time_s.last().copied().unwrap_or_default());
    let shared = simulation.together.as_ref().and_then(|together| together.shared);
    document.note(match (history.events, history.steps) {
        (events, steps) if shared.is_some() => Run::Stepped {
            steps,
            duration,
            events,
        },
        (0, series) => Run::NoEvents { series, duration },
        (events, series) => Run::Exact {
            events,
            series,
            duration,
        },
    });
    document.note(Run::Assumed);
}

fn energy(simulation: &FrameSimulation) -> Table {
    let end = simulation.history.energy.last().copied().unwrap_or_default();
    let mut parts = vec![
        (Run::Input, end.input_j),
        (Run::Kinetic, end.kinetic_j),
        (Run::Springs, end.stored_j),
        (Run::Friction, end.friction_j),
    ];
    let has_tenons = simulation.frame.tenons().iter().any(Option::is_some);
    parts.extend(has_tenons.then_some((Run::Crushing, end.crushing_j)));
    parts.push((Run::Dashpots, end.damping_j));
    let unit = energy_unit(&parts.iter().map(|(_, energy_j)| *energy_j).collect::<Vec<f64>>());
    let joules = |energy_j: f64| Quantity::new(energy_j, unit.clone(), Digits::Significant(4));
    let left = Quantity::ratio(simulation.history.energy_left_over_ratio(), 2);
    let row = parts.iter().map(|(_, energy_j)| Cell::number(joules(*energy_j)));
    Table {
        caption: vec![Run::Energy.into(), Run::EnergyMeaning { left }.into()],
        rows: vec![row.collect()],
        columns: parts
            .into_iter()
            .map(|(head, _)| Column::numbers(head, unit.clone()))
            .collect(),
    }
}
