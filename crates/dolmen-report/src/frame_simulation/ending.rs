//! How simulated frames ended.

use super::beside;
use super::split;
use super::tenons;
use super::title::{Title, title, title_of_all};
use crate::document::{Finding, Tone};
use crate::limits;
use crate::simulated::{
    Simulated, capitalised, cut, kilo, left, milli, millimetres, milliradians, seconds, undamped, under,
    version_name, vertical_peak,
};
use dolmen::assess::demand::DRIFT_RATIO_MOST;
use dolmen::dynamics::{ColumnOutcome, FrameOutcome, RockingOutcome, StoreyFriction};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::TiltLeftOut;
use dolmen_work::frame::{ColumnsAlone, ColumnsInMotion, ColumnsOnBeds, FrameSimulation};

messages! {
    /// How a frame ended.
    pub(crate) enum Ending in "frame.simulation.ending" {
        Finished { drift: Quantity, name: String, residual: Quantity } => {
            en: "the largest drift is {drift}, in ‘{name}’; the top comes to rest {residual} off.",
            ko: "최대 층간변위는 ‘{name}’의 {drift}이고, 최상층의 잔류 변위는 {residual}이다.",
        },
        DriftLimit { name: String, most: Quantity, at: Quantity } => {
            en: "‘{name}’ leaned by more than {most} of its height at {at}, beyond what small drifts can tell of: count it as fallen.",
            ko: "‘{name}’의 층간변위가 {at}에 층고의 {most}을(를) 넘었다. 미소변형 모델의 범위를 벗어났으므로 붕괴로 본다.",
        },
        DriftLimitLeaning { name: String, most: Quantity, at: Quantity } => {
            en: "the drift of ‘{name}’ and its lean as surveyed came to more than {most} of its height at {at}, beyond what small drifts can tell of: count it as fallen.",
            ko: "‘{name}’의 층간변위와 조사한 기울기의 합이 {at}에 층고의 {most}을(를) 넘었다. 미소변형 모델의 범위를 벗어났으므로 붕괴로 본다.",
        },
        PastTheMost { name: String, most: Quantity, at: Quantity } => {
            en: "‘{name}’ drifted by more than {most} at {at}, where its columns resist most: springs of their beds tell nothing beyond, count it as fallen.",
            ko: "‘{name}’의 층간변위가 {at}에 기둥의 저항이 최대가 되는 {most}을(를) 넘었다. 그 뒤는 지압면의 강성으로 알 수 없으므로 붕괴로 본다.",
        },
        Within(most: Quantity) => {
            en: "No storey leaned by more than {most} of its height.",
            ko: "모든 층의 층간변위가 층고의 {most} 이내이다.",
        },
        Stuck => { en: "No joint slipped.", ko: "미끄러진 접합부는 없다." },
        ColumnsLeftOut => {
            en: "The restoring moment of the free-standing columns is not in this motion: the frame moves on its storey stiffness and friction alone, and does not soften where feet lift off. «`dolmen check`|The check of stability» says what the columns hold.",
            ko: "이 해석에는 자립 기둥의 복원모멘트를 반영하지 않았으며, 골조는 층강성과 마찰만으로 거동하여 주각이 들린 뒤의 강성 저하가 나타나지 않는다. 기둥의 복원력은 «`dolmen check`|안정성 검토»에서 확인한다.",
        },
        ColumnsNeedOneStorey => {
            en: "The frame on its columns alone is moved only where it has one storey.",
            ko: "기둥만으로 거동하는 해석은 단층 골조에 한한다.",
        },
        ColumnsNeedOneComponent => {
            en: "The frame on its columns alone is moved only under one component of a motion: under x and y together a foot rolls around its edge or on a corner, which is not followed.",
            ko: "기둥만으로 거동하는 해석은 지반운동이 한 성분일 때에 한한다. x와 y가 함께 작용하면 주각이 가장자리를 따라 또는 모서리로 구르며, 이 거동은 추적하지 않는다.",
        },
        Together { name: String, drift: Quantity, share: Quantity, at: Quantity, top: Quantity } => {
            en: "Both directions together: ‘{name}’ drifts by up to {drift}, {share} of its height, at {at}; the top moves {top}.",
            ko: "두 방향을 합하면 최대 층간변위는 ‘{name}’의 {drift}(층고의 {share}, {at})이고, 최상층 변위는 {top}이다.",
        },
        Shared { names: Vec<String>, step: Quantity, change: Quantity } => {
            en: "Joints that rub in both directions share one slip force, however it points ({names}); steps of {step}, and at twice that the largest drifts differ by {change}.",
            ko: "두 방향에 함께 마찰하는 층({names})은 미끄러짐 힘 하나를 방향과 관계없이 나누어 쓴다. 시간 간격은 {step}이며, 두 배로 하면 최대 층간변위가 {change} 달라진다.",
        },
        Leans { survey: String, tilt: String, direction: String, lean: Sentence } => {
            en: "It leans as survey {survey} found it, tilt {tilt}: {lean} in direction {direction}, which its weight pushes on and which counts against the allowable drift«; as_surveyed = \"none\" leaves that out».",
            ko: "{survey} 조사의 실측 기울기 {tilt}을(를) 반영하였다. {direction} 방향 {lean}이며, 자중이 그쪽으로 밀고 허용 층간변위에서 그만큼을 뺀다.« 제외하려면 as_surveyed = \"none\"으로 한다.»",
        },
        OneIn(inverse: Quantity) => { en: "1/{inverse}", ko: "1/{inverse}" },
        Plumb => { en: "none", ko: "없음" },
        AloneStood { of: Sentence, count: usize, peak: Quantity, uplift: Quantity } => {
            en: "{of}, on its {count} columns alone, without joints and walls: no foot lifts off; the ground peaks at {peak}, they lift off at {uplift}.",
            ko: "{of}, 접합부와 벽체 없이 기둥 {count}개만으로는 주각이 들리지 않는다. 지반가속도 최댓값은 {peak}, 들림 가속도는 {uplift}이다.",
        },
        AloneRocked { of: Sentence, count: usize, uplift: Quantity, at: Quantity, drift: Quantity, rotation: Quantity, share: Quantity } => {
            en: "{of}, on its {count} columns alone, without joints and walls: they lift off at {uplift}, first at {at}, and rock without falling; heads drift by up to {drift}, columns lean by {rotation}, {share} of the lean at which they fall.",
            ko: "{of}, 접합부와 벽체 없이 기둥 {count}개만으로는 {uplift}에서 주각이 들리고({at}에 처음) 전도되지 않고 흔들린다. 주두의 최대 변위는 {drift}, 기둥의 최대 회전각은 {rotation}(으)로 전도 회전각의 {share}이다.",
        },
        AloneFell { of: Sentence, count: usize, uplift: Quantity, lifted: Quantity, at: Quantity } => {
            en: "{of}, on its {count} columns alone, without joints and walls: they lift off at {uplift}, first at {lifted}, and have fallen at {at}. Joints and walls must hold the frame.",
            ko: "{of}, 접합부와 벽체 없이 기둥 {count}개만으로는 {uplift}에서 주각이 들리고({lifted}에 처음) {at}에 전도된다. 접합부와 벽체가 골조를 지지해야 한다.",
        },
        BedsStood { of: Sentence, count: usize, uplift: Quantity, drift: Quantity } => {
            en: "{of}, on its {count} columns alone, by their force over drift: no foot lifts off; that begins at a drift of {uplift}, and the largest is {drift}.",
            ko: "{of}, 기둥 {count}개만의 하중-변위 곡선으로 해석하면 주각이 들리지 않는다. 들림 변위는 {uplift}, 최대 변위는 {drift}이다.",
        },
        BedsRocked { of: Sentence, count: usize, uplift: Quantity, at: Quantity, drift: Quantity, share: Quantity, spring: Quantity } => {
            en: "{of}, on its {count} columns alone, by their force over drift: feet lift off at a drift of {uplift}, first at {at}, and heads drift by up to {drift}, {share} of the drift at which they fall. The springs of their beds give {spring}; the larger counts.",
            ko: "{of}, 기둥 {count}개만의 하중-변위 곡선으로 해석하면 변위 {uplift}에서 주각이 들리고({at}에 처음) 주두의 최대 변위는 {drift}(전도 변위의 {share})이다. 지압면의 강성으로는 {spring}이며, 큰 값으로 판정한다.",
        },
        BedsFell { of: Sentence, count: usize, uplift: Quantity, lifted: Quantity, at: Quantity } => {
            en: "{of}, on its {count} columns alone, by their force over drift: feet lift off at a drift of {uplift}, first at {lifted}, and the columns have fallen at {at}. That decides, whatever the springs of their beds give.",
            ko: "{of}, 기둥 {count}개만의 하중-변위 곡선으로 해석하면 변위 {uplift}에서 주각이 들리고({lifted}에 처음) {at}에 전도된다. 지압면의 강성에 의한 결과와 관계없이 이것으로 판정한다.",
        },
        BedsNotFollowed { of: Sentence, count: usize, lifted: Quantity } => {
            en: "{of}, on its {count} columns alone, by their force over drift: feet lift off, first at {lifted}, and rock so irregularly that shorter steps still change the largest drift. Nothing is decided.",
            ko: "{of}, 기둥 {count}개만의 하중-변위 곡선으로 해석하면 주각이 들린 뒤({lifted}에 처음) 거동이 불규칙하여 시간 간격을 줄여도 최대 변위가 달라진다. 판정하지 않는다.",
        },
        LiftsOff { of: Sentence, name: String, uplift: Quantity } => {
            en: "{of}: columns alone support ‘{name}’, and their feet lift off at a drift of {uplift}, which the run passes. Beyond it they are softer than the springs of their beds, so nothing is decided.",
            ko: "{of}: 기둥만으로 지지되는 ‘{name}’의 주각이 변위 {uplift}에서 들리는데 해석이 이를 넘었다. 그 뒤에는 지압면의 강성보다 유연하므로 판정하지 않는다.",
        },
        TiltLeftOut { survey: String, tilt: String } => {
            en: "The frame starts plumb: the tilt of survey {survey} ({tilt}) is not in it, and what leans drifts further to that side.",
            ko: "골조는 연직 상태에서 시작하며 {survey} 조사의 실측 기울기({tilt})를 반영하지 않았다. 기울어진 골조는 그 방향으로 더 변위한다.",
        },
        Carries(weight: Quantity) => {
            en: "It carries the weight of its static loads, {weight}, which swings with it.",
            ko: "정하중의 중량 {weight}이(가) 함께 진동하는 것으로 해석하였다.",
        },
        ForcesLeftOut => {
            en: "Forces of static loads and the wind of the file do not act in this run: «`dolmen check`|the check of stability» judges them.",
            ko: "이 해석에는 정하중의 힘과 바람을 반영하지 않았다. «`dolmen check`|안정성 검토»에서 판정한다.",
        },
        VerticalLeftOut(peak: Quantity) => {
            en: "The vertical component of the motion, z, with a peak of {peak}, does not act: the axial forces of a frame are those at rest.",
            ko: "지반운동의 연직 성분 z(최대 {peak})는 작용하지 않는다. 골조의 축력은 정적 상태의 값이다.",
        },
        AtRest => { en: "At the end it is at rest.", ko: "종료 시 정지 상태이다." },
        Moving => {
            en: "At the end it is still moving: what is left is where it comes to rest if nothing slips any more.",
            ko: "해석 종료 시점에도 진동이 남아 있다. 잔류 변위는 그 뒤 미끄러짐이 없다고 본 값이다.",
        },
    }
}

