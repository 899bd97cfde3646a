//! Result of the sliding model for a pile, in addition to its contact simulation.

use crate::document::{Block, Cell, Column, Document, Finding, Table, Tone};
use crate::simulated::{milli, seconds};
use dolmen::blocks::SlidingOutcome;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::stack::{SlidingMode, SlidingRun, StackRuns, StackSimulation};

messages! {
    /// The sliding model.
    pub(crate) enum Slid in "stack-simulation.sliding" {
        Stuck => {
            en: "Sliding model (blocks slide and twist, and do not rock): no bed lets go, every block moves with the ground.",
            ko: "미끄러짐 모델(블록은 미끄러지고 비틀리며 흔들리지 않음): 미끄러진 접합면 없이 모든 블록이 지반과 함께 움직인다.",
        },
        Moved { moved: usize, beds: usize, upper: String, slip: Quantity, left: Quantity, turn: Quantity, beside: Quantity } => {
            en: "Sliding model (blocks slide and twist, and do not rock): {moved} of {beds} beds let go, the one below ‘{upper}’ most: slip up to {slip}, {left} left, turn up to {turn}; the simulation by contact has a slip of {beside} there.",
            ko: "미끄러짐 모델(블록은 미끄러지고 비틀리며 흔들리지 않음): 접합면 {beds}개 중 {moved}개가 미끄러졌고 ‘{upper}’ 아래가 가장 크다. 최대 미끄러짐 {slip}, 잔류 {left}, 최대 회전각 {turn}이며 접촉 해석의 미끄러짐은 {beside}이다.",
        },
        Rocks { upper: String, at: Quantity } => {
            en: "The sliding model does not hold here: at {at} the pressure leaves an edge of the bed below ‘{upper}’, which begins to rock. Read the simulation by contact.",
            ko: "미끄러짐 모델을 적용할 수 없다. {at}에 ‘{upper}’ 하부 접합면의 가장자리에서 압력이 없어져 흔들림(로킹)이 시작된다. 접촉 해석 결과를 쓴다.",
        },
        Jumps { at: Quantity } => {
            en: "The sliding model ends at {at}: the ground falls away faster than the blocks (jump mode). Read the simulation by contact.",
            ko: "미끄러짐 모델은 {at}에 끝난다. 지반이 블록보다 빨리 내려간다(도약 모드). 접촉 해석 결과를 쓴다.",
        },
        Stopped { at: Quantity } => {
            en: "The run of the sliding model was stopped at {at}.",
            ko: "미끄러짐 모델 해석이 {at}에 중단되었다.",
        },
        Caption => { en: "Beds by the sliding model, lowest first.", ko: "미끄러짐 모델의 접합면별 결과, 아래에서부터." },
        Meaning => {
            en: "Modes of Hwang and Kim (2002); each bed against the block below it.",
            ko: "황인섭·김재관(2002)의 거동 모드. 아래 블록에 대한 상대 운동이다.",
        },
        Until { at: Quantity } => { en: "Up to {at}, where it ended.", ko: "해석이 끝난 {at}까지의 값이다." },
        Bed => { en: "Bed below", ko: "접합면(위 블록)" },
        Name { name: String } => { en: "{name}", ko: "{name}" },
        Friction => { en: "μ", ko: "μ" },
        Mode => { en: "mode", ko: "모드" },
        Stick => { en: "stick", ko: "고착" },
        Slide => { en: "slide", ko: "미끄러짐" },
        Twist => { en: "twist", ko: "비틀림" },
        SlideTwist => { en: "slide, twist", ko: "미끄러짐·비틀림" },
        Slip => { en: "slip", ko: "미끄러짐" },
        SlipLeft => { en: "slip left", ko: "잔류 미끄러짐" },
        Turn => { en: "turn", ko: "회전각" },
        Moving => { en: "moving", ko: "운동 시간" },
    }
}

