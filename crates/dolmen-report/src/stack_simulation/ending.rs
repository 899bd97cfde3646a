//! Outcome of a simulated stack, and its significance.

use crate::simulated::{Simulated, cut, milli, seconds};
use dolmen::assess::{DamageState, DamageThresholds};
use dolmen::blocks::{Outcome, StackHistory};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::stack::StackSimulation;

messages! {
    /// How a stack ended.
    pub(crate) enum Ending in "stack-simulation.ending" {
        Under { motion: String, peak: Quantity, ending: Sentence } => {
            en: "Under {motion} with a horizontal peak of {peak} (x and y together): {ending}",
            ko: "{motion}(수평 최대 {peak}, x·y 합성) 작용 시: {ending}",
        },
        UnderOne { motion: String, peak: Quantity, ending: Sentence } => {
            en: "Under {motion} with a horizontal peak of {peak}: {ending}",
            ko: "{motion}(수평 최대 {peak}) 작용 시: {ending}",
        },
        OfVariant { variant: String } => {
            en: "All of this is of the variant: {variant}.",
            ko: "모두 대안의 결과이다: {variant}.",
        },
        LoadsAct => {
            en: "The static loads of the file act all the time, as they are; they have no mass.",
            ko: "입력한 정하중은 계수 없이 전 시간 동안 작용하며 질량은 없다.",
        },
        TiltLeftOut { survey: String, tilt: String } => {
            en: "The run starts plumb: the tilt of survey {survey} ({tilt}) is not in it, and what leans falls sooner. Give the stones as they lean« (`tilt`, `offset`, `points`)».",
            ko: "이 해석은 연직 상태에서 시작하며 {survey} 조사의 실측 기울기({tilt})를 반영하지 않았다. 기울어진 구조물은 더 일찍 전도된다. 부재를 기울어진 대로 입력한다«(`tilt`, `offset`, `points`)».",
        },
        GapsOpen { widest: Sentence, joints: usize } => {
            en: "Joints drawn with a gap start open: {widest}, the widest of {joints}.",
            ko: "간격을 두고 입력한 접합면은 벌어진 상태에서 시작한다: {widest}, {joints}개 중 가장 넓은 것.",
        },
        GapsClosed { widest: Sentence, joints: usize } => {
            en: "Joints drawn with a gap are taken as closed: {widest}, the widest of {joints}.",
            ko: "간격을 두고 입력한 접합면을 닫힌 것으로 보았다: {widest}, {joints}개 중 가장 넓은 것.",
        },
        Unseen { stones: Vec<String> } => {
            en: "Rigid joints have no stiffness: with them the loss of stiffness in the beds below {stones}, which inspections found, changes nothing.",
            ko: "강체 접촉 해석에는 접합면 강성이 없으므로 점검에서 확인된 {stones} 하부 접합면의 강성 저하는 이 해석 결과에 나타나지 않는다.",
        },
        NoWind => {
            en: "The wind of the file does not blow during the motion.",
            ko: "지반운동이 작용하는 동안 입력한 풍하중은 고려하지 않았다.",
        },
        SupportsAsDrawn => {
            en: "The movement of supports in the file is not in this run: the stones are shaken as drawn, with their joints closed. Joints that a support has opened leave less.",
            ko: "입력한 지점 이동은 이 해석에 반영하지 않았다. 부재는 도면 형상 그대로, 접합면이 닫힌 상태에서 흔들린다. 지점 이동으로 벌어진 접합면이 있으면 실제 여유는 더 작다.",
        },
        Ground => { en: "ground", ko: "지반" },
        Name { name: String } => { en: "{name}", ko: "{name}" },
        And { first: Sentence, next: Sentence } => { en: "{first} {next}", ko: "{first} {next}" },
        Shifted { upper: String, lower: Sentence, slip: Quantity, left: Quantity, share: Quantity, state: usize } => {
            en: "it shifted and stood; no stone fell. Largest for the width of its joint: '{upper}' on '{lower}' slipped by up to {slip} and lies {left} from its place, {share} of the width (DS{state}).",
            ko: "붕괴 없음. 접합면 폭에 비하여 가장 크게 어긋난 곳은 ‘{lower}’ 위의 ‘{upper}’이다: 최대 {slip} 미끄러지고 {left}(접합면 폭의 {share})가 남았다(DS{state}).",
        },
        ShiftedFarther { upper: String, lower: Sentence, slip: Quantity, left: Quantity } => {
            en: "Longest: '{upper}' on '{lower}' slipped by {slip} and lies {left} from its place.",
            ko: "가장 길게 미끄러진 곳은 ‘{lower}’ 위의 ‘{upper}’이다: {slip} 미끄러지고 {left}가 남았다.",
        },
        ShiftedOpened { upper: String, lower: Sentence, least: Quantity, at: Quantity } => {
            en: "Joints opened, first '{upper}' on '{lower}' by more than {least} at {at}.",
            ko: "접합면이 벌어졌으며 {at}에 ‘{lower}’ 위의 ‘{upper}’에서 처음 {least}을(를) 넘었다.",
        },
        ShiftedRocked { upper: String, lower: Sentence, share: Quantity, state: usize } => {
            en: "Widest rocking: '{upper}' on '{lower}' turned by {share} of the angle at which what stands there overturns (DS{state}).",
            ko: "가장 크게 흔들린(로킹) 곳은 ‘{lower}’ 위의 ‘{upper}’이다: 그 상부가 전도되는 각의 {share}까지 회전하였다(DS{state}).",
        },
        Stood { least: Quantity } => {
            en: "it stood; no joint opened by more than {least}.",
            ko: "붕괴 없음. {least} 이상 벌어진 접합면이 없다.",
        },
        Slipped { least: Quantity, upper: String, lower: Sentence, slip: Quantity, state: usize } => {
            en: "it stood; no joint opened by more than {least}, but '{upper}' on '{lower}' slipped by up to {slip} (DS{state}).",
            ko: "붕괴 없음. {least} 이상 벌어진 접합면은 없으나 ‘{lower}’ 위의 ‘{upper}’이(가) 최대 {slip} 미끄러졌다(DS{state}).",
        },
        Uplifted { upper: String, lower: Sentence, least: Quantity, at: Quantity, state: usize } => {
            en: "it rocked and stood; every stone stayed up, but joints opened, first '{upper}' on '{lower}' by more than {least} at {at} (DS{state}).",
            ko: "붕괴 없음. 접합면이 벌어졌으며 {at}에 ‘{lower}’ 위의 ‘{upper}’에서 처음 {least}을(를) 넘었다(DS{state}).",
        },
        Slid { block: String, slip: Quantity, left: Quantity } => {
            en: "it slid and stood; no stone fell, but '{block}' lies {slip} from its place; from its plumb line to the edge that carries it {left} of the way at rest is left.",
            ko: "붕괴 없음. 그러나 ‘{block}’이(가) 제자리에서 {slip} 미끄러졌으며, 무게중심선에서 지지면 가장자리까지의 거리가 처음의 {left}만 남았다.",
        },
        Fell { block: String, at: Quantity, upper: String, lower: Sentence } => {
            en: "it fell; '{block}' came down, first of all, at {at}; by then '{upper}' on '{lower}' had opened or slipped farthest.",
            ko: "붕괴. {at}에 ‘{block}’이(가) 가장 먼저 쓰러지거나 떨어졌다. 이때 ‘{lower}’ 위의 ‘{upper}’이(가) 가장 크게 벌어지거나 미끄러졌다.",
        },
        Falling { at: Quantity, block: String } => {
            en: "it was falling at the end of the run, {at}; the weight of '{block}' is beyond the edge that carries it. Give a longer --duration.",
            ko: "해석이 끝난 {at}에 전도 중이다. ‘{block}’의 무게중심이 지지면 가장자리를 벗어났다. --duration을 늘려 다시 해석한다.",
        },
        StillMoving { at: Quantity, block: String, left: Quantity } => {
            en: "it still moved at the end of the run, {at}; '{block}' is not at rest, {left} of the way from its plumb line to the edge that carries it is left; whether it comes to rest is not known. Give a longer --duration.",
            ko: "해석이 끝난 {at}에도 ‘{block}’이(가) 정지하지 않아 그 뒤의 거동은 알 수 없다. 무게중심선에서 지지면 가장자리까지의 거리는 처음의 {left}이(가) 남았다. --duration을 늘려 다시 해석한다.",
        },
        NotConverged { at: Quantity, nearest: Quantity } => {
            en: "the run found no solution at {at}; no velocities obey the law of every joint, nearest {nearest}; all values are of the part before, and there is no verdict. Try half the step.",
            ko: "{at}에 접촉 조건의 해를 찾지 못하여(최소 잔차 {nearest}) 해석이 중단되었고 판정하지 않는다. 모든 값은 그때까지의 것이다. 시간 간격을 반으로 줄여 다시 해석한다.",
        },
        Diverged { at: Quantity } => {
            en: "the run diverged at {at}; nothing of it can be used. Lower the step, and report the input.",
            ko: "해석이 {at}에 발산하여 결과를 사용할 수 없다. 시간 간격을 줄이고, 입력 자료를 개발자에게 알려 주기 바란다.",
        },
    }
}