/// How each ended, as findings.
pub(crate) fn findings(simulations: &[&FrameSimulation]) -> Vec<Finding> {
    of_versions(simulations).into_iter().flatten().collect()
}

/// A finding of one direction, and how it names its direction.
struct Said {
    finding: Finding,
    names: Names,
}

/// How a finding names its direction.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Names {
    /// It is about one direction.
    One,
    /// Its title names one or several.
    Title,
    /// It names none.
    None,
}

/// The findings of each simulation; one that all directions of a version share is said once, in the first, and names all of them.
pub(super) fn of_versions(simulations: &[&FrameSimulation]) -> Vec<Vec<Finding>> {
    let same = |a: &&FrameSimulation, b: &&FrameSimulation| a.variant == b.variant;
    let versions = simulations.chunk_by(same);
    versions.flat_map(of_directions).collect()
}

fn of_directions(simulations: &[&FrameSimulation]) -> Vec<Vec<Finding>> {
    let all = title_of_all(simulations);
    let of_all: Vec<Vec<Said>> = simulations.iter().map(|of| own(of, &all)).collect();
    let is_shared = |said: &Said| {
        let has = |other: &Vec<Said>| other.iter().any(|of| of.finding == said.finding);
        simulations.len() > 1 && said.names != Names::One && of_all.iter().all(has)
    };
    let each = simulations.iter().zip(&of_all).enumerate();
    let each = each.map(|(at, (simulation, of_all))| {
        let own = own(simulation, &title(simulation)).into_iter().zip(of_all);
        let found = own.filter_map(|(own, shared)| match (is_shared(shared), at) {
            (false, _) => Some(own.finding),
            (true, 0) => Some(match shared.names {
                Names::None => Finding {
                    sentence: Title::OfDirections {
                        of: all.clone(),
                        said: shared.finding.sentence.clone(),
                    }
                    .into(),
                    ..shared.finding.clone()
                },
                Names::One | Names::Title => shared.finding.clone(),
            }),
            (true, _) => None,
        });
        found.collect()
    });
    each.collect()
}

