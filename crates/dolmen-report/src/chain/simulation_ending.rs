//! How simulated chains ended.

use super::side_supports::met;
use crate::document::{Finding, Tone};
use crate::simulated::{
    Simulated, capitalised, cut, kilo, millimetres, milliradians, seconds, undamped, under, version_name,
    vertical_peak,
};
use dolmen::dynamics::ChainOutcome;
use dolmen_project::ChainAxis;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::chain::ChainSimulation;

messages! {
    /// How a chain ended.
    pub(crate) enum Ending in "chain.simulation.ending" {
        Pushed { of: Sentence, push: Quantity, ending: Sentence } => {
            en: "{of}, leaning by {push} at the start: {ending}",
            ko: "{of}, 초기 기울기 {push}: {ending}",
        },
        PushedAbove { of: Sentence, push: Quantity, name: String, ending: Sentence } => {
            en: "{of}, leaning by {push} at the start from ‘{name}’ up, since the joints below it are taken as rigid: {ending}",
            ko: "{of}, ‘{name}’ 아래의 접합부는 강체로 보아 그 위로만 초기 기울기 {push}: {ending}",
        },
        Direction { of: Sentence, direction: String } => { en: "{of}, direction {direction}", ko: "{of}, {direction} 방향" },
        Together { lean: Quantity, name: String, at: Quantity, top: Quantity } => {
            en: "Both directions together, at the samples: ‘{name}’ leans by up to {lean} at {at}, the top moves {top}.",
            ko: "두 방향을 합하면(표본 기준) 최대 회전각은 ‘{name}’의 {lean}({at}), 최상단 변위는 {top}이다.",
        },
        LeansTowards { survey: String, tilt: String, direction: String, lean: Quantity } => {
            en: "It leans as survey {survey} found it, tilt {tilt}: {lean} in direction {direction}«; as_surveyed = \"none\" leaves that out».",
            ko: "{survey} 조사의 실측 기울기 {tilt}을(를) 반영하였다. {direction} 방향으로 {lean}이다.« 제외하려면 as_surveyed = \"none\"으로 한다.»",
        },
        Stood { how: Sentence, lean: Quantity, top: Quantity } => {
            en: "it stands and {how}; links lean by up to {lean}, the top moves {top}.",
            ko: "전도되지 않으며 {how}. 최대 회전각 {lean}, 최상단 변위 {top}.",
        },
        NoEdge => { en: "no bed comes to its edge", ko: "합력이 밑면 끝에 이르는 접합면은 없다" },
        AllHeld => {
            en: "its joints were taken as unable to open («no bed_width is given, or opening = \"held\"|no width of the bed is given, or it is held shut»)",
            ko: "접합면이 벌어지지 않는 것으로 가정하였다(«bed_width가 없거나 opening = \"held\"|접합면 폭이 없거나 벌어지지 않게 입력됨»)",
        },
        SomeHeld { held: usize, joints: usize } => {
            en: "no bed that can open comes to its edge (taken as unable to open: {held} of {joints} joints)",
            ko: "벌어질 수 있는 접합면 중 합력이 밑면 끝에 이르는 것은 없다(접합면 {joints}개 중 {held}개는 벌어지지 않는 것으로 가정)",
        },
        Opened { name: String, at: Quantity, lean: Quantity, top: Quantity } => {
            en: "it stands, but beds come to their edge, the one below ‘{name}’ first, at {at}; links lean by up to {lean}, the top moves {top}.",
            ko: "전도되지 않으나 접합면이 벌어진다. ‘{name}’ 하부가 {at}에 처음 벌어지고, 최대 회전각 {lean}, 최상단 변위 {top}.",
        },
        Fell { name: String, angle: Quantity, at: Quantity } => {
            en: "it falls: ‘{name}’ leaned by {angle}° at {at}.",
            ko: "전도된다. ‘{name}’의 회전각이 {at}에 {angle}°를 넘는다.",
        },
        StillLeaning { name: String, at: Quantity } => {
            en: "no verdict: when the run ended, at {at}, ‘{name}’ leaned further out than in the time before and went on; it has to be followed for longer.",
            ko: "판정 불가: 해석이 끝난 {at}에 ‘{name}’의 회전각이 계속 커지고 있었다. 더 오래 해석해야 한다.",
        },
        LeaningWhenCut(name: String) => {
            en: "‘{name}’ leaned further out than in the time before and went on.",
            ko: "‘{name}’의 회전각이 계속 커지고 있었다.",
        },
        BeyondSmall { name: String, rotation: Quantity, most: Quantity } => {
            en: "‘{name}’ leaned by {rotation}, beyond the {most} up to which the equations of small rotations hold: counted as fallen; --rotations large follows it.",
            ko: "‘{name}’의 회전각이 {rotation}(으)로, 소회전 방정식의 범위 {most}을(를) 넘어 전도로 본다. --rotations large로 다시 해석한다.",
        },
        Leans { survey: String, tilt: String, lean: Quantity } => {
            en: "It leans as survey {survey} found it, tilt {tilt}, in the plane of the motion by all directions together: {lean}«; as_surveyed = \"none\" leaves that out».",
            ko: "{survey} 조사의 실측 기울기 {tilt}을(를) 반영하였다. 방향별 값을 합성하여 지반운동 방향으로 {lean} 기운 것으로 보았다.« 제외하려면 as_surveyed = \"none\"으로 한다.»",
        },
        TiltLeftOut { survey: String, tilt: String } => {
            en: "The run starts plumb: the tilt of survey {survey} ({tilt}) is not in it, and what leans falls sooner.« as_surveyed = \"{survey}\" takes it over.»",
            ko: "이 해석은 연직 상태에서 시작하며 {survey} 조사의 실측 기울기({tilt})를 반영하지 않았다. 기울어진 구조물은 더 일찍 전도된다.« 반영하려면 as_surveyed = \"{survey}\"(으)로 한다.»",
        },
        Carries(weight: Quantity) => {
            en: "It carries the weight of its static loads, {weight}, which swings with it.",
            ko: "정하중의 중량 {weight}이(가) 함께 진동하는 것으로 해석하였다.",
        },
        ForcesLeftOut => {
            en: "Forces and moments of static loads and the wind of the file do not act in this run: «`dolmen check`|the check of stability» judges them.",
            ko: "이 해석에는 정하중의 힘·모멘트와 바람을 반영하지 않았다. «`dolmen check`|안정성 검토»에서 판정한다.",
        },
        FrictionBeyondBed { name: String, moment: Quantity, most: Quantity } => {
            en: "Spring and friction below ‘{name}’ pass {moment}, more than the {most} at which its bed stands on its edge: unless posts or dowels beside the bed take the difference, it opens, and this run does not follow that.",
            ko: "‘{name}’ 하부의 스프링과 마찰이 전달하는 모멘트 {moment}이(가) 합력이 밑면 끝에 이르는 모멘트 {most}보다 크다. 지주나 촉이 그 차이를 부담하지 않으면 접합면이 벌어지며, 이 해석은 그 거동을 추적하지 못한다.",
        },
        VerticalLeftOut(peak: Quantity) => {
            en: "The vertical component of the motion, z, with a peak of {peak}, does not act: a chain turns in one plane, and its beds bear what they bear at rest. Shaking upwards takes from that.",
            ko: "지반운동의 연직 성분 z(최대 {peak})는 작용하지 않는다. 체인 모델은 한 평면에서 회전하며 접합면의 축력은 정적 상태의 값이다. 연직 진동은 그 축력을 줄일 수 있다.",
        },
        WordStood => { en: "stood", ko: "안정 유지" },
        WordOpened => { en: "joints opened", ko: "접합면 벌어짐" },
        WordFell => { en: "fell", ko: "전도" },
        WordLeaning => { en: "still leaning: no verdict", ko: "회전 진행 중, 판정 불가" },
        WordCut => { en: "ended before the motion: no verdict", ko: "지반운동보다 먼저 종료, 판정 불가" },
        WordStopped => { en: "stopped: no verdict", ko: "중단, 판정 불가" },
    }
}

