//! A frame of one storey whose beds and joints share its stiffness: its motion with the beds that the file gives, or, without them, with all of the
//! stiffness in the joints and all of it in the beds. Storeys whose softening is not followed.

use super::title::title;
use crate::document::{Finding, Tone};
use crate::simulated::{capitalised, millimetres, seconds};
use dolmen::dynamics::ColumnOutcome;
use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::frame::{
    AllInBeds, BedsFrom, ColumnsOnBeds, FrameSimulation, FrameTogether, UnfollowedStorey, WhySpringsAlone,
};

messages! {
    /// Beds and joints that share a stiffness.
    pub(crate) enum Split in "frame.simulation.split" {
        Given { of: Sentence, beds: Quantity, joints: Quantity, said: Sentence } => {
            en: "{of}: of the stiffness of the storey its beds have {beds}, as «bed_stiffness|the file» gives it, and joints and walls the other {joints}. {said}",
            ko: "{of}: 층강성 가운데 {beds}은(는) «bed_stiffness에|입력값에» 따라 기둥 지압면이, 나머지 {joints}은(는) 접합부와 벽체가 부담한다. {said}",
        },
        GivenStood { uplift: Quantity } => {
            en: "No foot lifts off; that begins at a drift of {uplift}.",
            ko: "주각은 들리지 않으며 들림 변위는 {uplift}이다.",
        },
        GivenRocked { uplift: Quantity, at: Quantity, drift: Quantity, share: Quantity, spring: Quantity } => {
            en: "Feet lift off at a drift of {uplift}, first at {at}, and soften the storey: it drifts by up to {drift}, {share} of its height. Springs alone give {spring}; the larger counts.",
            ko: "변위 {uplift}에서 주각이 들려({at}에 처음) 층강성이 낮아지며 최대 층간변위는 {drift}(층고의 {share})이다. 선형 강성으로는 {spring}이며, 큰 값으로 판정한다.",
        },
        GivenFell { uplift: Quantity, lifted: Quantity, falls: Quantity, at: Quantity } => {
            en: "Feet lift off at a drift of {uplift}, first at {lifted}, and at {at} the storey passes the drift at which it counts as fallen, {falls}. That decides, whatever springs give.",
            ko: "변위 {uplift}에서 주각이 들리고({lifted}에 처음) {at}에 전도로 보는 변위 {falls}을(를) 넘는다. 선형 강성에 의한 결과와 관계없이 이것으로 판정한다.",
        },
        GivenNotFollowed { lifted: Quantity } => {
            en: "Feet lift off, first at {lifted}, and rock so irregularly that shorter steps still change the largest drift. Nothing is decided.",
            ko: "주각이 들린 뒤({lifted}에 처음) 거동이 불규칙하여 시간 간격을 줄여도 최대 변위가 달라진다. 판정하지 않는다.",
        },
        TooStiff { of: Sentence, beds: Quantity, storey: Quantity } => {
            en: "{of}: with «bed_stiffness|the stiffness of beds that the file gives,» the beds of its columns alone would have {beds}, more than the {storey} of the whole storey. Both cannot be right, so that how beds and joints share the stiffness is assumed.",
            ko: "{of}: «bed_stiffness에|입력한 지압면 강성에» 따른 기둥 지압면만의 강성 {beds}이(가) 층 전체의 강성 {storey}보다 크다. 둘이 함께 옳을 수 없으므로 지압면과 접합부의 강성 분담을 가정하였다.",
        },
        Together { name: String, drift: Quantity, share: Quantity } => {
            en: "Both directions together: where feet lift off, each direction was followed under its own component. With the largest drifts of both at one time ‘{name}’ drifts by {drift}, {share} of its height, which counts. A foot that tilts both ways at once presses on less of its face than one that tilts either way; that is not followed.",
            ko: "두 방향을 합하면, 주각이 들린 뒤의 거동은 방향마다 그 성분만으로 해석하였다. 두 방향의 최댓값이 동시에 생긴다고 보면 ‘{name}’의 층간변위는 {drift}(층고의 {share})이며 이 값으로 판정한다. 두 방향으로 함께 기우는 주각은 한 방향일 때보다 접촉면이 작으며, 이는 추적하지 않았다.",
        },
        TogetherInBeds { name: String, drift: Quantity, share: Quantity } => {
            en: "Both directions together, with all of the stiffness in the beds: each direction was followed under its own component. With the largest drifts of both at one time ‘{name}’ drifts by {drift}, {share} of its height. A foot that tilts both ways at once presses on less of its face; that is not followed.",
            ko: "두 방향을 합하여 강성이 모두 기둥 지압면에서 나온다고 보면, 방향마다 그 성분만으로 해석하였다. 두 방향의 최댓값이 동시에 생긴다고 보면 ‘{name}’의 층간변위는 {drift}(층고의 {share})이다. 두 방향으로 함께 기우는 주각은 접촉면이 더 작으며, 이는 추적하지 않았다.",
        },
        Unlifted { of: Sentence, name: String, uplift: Quantity } => {
            en: "{of}: no foot of the columns of ‘{name}’ lifts off, however beds and joints share its stiffness; that begins at a drift of {uplift} at the earliest.",
            ko: "{of}: 지압면과 접합부의 강성 분담과 관계없이 ‘{name}’의 주각은 들리지 않는다. 들림 변위는 최소 {uplift}이다.",
        },
        UnfollowedGiven { of: Sentence, name: String, drift: Quantity, uplift: Quantity, why: Sentence } => {
            en: "{of}: on beds as stiff as «bed_stiffness|the file» says, the columns of ‘{name}’ lift off at a drift of {uplift}, and it drifts by {drift} on springs. Beyond the lift-off it is softer, which is not followed {why}.",
            ko: "{of}: «bed_stiffness의|입력한 강성의» 지압면에서 ‘{name}’의 주각은 변위 {uplift}에서 들리는데, 선형 강성에 의한 층간변위는 {drift}이다. 들린 뒤에는 더 유연하지만 {why} 이를 추적하지 않았다.",
        },
        UnfollowedAssumed { of: Sentence, name: String, drift: Quantity, uplift: Quantity, why: Sentence } => {
            en: "{of}: how beds and joints share the stiffness of ‘{name}’ is assumed: springs keep all of it, and it drifts by {drift}. With all of it in the beds of its columns feet lift off from {uplift} on and soften. No range of the drift was run {why}.",
            ko: "{of}: ‘{name}’의 지압면과 접합부의 강성 분담은 가정이다. 강성이 변하지 않는다고 보아 층간변위는 {drift}이다. 모두 기둥 지압면의 강성이면 {uplift}부터 주각이 들려 유연해지지만, {why} 층간변위의 범위를 해석하지 않았다.",
        },
        SeveralStoreys => { en: "with several storeys", ko: "여러 층이므로" },
        JointsOfTheirOwn => { en: "where joints rub or have slack", ko: "접합부에 마찰이나 유격이 있으므로" },
        Stood { of: Sentence } => {
            en: "{of}: also with all of its stiffness in the beds of its columns no foot lifts off, so that it does not matter how beds and joints share it.",
            ko: "{of}: 강성이 모두 기둥 지압면에서 나온다고 보아도 주각이 들리지 않으므로 지압면과 접합부의 강성 분담은 결과에 영향이 없다.",
        },
        Rocked { of: Sentence, joints: Quantity, joints_share: Quantity, beds: Quantity, beds_share: Quantity, at: Quantity } => {
            en: "{of}: how beds and joints share the stiffness of the storey is assumed, since a frequency measures only their sum. With all of it in the joints it drifts by up to {joints}, {joints_share} of its height; with all of it in the beds of its columns, which soften where feet lift off (first at {at}), by up to {beds}, {beds_share}.",
            ko: "{of}: 고유진동수는 지압면과 접합부 강성의 합만 나타내므로 그 분담은 가정이다. 모두 접합부의 강성이면 최대 층간변위는 {joints}(층고의 {joints_share}), 모두 기둥 지압면의 강성이면 주각이 들린 뒤({at}에 처음) 강성이 낮아져 {beds}({beds_share})이다.",
        },
        Fell { of: Sentence, joints: Quantity, joints_share: Quantity, at: Quantity } => {
            en: "{of}: how beds and joints share the stiffness of the storey is assumed, since a frequency measures only their sum. With all of it in the joints it drifts by up to {joints}, {joints_share} of its height; with all of it in the beds of its columns, which soften where feet lift off, it has fallen at {at}.",
            ko: "{of}: 고유진동수는 지압면과 접합부 강성의 합만 나타내므로 그 분담은 가정이다. 모두 접합부의 강성이면 최대 층간변위는 {joints}(층고의 {joints_share}), 모두 기둥 지압면의 강성이면 주각이 들린 뒤 강성이 낮아져 {at}에 전도된다.",
        },
        NotFollowed { of: Sentence, joints: Quantity, joints_share: Quantity } => {
            en: "{of}: how beds and joints share the stiffness of the storey is assumed, since a frequency measures only their sum. With all of it in the joints it drifts by up to {joints}, {joints_share} of its height; with all of it in the beds of its columns feet lift off and rock so irregularly that the largest drift is not known.",
            ko: "{of}: 고유진동수는 지압면과 접합부 강성의 합만 나타내므로 그 분담은 가정이다. 모두 접합부의 강성이면 최대 층간변위는 {joints}(층고의 {joints_share}), 모두 기둥 지압면의 강성이면 주각이 들린 뒤 거동이 불규칙하여 최대 층간변위를 알 수 없다.",
        },
    }
}