/// How one ended, and its storeys compared with their limit; `of` is the title of findings that directions may share.
fn own(simulation: &FrameSimulation, of: &Sentence) -> Vec<Said> {
    let named = |names: Names| move |finding: Finding| Said { finding, names };
    let mut all: Vec<Said> = vec![named(Names::One)(finding(simulation))];
    let beside = beside::findings(simulation, title(simulation));
    all.extend(beside.into_iter().map(named(Names::One)));
    all.extend(undamped(simulation.undamped.as_ref()).map(named(Names::None)));
    all.extend(on_columns(simulation, of).into_iter().map(named(Names::Title)));
    all.extend(columns_left_out(simulation).into_iter().map(named(Names::None)));
    all.extend(unfollowed(simulation).into_iter().map(named(Names::One)));
    all.extend(leans(simulation).map(named(Names::One)));
    all.extend(tilt_left_out(simulation).map(named(Names::None)));
    all.extend(loads(simulation).into_iter().map(named(Names::None)));
    all.extend(together(simulation).into_iter().map(named(Names::One)));
    all.extend(tenons::findings(simulation).into_iter().map(named(Names::One)));
    // a fall was already reported
    if !simulation.falls() {
        all.extend(limits(simulation).into_iter().map(named(Names::One)));
    }
    all
}

