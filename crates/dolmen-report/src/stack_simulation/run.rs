//! The run itself: data for a second engineer to repeat and check it.

use crate::document::{Block, Cell, Document};
use crate::simulated::{milli, seconds};
use dolmen::blocks::{ContactLaw, ContactRule, RigidEvidence, StackHistory};
use dolmen::structure::stack::Stack;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::stack::StackSimulation;

/// Height by which the input energy could lift a structure, up to which fractions of that energy are meaningless. Our choice.
const LIFT_LEAST_M: f64 = 1e-6;
/// Largest share of the input energy that contacts may create without a fault: that of the engine's own tests.
const ENERGY_MADE_MOST: f64 = 1e-3;
/// Residual above which solutions are inaccurate, m/s: as in the engine.
const LOOSE_M_S: f64 = 1e-6;
/// Digits of steps and residuals.
const DIGITS: usize = 3;

messages! {
    /// The run of a stack.
    pub(crate) enum Run in "stack-simulation.run" {
        Springs { side: usize, same: usize, points: usize, steps: usize, step: Quantity, longest: Quantity, length: Quantity } => {
            en: "Springs at {side} × {same} points of each joint, {points} in all; {steps} steps of {step} (longest stable {longest}), {length} in all.",
            ko: "접합면마다 {side} × {same}점 스프링(모두 {points}점), 시간 간격 {step}(안정 한계 {longest}), {steps}단계, 해석 시간 {length}.",
        },
        Rigid { side: usize, same: usize, points: usize, steps: usize, step: Quantity, length: Quantity } => {
            en: "Rigid contact at {side} × {same} points of each joint, {points} in all; {steps} steps of {step}, {length} in all.",
            ko: "접합면마다 {side} × {same}점 강체 접촉(모두 {points}점), 시간 간격 {step}, {steps}단계, 해석 시간 {length}.",
        },
        SpringsEnergy { input: Quantity, taken: Quantity, made: Quantity } => {
            en: "The ground put in {input}; friction and dashpots took {taken}; contacts made {made} of the most put in.",
            ko: "지반이 한 일 {input}, 마찰과 감쇠로 소산 {taken}; 접촉에서 생겨난 에너지 {made}.",
        },
        RigidEnergy { input: Quantity, taken: Quantity, made: Quantity } => {
            en: "The ground put in {input}; friction and impacts took {taken}; contacts made {made} of the most put in.",
            ko: "지반이 한 일 {input}, 마찰과 충돌로 소산 {taken}; 접촉에서 생겨난 에너지 {made}.",
        },
        MadeTooMuch { made: Quantity, limit: Quantity } => {
            en: "Contacts made {made} of the most energy put in, more than {limit}: do not use this run, try half the step.",
            ko: "접촉에서 생겨난 에너지가 지반이 한 일의 최댓값의 {made}(으)로 허용값 {limit}을(를) 넘는다. 이 해석 결과는 쓰지 말고 시간 간격을 반으로 줄여 다시 해석한다.",
        },
        RestitutionUnused => {
            en: "«rocking_restitution|The rocking restitution» is not used by contact springs, whose rocking loses what their stiffness and «damping_ratio|damping» make of it; rigid joints use it.",
            ko: "로킹 반발계수«(rocking_restitution)»는 접촉 스프링 해석에 쓰이지 않는다. 로킹의 에너지 손실은 접촉 스프링의 강성과 «damping_ratio|감쇠비»에 따르며, 로킹 반발계수는 강체 접촉 해석에서 쓰인다.",
        },
        SoilLeftOut => {
            en: "The soil is in the springs, not in the rigid law, whose ground gives nothing.",
            ko: "지반(soil)은 접촉 스프링 해석에만 반영되며, 강체 접촉 해석에서는 지반이 변형하지 않는 것으로 본다.",
        },
        RocksOnMore { upper: String, given: Quantity, edge: Quantity } => {
            en: "«rocking_restitution|A rocking restitution of» {given} below '{upper}' is more than the {edge} that an impact at the far edge leaves a stone so slender (Housner): only a measurement can tell.",
            ko: "‘{upper}’ 하부 접합면의 «rocking_restitution|로킹 반발계수» {given}은(는) 이만한 세장비의 부재가 반대쪽 모서리에 부딪힐 때 남는 값 {edge}(Housner)보다 크다. 실측값일 때만 쓴다.",
        },
        OneCase => {
            en: "A stack that rocks is sensitive to every input: one run is one case, not a probability.",
            ko: "로킹하는 적층 구조는 모든 입력에 민감하다. 한 번의 해석은 하나의 사례일 뿐 확률이 아니다.",
        },
        OneCaseOfMany => {
            en: "A stack that rocks is sensitive to every input: one run is one case. --repeats 8 repeats it with differences that nobody can measure and takes the worst.",
            ko: "로킹하는 적층 구조는 모든 입력에 민감하여 한 번의 해석은 하나의 사례일 뿐이다. --repeats 8을 주면 잴 수 없는 작은 차이를 주어 반복하고 가장 나쁜 결과를 택한다.",
        },
        Top { name: String, peak: Quantity, left: Quantity } => {
            en: "The highest stone, '{name}', moved by up to {peak} against the ground, {left} when the run ended.",
            ko: "최상부 부재 ‘{name}’의 지반에 대한 수평 변위는 최대 {peak}, 해석 종료 시 {left}이다.",
        },
        Settled { by: Quantity } => {
            en: "Before the motion the highest stone settled by {by} on the springs.",
            ko: "지반운동 작용 전에 최상부 부재는 접촉 스프링 위에서 자중으로 {by} 내려앉았다.",
        },
        Impacts { impacts: usize, resting: usize, residual: Quantity, depth: Quantity } => {
            en: "Impacts: {impacts}; steps at rest on the ground: {resting}. Every joint obeys its law to {residual}, and no stone lies deeper than {depth} in another.",
            ko: "충돌 {impacts}회, 지반에 대하여 정지한 단계 {resting}개. 모든 접합면이 접촉 조건을 {residual} 이내로 만족하며, 부재가 서로 겹친 깊이는 최대 {depth}이다.",
        },
        Loose { loose: usize, solutions: usize, limit: Quantity, halvings: usize } => {
            en: "Solutions farther than {limit} from the law: {loose} of {solutions}; times a step was halved to find one: {halvings}.",
            ko: "접촉 조건의 잔차가 {limit}을(를) 넘는 해: {solutions}개 중 {loose}개. 해를 찾으려고 시간 간격을 반으로 나눈 횟수: {halvings}회.",
        },
        BrokenTies { ties: Vec<usize> } => {
            en: "Broken ties, by number: {ties}.",
            ko: "끊어진 연결재(번호): {ties}.",
        },
        Balance => { en: "Balance of energy", ko: "에너지 수지" },
        PutIn => { en: "put in by the ground", ko: "지반이 한 일" },
        Moving => { en: "in motion at the end", ko: "종료 시 운동에너지" },
        Raised => { en: "in raised stones", ko: "위치에너지 증가" },
        Stored => { en: "in springs", ko: "스프링 변형에너지" },
        Friction => { en: "taken by friction", ko: "마찰 소산" },
        Dashpots => { en: "taken by dashpots", ko: "감쇠 소산" },
        TakenByImpacts => { en: "taken by impacts, small ones of a step included", ko: "충돌 소산(한 단계 안의 작은 충돌 포함)" },
        LeftOver => { en: "left over, of the most put in", ko: "수지 오차(지반이 한 일의 최댓값 대비)" },
        Made => { en: "made by contacts, of the most put in", ko: "접촉에서 생겨난 에너지(지반이 한 일의 최댓값 대비)" },
    }
}