/// The motion with the beds that the file gives, and joints beside them.
pub(super) fn given(simulation: &FrameSimulation, run: &ColumnsOnBeds, of: Sentence) -> Finding {
    let history = &run.history;
    let uplift = millimetres(history.uplift_drift_m);
    let lifted = seconds(history.uplift_s.unwrap_or_default());
    let (tone, said) = match history.outcome {
        ColumnOutcome::Stood => (Tone::Plain, Split::GivenStood { uplift }),
        ColumnOutcome::Rocked => (
            Tone::Warn,
            Split::GivenRocked {
                uplift,
                at: lifted,
                drift: millimetres(history.peak_drift_m),
                share: share(history.peak_drift_m, run.height_m),
                spring: millimetres(spring_m(simulation)),
            },
        ),
        ColumnOutcome::Fell { at_s } => (
            Tone::Bad,
            Split::GivenFell {
                uplift,
                lifted,
                falls: millimetres(history.falls_drift_m),
                at: seconds(at_s),
            },
        ),
        ColumnOutcome::NotConverged => (Tone::Unknown, Split::GivenNotFollowed { lifted }),
    };
    let said = Split::Given {
        of,
        beds: stiffness(run.beds_n_m),
        joints: stiffness(run.run.joints_n_m),
        said: said.into(),
    };
    Finding::key(tone, capitalised(said.into()))
}

