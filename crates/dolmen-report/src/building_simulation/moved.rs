//! Sentences on the motion of a building.

use crate::building::{floor_words, millimetres, of_both, stroke_words};
use crate::document::{Finding, Tone};
use crate::limits;
use crate::simulated::{seconds, version_name, vertical_peak};
use crate::text::GROWN;
use dolmen::assess::demand::TorsionCode;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::building::{Against, BuildingSimulation};

messages! {
    /// How a building moved.
    pub(crate) enum Moved in "building-simulation.moved" {
        Under { motion: String, said: Sentence } => { en: "Under {motion}, {said}", ko: "{motion} 작용 시: {said}" },
        UnderVariant { motion: String, variant: Sentence, said: Sentence } => {
            en: "Under {motion}, {variant}, {said}",
            ko: "{variant}, {motion} 작용 시: {said}",
        },
        Cut { end: Quantity, whole: Quantity } => {
            en: "the run ended before the motion: {end} of its {whole} were run; no verdict. All values are of that part.",
            ko: "지반운동이 끝나기 전에 해석을 마쳐 판정하지 않는다({whole} 중 {end}까지 해석). 모든 값은 그때까지의 것이다.",
        },
        BeyondRoom { damper: Sentence, needed: Quantity, room: Quantity } => {
            en: "damper {damper} is beyond its room: it needs {needed} each way and has {room}. It would meet its stops, which this run does not have, so that all values are too good.",
            ko: "감쇠기 {damper}의 행정 {needed}이(가) 여유 공간 {room}을(를) 넘는다. 이 해석은 스토퍼 충돌을 고려하지 않아 응답을 작게 평가하므로 결과를 그대로 쓸 수 없다.",
        },
        Corner { ratio: Quantity, floor: Sentence, direction: Quantity } => {
            en: "the largest drift at a corner is {ratio} of the height of the storey below floor {floor}, {direction}° from x.",
            ko: "최대 층간변위(모서리)는 {floor} 바닥 아래에서 층고의 {ratio}이며 방향은 x축에서 {direction}°이다.",
        },
        Centre { ratio: Quantity, floor: Sentence, direction: Quantity } => {
            en: "the largest drift of a centre of mass is {ratio} of the height of the storey below floor {floor}, {direction}° from x (its outline is not known: corners drift more where it twists; give sides or outline).",
            ko: "최대 층간변위(질량중심)는 {floor} 바닥 아래에서 층고의 {ratio}이며 방향은 x축에서 {direction}°이다. 평면 외곽선이 없으며, 비틀리면 모서리의 층간변위가 더 크다(sides 또는 outline 입력 필요).",
        },
        TiltLeftOut { survey: String, tilt: String } => {
            en: "the building starts plumb: the tilt of survey {survey} ({tilt}) is not in it, and what leans drifts further to that side.",
            ko: "건물은 연직 상태에서 시작하며 {survey} 조사의 실측 기울기({tilt})를 반영하지 않았다. 기울어진 건물은 그 방향으로 더 변위한다.",
        },
        VerticalLeftOut(peak: Quantity) => {
            en: "the vertical component of the motion, z, with a peak of {peak}, does not act: a building of floors knows no vertical shaking.",
            ko: "지반운동의 연직 성분 z(최대 {peak})는 작용하지 않는다. 층 모델은 연직 진동을 고려하지 않는다.",
        },
        NoWind => {
            en: "the wind of the file does not blow during the motion; «`dolmen check`|the check of stability» says what it does.",
            ko: "지반운동 작용 중에는 입력한 바람을 고려하지 않는다. 풍응답은 «`dolmen check`|안정성 검토»에 나온다.",
        },
        NoAccidentalTorsion { code: String } => {
            en: "the centres of mass are those of the file: the accidental torsion that {code} requires is not in this run, but «`dolmen check`|the check of stability» includes it for the spectrum of a site.",
            ko: "질량중심은 입력한 위치이며, {code}이(가) 요구하는 우발비틀림은 이 해석에 없다. 부지 스펙트럼에 대해서는 «`dolmen check`|안정성 검토»가 고려한다.",
        },
        And { first: Sentence, next: Sentence } => { en: "{first} {next}", ko: "{first} {next}" },
        Top { list: Vec<Sentence> } => {
            en: "Of what it would move without dampers: {list}.",
            ko: "감쇠기가 없을 때에 대한 비: {list}.",
        },
        More { list: Vec<Sentence> } => {
            en: "More than without dampers: {list}.",
            ko: "감쇠기가 없을 때보다 큰 값: {list}.",
        },
        MoreOf { list: Vec<Sentence>, others: usize } => {
            en: "More than without dampers: {list} and {others} more.",
            ko: "감쇠기가 없을 때보다 큰 값: {list} 외 {others}개.",
        },
        Share { what: Sentence, ratio: Quantity } => { en: "{what} {ratio}", ko: "{what} {ratio}" },
        Grows => {
            en: "a displacement is largest where the run ends, and may grow on: give a longer --duration.",
            ko: "해석이 끝나는 시점에 변위가 최대이므로 더 커질 수 있다. --duration을 늘려 다시 해석한다.",
        },
    }
}

/// Number of responses increased by dampers that are listed, the worst first; JSON has all.
const GROWN_MOST: usize = 4;