/// The outcome, in a sentence that begins with a small letter.
pub(super) fn ending(simulation: &StackSimulation) -> Sentence {
    match simulation.ended_before_the_motion_s() {
        Some(end_s) => cut(&simulation.motion, end_s, until_the_end(simulation)),
        None => until_the_end(simulation),
    }
}

fn until_the_end(simulation: &StackSimulation) -> Sentence {
    if let Some(said) = shifted(simulation) {
        return said;
    }
    let state = state(simulation);
    let name = |block: usize| {
        let blocks = simulation.stack.blocks();
        blocks.get(block).map_or_else(String::new, |b| b.name.clone())
    };
    let stones = |joint: usize| stones(simulation, joint);
    let whole_percent = |share: f64| Quantity::new(share, Unit::percent(), Digits::Fixed(0));
    let said = match simulation.history.outcome {
        Outcome::Stood => match simulation.slipped() {
            Some((joint, of)) => {
                let (upper, lower) = stones(joint);
                Ending::Slipped {
                    least: least(),
                    upper,
                    lower,
                    slip: tenths_mm(of.peak_slip_m),
                    state,
                }
            }
            None => Ending::Stood { least: least() },
        },
        Outcome::Uplifted { joint, at_s } => {
            let (upper, lower) = stones(joint);
            Ending::Uplifted {
                upper,
                lower,
                least: least(),
                at: seconds(at_s),
                state,
            }
        }
        Outcome::Slid {
            block,
            slip_m,
            margin_ratio,
        } => Ending::Slid {
            block: name(block),
            slip: tenths_mm(slip_m),
            left: whole_percent(margin_ratio),
        },
        Outcome::Fell { block, joint, at_s } => {
            let (upper, lower) = stones(joint);
            Ending::Fell {
                block: name(block),
                at: seconds(at_s),
                upper,
                lower,
            }
        }
        Outcome::StillMoving {
            block,
            at_s,
            margin_ratio,
        } if margin_ratio <= 0.0 => Ending::Falling {
            at: seconds(at_s),
            block: name(block),
        },
        Outcome::StillMoving {
            block,
            at_s,
            margin_ratio,
        } => Ending::StillMoving {
            at: seconds(at_s),
            block: name(block),
            left: whole_percent(margin_ratio),
        },
        Outcome::Stopped { at_s } => return Simulated::Stopped(seconds(at_s)).into(),
        Outcome::NotConverged { at_s, residual_m_s } => Ending::NotConverged {
            at: step_s(at_s),
            nearest: Quantity::new(residual_m_s, Unit::si("m/s"), Digits::Significant(2)),
        },
        Outcome::Diverged { at_s } => Ending::Diverged { at: step_s(at_s) },
    };
    said.into()
}