/// How each ended, as findings.
pub(crate) fn simulation_findings(simulations: &[&ChainSimulation]) -> Vec<Finding> {
    let each = simulations.iter();
    each.flat_map(|simulation| {
        let without = undamped(simulation.undamped.as_ref());
        let first = [finding(simulation)].into_iter();
        first
            .chain(beyond_bed(simulation))
            .chain(together(simulation))
            .chain(without)
            .chain(beyond_small(simulation))
            .chain(leans(simulation))
            .chain(tilt_left_out(simulation))
            .chain(loads(simulation))
            .chain(met(simulation))
    })
    .collect()
}

/// The joint whose moment from spring and friction exceeds its bed's limit most.
pub(super) fn beyond_bed(simulation: &ChainSimulation) -> Option<Finding> {
    let beyond = simulation.parts().into_iter().filter(|part| {
        let ratio = part.ratio().unwrap_or(f64::INFINITY);
        ratio < 1.0 - 1e-9
    });
    let worst = beyond.max_by(|a, b| b.ratio().unwrap_or(0.0).total_cmp(&a.ratio().unwrap_or(0.0)))?;
    let moment = |n_m: f64| Quantity::new(n_m, kilo("N·m"), Digits::Significant(3));
    let said = Ending::FrictionBeyondBed {
        name: worst.part.name().to_owned(),
        moment: moment(worst.demand),
        most: moment(worst.capacity?),
    };
    Some(Finding::key(Tone::Bad, said))
}