/// The motion of the frame on its columns, and that its own motion does not include them; empty if the file has none.
pub(super) fn columns(simulation: &FrameSimulation) -> Vec<Finding> {
    let mut all = on_columns(simulation, &title(simulation));
    all.extend(columns_left_out(simulation));
    all.extend(unfollowed(simulation));
    all
}

/// The motion of the frame on its columns, alone or beside joints.
fn on_columns(simulation: &FrameSimulation, of: &Sentence) -> Vec<Finding> {
    let own = match &simulation.columns {
        ColumnsInMotion::BesideJoints(run) => Some(split::given(simulation, run, of.clone())),
        ColumnsInMotion::OnBeds(run) => Some(on_beds(simulation, run, of.clone())),
        ColumnsInMotion::Alone(alone) => Some(columns_alone(simulation, alone, of.clone())),
        ColumnsInMotion::Absent
        | ColumnsInMotion::SeveralStoreys
        | ColumnsInMotion::JointsOfTheirOwn
        | ColumnsInMotion::SplitAssumed
        | ColumnsInMotion::BothComponents => None,
    };
    let assumed = simulation.all_in_beds.as_ref();
    let assumed = assumed.map_or(Vec::new(), |assumed| split::assumed(simulation, assumed, of));
    own.into_iter().chain(assumed).collect()
}

