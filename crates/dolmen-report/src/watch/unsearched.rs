//! Surveys that are doubtful in the search for changes, or left out, because they have no temperature.

use super::numbers::{hertz, name, percent, plain};
use crate::document::{Finding, Tone};
use dolmen::monitoring::WatchedMode;
use dolmen::numeric::quantile;
use dolmen_words::{Quantity, messages};
use dolmen_work::watched::WatchAnswer;
use std::collections::BTreeSet;

messages! {
    /// Findings on surveys without a temperature.
    pub(crate) enum Unsearched in "watch.unsearched" {
        Guessed { surveys: usize, from: String, to: String } => {
            en: "Surveys without a temperature: {surveys}, from {from} to {to}. In the search for changes they have the mean temperature of their time of the year, and what the weather does then as their error. Enter «temperature_c|the temperature»: less is missed with it.",
            ko: "기온이 없는 조사: {surveys}회({from}~{to}). 변화 검토에서 같은 계절의 평균 기온을 쓰고 그 계절 날씨의 영향을 오차에 더하였다. «temperature_c를|기온을» 적으면 더 작은 변화도 발견된다.",
        },
        LeftOut { surveys: usize, from: String, to: String, frequency: Quantity, by: Quantity, times: Quantity } => {
            en: "Left out of the search for changes, as their temperature is not known or too few others were as cold: surveys {surveys}, from {from} to {to}. Their median of {frequency} lies {by} off that of the others, {times} times the scatter of these.",
            ko: "기온을 알 수 없거나 그만큼 추운 조사가 너무 적어 변화 검토에서 제외한 조사: {surveys}회({from}~{to}). 이 조사들의 {frequency} 모드 중앙값은 나머지 조사의 중앙값에서 {by} 벗어나며 이는 나머지 조사 산포의 {times}배이다.",
        },
    }
}

/// Multiple of the scatter of the other surveys, beyond which surveys left out are far off. Our choice, as for a last survey without
/// a verdict.
const FAR_FROM: f64 = 4.0;
/// Ratio of the standard deviation to the median absolute deviation of normal values.
const OF_MEDIAN: f64 = 1.4826;

/// A mode in the surveys left out, compared with the others.
struct LeftOut {
    frequency_hz: f64,
    ratio: f64,
    times: f64,
}

impl LeftOut {
    fn of(answer: &WatchAnswer, mode: &WatchedMode) -> Option<Self> {
        let read = |survey: usize| {
            let at = (*mode.track.modes.get(survey)?)?;
            answer.surveys.get(survey)?.frequencies_hz.get(at).copied()
        };
        let all = 0..answer.surveys.len();
        let [of, others] = [true, false].map(|is_out| -> Vec<f64> {
            let own = all
                .clone()
                .filter(|survey| mode.strange.contains(survey) == is_out);
            own.filter_map(read).collect()
        });
        let (own_hz, usual_hz) = (quantile(&of, 0.5).ok()?, quantile(&others, 0.5).ok()?);
        let off: Vec<f64> = others.iter().map(|hz| (hz - usual_hz).abs()).collect();
        let scatter_hz = OF_MEDIAN * quantile(&off, 0.5).ok()?;
        let times = (own_hz - usual_hz).abs() / scatter_hz;
        times.is_finite().then_some(LeftOut {
            frequency_hz: mode.track.frequency_hz,
            ratio: own_hz / usual_hz - 1.0,
            times,
        })
    }
}

/// The mode that differs most between the surveys left out and the others.
fn farthest(answer: &WatchAnswer) -> Option<LeftOut> {
    let modes = answer.watched.modes.iter();
    let each = modes.filter_map(|mode| LeftOut::of(answer, mode));
    each.max_by(|a, b| a.times.total_cmp(&b.times))
}

/// Whether surveys left out are far off the others, so that "no change found" is not good news.
pub(super) fn is_far(answer: &WatchAnswer) -> bool {
    farthest(answer).is_some_and(|of| of.times >= FAR_FROM)
}

/// The surveys with an estimated seasonal temperature, and those left out, with their results.
pub(super) fn unsearched(answer: &WatchAnswer) -> Vec<Finding> {
    let surveys = |of: fn(&WatchedMode) -> &Vec<usize>| -> BTreeSet<usize> {
        answer.watched.modes.iter().flat_map(of).copied().collect()
    };
    let ends = |of: &BTreeSet<usize>| Some([name(answer, *of.first()?), name(answer, *of.last()?)]);
    let (guessed, strange) = (surveys(|mode| &mode.guessed), surveys(|mode| &mode.strange));
    let guess = ends(&guessed).map(|[from, to]| {
        let said = Unsearched::Guessed {
            surveys: guessed.len(),
            from,
            to,
        };
        Finding::key(Tone::Unknown, said)
    });
    let left_out = ends(&strange).zip(farthest(answer)).map(|([from, to], of)| {
        let is_unknown = strange.iter().any(|survey| {
            let of = answer.surveys.get(*survey);
            of.is_some_and(|of| of.temperature_c.is_none())
        });
        let said = Unsearched::LeftOut {
            surveys: strange.len(),
            from,
            to,
            frequency: hertz(of.frequency_hz),
            by: percent(of.ratio, 1),
            times: plain(of.times, 1),
        };
        match (of.times >= FAR_FROM, is_unknown) {
            (true, _) => Finding::key(Tone::Warn, said),
            (false, true) => Finding::key(Tone::Unknown, said),
            (false, false) => Finding::new(Tone::Plain, said),
        }
    });
    left_out.into_iter().chain(guess).collect()
}
