//! Earthquakes at the structure.

use super::numbers::percent;
use crate::document::{Finding, Tone};
use dolmen::modal::LastingChange;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::watched::{WatchAnswer, WatchedEarthquake};

messages! {
    /// Earthquakes in a history.
    pub(crate) enum Felt in "watch.earthquakes" {
        Open { survey: String, peak: Sentence, changed: Sentence } => {
            en: "ALARM: an earthquake on {survey}{peak}{changed}, and no repair or inspection followed. Look at the structure; then enter it into «works of [watch]|the list of works».",
            ko: "경보: {survey}의 지진{peak}{changed} 이후 보수나 점검이 없다. 구조물을 점검하고 «[watch]의 works|조치 이력»에 기록한다.",
        },
        Answered { survey: String, peak: Sentence, changed: Sentence } => {
            en: "An earthquake on {survey}{peak}{changed}; a repair or inspection followed.",
            ko: "{survey}의 지진{peak}{changed} 이후 보수나 점검이 있었다.",
        },
        PeakOf { peak: Quantity } => { en: ", peak acceleration {peak}", ko: "(최대가속도 {peak})" },
        AtLeast { peak: Quantity } => { en: ", peak acceleration at least {peak}", ko: "(최대가속도 {peak} 이상)" },
        ChangedBy { by: Quantity } => { en: ", a frequency changed by {by}", ko: "(고유진동수 변화 {by})" },
        NoMore => { en: "", ko: "" },
    }
}

/// Earthquakes, those without a later inspection first.
pub(super) fn earthquakes(answer: &WatchAnswer) -> Vec<Finding> {
    let said = |of: &WatchedEarthquake| {
        let survey = of.survey.clone();
        let peak = of.part.peak_m_s2.map_or(Felt::NoMore, |peak| {
            let peak = Quantity::new(peak, Unit::si("m/s²"), Digits::Significant(3));
            match of.part.is_at_least {
                true => Felt::AtLeast { peak },
                false => Felt::PeakOf { peak },
            }
        });
        let is_beyond = |by: &f64| {
            of.part
                .changed_sd
                .is_none_or(|sd| by.abs() > LastingChange::BEYOND * sd)
        };
        let changed = of.part.changed.filter(is_beyond);
        let changed = changed.map_or(Felt::NoMore, |by| Felt::ChangedBy { by: percent(by, 1) });
        let (peak, changed) = (peak.into(), changed.into());
        match of.is_answered {
            true => Finding::new(
                Tone::Plain,
                Felt::Answered {
                    survey,
                    peak,
                    changed,
                },
            ),
            false => Finding::key(
                Tone::Bad,
                Felt::Open {
                    survey,
                    peak,
                    changed,
                },
            ),
        }
    };
    let mut all: Vec<Finding> = answer.earthquakes.iter().map(said).collect();
    all.sort_by_key(|finding| !finding.is_key);
    all
}