/// A warning if contacts created too much energy.
pub(super) fn made_too_much(simulation: &StackSimulation) -> Option<Run> {
    made_in(&simulation.stack, &simulation.history)
}

/// The same for any run of a stack.
pub(super) fn made_in(stack: &Stack, history: &StackHistory) -> Option<Run> {
    let made = history.energy_made_ratio();
    let weight_n = stack.mass_kg() * stack.gravity_m_s2();
    let is_tiny = history.energy_made_j <= weight_n * LIFT_LEAST_M;
    (made > ENERGY_MADE_MOST && !is_tiny).then(|| Run::MadeTooMuch {
        made: Quantity::percent(made, 2),
        limit: Quantity::new(ENERGY_MADE_MOST, Unit::percent(), Digits::Trimmed(2)),
    })
}

/// Contact points along one side of a quadrilateral joint.
pub(crate) fn points_a_side(rule: ContactRule) -> usize {
    match rule {
        ContactRule::Corners => 2,
        ContactRule::Three => 3,
        ContactRule::Four => 4,
        ContactRule::Six => 6,
    }
}

/// Displacement of the highest stone.
pub(super) fn top(simulation: &StackSimulation) -> Run {
    let block = simulation.highest_block();
    let moved = simulation.displacement_m(block);
    let far = |d: &[f64; 3]| d[0].hypot(d[1]);
    let mm = |length_m: f64| Quantity::new(length_m, milli("m"), Digits::Significant(4));
    let own = simulation.stack.blocks().get(block);
    Run::Top {
        name: own.map_or_else(String::new, |b| b.name.clone()),
        peak: mm(moved.iter().map(far).fold(0.0, f64::max)),
        left: mm(moved.last().map_or(0.0, far)),
    }
}

