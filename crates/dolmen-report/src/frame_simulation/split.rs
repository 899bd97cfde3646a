//! A frame whose beds and joints share its stiffness: how it moves with all of it in the joints, and with all of it in the beds.

use super::title::title;
use crate::document::{Finding, Tone};
use crate::simulated::{capitalised, millimetres, seconds};
use dolmen::dynamics::ColumnOutcome;
use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::frame::{ColumnsOnBeds, FrameSimulation};

messages! {
    /// Beds and joints that share a stiffness.
    pub(crate) enum Split in "frame.simulation.split" {
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

/// The range of the drift over both extremes.
pub(super) fn finding(simulation: &FrameSimulation, run: &ColumnsOnBeds) -> Finding {
    let history = &run.history;
    let peak_m = simulation.history.drift_peaks.first();
    let peak_m = peak_m.map_or(0.0, |peak| peak.value_m.abs());
    let share = |drift_m: f64| Quantity::percent(drift_m / run.height_m, 3);
    let (of, joints, joints_share) = (title(simulation), millimetres(peak_m), share(peak_m));
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
