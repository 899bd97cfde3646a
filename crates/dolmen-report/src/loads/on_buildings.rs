//! Static loads on buildings, with the wind and the earthquake of their combinations: findings and tables.

use super::section::Shown;
use super::words::{DIGITS, Found, what};
use crate::building::{axis_words, beside, floor_words, millimetres, name, scaled, significant};
use crate::document::{Block, Cell, Column, Document, Figure, Finding, Table, Tone, table_series};
use crate::figures::building_drifts;
use crate::html::words::set;
use dolmen::stability::Verdict;
use dolmen_project::LoadPart;
use dolmen_words::{Quantity, Sentence, Unit, messages};
use dolmen_work::loads::{
    BuildingCombination, CombinationAnswer, LargestCombined, LoadsAnswer, StoreyCombined, UnknownMotion,
};

messages! {
    /// Drifts of a building under its combinations.
    pub(crate) enum OnBuildings in "loads.buildings" {
        WithinDrift { what: Sentence, ratio: Quantity, limit: Quantity, floor: Sentence, axis: Sentence } => {
            en: "{what}: the largest drift is {ratio} of the storey height, along {axis} below floor {floor}; {limit} is allowed.",
            ko: "{what}: 최대 층간변위는 {floor} 바닥 아래에서 {axis} 방향으로 층고의 {ratio}이며 허용값 {limit} 이내이다.",
        },
        BeyondDrift { what: Sentence, ratio: Quantity, limit: Quantity, floor: Sentence, axis: Sentence } => {
            en: "{what}: the storey below floor {floor} is beyond its limit: it drifts by {ratio} of its height along {axis}, and {limit} is allowed.",
            ko: "{what}: {floor} 바닥 아래층의 {axis} 방향 층간변위가 층고의 {ratio}(으)로 허용값 {limit}을(를) 넘는다.",
        },
        NoLimit { what: Sentence, ratio: Quantity, floor: Sentence, axis: Sentence } => {
            en: "{what}: the largest drift is {ratio} of the storey height, along {axis} below floor {floor}. The file gives no limit for it.« Write storey_drift into [limits].»",
            ko: "{what}: 최대 층간변위는 {floor} 바닥 아래에서 {axis} 방향으로 층고의 {ratio}이다. 파일에 허용값이 없어 판정하지 않았다.« [limits]에 storey_drift를 쓴다.»",
        },
        UnknownWind { what: Sentence } => {
            en: "{what}: its drifts are without the motion in the wind, which is not computed.",
            ko: "{what}: 풍응답을 계산하지 못하여 층간변위에 포함하지 않았다.",
        },
        UnknownEarthquake { what: Sentence } => {
            en: "{what}: its drifts are without the motion under the spectrum of the site, which is not computed.",
            ko: "{what}: 지점 스펙트럼에 대한 응답을 계산하지 못하여 층간변위에 포함하지 않았다.",
        },
        OnFloor { name: String, floor: Sentence, what: String } => {
            en: "Static load ‘{name}’ on floor {floor}: {what}.",
            ko: "정하중 ‘{name}’({floor} 바닥): {what}.",
        },
        Meaning => {
            en: "Drift: the largest of all storeys, at the worst corner of the floor above, over the height of the storey. Static loads have their sign; peaks of wind and earthquake come from either side and are added to their size, each at its own worst corner.",
            ko: "층간변위: 모든 층의 최댓값으로, 윗바닥의 가장 불리한 모서리에서의 값을 층고로 나눈 것이다. 정하중은 부호를 고려하고, 풍응답과 지진응답의 최댓값은 어느 쪽으로도 작용하므로 각각 가장 불리한 모서리의 값을 그 크기에 더한다.",
        },
        EarthquakeTimes => { en: "earthquake ×", ko: "지진 ×" },
        Drift => { en: "drift", ko: "층간변위" },
        Allowed => { en: "allowed", ko: "허용값" },
        Below => { en: "below floor", ko: "윗바닥" },
        Along => { en: "along", ko: "방향" },
        Judged => { en: "drift is", ko: "판정" },
        Within => { en: "within", ko: "이내" },
        Beyond => { en: "beyond", ko: "초과" },
        NotJudged => { en: "no limit", ko: "허용값 없음" },
        NotKnown => { en: "unknown", ko: "판정 불가" },
        Falls => { en: "falls", ko: "붕괴" },
        Still => { en: "none", ko: "없음" },
        Storeys { what: Sentence } => { en: "{what}: floors and storeys.", ko: "{what}: 바닥과 층별 결과." },
        StoreysMeaning => {
            en: "u, v and θ are those of the centre of mass of the floor under the static loads. Drifts of the storey below it are those at the worst corner: by static loads, in the wind, under the earthquake, and their sum over the height.",
            ko: "u, v, θ는 정하중에 의한 바닥 질량중심의 변위와 회전각이다. 아래층의 층간변위는 가장 불리한 모서리의 값으로, 정하중·바람·지진에 의한 것과 그 합을 층고로 나눈 것이다.",
        },
        Floor => { en: "Floor", ko: "바닥" },
        ByLoads { axis: Sentence } => { en: "loads, {axis}", ko: "정하중, {axis}" },
        InWind { axis: Sentence } => { en: "wind, {axis}", ko: "바람, {axis}" },
        Shaken { axis: Sentence } => { en: "earthquake, {axis}", ko: "지진, {axis}" },
        OfHeight { axis: Sentence } => { en: "of height, {axis}", ko: "층고 대비, {axis}" },
        AtCentre => {
            en: "Where a floor has no outline, the drift is that at its centre of mass, and torsion is not in it.",
            ko: "외곽선이 없는 바닥은 질량중심의 층간변위를 썼으며 비틀림이 포함되지 않았다.",
        },
        Figure => { en: "Drifts of the storeys under the worst combination.", ko: "가장 불리한 하중조합의 층간변위." },
    }
}

