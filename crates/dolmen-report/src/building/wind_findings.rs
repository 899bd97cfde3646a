//! Findings on a building in the wind.

use super::words::{axis_words, floor_words, millimetres, significant, stroke_words};
use crate::document::{Finding, Tone};
use dolmen::structure::Building;
use dolmen_words::message::Both;
use dolmen_words::{Quantity, Sentence, Unit, messages};
use dolmen_work::building::{BuildingAnswer, BuildingWind, StandingBuilding, WindAlong};

/// Height over √(breadth × depth) above which gusts across the wind are expected to move a building more than those along it. Chosen
/// here, as the threshold from which codes require wind across.
const SLENDER: f64 = 3.0;

messages! {
    /// Findings on a building in the wind.
    pub(crate) enum Blown in "building.wind-findings" {
        Acceleration { peak: Quantity, rms: Quantity, axis: Sentence } => {
            en: "In the wind of the file the peak acceleration of the top floor is {peak} at its worst corner (σ {rms}), the wind along {axis}.",
            ko: "입력한 바람에서 최상층의 최대가속도는 가장 불리한 모서리에서 {peak}(표준편차 {rms})이며 풍향은 {axis} 방향이다.",
        },
        NoLimit => {
            en: "What people bear is not judged: no limit of a code is held here, and the wind of a design comes once in decades.« Write wind.acceleration_limit to have it judged.»",
            ko: "거주성은 판정하지 않았다. 기준의 한계값이 수록되어 있지 않으며 설계풍은 수십 년에 한 번 부는 바람이다.« wind.acceleration_limit를 입력하면 판정한다.»",
        },
        BeyondAcceleration { peak: Quantity, limit: Quantity, axis: Sentence } => {
            en: "The top floor is beyond its limit in the wind along {axis}: its peak acceleration is {peak}, {limit} is allowed.",
            ko: "{axis} 방향 바람에서 최상층 최대가속도 {peak}이(가) 허용값 {limit}을(를) 넘는다.",
        },
        WithinAcceleration { peak: Quantity, limit: Quantity, axis: Sentence } => {
            en: "The peak acceleration of the top floor is {peak} in the wind along {axis}; {limit} is allowed.",
            ko: "최상층 최대가속도는 {axis} 방향 바람에서 {peak}이며 허용값 {limit} 이내이다.",
        },
        Drift { ratio: Quantity, floor: Sentence, axis: Sentence } => {
            en: "In the wind of the file the largest peak drift at an edge is {ratio} of the storey height, below floor {floor}, the wind along {axis}.",
            ko: "입력한 바람에서 단부 최대 층간변위는 {floor} 바닥 아래에서 층고의 {ratio}이며 풍향은 {axis} 방향이다.",
        },
        WithinDrift { ratio: Quantity, limit: Quantity, floor: Sentence, axis: Sentence } => {
            en: "In the wind of the file the largest peak drift at an edge is {ratio} of the storey height, below floor {floor}, the wind along {axis}; {limit} is allowed.",
            ko: "입력한 바람에서 단부 최대 층간변위는 {floor} 바닥 아래에서 층고의 {ratio}이며 풍향은 {axis} 방향이다. 허용값 {limit} 이내이다.",
        },
        BeyondDrift { ratio: Quantity, limit: Quantity, floor: Sentence, axis: Sentence } => {
            en: "The storey below floor {floor} is beyond its limit in the wind along {axis}: it drifts by {ratio} of its height, {limit} is allowed.",
            ko: "{axis} 방향 바람에서 {floor} 바닥 아래층의 층간변위비 {ratio}이(가) 허용값 {limit}을(를) 넘는다.",
        },
        BeyondRoom { damper: Sentence, needed: Quantity, has: Quantity } => {
            en: "Damper {damper} is beyond its room in the wind: it needs {needed} each way and has {has}.",
            ko: "바람에 대한 감쇠기 {damper}의 행정 {needed}이(가) 여유 공간 {has}을(를) 넘는다.",
        },
        With { acceleration: Quantity, drift: Quantity } => {
            en: "With the dampers the peak acceleration of the top floor is {acceleration} of that without, the largest drift {drift}.",
            ko: "감쇠기를 설치하면 최상층 최대가속도는 설치하지 않을 때의 {acceleration}, 최대 층간변위는 {drift}이다.",
        },
        Slender(slenderness: Quantity) => {
            en: "It is slender (height over √(breadth × depth) is {slenderness}): gusts and vortices across the wind may move it more than those along it, and are not in these numbers.",
            ko: "세장한 건물이다(높이/√(폭×깊이) = {slenderness}). 여기에 포함되지 않은 풍직각방향 진동이 풍방향보다 클 수 있다.",
        },
        NotComputed(why: Both) => {
            en: "The motion in the wind is not computed: {why}.",
            ko: "풍응답을 계산하지 않았다: {why}.",
        },
    }
}

