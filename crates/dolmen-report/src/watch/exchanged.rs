//! Directions that look exchanged since a survey: two modes take each other's frequency.

use super::numbers::{hertz, name};
use crate::document::{Finding, Tone};
use dolmen::monitoring::{ChangeForm, WatchedChange, WatchedMode};
use dolmen_words::{Quantity, messages};
use dolmen_work::watched::WatchAnswer;

messages! {
    /// Exchanged directions.
    pub(crate) enum Exchanged in "watch.exchanged" {
        Directions { first: String, second: String, since: String, from: Quantity, to: Quantity } => {
            en: "PROBABLY A SLIP: since {since} the modes along {first} and {second} have each other's frequency ({from} and {to}): are the two directions exchanged in the surveys from then on? Correct them before believing an alarm or a change; if they are right, look at the structure.",
            ko: "입력 오류 의심: {since}부터 {first} 방향과 {second} 방향 모드의 고유진동수({from}, {to})가 서로 바뀌었다. 그 이후 조사에서 두 방향을 바꾸어 적은 것은 아닌가? 경보나 변화로 판단하기 전에 고치고, 값이 맞다면 구조물을 점검한다.",
        },
    }
}

/// Most surveys on either side whose mean is compared.
const BESIDE: usize = 4;
/// Part of the step by which a mode may miss the frequency of the other. Our choice.
const MISSES_MOST: f64 = 0.25;

/// The first two modes that exchange their frequencies, if any do.
pub(super) fn exchanged(answer: &WatchAnswer) -> Option<Finding> {
    let modes = &answer.watched.modes;
    let mut pairs = (0..modes.len()).flat_map(|j| (0..j).map(move |i| (&modes[i], &modes[j])));
    let found = pairs.find_map(|(a, b)| {
        let (first, second) = (a.track.direction.clone()?, b.track.direction.clone()?);
        let since = exchanged_since(answer, a, b).filter(|_| first != second)?;
        Some(Exchanged::Directions {
            first,
            second,
            since: name(answer, since),
            from: hertz(a.track.frequency_hz),
            to: hertz(b.track.frequency_hz),
        })
    });
    found.map(|said| Finding::key(Tone::Warn, said))
}

/// The survey from which two modes have each other's frequency.
fn exchanged_since(answer: &WatchAnswer, a: &WatchedMode, b: &WatchedMode) -> Option<usize> {
    let steps = |mode: &WatchedMode| -> Vec<WatchedChange> {
        let steps = mode.changes.iter().filter(|of| of.form == ChangeForm::Step);
        steps.copied().collect()
    };
    let others = steps(b);
    let is_exchange = |own: &WatchedChange| {
        let meets = |other: &WatchedChange| own.after < other.before && other.after < own.before;
        let Some(other) = others.iter().find(|other| meets(other)) else {
            return false;
        };
        let of_both = beside(answer, a, own).zip(beside(answer, b, other));
        of_both.is_some_and(|([a_before, a_behind], [b_before, b_behind])| {
            let most = MISSES_MOST * (a_behind - a_before).abs().min((b_behind - b_before).abs());
            (a_behind - b_before).abs() <= most && (b_behind - a_before).abs() <= most
        })
    };
    steps(a).into_iter().find(is_exchange).map(|of| of.before)
}

/// Mean frequency of a mode in the surveys before and after a step, Hz.
fn beside(answer: &WatchAnswer, mode: &WatchedMode, step: &WatchedChange) -> Option<[f64; 2]> {
    let read = |survey: usize| {
        let at = (*mode.track.modes.get(survey)?)?;
        answer.surveys.get(survey)?.frequencies_hz.get(at).copied()
    };
    let mean = |all: Vec<f64>| (!all.is_empty()).then(|| all.iter().sum::<f64>() / all.len() as f64);
    let before = (0..=step.after).rev().filter_map(read).take(BESIDE).collect();
    let behind = (step.before..answer.surveys.len())
        .filter_map(read)
        .take(BESIDE)
        .collect();
    Some([mean(before)?, mean(behind)?])
}