/// The findings of a building: of the worst combination, of the worst with the earthquake, and of each whose motion is unknown.
pub(super) fn findings(answer: &LoadsAnswer, is_contradicted: bool) -> Vec<Finding> {
    let mut all = Vec::new();
    for combination in &answer.combinations {
        let what = || what(answer, combination);
        let said = match combination.building().and_then(|of| of.unknown) {
            Some(UnknownMotion::Wind) => OnBuildings::UnknownWind { what: what() },
            Some(UnknownMotion::Earthquake) => OnBuildings::UnknownEarthquake { what: what() },
            None => continue,
        };
        all.push(Finding::key(Tone::Unknown, said));
    }
    let worst = answer.worst();
    let shaken =
        worst_shaken(answer).filter(|shaken| worst.is_none_or(|worst| !std::ptr::eq(worst, *shaken)));
    all.extend(worst.into_iter().chain(shaken).filter_map(|combination| {
        let of = combination.building()?;
        Some(of_combination(what(answer, combination), of, is_contradicted))
    }));
    all
}

/// The combination with the earthquake that uses most of its allowable drift.
fn worst_shaken(answer: &LoadsAnswer) -> Option<&CombinationAnswer> {
    let used = |of: &CombinationAnswer| {
        let building = of.building().filter(|building| building.earthquake > 0.0)?;
        Some(building.largest()?.ratio / building.drift_limit?)
    };
    let each = answer.combinations.iter().filter_map(|of| Some((used(of)?, of)));
    each.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, of)| of)
}

fn of_combination(what: Sentence, of: &BuildingCombination, is_contradicted: bool) -> Finding {
    let Some(largest) = of.largest() else {
        return Finding::key(Tone::Bad, Found::Falls(what));
    };
    if of.verdict() == Verdict::Marginal {
        let factor = Quantity::beside_one(of.weight_factor, DIGITS);
        let stable = Quantity::ratio(Verdict::MARGINAL_BELOW, 2);
        return Finding::key(Tone::Warn, Found::Heavy { what, factor, stable });
    }
    if largest.ratio == 0.0 {
        return Finding::key(Tone::Plain, Found::NothingPushes(what));
    }
    let (floor, axis) = (floor_words(&largest.storey.floor), axis_words(largest.axis));
    let ratio = Quantity::percent(largest.ratio, DIGITS);
    let limit = of
        .drift_limit
        .map(|limit| (largest.ratio > limit, Quantity::percent(limit, DIGITS)));
    match limit {
        None => Finding::key(
            Tone::Plain,
            OnBuildings::NoLimit {
                what,
                ratio,
                floor,
                axis,
            },
        ),
        Some((true, limit)) => {
            let said = OnBuildings::BeyondDrift {
                what,
                ratio,
                limit,
                floor,
                axis,
            };
            Finding::key(Tone::Bad, said)
        }
        Some((false, limit)) => {
            // a model that a survey contradicts gives no good news
            let tone = match is_contradicted || of.unknown.is_some() {
                true => Tone::Unknown,
                false => Tone::Good,
            };
            Finding::key(
                tone,
                OnBuildings::WithinDrift {
                    what,
                    ratio,
                    limit,
                    floor,
                    axis,
                },
            )
        }
    }
}

