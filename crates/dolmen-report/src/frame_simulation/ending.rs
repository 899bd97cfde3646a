//! How simulated frames ended.

use crate::document::{Finding, Tone};
use crate::limits;
use crate::simulated::{
    Simulated, capitalised, cut, left, milli, millimetres, seconds, undamped, under, version_name,
};
use dolmen::dynamics::{FrameOutcome, StoreyFriction};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::TiltLeftOut;
use dolmen_work::frame::FrameSimulation;

messages! {
    /// How a frame ended.
    pub(crate) enum Ending in "frame.simulation.ending" {
        Direction { direction: String } => { en: "Direction {direction}", ko: "{direction} 방향" },
        Version { direction: String, variant: Sentence } => {
            en: "Direction {direction}, {variant}",
            ko: "{direction} 방향, {variant}",
        },
        Finished { drift: Quantity, name: String, residual: Quantity } => {
            en: "the largest drift is {drift}, in ‘{name}’; the top comes to rest {residual} off.",
            ko: "최대 층간변위는 ‘{name}’의 {drift}이고, 최상층의 잔류 변위는 {residual}이다.",
        },
        DriftLimit { name: String, most: Quantity, at: Quantity } => {
            en: "‘{name}’ leaned by more than {most} of its height at {at}, beyond what small drifts can tell of: count it as fallen.",
            ko: "‘{name}’의 층간변위가 {at}에 층고의 {most}를 넘었다. 미소변형 모델의 범위를 벗어났으므로 붕괴로 본다.",
        },
        Within { most: Quantity } => {
            en: "No storey leaned by more than {most} of its height.",
            ko: "모든 층의 층간변위가 층고의 {most} 이내이다.",
        },
        Stuck => { en: "No joint slipped.", ko: "미끄러진 접합부는 없다." },
        ColumnsLeftOut => {
            en: "The restoring moment of the free-standing columns is not in this motion: the frame moves on its storey stiffness and friction alone, and does not soften where feet lift off. `dolmen check` says what the columns hold.",
            ko: "이 해석에는 자립 기둥의 복원모멘트를 반영하지 않았으며, 골조는 층강성과 마찰만으로 거동하여 주각이 들린 뒤의 강성 저하가 나타나지 않는다. 기둥의 복원력은 `dolmen check`에서 확인한다.",
        },
        TiltLeftOut { survey: String, tilt: String } => {
            en: "The frame starts plumb: the tilt of survey {survey} ({tilt}) is not in it, and what leans drifts further to that side.",
            ko: "골조는 연직 상태에서 시작하며 {survey} 조사의 실측 기울기({tilt})를 반영하지 않았다. 기울어진 골조는 그 방향으로 더 변위한다.",
        },
        AtRest => { en: "At the end it is at rest.", ko: "종료 시 정지 상태이다." },
        Moving => {
            en: "At the end it is still moving: what is left is where it comes to rest if nothing slips any more.",
            ko: "종료 시 아직 움직이고 있으며, 잔류 변위는 더 미끄러지지 않을 때의 값이다.",
        },
    }
}

/// How each ended, as findings.
pub(crate) fn findings(simulations: &[&FrameSimulation]) -> Vec<Finding> {
    simulations
        .iter()
        .flat_map(|simulation| own(simulation))
        .collect()
}

/// How one ended, and its storeys against their limit.
pub(super) fn own(simulation: &FrameSimulation) -> Vec<Finding> {
    let mut all = vec![finding(simulation)];
    all.extend(undamped(simulation.undamped.as_ref()));
    all.extend(columns_left_out(simulation));
    all.extend(tilt_left_out(simulation));
    // what fell has said so
    if !simulation.falls() {
        all.extend(limits(simulation));
    }
    all
}

/// That the columns are not in the motion; nothing where the file has none.
pub(super) fn columns_left_out(simulation: &FrameSimulation) -> Option<Finding> {
    simulation
        .leaves_columns_out
        .then(|| Finding::key(Tone::Warn, Ending::ColumnsLeftOut))
}

/// That a surveyed tilt is not in the motion; nothing where none was surveyed.
pub(super) fn tilt_left_out(simulation: &FrameSimulation) -> Option<Finding> {
    let TiltLeftOut { survey, written } = simulation.tilt_left_out.clone()?;
    let said = Ending::TiltLeftOut {
        survey,
        tilt: written,
    };
    Some(Finding::key(Tone::Warn, said))
}

fn limits(simulation: &FrameSimulation) -> Vec<Finding> {
    limits::findings(
        &simulation.parts(),
        simulation.drift_limit.as_ref(),
        version_name(simulation.variant.as_deref(), simulation.variant_title.as_ref()),
    )
}

/// How it ended, and of which direction under which motion.
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

/// Direction and variant.
pub(super) fn title(simulation: &FrameSimulation) -> Sentence {
    let direction = simulation.direction.clone();
    let variant = version_name(simulation.variant.as_deref(), simulation.variant_title.as_ref());
    match variant {
        None => Ending::Direction { direction }.into(),
        Some(variant) => Ending::Version { direction, variant }.into(),
    }
}

/// How it ended, in a sentence that begins with a small letter.
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
        FrameOutcome::DriftLimit { storey, at_s } => Ending::DriftLimit {
            name: name(storey),
            most: drift_most(simulation),
            at: seconds(at_s),
        }
        .into(),
        FrameOutcome::Stopped { at_s } => Simulated::Stopped { at: seconds(at_s) }.into(),
    }
}

/// The largest drift of a storey of which small drifts can tell.
fn drift_most(simulation: &FrameSimulation) -> Quantity {
    let most = simulation.options.drift_ratio_most;
    Quantity::new(most, Unit::percent(), Digits::Trimmed(3))
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
    let most = drift_most(simulation);
    let moves = match history.at_rest {
        true => Ending::AtRest,
        false => Ending::Moving,
    };
    let said = [Ending::Within { most }].into_iter().chain(stuck).chain([moves]);
    said.map(Sentence::from).collect()
}