/// The motion of each, the most important finding first.
pub(crate) fn findings(simulations: &[&BuildingSimulation]) -> Vec<Finding> {
    simulations
        .iter()
        .flat_map(|simulation| own(simulation))
        .collect()
}

/// Motion of one building.
pub(super) fn own(simulation: &BuildingSimulation) -> Vec<Finding> {
    let all = alarms(simulation).into_iter().chain([of_all(simulation)]);
    let mut all: Vec<Finding> = all
        .map(|(tone, said)| Finding::key(tone, under(simulation, said)))
        .collect();
    all.extend(limits::findings(
        &simulation.parts(),
        simulation.drift_limit.as_ref(),
        variant(simulation),
    ));
    all
}

/// The warnings, each beginning with a small letter.
pub(super) fn alarms(simulation: &BuildingSimulation) -> Vec<(Tone, Sentence)> {
    let mut all = Vec::new();
    if let Some(end_s) = simulation.ended_before_the_motion_s() {
        let said = Moved::Cut {
            end: seconds(end_s),
            whole: seconds(simulation.motion.motion.duration_s()),
        };
        all.push((Tone::Unknown, said.into()));
    }
    let four = |length_m: f64| Quantity::new(length_m, millimetres(), Digits::Significant(4));
    for beyond in simulation.beyond_room() {
        let said = Moved::BeyondRoom {
            damper: stroke_words(&beyond.name),
            needed: four(beyond.stroke_m),
            room: four(beyond.room_m),
        };
        all.push((Tone::Bad, said.into()));
    }
    let vertical = vertical_peak(&simulation.motion.motion);
    all.extend(vertical.map(|peak| (Tone::Warn, Moved::VerticalLeftOut(peak).into())));
    if let Some(code) = simulation.drift_limit.as_ref().and_then(TorsionCode::of_limit) {
        let code = code.name().to_owned();
        all.push((Tone::Plain, Moved::NoAccidentalTorsion { code }.into()));
    }
    if simulation.without_wind {
        all.push((Tone::Plain, Moved::NoWind.into()));
    }
    if let Some(left_out) = simulation.tilt_left_out.clone() {
        let said = Moved::TiltLeftOut {
            survey: left_out.survey,
            tilt: left_out.written,
        };
        all.push((Tone::Warn, said.into()));
    }
    if simulation.history.grows_at_the_end() {
        all.push((Tone::Unknown, Moved::Grows.into()));
    }
    all
}

/// The largest drift, and the effect of dampers.
pub(super) fn of_all(simulation: &BuildingSimulation) -> (Tone, Sentence) {
    let against = simulation.against_without();
    let is_top = |of: &&Against| of.what[0].starts_with("the top");
    let is_more = |of: &&Against| of.ratio > GROWN;
    let list = |of: Vec<&Against>, digits: usize| -> Vec<Sentence> {
        let share = |of: &Against| Moved::Share {
            what: of_both(&of.what),
            ratio: Quantity::percent(of.ratio, digits),
        };
        of.into_iter().map(|of| share(of).into()).collect()
    };
    let top = list(against.iter().filter(is_top).collect(), 3);
    let mut grown: Vec<&Against> = against.iter().filter(is_more).collect();
    grown.sort_by(|a, b| b.ratio.total_cmp(&a.ratio));
    let others = grown.len().saturating_sub(GROWN_MOST);
    grown.truncate(GROWN_MOST);
    let more = list(grown, 4);
    let tone = if more.is_empty() { Tone::Plain } else { Tone::Warn };
    let top = (!top.is_empty()).then_some(Moved::Top { list: top });
    let more = match (more.is_empty(), others) {
        (true, _) => None,
        (false, 0) => Some(Moved::More { list: more }),
        (false, others) => Some(Moved::MoreOf { list: more, others }),
    };
    let said = top
        .into_iter()
        .chain(more)
        .fold(drift(simulation).into(), |first, next| {
            Moved::And {
                first,
                next: next.into(),
            }
            .into()
        });
    (tone, said)
}

fn drift(simulation: &BuildingSimulation) -> Moved {
    let drift = simulation.drift();
    let floor = simulation.floors.get(drift.storey.saturating_sub(1));
    let floor = floor_words(floor.map_or("", String::as_str));
    let ratio = Quantity::percent(drift.ratio, 3);
    // no minus before zero
    let degrees = drift.drift.direction_degrees + 0.0;
    let direction = Quantity::new(degrees, Unit::ratio(), Digits::Fixed(0));
    match drift.at_corner {
        true => Moved::Corner {
            ratio,
            floor,
            direction,
        },
        false => Moved::Centre {
            ratio,
            floor,
            direction,
        },
    }
}

/// The finding with the motion, and the variant if it is one.
fn under(simulation: &BuildingSimulation, said: Sentence) -> Sentence {
    let motion = simulation.motion.motion.name().to_owned();
    match variant(simulation) {
        None => Moved::Under { motion, said }.into(),
        Some(variant) => Moved::UnderVariant {
            motion,
            variant,
            said,
        }
        .into(),
    }
}

/// The variant by its title, or by its name in the file.
pub(super) fn variant(simulation: &BuildingSimulation) -> Option<Sentence> {
    version_name(simulation.variant.as_deref(), simulation.variant_title.as_ref())
}