/// What the run leaves out of the columns: their motion alone, and their restoring moment.
fn columns_left_out(simulation: &FrameSimulation) -> Vec<Finding> {
    let not_moved = match &simulation.columns {
        ColumnsInMotion::Absent | ColumnsInMotion::BesideJoints(_) | ColumnsInMotion::OnBeds(_) => {
            return Vec::new();
        }
        ColumnsInMotion::SeveralStoreys => Some(Ending::ColumnsNeedOneStorey),
        ColumnsInMotion::BothComponents => Some(Ending::ColumnsNeedOneComponent),
        // said with both extremes
        ColumnsInMotion::SplitAssumed => return Vec::new(),
        ColumnsInMotion::JointsOfTheirOwn | ColumnsInMotion::Alone(_) => None,
    };
    let not_moved = not_moved.map(|said| Finding::new(Tone::Plain, said));
    let left_out = Finding::key(Tone::Warn, Ending::ColumnsLeftOut);
    not_moved.into_iter().chain([left_out]).collect()
}

/// Storeys on columns that lift off in a run that does not follow them.
fn unfollowed(simulation: &FrameSimulation) -> Vec<Finding> {
    let storeys = simulation.unfollowed.iter();
    let storeys = storeys.map(|storey| split::unfollowed(simulation, storey));
    lifts_off(simulation).into_iter().chain(storeys).collect()
}

/// A storey on columns that lift off in a run that does not follow them.
fn lifts_off(simulation: &FrameSimulation) -> Option<Finding> {
    let storey = simulation.lifts_off_unfollowed()?;
    let alone = simulation.columns_alone.get(storey)?.as_ref()?;
    let height_m = simulation.frame.frame().storeys().get(storey)?.height_m;
    let said = Ending::LiftsOff {
        of: title(simulation),
        name: simulation.storeys.get(storey).cloned().unwrap_or_default(),
        uplift: millimetres(alone.uplift * height_m),
    };
    Some(Finding::key(Tone::Unknown, said))
}

/// The motion on columns alone, on beds that give way.
fn on_beds(simulation: &FrameSimulation, columns: &ColumnsOnBeds, of: Sentence) -> Finding {
    let history = &columns.history;
    let count = columns.count;
    let (uplift, drift) = (
        millimetres(history.uplift_drift_m),
        millimetres(history.peak_drift_m),
    );
    let lifted = seconds(history.uplift_s.unwrap_or_default());
    match history.outcome {
        ColumnOutcome::Stood => Finding::key(
            Tone::Plain,
            Ending::BedsStood {
                of,
                count,
                uplift,
                drift,
            },
        ),
        ColumnOutcome::Rocked => Finding::key(
            Tone::Warn,
            Ending::BedsRocked {
                of,
                count,
                uplift,
                at: lifted,
                drift,
                share: Quantity::percent(history.peak_drift_m / history.falls_drift_m, 2),
                spring: millimetres(
                    simulation
                        .history
                        .drift_peaks
                        .first()
                        .map_or(0.0, |peak| peak.value_m.abs()),
                ),
            },
        ),
        ColumnOutcome::Fell { at_s } => Finding::key(
            Tone::Bad,
            Ending::BedsFell {
                of,
                count,
                uplift,
                lifted,
                at: seconds(at_s),
            },
        ),
        ColumnOutcome::NotConverged => {
            Finding::key(Tone::Unknown, Ending::BedsNotFollowed { of, count, lifted })
        }
    }
}