/// Its finding, if it was run.
pub(super) fn finding(runs: &StackRuns) -> Option<Finding> {
    let run = runs.sliding.as_ref()?;
    let simulation = &runs.deciding;
    let upper = |joint: usize| simulation.joint_names(joint)[0].to_owned();
    let (tone, said) = match run.history.outcome {
        SlidingOutcome::Rocks { joint, at_s } => (
            Tone::Unknown,
            Slid::Rocks {
                upper: upper(joint),
                at: seconds(at_s),
            },
        ),
        SlidingOutcome::LeftTheGround { at_s } => (Tone::Unknown, Slid::Jumps { at: seconds(at_s) }),
        SlidingOutcome::Stopped { at_s } => (Tone::Unknown, Slid::Stopped { at: seconds(at_s) }),
        SlidingOutcome::Stuck | SlidingOutcome::Slid => match run.farthest() {
            None => (Tone::Plain, Slid::Stuck),
            Some(joint) => (Tone::Plain, moved(run, simulation, joint, upper(joint))),
        },
    };
    Some(Finding::key(tone, said))
}

fn moved(run: &SlidingRun, simulation: &StackSimulation, joint: usize, upper: String) -> Slid {
    let of = &run.history.joints[joint];
    let beside_m = simulation
        .history
        .joints
        .get(joint)
        .map_or(0.0, |joint| joint.peak_slip_m);
    Slid::Moved {
        moved: run.moved(),
        beds: run.history.joints.len(),
        upper,
        slip: significant(of.peak_slip_m, "m"),
        left: significant(of.residual_slip_m(), "m"),
        turn: Quantity::new(of.peak_yaw_rad, milli("rad"), Digits::Fixed(3)),
        beside: significant(beside_m, "m"),
    }
}

fn significant(value: f64, unit: &str) -> Quantity {
    Quantity::new(value, milli(unit), Digits::Significant(3))
}

/// Every bed, if it was run.
pub(super) fn section(document: &mut Document<'_>, runs: &StackRuns) {
    let Some(run) = &runs.sliding else { return };
    if let Some(found) = finding(runs) {
        document.put(Block::Paragraph(vec![found.sentence]));
    }
    let joints = runs.deciding.stack.joints().iter().enumerate();
    let row = |(i, joint): (usize, &dolmen::structure::stack::Joint)| {
        let of = &run.history.joints[i];
        let [upper, _] = runs.deciding.joint_names(i);
        let fixed =
            |value: f64, unit: &str| Cell::number(Quantity::new(value, milli(unit), Digits::Fixed(3)));
        vec![
            Cell::words(Slid::Name {
                name: upper.to_owned(),
            }),
            Cell::number(Quantity::ratio(joint.material.friction_static, 3)),
            Cell::words(mode(run.mode(i))),
            fixed(of.peak_slip_m, "m"),
            fixed(of.residual_slip_m(), "m"),
            fixed(of.peak_yaw_rad, "rad"),
            Cell::number(Quantity::new(run.moving_s(i), Unit::si("s"), Digits::Fixed(2))),
        ]
    };
    let mut caption: Vec<Sentence> = vec![Slid::Caption.into(), Slid::Meaning.into()];
    if !run.is_whole() {
        let at_s = run.history.time_s.last().copied().unwrap_or_default();
        caption.push(Slid::Until { at: seconds(at_s) }.into());
    }
    let rows = joints.take(run.history.joints.len()).map(row).collect();
    document.put(Block::Table(Table {
        caption,
        columns: vec![
            Column::words(Slid::Bed),
            Column::numbers(Slid::Friction, Unit::ratio()),
            Column::words(Slid::Mode),
            Column::numbers(Slid::Slip, milli("m")),
            Column::numbers(Slid::SlipLeft, milli("m")),
            Column::numbers(Slid::Turn, milli("rad")),
            Column::numbers(Slid::Moving, Unit::si("s")),
        ],
        rows,
    }));
}

fn mode(mode: SlidingMode) -> Slid {
    match mode {
        SlidingMode::Stick => Slid::Stick,
        SlidingMode::Slide => Slid::Slide,
        SlidingMode::Twist => Slid::Twist,
        SlidingMode::SlideTwist => Slid::SlideTwist,
    }
}
