//! Sentences on the motion of a building in histories of the wind.

use crate::building::{axis_words, floor_words, millimetres, significant, slender, stroke_words};
use crate::document::{Finding, Tone};
use crate::simulated::{seconds_whole, version_name};
use dolmen_words::{Quantity, Sentence, Unit, messages};
use dolmen_work::building::{InTime, WindSimulation};

messages! {
    /// Findings on histories of the wind.
    pub(crate) enum Blew in "wind-simulation.findings" {
        OfVariant { variant: Sentence } => { en: "All of this is of the variant: {variant}.", ko: "모두 대안의 결과이다: {variant}." },
        Acceleration { histories: usize, length: Quantity, peak: Quantity, least: Quantity, most: Quantity, axis: Sentence, mean_square: Quantity } => {
            en: "In {histories} histories of {length} each, the wind along {axis}, the peak acceleration of the top floor at its worst corner is {peak} in the mean, {least} to {most}; the mean square gives {mean_square}.",
            ko: "{axis} 방향 바람의 시간이력 {histories}개(각 {length})에서 최상층의 가장 불리한 모서리 최대가속도는 평균 {peak}({least}~{most})이며, 평균제곱법의 값은 {mean_square}이다.",
        },
        AccelerationOnce { length: Quantity, peak: Quantity, axis: Sentence, mean_square: Quantity } => {
            en: "In one history of {length}, the wind along {axis}, the peak acceleration of the top floor at its worst corner is {peak}; the mean square gives {mean_square}. One history says nothing of how peaks scatter: leave --repeats out for ten.",
            ko: "{axis} 방향 바람의 시간이력 1개({length})에서 최상층의 가장 불리한 모서리 최대가속도는 {peak}이며, 평균제곱법의 값은 {mean_square}이다. 시간이력 1개로는 최댓값의 산포를 알 수 없다. --repeats를 빼면 10개를 해석한다.",
        },
        BeyondOnce { limit: Quantity } => {
            en: "That is beyond its limit: {limit} is allowed.",
            ko: "허용값 {limit}을(를) 넘는다.",
        },
        WithinOnce { limit: Quantity } => {
            en: "That is within its limit: {limit} is allowed.",
            ko: "허용값 {limit} 이내이다.",
        },
        BeyondAcceleration { limit: Quantity, beyond: usize, histories: usize } => {
            en: "That is beyond its limit: {limit} is allowed; {beyond} of these {histories} histories go beyond it.",
            ko: "허용값 {limit}을(를) 넘는다. 시간이력 {histories}개 중 {beyond}개가 허용값을 넘는다.",
        },
        WithinAcceleration { limit: Quantity, beyond: usize, histories: usize } => {
            en: "That is within its limit: {limit} is allowed; {beyond} of these {histories} histories go beyond it.",
            ko: "허용값 {limit} 이내이다. 시간이력 {histories}개 중 {beyond}개가 허용값을 넘는다.",
        },
        NoLimit => {
            en: "What people bear is not judged.« Write wind.acceleration_limit to have it judged.»",
            ko: "거주성은 판정하지 않았다.« wind.acceleration_limit를 입력하면 판정한다.»",
        },
        Drift { ratio: Quantity, floor: Sentence, axis: Sentence, mean_square: Quantity } => {
            en: "The largest peak drift at an edge is {ratio} of the storey height in the mean, below floor {floor}, the wind along {axis}; the mean square gives {mean_square}.",
            ko: "단부 최대 층간변위는 {axis} 방향 바람에서 {floor} 바닥 아래에서 평균적으로 층고의 {ratio}이며, 평균제곱법의 값은 {mean_square}이다.",
        },
        BeyondDrift { ratio: Quantity, limit: Quantity, floor: Sentence, axis: Sentence, mean_square: Quantity } => {
            en: "The storey below floor {floor} is beyond its limit in the wind along {axis}: it drifts by {ratio} of its height in the mean, {limit} is allowed; the mean square gives {mean_square}.",
            ko: "{axis} 방향 바람에서 {floor} 바닥 아래층의 층간변위비가 평균 {ratio}으로 허용값 {limit}을(를) 넘는다. 평균제곱법의 값은 {mean_square}이다.",
        },
        BeyondRoom { damper: Sentence, needed: Quantity, has: Quantity } => {
            en: "Damper {damper} is beyond its room: it needs {needed} each way, in the mean of the histories or by the mean square, and has {has}. It would meet its stops, which these histories do not have, so that all values with dampers are too good.",
            ko: "감쇠기 {damper}의 행정이 시간이력 평균 또는 평균제곱법으로 {needed}이며 여유 공간 {has}을(를) 넘는다. 스토퍼 충돌을 고려하지 않아 감쇠기가 있을 때의 응답을 작게 평가한다.",
        },
        Struck { damper: Sentence, struck: usize, histories: usize, largest: Quantity, has: Quantity } => {
            en: "Damper {damper} meets its stops in {struck} of these {histories} histories, the largest stroke being {largest} of the {has} that it has: the histories do not have the stops, and are too good there.",
            ko: "감쇠기 {damper}이(가) 시간이력 {histories}개 중 {struck}개에서 스토퍼에 부딪친다(최대 행정 {largest}, 여유 공간 {has}). 시간이력에는 스토퍼가 없어 응답을 작게 평가한다.",
        },
        TooShort { length: Quantity } => {
            en: "Limits are of the ten minutes of the mean wind, in which the largest gusts may come at any time: of {length} nothing within them is decided. Leave --duration out.",
            ko: "한계는 평균풍속의 10분에 대한 것이며 최대 돌풍은 그 안에서 언제든 올 수 있다. {length}의 시간이력으로는 한계 이내를 판정할 수 없다. --duration을 뺀다.",
        },
        BeyondByMeanSquare { limit: Quantity, beyond: usize, histories: usize } => {
            en: "By the mean square that is beyond its limit, which decides: {limit} is allowed; {beyond} of {histories} histories go beyond it.",
            ko: "평균제곱법의 값이 허용값 {limit}을(를) 넘으며 이 값으로 판정한다. 시간이력 {histories}개 중 {beyond}개가 허용값을 넘는다.",
        },
        With { acceleration: Quantity, displacement: Quantity, axis: Sentence } => {
            en: "With the dampers the peak acceleration of that corner is {acceleration} of that without, the peak displacement of the top floor {displacement}, the wind along {axis}.",
            ko: "{axis} 방향 바람에서 감쇠기를 설치하면 모서리 최대가속도는 설치하지 않을 때의 {acceleration}, 최상층 최대변위는 {displacement}이다.",
        },
    }
}