fn columns_alone(simulation: &FrameSimulation, alone: &ColumnsAlone, of: Sentence) -> Finding {
    let history = &alone.history;
    let in_g = |a_m_s2: f64| {
        Quantity::new(
            a_m_s2 / alone.rocks_like.gravity_m_s2,
            Unit::si("g"),
            Digits::Fixed(3),
        )
    };
    let count = alone.count;
    let uplift = in_g(alone.uplift_m_s2());
    let lifted = seconds(history.uplift_s.unwrap_or_default());
    let peak_rad = history.peak_rotation_rad;
    match history.outcome {
        RockingOutcome::Fell { at_s } => {
            let at = seconds(at_s);
            Finding::key(
                Tone::Warn,
                Ending::AloneFell {
                    of,
                    count,
                    uplift,
                    lifted,
                    at,
                },
            )
        }
        RockingOutcome::Rocked | RockingOutcome::LeftTheGround { .. } => Finding::key(
            Tone::Plain,
            Ending::AloneRocked {
                of,
                count,
                uplift,
                at: lifted,
                drift: millimetres(alone.drift_m(peak_rad)),
                rotation: milliradians(peak_rad),
                share: Quantity::percent(peak_rad / alone.rocks_like.slenderness_rad, 2),
            },
        ),
        RockingOutcome::Stood => {
            let peak = in_g(simulation.peak_acceleration_m_s2());
            Finding::key(
                Tone::Plain,
                Ending::AloneStood {
                    of,
                    count,
                    peak,
                    uplift,
                },
            )
        }
    }
}

/// The combined response of both directions, and their coupling; empty for one component.
pub(super) fn together(simulation: &FrameSimulation) -> Vec<Finding> {
    let Some(together) = simulation.together_once() else {
        return Vec::new();
    };
    let name = |storey: usize| simulation.storeys.get(storey).cloned().unwrap_or_default();
    let worst = together.storeys[together.worst];
    let height_m = simulation.frame.frame().storeys()[together.worst].height_m;
    let said = Ending::Together {
        name: name(together.worst),
        drift: millimetres(worst.drift_m),
        share: Quantity::percent(worst.drift_m / height_m, 3),
        at: seconds(worst.at_s),
        top: millimetres(together.top_m),
    };
    let shared = together.shared.map(|shared| Ending::Shared {
        names: together.rubbing.iter().map(|storey| name(*storey)).collect(),
        step: Quantity::new(shared.step_s, milli("s"), Digits::Significant(3)),
        change: Quantity::percent(shared.change, 2),
    });
    let shared = shared.map(|said| Finding::key(Tone::Plain, said));
    [Finding::key(Tone::Plain, said)]
        .into_iter()
        .chain(split::together(simulation, together))
        .chain(shared)
        .collect()
}

/// The lean and its survey.
pub(super) fn leans(simulation: &FrameSimulation) -> Option<Finding> {
    let lean = simulation.lean.as_ref()?;
    let tilt = simulation.tilt;
    let said = Ending::Leans {
        survey: lean.survey.clone(),
        tilt: lean.written.clone(),
        direction: simulation.direction.clone(),
        lean: match tilt == 0.0 {
            true => Ending::Plumb.into(),
            false => Ending::OneIn(Quantity::ratio(1.0 / tilt.abs(), 3)).into(),
        },
    };
    Some(Finding::key(Tone::Plain, said))
}

/// Finding that a surveyed tilt is not in the motion; empty if none was surveyed.
pub(super) fn tilt_left_out(simulation: &FrameSimulation) -> Option<Finding> {
    let TiltLeftOut { survey, written } = simulation.tilt_left_out.clone()?;
    let said = Ending::TiltLeftOut {
        survey,
        tilt: written,
    };
    Some(Finding::key(Tone::Warn, said))
}

/// Static loads and wind that are in the run, and what is not: also vertical shaking.
pub(super) fn loads(simulation: &FrameSimulation) -> Vec<Finding> {
    let carries = (simulation.carried_n != 0.0).then(|| {
        Ending::Carries(Quantity::new(
            simulation.carried_n,
            kilo("N"),
            Digits::Significant(3),
        ))
    });
    let carries = carries.map(|said| Finding::key(Tone::Plain, said));
    let left_out = simulation.loads_left_out.then_some(Ending::ForcesLeftOut);
    let vertical = vertical_peak(&simulation.motion.motion).map(Ending::VerticalLeftOut);
    let left_out = left_out.into_iter().chain(vertical);
    let left_out = left_out.map(|said| Finding::key(Tone::Warn, said));
    carries.into_iter().chain(left_out).collect()
}

fn limits(simulation: &FrameSimulation) -> Vec<Finding> {
    limits::findings(
        &simulation.parts(),
        simulation.drift_limit.as_ref(),
        version_name(simulation.variant.as_deref(), simulation.variant_title.as_ref()),
    )
}