/// Beds that would be stiffer than the whole storey, and the range of the drift over both extremes of what beds and joints share.
pub(super) fn assumed(simulation: &FrameSimulation, assumed: &AllInBeds, of: &Sentence) -> Vec<Finding> {
    let too_stiff = match assumed.beds {
        BedsFrom::StoreyTooStiff { storey_n_m, beds_n_m } => {
            let said = Split::TooStiff {
                of: of.clone(),
                beds: stiffness(beds_n_m),
                storey: stiffness(storey_n_m),
            };
            Some(Finding::key(Tone::Warn, capitalised(said.into())))
        }
        BedsFrom::File | BedsFrom::Storey => None,
    };
    let range = range(simulation, &assumed.run, of.clone());
    too_stiff.into_iter().chain([range]).collect()
}

/// The range of the drift over both extremes.
fn range(simulation: &FrameSimulation, run: &ColumnsOnBeds, of: Sentence) -> Finding {
    let history = &run.history;
    let peak_m = spring_m(simulation);
    let share = |drift_m: f64| share(drift_m, run.height_m);
    let (joints, joints_share) = (millimetres(peak_m), share(peak_m));
    let (tone, said) = match history.outcome {
        ColumnOutcome::Stood => (Tone::Plain, Split::Stood { of }),
        ColumnOutcome::Rocked => (
            Tone::Warn,
            Split::Rocked {
                of,
                joints,
                joints_share,
                beds: millimetres(history.peak_drift_m),
                beds_share: share(history.peak_drift_m),
                at: seconds(history.uplift_s.unwrap_or_default()),
            },
        ),
        ColumnOutcome::Fell { at_s } => (
            Tone::Warn,
            Split::Fell {
                of,
                joints,
                joints_share,
                at: seconds(at_s),
            },
        ),
        ColumnOutcome::NotConverged => (
            Tone::Warn,
            Split::NotFollowed {
                of,
                joints,
                joints_share,
            },
        ),
    };
    Finding::key(tone, capitalised(said.into()))
}