/// The response, the worst first.
pub(super) fn findings(run: &WindSimulation) -> Vec<Finding> {
    let mut all = Vec::new();
    if let Some(variant) = version_name(run.variant.as_deref(), run.variant_title.as_ref()) {
        all.push(Finding::key(Tone::Plain, Blew::OfVariant { variant }));
    }
    for beyond in run.beyond_room() {
        all.push(Finding::key(
            Tone::Bad,
            Blew::BeyondRoom {
                damper: stroke_words(&beyond.name),
                needed: significant(beyond.stroke_m, millimetres(), 3),
                has: significant(beyond.room_m, millimetres(), 3),
            },
        ));
    }
    for struck in run.struck() {
        all.push(Finding::key(
            Tone::Bad,
            Blew::Struck {
                damper: stroke_words(&struck.name),
                struck: struck.histories,
                histories: run.seeds.len(),
                largest: significant(struck.largest_m, millimetres(), 3),
                has: significant(struck.room_m, millimetres(), 3),
            },
        ));
    }
    let is_limited = run.acceleration_limit_m_s2.is_some() || run.drift_limit.is_some();
    if is_limited && !run.is_as_long_as_its_wind() {
        let length = seconds_whole(run.duration_s);
        all.push(Finding::key(Tone::Warn, Blew::TooShort { length }));
    }
    acceleration(run, &mut all);
    all.extend(drift(run));
    all.extend(with_dampers(run).map(|said| Finding::key(Tone::Plain, said)));
    let breadths_m = run.along.each_ref().map(|along| along.breadth_m);
    all.extend(slender(&run.building, breadths_m).map(|said| Finding::key(Tone::Warn, said)));
    all
}

