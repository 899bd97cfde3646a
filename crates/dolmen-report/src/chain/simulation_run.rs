//! The run of a simulated chain: its start, its end, and data for a second engineer to repeat and check it.

use super::simulation_ending::push;
use crate::document::{Block, Cell, Column, Document, Table};
use crate::simulated::{energy_unit, millimetres, milliradians, seconds};
use dolmen::dynamics::{ChainOutcome, ChainRotations};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::chain::ChainSimulation;

messages! {
    /// Runs of chains.
    pub(crate) enum Run in "chain.simulation.run" {
        Push(push: Quantity) => {
            en: "At the start the whole chain leans by {push}.",
            ko: "시작 시 전체가 {push} 기울어 있다.",
        },
        PushAbove { push: Quantity, name: String } => {
            en: "At the start the chain leans by {push} from ‘{name}’ up: the joints below it are taken as rigid.",
            ko: "시작 시 ‘{name}’부터 위쪽이 {push} 기울어 있다. 그 아래의 접합부는 강체로 본다.",
        },
        Stands(frequency: Quantity) => {
            en: "Upright it stands by itself: its lowest natural frequency is {frequency}.",
            ko: "연직 상태에서 스스로 안정하며 1차 고유진동수는 {frequency}이다.",
        },
        DoesNotStand(time: Quantity) => {
            en: "Upright it does not stand by itself: small leans grow by a factor of e every {time}.",
            ko: "연직 상태에서 스스로 안정하지 못하다. 작은 기울기는 {time}마다 e배로 커진다.",
        },
        Growth { from: Quantity, to: Quantity, rate: Quantity, linear: Quantity, off: Quantity } => {
            en: "The shape that falls fastest grew from 10 to 100 times the push ({from} to {to}) at a rate of {rate}; the linear equations give {linear} (difference {off}).",
            ko: "가장 빨리 전도되는 형상은 초기 기울기의 10배에서 100배까지({from}~{to}) {rate}의 속도로 커졌다. 선형 방정식의 값은 {linear}이다(차이 {off}).",
        },
        AtRest(lean: Quantity) => {
            en: "At the end it is at rest, its top link {lean} off the vertical.",
            ko: "종료 시 정지 상태이며 최상단 부재의 회전각은 {lean}이다.",
        },
        Moving(lean: Quantity) => {
            en: "At the end it is still moving, its top link {lean} off the vertical.",
            ko: "종료 시 아직 움직이고 있으며 최상단 부재의 회전각은 {lean}이다.",
        },
        Top { top: Quantity, at: Quantity } => {
            en: "The top moved {top} at most, at {at}.",
            ko: "최상단의 최대 변위는 {top}이다({at}).",
        },
        OneHeld { joints: usize, beds: Vec<Sentence> } => {
            en: "1 of {joints} joints has no bed that can open («no bed_width, or opening = \"held\"|no width of the bed, or held shut») and passes any moment here. The bed it would take, 2 M/N: {beds}.",
            ko: "접합면 {joints}개 중 1개는 벌어지지 않으며(«bed_width가 없거나 opening = \"held\"|접합면 폭이 없거나 벌어지지 않게 입력됨») 어떤 모멘트든 전달한다. 필요한 접합면 폭 2M/N: {beds}.",
        },
        Held { held: usize, joints: usize, beds: Vec<Sentence> } => {
            en: "{held} of {joints} joints have no bed that can open («no bed_width, or opening = \"held\"|no width of the bed, or held shut») and pass any moment here. The beds they would take, 2 M/N: {beds}.",
            ko: "접합면 {joints}개 중 {held}개는 벌어지지 않으며(«bed_width가 없거나 opening = \"held\"|접합면 폭이 없거나 벌어지지 않게 입력됨») 어떤 모멘트든 전달한다. 필요한 접합면 폭 2M/N: {beds}.",
        },
        Bed { name: String, width: Quantity } => { en: "‘{name}’ {width}", ko: "‘{name}’ {width}" },
        Opened(joints: Vec<Sentence>) => {
            en: "Beds opened on one side, beyond a third of the moment at their edge, below {joints}: where they are of stone, springs are softer from there on than this run takes them.",
            ko: "접합면의 모멘트가 전도 모멘트의 1/3을 넘어 한쪽이 벌어진 부재 하부: {joints}. 석재라면 이후 강성이 이 해석의 값보다 작아진다.",
        },
        Rigid { joints: Vec<Sentence>, change: Quantity } => {
            en: "Taken as rigid, being so stiff beside the others: the joints below {joints}. That changes every other natural frequency by at most {change} of it; their rotation is their moment over their stiffness.",
            ko: "다른 접합부에 비해 강성이 매우 커서 강체로 본 접합부: {joints} 하부. 이에 따른 나머지 고유진동수의 변화는 {change} 이하이며, 그 회전각은 모멘트를 강성으로 나눈 값이다.",
        },
        Below(name: String) => { en: "‘{name}’", ko: "‘{name}’" },
        Large { steps: usize, duration: Quantity } => {
            en: "Rigid links with large rotations: {duration} in {steps} steps of Taylor series, openings located between them.",
            ko: "강체 부재의 대회전 운동방정식을 테일러 급수로 {duration} 동안 {steps}단계 적분하였으며, 벌어짐 시각을 단계 사이에서 찾았다.",
        },
        Small { steps: usize, duration: Quantity } => {
            en: "Rigid links with the linear equations of small rotations, whatever size they reach: {duration} in {steps} steps of Taylor series, openings located between them.",
            ko: "강체 부재의 미소 회전 선형 운동방정식을 회전각의 크기와 관계없이 테일러 급수로 {duration} 동안 {steps}단계 적분하였으며, 벌어짐 시각을 단계 사이에서 찾았다.",
        },
        FrictionChanges(events: usize) => {
            en: "Number of changes of friction, each located: {events}.",
            ko: "마찰 상태가 바뀌는 시각도 찾았다({events}회).",
        },
        Assumed => {
            en: "A joint that opens is elastic and loses nothing as it closes; no stone slides; the axial forces are those at rest. What a fall does to the ground is not followed.",
            ko: "벌어진 접합면은 탄성으로 닫히며 충돌 손실이 없고, 부재의 미끄러짐은 없으며, 축력은 정적 상태의 값이다. 전도 이후는 추적하지 않는다.",
        },
        Energy => { en: "Balance of energy at the end.", ko: "종료 시의 에너지 수지." },
        EnergyMeaning(left: Quantity) => {
            en: "What was there at the start and was put in is the sum of the others; at most {left} of the largest energy of motion is left over.",
            ko: "초기 에너지와 입력의 합은 나머지의 합과 같아야 하며, 그 오차는 최대 운동에너지의 {left}배 이하이다.",
        },
        Input => { en: "start and input", ko: "초기·입력" },
        Kinetic => { en: "moving", ko: "운동" },
        Weight => { en: "weight", ko: "위치(중력)" },
        Springs => { en: "in springs", ko: "스프링" },
        Friction => { en: "friction", ko: "마찰 소산" },
        Dashpots => { en: "dashpots", ko: "점성 소산" },
    }
}