/// The combined response of both directions, given once.
pub(super) fn together(simulation: &ChainSimulation) -> Option<Finding> {
    let of = simulation.together?;
    let said = Ending::Together {
        lean: milliradians(of.lean_rad),
        name: simulation.link(of.link).to_owned(),
        at: seconds(of.at_s),
        top: millimetres(of.top_m),
    };
    (simulation.direction == Some(ChainAxis::Across)).then(|| Finding::key(Tone::Plain, said))
}

/// Rotations beyond the linear equations.
pub(super) fn beyond_small(simulation: &ChainSimulation) -> Option<Finding> {
    let (link, rotation_rad) = simulation.beyond_small_rotations()?;
    let said = Ending::BeyondSmall {
        name: simulation.link(link).to_owned(),
        rotation: milliradians(rotation_rad),
        most: milliradians(ChainSimulation::SMALL_ROTATION_MOST_RAD),
    };
    Some(Finding::key(Tone::Bad, said))
}

/// The lean and its survey.
pub(super) fn leans(simulation: &ChainSimulation) -> Option<Finding> {
    let lean = simulation.lean.as_ref()?;
    let (survey, tilt) = (lean.survey.clone(), lean.written.clone());
    let said = match simulation.direction {
        None => Ending::Leans {
            survey,
            tilt,
            lean: milliradians(lean.lean_rad),
        },
        Some(axis) => Ending::LeansTowards {
            survey,
            tilt,
            direction: axis.name().to_owned(),
            lean: milliradians(lean.towards_rad(axis)),
        },
    };
    Some(Finding::key(Tone::Plain, said))
}

/// Static loads and wind that are in the run, and those that are not.
pub(super) fn loads(simulation: &ChainSimulation) -> Vec<Finding> {
    let carries = (simulation.carried_n != 0.0).then(|| {
        Ending::Carries(Quantity::new(
            simulation.carried_n,
            kilo("N"),
            Digits::Significant(3),
        ))
    });
    let left_out = simulation.loads_left_out.then_some(Ending::ForcesLeftOut);
    let carries = carries.map(|said| Finding::key(Tone::Plain, said));
    let motion = simulation.motion.as_ref();
    let vertical = motion.and_then(|(of, _)| vertical_peak(&of.motion));
    let vertical = vertical.map(Ending::VerticalLeftOut);
    let left_out = left_out.into_iter().chain(vertical);
    let left_out = left_out.map(|said| Finding::key(Tone::Warn, said));
    carries.into_iter().chain(left_out).collect()
}

pub(super) fn tilt_left_out(simulation: &ChainSimulation) -> Option<Finding> {
    let left_out = simulation.tilt_left_out.as_ref()?;
    let (survey, tilt) = (left_out.survey.clone(), left_out.written.clone());
    Some(Finding::key(Tone::Warn, Ending::TiltLeftOut { survey, tilt }))
}

/// The outcome, with the version and the motion.
pub(super) fn finding(simulation: &ChainSimulation) -> Finding {
    let (of, ended) = (title(simulation), ending(simulation));
    let said = match &simulation.motion {
        Some((motion, _)) => under(of, motion, simulation.peak_acceleration_m_s2(), ended),
        None if simulation.pushed_from > 0 => Ending::PushedAbove {
            of,
            push: push(simulation),
            name: simulation.links[simulation.pushed_from].clone(),
            ending: ended,
        }
        .into(),
        None => Ending::Pushed {
            of,
            push: push(simulation),
            ending: ended,
        }
        .into(),
    };
    Finding::key(tone(simulation), capitalised(said))
}