/// The outcome, with the direction and the motion.
pub(super) fn finding(simulation: &FrameSimulation) -> Finding {
    let tone = match simulation.history.outcome {
        FrameOutcome::DriftLimit { .. } => Tone::Bad,
        FrameOutcome::Stopped { .. } => Tone::Unknown,
        FrameOutcome::Finished if simulation.ended_before_the_motion_s().is_some() => Tone::Unknown,
        FrameOutcome::Finished => Tone::Plain,
    };
    let said = under(
        title(simulation),
        &simulation.motion,
        simulation.peak_acceleration_m_s2(),
        ending(simulation),
    );
    Finding::key(tone, capitalised(said))
}

/// The outcome, in a sentence that begins with a small letter.
pub(super) fn ending(simulation: &FrameSimulation) -> Sentence {
    match simulation.ended_before_the_motion_s() {
        Some(end_s) => cut(&simulation.motion, end_s, until_the_end(simulation)),
        None => until_the_end(simulation),
    }
}

fn until_the_end(simulation: &FrameSimulation) -> Sentence {
    let history = &simulation.history;
    let name = |storey: usize| simulation.storeys.get(storey).cloned().unwrap_or_default();
    let drift_m = |storey: usize| history.drift_peaks[storey].value_m.abs();
    match history.outcome {
        FrameOutcome::Finished => {
            let storeys = 0..simulation.storeys.len();
            let worst = storeys.max_by(|a, b| drift_m(*a).total_cmp(&drift_m(*b)));
            let rest_m = history.rest_m.last().copied().unwrap_or(0.0);
            Ending::Finished {
                drift: millimetres(worst.map_or(0.0, drift_m)),
                name: worst.map_or_else(String::new, name),
                residual: left(rest_m.abs(), worst.map_or(0.0, drift_m), milli("m")),
            }
            .into()
        }
        FrameOutcome::DriftLimit { storey, at_s } if ends_at_most(simulation, storey) => {
            Ending::PastTheMost {
                name: name(storey),
                most: millimetres(drift_m(storey)),
                at: seconds(at_s),
            }
            .into()
        }
        FrameOutcome::DriftLimit { storey, at_s } if simulation.lean.is_some() => Ending::DriftLimitLeaning {
            name: name(storey),
            most: drift_most(),
            at: seconds(at_s),
        }
        .into(),
        FrameOutcome::DriftLimit { storey, at_s } => Ending::DriftLimit {
            name: name(storey),
            most: drift_most(),
            at: seconds(at_s),
        }
        .into(),
        FrameOutcome::Stopped { at_s } => Simulated::Stopped(seconds(at_s)).into(),
    }
}

/// Whether a storey reached the largest resistance of its columns before the limit of small drifts.
fn ends_at_most(simulation: &FrameSimulation, storey: usize) -> bool {
    let alone = simulation.columns_alone.get(storey).and_then(Option::as_ref);
    let most = simulation.options.drift_ratio_most;
    alone.is_some_and(|alone| (alone.most - most).abs() <= 1e-9 * most)
}

/// The largest lean of a storey for which small drifts are valid.
fn drift_most() -> Quantity {
    Quantity::new(DRIFT_RATIO_MOST, Unit::percent(), Digits::Trimmed(3))
}

/// Whether joints slipped, and whether it still moves.
pub(super) fn state(simulation: &FrameSimulation) -> Vec<Sentence> {
    let history = &simulation.history;
    if history.outcome != FrameOutcome::Finished {
        return Vec::new();
    }
    let mut each = simulation.frame.friction().iter();
    let can_slip = each.any(|friction| *friction != StoreyFriction::None);
    let stuck = (can_slip && history.slips.is_empty()).then_some(Ending::Stuck);
    let most = drift_most();
    let moves = match history.at_rest {
        true => Ending::AtRest,
        false => Ending::Moving,
    };
    let said = [Ending::Within(most)].into_iter().chain(stuck).chain([moves]);
    said.map(Sentence::from).collect()
}