/// Finding that it stood with a residual offset, and whether joints also opened.
fn shifted(simulation: &StackSimulation) -> Option<Sentence> {
    let opened = match simulation.history.outcome {
        Outcome::Stood => None,
        Outcome::Uplifted { joint, at_s } => Some((joint, at_s)),
        Outcome::Slid { .. }
        | Outcome::Fell { .. }
        | Outcome::StillMoving { .. }
        | Outcome::Stopped { .. }
        | Outcome::NotConverged { .. }
        | Outcome::Diverged { .. } => return None,
    };
    let (joint, of) = simulation.shifted()?;
    let (upper, lower) = stones(simulation, joint);
    let shifted = Ending::Shifted {
        upper,
        lower,
        slip: tenths_mm(of.peak_slip_m),
        left: tenths_mm(of.residual_slip_m),
        share: Quantity::new(of.residual_slip_ratio, Unit::percent(), Digits::Fixed(1)),
        state: usize::from(of.state_by_offset(&DamageThresholds::default()).number()),
    };
    let rocked = rocked(simulation);
    let farther = simulation.slipped().filter(|(longest, _)| *longest != joint);
    let farther = farther.map(|(longest, of)| {
        let (upper, lower) = stones(simulation, longest);
        let (slip, left) = (tenths_mm(of.peak_slip_m), tenths_mm(of.residual_slip_m));
        Sentence::from(Ending::ShiftedFarther {
            upper,
            lower,
            slip,
            left,
        })
    });
    let opened = opened.map(|(first, at_s)| {
        let (upper, lower) = stones(simulation, first);
        let (least, at) = (least(), seconds(at_s));
        Sentence::from(Ending::ShiftedOpened {
            upper,
            lower,
            least,
            at,
        })
    });
    let all = rocked.into_iter().chain(farther).chain(opened);
    Some(all.fold(shifted.into(), |first, next| Ending::And { first, next }.into()))
}