/// A static load on a floor.
pub(super) fn listed(load: &LoadPart, floor: &str) -> OnBuildings {
    let forces = [&load.force, &load.force_across].into_iter().zip(["x", "y"]);
    let acting =
        forces.filter_map(|(force, axis)| Some((force.as_ref().filter(|of| of.value != 0.0)?, axis)));
    let mut written: Vec<String> = acting
        .map(|(force, axis)| format!("{axis} {}", force.written))
        .collect();
    if let Some([x, y]) = &load.place {
        written.push(format!("({}, {})", x.written, y.written));
    }
    written.extend(
        load.torque
            .iter()
            .map(|torque| format!("θ {}", set(&torque.written))),
    );
    OnBuildings::OnFloor {
        name: load.name.clone(),
        floor: floor_words(floor),
        what: written.join(", "),
    }
}

/// All combinations side by side.
pub(super) fn combinations(answer: &LoadsAnswer) -> Table {
    let factor = |value: f64| Cell::number(Quantity::ratio(value, 3));
    let row = |combination: &CombinationAnswer| {
        let of = combination.building();
        let largest = of
            .and_then(BuildingCombination::largest)
            .filter(|of| of.ratio > 0.0);
        let drift = |largest: &LargestCombined<'_>| Quantity::percent(largest.ratio, DIGITS);
        let limit = of.and_then(|of| of.drift_limit);
        let is_beyond = largest
            .zip(limit)
            .is_some_and(|(largest, limit)| largest.ratio > limit);
        vec![
            Cell::words(what(answer, combination)),
            judged(of, largest.as_ref(), is_beyond),
            factor(combination.weight),
            factor(combination.wind),
            factor(combination.loads),
            factor(of.map_or(0.0, |of| of.earthquake)),
            match largest {
                Some(largest) if is_beyond => Cell::Bad(drift(&largest)),
                largest => Cell::Number(largest.as_ref().map(drift)),
            },
            Cell::Number(limit.map(|limit| Quantity::percent(limit, DIGITS))),
            Cell::words(largest.map_or_else(|| Sentence::of_symbol("–"), |of| name(&of.storey.floor))),
            Cell::words(largest.map_or_else(|| Sentence::of_symbol("–"), |of| axis_words(of.axis))),
        ]
    };
    let numbers = |head: Sentence| Column::numbers(head, Unit::ratio());
    Table {
        caption: vec![Shown::Combinations.into(), OnBuildings::Meaning.into()],
        columns: vec![
            Column::words(Shown::Combination),
            Column::words(OnBuildings::Judged),
            numbers(Shown::Weight.into()),
            numbers(Shown::WindTimes.into()),
            numbers(Shown::LoadsTimes.into()),
            numbers(OnBuildings::EarthquakeTimes.into()),
            Column::numbers(OnBuildings::Drift, Unit::percent()),
            Column::numbers(OnBuildings::Allowed, Unit::percent()),
            Column::words(OnBuildings::Below),
            Column::words(OnBuildings::Along),
        ],
        rows: answer.combinations.iter().map(row).collect(),
    }
}