fn tone(simulation: &ChainSimulation) -> Tone {
    match simulation.history.outcome {
        ChainOutcome::Fell { .. } => Tone::Bad,
        ChainOutcome::StillLeaning { .. } | ChainOutcome::Stopped { .. } => Tone::Unknown,
        _ if simulation.ended_before_the_motion_s().is_some() => Tone::Unknown,
        ChainOutcome::Stood if simulation.held_joints().is_empty() => Tone::Plain,
        ChainOutcome::Stood | ChainOutcome::Uplifted { .. } => Tone::Warn,
    }
}

/// The variant, or the structure as it is.
pub(super) fn title(simulation: &ChainSimulation) -> Sentence {
    let of = version_name(simulation.variant.as_deref(), simulation.variant_title.as_ref())
        .unwrap_or_else(|| Simulated::AsItIs.into());
    match simulation.direction {
        None => of,
        Some(axis) => Ending::Direction {
            of,
            direction: axis.name().to_owned(),
        }
        .into(),
    }
}

/// The angle by which the chain leaned at the start.
pub(super) fn push(simulation: &ChainSimulation) -> Quantity {
    Quantity::new(simulation.push_rad, Unit::si("rad"), Digits::Trimmed(6))
}

/// The largest lean of any link.
pub(super) fn lean(simulation: &ChainSimulation) -> Quantity {
    let peaks = simulation.history.rotation_peaks.iter();
    milliradians(peaks.fold(0.0, |most, peak| peak.rotation_rad.abs().max(most)))
}

/// How it ended, in a sentence that begins with a small letter.
pub(super) fn ending(simulation: &ChainSimulation) -> Sentence {
    match (simulation.ended_before_the_motion_s(), &simulation.motion) {
        (Some(end_s), Some((motion, _))) => cut(motion, end_s, until_the_end(simulation)),
        _ => until_the_end(simulation),
    }
}

fn until_the_end(simulation: &ChainSimulation) -> Sentence {
    let lean = lean(simulation);
    let top = millimetres(simulation.history.top_peak_m);
    let name = |link: usize| simulation.link(link).to_owned();
    let said = match simulation.history.outcome {
        ChainOutcome::Stood => Ending::Stood {
            how: how_it_stood(simulation).into(),
            lean,
            top,
        },
        ChainOutcome::Uplifted { joint, at_s } => Ending::Opened {
            name: name(joint),
            at: seconds(at_s),
            lean,
            top,
        },
        ChainOutcome::Fell { link, at_s } => Ending::Fell {
            name: name(link),
            angle: Quantity::new(
                simulation.options.fall_rad.to_degrees(),
                Unit::ratio(),
                Digits::Trimmed(3),
            ),
            at: seconds(at_s),
        },
        ChainOutcome::StillLeaning { link, .. } if simulation.ended_before_the_motion_s().is_some() => {
            Ending::LeaningWhenCut(name(link))
        }
        ChainOutcome::StillLeaning { link, at_s } => Ending::StillLeaning {
            name: name(link),
            at: seconds(at_s),
        },
        ChainOutcome::Stopped { at_s } => return Simulated::Stopped(seconds(at_s)).into(),
    };
    said.into()
}

fn how_it_stood(simulation: &ChainSimulation) -> Ending {
    let (held, joints) = (simulation.held_joints().len(), simulation.links.len());
    match held {
        0 => Ending::NoEdge,
        all if all == joints => Ending::AllHeld,
        held => Ending::SomeHeld { held, joints },
    }
}

/// How it ended, in a word or two.
pub(super) fn ending_word(simulation: &ChainSimulation) -> Ending {
    match simulation.history.outcome {
        ChainOutcome::Fell { .. } => Ending::WordFell,
        _ if simulation.ended_before_the_motion_s().is_some() => Ending::WordCut,
        ChainOutcome::Stood => Ending::WordStood,
        ChainOutcome::Uplifted { .. } => Ending::WordOpened,
        ChainOutcome::StillLeaning { .. } => Ending::WordLeaning,
        ChainOutcome::Stopped { .. } => Ending::WordStopped,
    }
}