/// Both directions together where feet lift off, each followed by itself.
pub(super) fn together(simulation: &FrameSimulation, both: &FrameTogether) -> Vec<Finding> {
    let ([storey], Some(name)) = (
        simulation.frame.frame().storeys(),
        simulation.storeys.first().cloned(),
    ) else {
        return Vec::new();
    };
    let drift_of = |drift_m: f64| (millimetres(drift_m), share(drift_m, storey.height_m));
    let softened = both.softened_m.map(|drift_m| {
        let ((drift, share), name) = (drift_of(drift_m), name.clone());
        Split::Together { name, drift, share }
    });
    let in_beds = both.all_in_beds_m.map(|drift_m| {
        let (drift, share) = drift_of(drift_m);
        Split::TogetherInBeds { name, drift, share }
    });
    let all = softened.into_iter().chain(in_beds);
    all.map(|said| Finding::key(Tone::Warn, said)).collect()
}

/// A storey whose softening is not followed.
pub(super) fn unfollowed(simulation: &FrameSimulation, storey: &UnfollowedStorey) -> Finding {
    let storeys = simulation.frame.frame().storeys();
    let height_m = storeys.get(storey.storey).map_or(0.0, |of| of.height_m);
    let (of, name) = (title(simulation), storey.name.clone());
    let (drift, uplift) = (
        millimetres(storey.drift * height_m),
        millimetres(storey.uplift * height_m),
    );
    if !storey.lifts_off() {
        return Finding::new(Tone::Plain, Split::Unlifted { of, name, uplift });
    }
    let why = Sentence::from(match storey.why {
        WhySpringsAlone::SeveralStoreys => Split::SeveralStoreys,
        WhySpringsAlone::JointsOfTheirOwn => Split::JointsOfTheirOwn,
    });
    let said = match storey.beds {
        BedsFrom::File => Split::UnfollowedGiven {
            of,
            name,
            drift,
            uplift,
            why,
        },
        BedsFrom::Storey | BedsFrom::StoreyTooStiff { .. } => Split::UnfollowedAssumed {
            of,
            name,
            drift,
            uplift,
            why,
        },
    };
    Finding::key(Tone::Warn, said)
}

/// The largest drift of the first storey on springs, m.
fn spring_m(simulation: &FrameSimulation) -> f64 {
    let peak = simulation.history.drift_peaks.first();
    peak.map_or(0.0, |peak| peak.value_m.abs())
}

fn share(drift_m: f64, height_m: f64) -> Quantity {
    Quantity::percent(drift_m / height_m, 3)
}

fn stiffness(value_n_m: f64) -> Quantity {
    Quantity::engineering(value_n_m, "N/m", 3)
}