/// Results that could not be computed, and why.
pub(super) fn wind_refused(standing: &StandingBuilding) -> Option<Blown> {
    let why = standing.wind_refused.clone()?;
    Some(Blown::NotComputed(why))
}

/// The findings of the wind, the worst first.
pub(super) fn wind_findings(answer: &BuildingAnswer, standing: &StandingBuilding) -> Vec<Finding> {
    let mut all: Vec<Finding> = wind_refused(standing)
        .map(|said| Finding::key(Tone::Unknown, said))
        .into_iter()
        .collect();
    let Some(wind) = &standing.wind else {
        return all;
    };
    all.extend(beyond_room(standing));
    all.extend(acceleration(wind));
    all.extend(drift(answer, standing, wind));
    all.extend(with_dampers(standing, wind).map(|said| Finding::key(Tone::Plain, said)));
    // breadths across the wind along x and along y: depth and breadth
    let breadths_m = wind.along.each_ref().map(WindAlong::breadth_m);
    all.extend(slender(&standing.building, breadths_m).map(|said| Finding::key(Tone::Warn, said)));
    all
}

/// Dampers that need more room in the wind than they have.
pub(super) fn beyond_room(standing: &StandingBuilding) -> Vec<Finding> {
    let beyond = standing
        .wind
        .iter()
        .flat_map(|wind| wind.beyond_room(&standing.dampers));
    beyond
        .map(|of| {
            let said = Blown::BeyondRoom {
                damper: stroke_words(&of.name),
                needed: significant(of.stroke_m, millimetres(), 4),
                has: significant(of.room_m, millimetres(), 4),
            };
            Finding::key(Tone::Bad, said)
        })
        .collect()
}

fn acceleration(wind: &BuildingWind) -> Vec<Finding> {
    let Some((axis, top)) = wind.top_acceleration() else {
        return Vec::new();
    };
    let shown = |value: f64| significant(value, Unit::si("m/s²"), 3);
    let (axis, peak) = (axis_words(axis), shown(top.peak()));
    match wind.acceleration_limit_m_s2 {
        None => {
            let rms = shown(top.rms);
            vec![
                Finding::key(Tone::Plain, Blown::Acceleration { peak, rms, axis }),
                Finding::new(Tone::Plain, Blown::NoLimit),
            ]
        }
        Some(limit_m_s2) => {
            let limit = shown(limit_m_s2);
            vec![match top.peak() <= limit_m_s2 {
                true => Finding::key(Tone::Good, Blown::WithinAcceleration { peak, limit, axis }),
                false => Finding::key(Tone::Bad, Blown::BeyondAcceleration { peak, limit, axis }),
            }]
        }
    }
}

fn drift(answer: &BuildingAnswer, standing: &StandingBuilding, wind: &BuildingWind) -> Option<Finding> {
    let (axis, storey, of_height) = wind.largest_drift(&standing.building)?;
    let (floor, axis) = (floor_words(&answer.floors[storey]), axis_words(axis));
    let ratio = Quantity::percent(of_height, 3);
    Some(match wind.drift_limit {
        Some(limit) if of_height > limit => Finding::key(
            Tone::Bad,
            Blown::BeyondDrift {
                ratio,
                limit: Quantity::percent(limit, 3),
                floor,
                axis,
            },
        ),
        Some(limit) if of_height <= limit => Finding::key(
            Tone::Good,
            Blown::WithinDrift {
                ratio,
                limit: Quantity::percent(limit, 3),
                floor,
                axis,
            },
        ),
        _ => Finding::key(Tone::Plain, Blown::Drift { ratio, floor, axis }),
    })
}

fn with_dampers(standing: &StandingBuilding, wind: &BuildingWind) -> Option<Blown> {
    wind.along[0].with.as_ref()?;
    let without = wind.without_dampers();
    let (_, with_top) = wind.top_acceleration()?;
    let (_, without_top) = without.top_acceleration()?;
    let (_, _, with_drift) = wind.largest_drift(&standing.building)?;
    let (_, _, without_drift) = without.largest_drift(&standing.building)?;
    Some(Blown::With {
        acceleration: Quantity::percent(with_top.peak() / without_top.peak(), 3),
        drift: Quantity::percent(with_drift / without_drift, 3),
    })
}

/// Finding that it is slender; the breadths are those across the wind along x and along y, m.
pub(crate) fn slender(building: &Building, [across_x, across_y]: [f64; 2]) -> Option<Blown> {
    let height_m = building.floor_heights_m().last().copied()?;
    let slenderness = height_m / (across_x * across_y).sqrt();
    (slenderness >= SLENDER).then(|| Blown::Slender(Quantity::ratio(slenderness, 3)))
}