/// Its stability upright, the growth of a push, its position at the end.
pub(super) fn course(simulation: &ChainSimulation) -> Vec<Sentence> {
    let mut said: Vec<Run> = Vec::new();
    if simulation.push_rad != 0.0 {
        said.push(match simulation.pushed_from {
            0 => Run::Push(push(simulation)),
            link => Run::PushAbove {
                push: push(simulation),
                name: simulation.links[link].clone(),
            },
        });
    }
    said.extend(
        simulation
            .first_frequency_hz
            .map(|hz| Run::Stands(Quantity::new(hz, Unit::si("Hz"), Digits::Significant(4)))),
    );
    said.extend(growth(simulation));
    said.extend(state(simulation));
    said.push(Run::Top {
        top: millimetres(simulation.history.top_peak_m),
        at: seconds(simulation.history.top_peak_at_s),
    });
    said.into_iter().map(Sentence::from).collect()
}

fn growth(simulation: &ChainSimulation) -> Vec<Run> {
    let Some(growth) = &simulation.growth else {
        return Vec::new();
    };
    let linear = growth.linear_rate_per_s;
    let rate = |per_s: f64| Quantity::new(per_s, Unit::si("1/s"), Digits::Significant(6));
    let time = Quantity::new(1.0 / linear, Unit::si("s"), Digits::Significant(4));
    let measured = growth.measured.map(|measured| Run::Growth {
        from: seconds(measured.from_s),
        to: seconds(measured.to_s),
        rate: rate(measured.rate_per_s),
        linear: rate(linear),
        off: Quantity::new(
            measured.rate_per_s / linear - 1.0,
            Unit::percent(),
            Digits::Fixed(2),
        ),
    });
    std::iter::once(Run::DoesNotStand(time)).chain(measured).collect()
}

