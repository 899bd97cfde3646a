//! Findings of the last survey before an alarm.

use super::numbers::{HALF_95, bare_percent, hertz, name, percent, plain};
use crate::document::{Finding, Tone};
use dolmen::monitoring::{NotJudged, WatchedMode};
use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::watched::WatchAnswer;

messages! {
    /// Findings on the last survey.
    pub(crate) enum Last in "watch.last" {
        NotJudgedYet { last: String, reason: Sentence } => {
            en: "The survey of {last} was not judged: {reason}.",
            ko: "{last} 조사는 판정하지 않았다: {reason}.",
        },
        StandsOff { frequency: Quantity, by: Quantity, half: Quantity, since: String } => {
            en: "Since {since}, {frequency} lies {by} ± {half} off what the surveys before and the weather explain: in one or two surveys, too few to call it a lasting change. Measure again soon.",
            ko: "{since}부터 {frequency} 모드가 이전 조사와 기상으로 설명되는 값에서 {by} ± {half} 벗어났다. 조사가 1~2회뿐이어서 지속적인 변화로 판정하지 않는다. 곧 다시 계측한다.",
        },
        FarOff { last: String, frequency: Quantity, by: Quantity, score: Quantity, off: usize, of: usize } => {
            en: "The last survey, {last}, has {frequency} {by} off what those before it predict (score {score}; beyond ±3 lies one in 370 by chance); modes beyond ±3: {off} of {of}. One survey is no alarm yet: watch it, measure again soon.",
            ko: "마지막 조사 {last}에서 {frequency} 모드가 이전 조사의 예측보다 {by} 벗어났다(점수 {score}, 우연히 ±3을 벗어날 확률은 370회 중 1회). ±3을 벗어난 모드는 {of}개 중 {off}개이다. 조사 1회로는 아직 경보가 아니나 주의하여 곧 다시 계측한다.",
        },
        FurtherOff { last: String, frequency: Quantity, by: Quantity, score: Quantity, off: usize, of: usize } => {
            en: "Beside the alarm, the last survey, {last}, has {frequency} {by} off what those before it predict (score {score}; beyond ±3 lies one in 370 by chance); modes beyond ±3: {off} of {of}.",
            ko: "경보 외에 마지막 조사 {last}에서 {frequency} 모드도 이전 조사의 예측보다 {by} 벗어났다(점수 {score}, 우연히 ±3을 벗어날 확률은 370회 중 1회). ±3을 벗어난 모드는 {of}개 중 {off}개이다.",
        },
        TogetherOff { last: String, value: Quantity, limit: Quantity } => {
            en: "All modes of the last survey, {last}, together lie off what those before it predict: T² {value}, where one in 365 lies beyond {limit} by chance. Watch it, measure again soon.",
            ko: "마지막 조사 {last}의 모든 모드를 합하여 보면 이전 조사의 예측을 벗어났다. T²가 {value}이며 우연히 {limit}을(를) 넘을 확률은 365회 중 1회이다. 주의하여 곧 다시 계측한다.",
        },
    }
}

messages! {
    /// Why a survey was not judged.
    pub(crate) enum Unjudged in "watch.unjudged" {
        Training => { en: "too few surveys before it", ko: "이전 조사가 너무 적다" },
        NewLevel => { en: "the level after a repair or alarm is still being learned", ko: "보수 또는 경보 이후의 수준을 아직 익히는 중이다" },
        Temperature { temperature: Quantity } => { en: "too few earlier surveys near {temperature}", ko: "{temperature} 부근에서 실시한 이전 조사가 너무 적다" },
        NoTemperature => { en: "its temperature is not known", ko: "기온을 알 수 없다" },
        NotFound => { en: "none of the modes that are followed was found", ko: "추적 중인 모드가 확인되지 않았다" },
    }
}

/// Modes of the last survey that are off their prediction, without an alarm or a step that reports it.
pub(super) fn far_off(answer: &WatchAnswer) -> Vec<Finding> {
    let last = answer.surveys.len().saturating_sub(1);
    let is_said = |mode: usize| {
        let mut open = answer.watched.alarms.iter().filter(|of| !of.is_answered);
        let has_step = answer
            .watched
            .modes
            .get(mode)
            .is_some_and(|of| of.last_off.is_some());
        has_step || open.any(|of| of.mode == mode)
    };
    let off = answer.last_far_off();
    let is_alarmed = answer
        .watched
        .alarms
        .iter()
        .any(|of| !of.is_answered && of.alarm.survey == last);
    let new = off.iter().find(|of| !is_said(of.mode)).map(|of| {
        let (frequency, by) = (hertz(of.frequency_hz), percent(of.ratio, 2));
        let score = plain(of.score, 1);
        let (last, off, of) = (name(answer, last), off.len(), answer.watched.modes.len());
        match is_alarmed {
            true => Last::FurtherOff {
                last,
                frequency,
                by,
                score,
                off,
                of,
            },
            false => Last::FarOff {
                last,
                frequency,
                by,
                score,
                off,
                of,
            },
        }
    });
    let together = answer.last_t_squared().filter(|_| off.is_empty());
    let together = together.map(|of| Last::TogetherOff {
        last: name(answer, last),
        value: plain(of.value, 0),
        limit: plain(of.limit, 0),
    });
    new.into_iter()
        .chain(together)
        .map(|said| Finding::key(Tone::Warn, said))
        .collect()
}

/// Why the last survey has no verdict, if none of its modes has one.
pub(super) fn last_survey(answer: &WatchAnswer) -> Option<Finding> {
    let last = answer.surveys.len().checked_sub(1)?;
    if answer.watched.modes.is_empty() {
        return None; // only tilts are watched
    }
    let of_last = answer.watched.modes.iter().filter_map(|mode| {
        let found = mode.judged.judged.last()?;
        (found.survey == last).then_some(found)
    });
    let mut reason = Some(Unjudged::NotFound);
    for judged in of_last {
        match judged.score {
            Ok(_) => return None,
            Err(NotJudged::Training) => return None, // reported for the whole history
            Err(NotJudged::NewLevel) => reason = Some(Unjudged::NewLevel),
            Err(NotJudged::NoTemperature) => reason = Some(Unjudged::NoTemperature),
            Err(NotJudged::Temperature) => {
                let temperature_c = answer.surveys[last].temperature_c.unwrap_or(f64::NAN);
                let unit = dolmen_words::Unit::si("°C");
                let temperature = Quantity::new(temperature_c, unit, dolmen_words::Digits::Trimmed(3));
                reason = Some(Unjudged::Temperature { temperature });
            }
        }
    }
    let reason: Sentence = reason?.into();
    let last = name(answer, last);
    Some(Finding::key(Tone::Unknown, Last::NotJudgedYet { last, reason }))
}

/// Findings of only the last one or two surveys.
pub(super) fn last_off(answer: &WatchAnswer, mode: &WatchedMode) -> Option<Finding> {
    let off = mode.last_off?;
    let said = Last::StandsOff {
        frequency: hertz(mode.track.frequency_hz),
        by: bare_percent(off.ratio, 2),
        half: percent(HALF_95 * off.sd, 2),
        since: name(answer, off.from),
    };
    Some(Finding::key(Tone::Warn, said))
}