/// Steps, contact points, the energy balance, and their accuracy.
pub(super) fn section(document: &mut Document<'_>, simulation: &StackSimulation) {
    document.subheading(Run::Balance);
    document.put(Block::KeyValues(balance(simulation)));
    if let Some(said) = made_too_much(simulation) {
        document.put(Block::Warning(said.into()));
    }
    document.note(steps(simulation));
    document.note(energy(simulation));
    let history = &simulation.history;
    match &history.rigid {
        Some(rigid) => solutions(document, rigid),
        None => document.note(Run::Settled {
            by: Quantity::new(history.settlement_m, milli("m"), Digits::Fixed(4)),
        }),
    }
    if !history.broken_ties.is_empty() {
        document.note(Run::BrokenTies {
            ties: history.broken_ties.iter().map(|tie| tie + 1).collect(),
        });
    }
    document.note(Run::OneCase);
}

fn steps(simulation: &StackSimulation) -> Run {
    let history = &simulation.history;
    let side = points_a_side(simulation.law.contact_rule());
    let short_s = |time_s: f64| Quantity::new(time_s, Unit::si("s"), Digits::Significant(DIGITS));
    let (points, steps) = (history.contact_points, history.steps);
    let step = short_s(history.time_step_s);
    let length = seconds(history.time_s.last().copied().unwrap_or_default());
    match &simulation.law {
        ContactLaw::Springs(_) => Run::Springs {
            side,
            same: side,
            points,
            steps,
            step,
            longest: short_s(history.longest_step_s),
            length,
        },
        ContactLaw::Rigid(_) => Run::Rigid {
            side,
            same: side,
            points,
            steps,
            step,
            length,
        },
    }
}

fn energy(simulation: &StackSimulation) -> Run {
    let history = &simulation.history;
    let end = history.energy.last().copied().unwrap_or_default();
    let joules = |value: f64| Quantity::new(value, Unit::si("J"), Digits::Significant(DIGITS));
    let (input, taken) = (joules(end.input_j), joules(end.friction_j + end.damping_j));
    let made = Quantity::percent(history.energy_made_ratio(), 2);
    match &simulation.law {
        ContactLaw::Springs(_) => Run::SpringsEnergy { input, taken, made },
        ContactLaw::Rigid(_) => Run::RigidEnergy { input, taken, made },
    }
}

fn balance(simulation: &StackSimulation) -> Vec<(Sentence, Cell)> {
    let history = &simulation.history;
    let end = history.energy.last().copied().unwrap_or_default();
    let start = history.energy.first().copied().unwrap_or_default();
    let moving = end.kinetic_j - start.kinetic_j;
    let raised = end.potential_j - start.potential_j;
    let spent = moving + raised + end.stored_j + end.friction_j + end.damping_j + end.clipping_j;
    let most = history.energy.iter().map(|e| e.input_j.abs()).fold(0.0, f64::max);
    let left_over = match most > 0.0 {
        true => (end.input_j - spent) / most,
        false => 0.0,
    };
    // sums of many steps keep nine digits
    let left_over = if left_over.abs() < 1e-9 { 0.0 } else { left_over };
    let lost_in = match &simulation.law {
        ContactLaw::Springs(_) => Run::Dashpots,
        ContactLaw::Rigid(_) => Run::TakenByImpacts,
    };
    let energies = [
        (Run::PutIn, end.input_j),
        (Run::Moving, moving),
        (Run::Raised, raised),
        (Run::Stored, end.stored_j),
        (Run::Friction, end.friction_j),
        (lost_in, end.damping_j),
    ];
    let each = energies.into_iter().map(|(what, value)| {
        let energy = Quantity::new(value, Unit::si("J"), Digits::Significant(4));
        (what.into(), Cell::number(energy))
    });
    let shares = [
        (Run::LeftOver, left_over),
        (Run::Made, history.energy_made_ratio()),
    ];
    let share = |(what, value): (Run, f64)| (what.into(), Cell::number(Quantity::percent(value, 2)));
    each.chain(shares.into_iter().map(share)).collect()
}

/// Residuals of the rigid contact law.
fn solutions(document: &mut Document<'_>, rigid: &RigidEvidence) {
    let short = |value: f64, unit: &str| Quantity::new(value, Unit::si(unit), Digits::Significant(2));
    document.note(Run::Impacts {
        impacts: rigid.impacts,
        resting: rigid.steps_at_rest,
        residual: short(rigid.residual_most_m_s, "m/s"),
        depth: short(rigid.penetration_most_m, "m"),
    });
    if rigid.loose_solutions + rigid.halvings > 0 {
        document.note(Run::Loose {
            loose: rigid.loose_solutions,
            solutions: rigid.solutions,
            limit: Quantity::new(LOOSE_M_S, Unit::si("m/s"), Digits::Significant(1)),
            halvings: rigid.halvings,
        });
    }
}