fn judged(of: Option<&BuildingCombination>, largest: Option<&LargestCombined<'_>>, is_beyond: bool) -> Cell {
    let falls = of.is_some_and(|of| of.storeys.is_empty());
    let is_unknown = of.is_some_and(|of| of.unknown.is_some());
    let is_limited = of.is_some_and(|of| of.drift_limit.is_some());
    match (falls, is_beyond, is_unknown, largest, is_limited) {
        (true, ..) => Cell::BadWords(OnBuildings::Falls.into()),
        (_, true, ..) => Cell::BadWords(OnBuildings::Beyond.into()),
        (_, _, true, ..) => Cell::words(OnBuildings::NotKnown),
        (_, _, _, None, _) => Cell::words(OnBuildings::Still),
        (_, _, _, _, true) => Cell::words(OnBuildings::Within),
        (_, _, _, _, false) => Cell::words(OnBuildings::NotJudged),
    }
}

/// Floors and storeys under the worst combination, and the drifts by height.
pub(super) fn section<'a>(document: &mut Document<'a>, what: &Sentence, of: &'a BuildingCombination) {
    if of.storeys.is_empty() {
        return;
    }
    document.put(Block::Table(storeys(what, of)));
    if of.storeys.iter().any(|storey| storey.at_centre) {
        document.note(OnBuildings::AtCentre);
    }
    if of.largest().is_some_and(|largest| largest.ratio > 0.0) {
        let table = storeys(what, of);
        let caption = vec![OnBuildings::Figure.into()];
        let drawn = Figure::drawn(caption, move |language| building_drifts(of, language));
        document.charted(drawn.with_series(move || table_series(&table)));
    }
}

/// A part of the drift of a storey along x and y, m.
type Drift = fn(&StoreyCombined) -> [f64; 2];
/// The head of its column, from the axis.
type Head = fn(Sentence) -> OnBuildings;

fn storeys(what: &Sentence, of: &BuildingCombination) -> Table {
    let acts = |drift: Drift| {
        let mut all = of.storeys.iter().flat_map(drift);
        all.any(|m| m != 0.0)
    };
    let shown: Vec<(Drift, Head)> = [
        (
            (|of| of.loads_m) as Drift,
            (|axis| OnBuildings::ByLoads { axis }) as Head,
        ),
        (|of| of.wind_m, |axis| OnBuildings::InWind { axis }),
        (|of| of.earthquake_m, |axis| OnBuildings::Shaken { axis }),
    ]
    .into_iter()
    .filter(|(drift, _)| acts(*drift))
    .collect();
    let milliradians = || scaled("mrad", 1e3);
    let mut columns = vec![
        Column::words(OnBuildings::Floor),
        Column::numbers(Sentence::of_symbol("u"), millimetres()),
        Column::numbers(Sentence::of_symbol("v"), millimetres()),
        Column::numbers(Sentence::of_symbol("θ"), milliradians()),
    ];
    for (_, head) in &shown {
        columns.extend([0, 1].map(|axis| Column::numbers(head(axis_words(axis)), millimetres())));
    }
    columns.extend([0, 1].map(|axis| {
        let axis = axis_words(axis);
        Column::numbers(OnBuildings::OfHeight { axis }, Unit::percent())
    }));
    let largest = |value: fn(&StoreyCombined) -> f64| of.storeys.iter().map(value).fold(0.0, f64::max);
    let moved_m = largest(|of| of.displacement_m[0].abs().max(of.displacement_m[1].abs()));
    let turned = largest(|of| of.rotation_rad.abs());
    let row = |storey: &StoreyCombined| {
        let millimetre = |m: f64| Cell::number(beside(m, moved_m, millimetres()));
        let [u, v] = storey.displacement_m;
        let rotation = beside(storey.rotation_rad, turned, milliradians());
        let mut row = vec![
            Cell::words(name(&storey.floor)),
            millimetre(u),
            millimetre(v),
            Cell::number(rotation),
        ];
        for (drift, _) in &shown {
            row.extend(drift(storey).map(|m| Cell::number(significant(m, millimetres(), 4))));
        }
        row.extend(storey.drift_ratios().map(|ratio| {
            let shown = Quantity::percent(ratio, DIGITS);
            match of.drift_limit.is_some_and(|limit| ratio > limit) {
                true => Cell::Bad(shown),
                false => Cell::number(shown),
            }
        }));
        row
    };
    Table {
        caption: vec![
            OnBuildings::Storeys { what: what.clone() }.into(),
            OnBuildings::StoreysMeaning.into(),
        ],
        columns,
        rows: of.storeys.iter().rev().map(row).collect(),
    }
}