fn state(simulation: &ChainSimulation) -> Option<Run> {
    let history = &simulation.history;
    if matches!(
        history.outcome,
        ChainOutcome::Fell { .. } | ChainOutcome::Stopped { .. }
    ) {
        return None;
    }
    let last = history.rotation_rad.last().and_then(|row| row.last());
    let lean = milliradians(last.copied().unwrap_or_default());
    Some(match history.at_rest {
        true => Run::AtRest(lean),
        false => Run::Moving(lean),
    })
}

/// Behaviour of beds that this run does not model.
pub(super) fn bed_notes(document: &mut Document<'_>, simulation: &ChainSimulation) {
    let bed = |(joint, bed_m): &(usize, f64)| -> Sentence {
        Run::Bed {
            name: simulation.link(*joint).to_owned(),
            width: Quantity::new(*bed_m, Unit::si("m"), Digits::Significant(2)),
        }
        .into()
    };
    let held = simulation.held_joints();
    let (beds, joints) = (held.iter().map(bed).collect(), simulation.links.len());
    match held.len() {
        0 => {}
        1 => document.note(Run::OneHeld { joints, beds }),
        held => document.note(Run::Held { held, joints, beds }),
    }
    let below = |joint: &usize| -> Sentence {
        let name = simulation.link(*joint).to_owned();
        Run::Below(name).into()
    };
    let opened = simulation.opened_beds();
    if !opened.is_empty() {
        document.note(Run::Opened(opened.iter().map(below).collect()));
    }
}

/// The joints modelled as rigid, and the effect.
fn rigid(simulation: &ChainSimulation) -> Option<Run> {
    let rigid = &simulation.history.rigid_joints;
    let change_ratio = rigid.first()?.frequency_change_ratio;
    let below = rigid.iter().map(|of| {
        let name = simulation.link(of.joint).to_owned();
        Run::Below(name).into()
    });
    Some(Run::Rigid {
        joints: below.collect(),
        change: Quantity::new(change_ratio, Unit::percent(), Digits::Significant(2)),
    })
}

/// The energy balance, the steps, the assumptions.
pub(super) fn run(document: &mut Document<'_>, simulation: &ChainSimulation) {
    let history = &simulation.history;
    document.put(Block::Table(energy(simulation)));
    let (steps, duration) = (history.steps, seconds(simulation.duration_s()));
    document.note(match simulation.model.rotations() {
        ChainRotations::Large => Run::Large { steps, duration },
        ChainRotations::Small => Run::Small { steps, duration },
    });
    if let Some(rigid) = rigid(simulation) {
        document.note(rigid);
    }
    if simulation.model.has_friction() {
        document.note(Run::FrictionChanges(history.friction_events));
    }
    document.note(Run::Assumed);
}

fn energy(simulation: &ChainSimulation) -> Table {
    let end = simulation.history.energy.last().copied().unwrap_or_default();
    let parts = [
        (Run::Input, end.input_j),
        (Run::Kinetic, end.kinetic_j),
        (Run::Weight, end.gravity_j),
        (Run::Springs, end.springs_j),
        (Run::Friction, end.friction_j),
        (Run::Dashpots, end.damping_j),
    ];
    let unit = energy_unit(&parts.each_ref().map(|(_, energy_j)| *energy_j));
    let joules = |energy_j: f64| Quantity::new(energy_j, unit.clone(), Digits::Significant(4));
    let left = Quantity::ratio(simulation.history.energy_left_over_ratio, 2);
    let row = parts.iter().map(|(_, energy_j)| Cell::number(joules(*energy_j)));
    Table {
        caption: vec![Run::Energy.into(), Run::EnergyMeaning(left).into()],
        rows: vec![row.collect()],
        columns: parts.map(|(head, _)| Column::numbers(head, unit.clone())).into(),
    }
}