fn acceleration(run: &WindSimulation, all: &mut Vec<Finding>) {
    let (axis, top) = run.top_acceleration();
    let in_si = |value: f64| significant(value, Unit::si("m/s²"), 3);
    let histories = top.peaks.len();
    let least = top.peaks.iter().copied().fold(f64::INFINITY, f64::min);
    let (length, peak) = (seconds_whole(run.duration_s), in_si(top.peak()));
    let (axis, mean_square) = (axis_words(axis), in_si(top.mean_square.peak()));
    let said = match histories {
        1 => Blew::AccelerationOnce {
            length,
            peak,
            axis,
            mean_square,
        },
        _ => Blew::Acceleration {
            histories,
            length,
            peak,
            least: in_si(least),
            most: in_si(top.largest()),
            axis,
            mean_square,
        },
    };
    let Some(limit_m_s2) = run.acceleration_limit_m_s2 else {
        all.push(Finding::key(Tone::Plain, said));
        all.push(Finding::key(Tone::Plain, Blew::NoLimit));
        return;
    };
    let (limit, beyond) = (in_si(limit_m_s2), top.beyond(limit_m_s2));
    all.push(Finding::key(Tone::Plain, said));
    let is_beyond = top.peak() > limit_m_s2;
    if !is_beyond && run.judged_acceleration_m_s2() > limit_m_s2 {
        let said = Blew::BeyondByMeanSquare {
            limit,
            beyond,
            histories,
        };
        return all.push(Finding::key(Tone::Bad, said));
    }
    let tone = match (is_beyond, beyond) {
        (true, _) => Tone::Bad,
        (false, 0) => Tone::Plain,
        (false, _) => Tone::Warn,
    };
    all.push(Finding::key(
        tone,
        match is_beyond {
            true if histories == 1 => Blew::BeyondOnce { limit },
            false if histories == 1 => Blew::WithinOnce { limit },
            true => Blew::BeyondAcceleration {
                limit,
                beyond,
                histories,
            },
            false => Blew::WithinAcceleration {
                limit,
                beyond,
                histories,
            },
        },
    ));
}

fn drift(run: &WindSimulation) -> Option<Finding> {
    let drift = run.judged_drift()?;
    let of: &InTime = &run.motions()[drift.axis].drifts_m[drift.storey];
    let height_m = run.building.storeys()[drift.storey].height_m;
    let (floor, axis) = (floor_words(&run.floors[drift.storey]), axis_words(drift.axis));
    let ratio = Quantity::percent(of.peak() / height_m, 3);
    let mean_square = Quantity::percent(of.mean_square.peak() / height_m, 3);
    Some(match run.drift_limit {
        Some(limit) if drift.of_height > limit => Finding::key(
            Tone::Bad,
            Blew::BeyondDrift {
                ratio,
                limit: Quantity::percent(limit, 3),
                floor,
                axis,
                mean_square,
            },
        ),
        _ => Finding::key(
            Tone::Plain,
            Blew::Drift {
                ratio,
                floor,
                axis,
                mean_square,
            },
        ),
    })
}

fn with_dampers(run: &WindSimulation) -> Option<Blew> {
    let (axis, _) = run.top_acceleration();
    let along = &run.along[axis];
    let (with, without) = (along.with.as_ref()?, &along.without);
    Some(Blew::With {
        acceleration: Quantity::percent(with.corner_m_s2.peak() / without.corner_m_s2.peak(), 3),
        displacement: Quantity::percent(
            with.top_displacement_m.peak() / without.top_displacement_m.peak(),
            3,
        ),
        axis: axis_words(axis),
    })
}