/// The joint that rocked farthest, if it rocked severely.
fn rocked(simulation: &StackSimulation) -> Option<Sentence> {
    let joints = simulation.damage.joints.iter().enumerate();
    let (joint, of) = joints.max_by(|a, b| a.1.peak_rocking_ratio.total_cmp(&b.1.peak_rocking_ratio))?;
    if !of.rocked_severely(&DamageThresholds::default()) {
        return None;
    }
    let (upper, lower) = stones(simulation, joint);
    let said = Ending::ShiftedRocked {
        upper,
        lower,
        share: Quantity::new(of.peak_rocking_ratio, Unit::percent(), Digits::Fixed(0)),
        state: usize::from(DamageState::Severe.number()),
    };
    Some(said.into())
}

fn state(simulation: &StackSimulation) -> usize {
    usize::from(simulation.damage.state.number())
}

/// The stone above a joint, and the one below.
fn stones(simulation: &StackSimulation, joint: usize) -> (String, Sentence) {
    let [upper, lower] = simulation.joint_names(joint);
    (upper.to_owned(), lower_words(lower))
}

/// The part below a joint: the ground has its own word.
pub(super) fn lower_words(lower: &str) -> Sentence {
    match lower {
        "ground" => Ending::Ground.into(),
        name => name_words(name),
    }
}

/// A name that the user gave.
pub(super) fn name_words(name: &str) -> Sentence {
    Ending::Name {
        name: name.to_owned(),
    }
    .into()
}

/// The opening above which a joint is open.
fn least() -> Quantity {
    Quantity::new(StackHistory::UPLIFT_LEAST_M, milli("m"), Digits::Trimmed(2))
}

/// A length to the tenth of a millimetre.
fn tenths_mm(length_m: f64) -> Quantity {
    Quantity::new(length_m, milli("m"), Digits::Fixed(1))
}

/// A time to the tenth of a millisecond: that of a step.
fn step_s(at_s: f64) -> Quantity {
    Quantity::new(at_s, Unit::si("s"), Digits::Fixed(4))
}
