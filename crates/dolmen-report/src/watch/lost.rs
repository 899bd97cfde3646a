//! Modes that are missing or different in the last surveys, and modes that wander.

use super::numbers::{hertz, name, percent, plain};
use crate::document::{Finding, Tone};
use dolmen::numeric::quantile;
use dolmen_words::{Quantity, Values, messages};
use dolmen_work::watched::WatchAnswer;
use std::collections::BTreeSet;

messages! {
    /// Findings on modes that are not there, or not in one place.
    pub(crate) enum Missing in "watch.lost" {
        Lost { modes: Values, since: String, missed: usize, found: usize, of: usize } => {
            en: "ALARM: not found since {since}: {modes}; surveys missing it: {missed}, found before in {found} of {of}. It changed by more than the modes are looked for, or the measurement lost it. Look at the structure and at these records; then enter it into «works of [watch]|the list of works».",
            ko: "경보: {since}부터 확인되지 않는 모드: {modes}. 누락 {missed}회, 이전에는 {of}회 중 {found}회 확인되었다. 추적 범위를 넘게 변하였거나 계측에서 놓친 것이다. 구조물과 해당 기록을 점검하고 «[watch]의 works|조치 이력»에 기록한다.",
        },
        LostOnce { modes: Values, since: String, found: usize, of: usize } => {
            en: "Not found since {since}: {modes}, found before in {found} of {of} surveys. That may be chance; if the next survey misses it too, it is none. Measure again soon.",
            ko: "{since}부터 확인되지 않는 모드: {modes}(이전 {of}회 중 {found}회 확인). 우연일 수 있으나 다음 조사에서도 확인되지 않으면 우연으로 보기 어렵다. 곧 다시 계측한다.",
        },
        Unseen { modes: Values, direction: String, last: String } => {
            en: "Last found on {last}: {modes}; of it nothing is known since, as no later survey has a mode along {direction}. Measure along {direction} again; if that was done, look at the structure and at these records.",
            ko: "{last}에 마지막으로 확인된 모드: {modes}. 이후 조사에는 {direction} 방향 모드가 하나도 없어 그 뒤의 상태를 알 수 없다. {direction} 방향을 다시 계측하고, 계측하였다면 구조물과 해당 기록을 점검한다.",
        },
        Began { from: Quantity, to: Quantity, by: Quantity } => {
            en: "{to} began there with the shape of {from}: if it is the same mode, it changed by {by}.",
            ko: "그때 {from} 모드와 같은 형상의 {to} 모드가 나타났다. 같은 모드라면 {by} 변한 것이다.",
        },
        Wanders { frequency: Quantity, by: Quantity, stated: Quantity } => {
            en: "{frequency} wanders by {by} (standard deviation), where its surveys state {stated} and the weather does not explain it: several steps would look so, too. Whether it changed lastingly cannot be said; look at the chart.",
            ko: "{frequency} 모드는 표준편차 {by}(으)로 서서히 변동하는데 조사별 오차는 {stated}이고 기상으로 설명되지 않는다. 여러 번의 급변도 이렇게 나타난다. 지속적인 변화인지 판단할 수 없으므로 그래프를 확인한다.",
        },
        LastApart { last: String, frequency: Quantity, change: Quantity, usual: Quantity, times: Quantity } => {
            en: "The last survey, {last}, has {frequency}: {change} from the median of those before it, {usual}, and {times} times the standard deviations of both. With so few surveys that gives no alarm, and the weather may do it; look at it with «`dolmen compare`|the comparison of two surveys».",
            ko: "마지막 조사 {last}의 고유진동수는 {frequency}(으)로, 이전 조사의 중앙값 {usual}에서 {change} 변하였으며 표준편차의 {times}배이다. 조사가 적어 경보로 판정하지 않으며 기상의 영향일 수 있다. «`dolmen compare`|조사 비교»로 살펴본다.",
        },
    }
}

/// Modes missing in the last surveys.
pub(super) fn lost(answer: &WatchAnswer) -> Vec<Finding> {
    let watched = &answer.watched;
    let lost = &watched.lost;
    // the most reliable mode represents all
    let Some(least) = lost.iter().min_by(|a, b| a.chance.total_cmp(&b.chance)) else {
        return Vec::new();
    };
    let modes = Values(lost.iter().map(|of| mode_hz(answer, of.mode)).collect());
    let (since, found, of) = (name(answer, least.since), least.found, least.of);
    let first = match watched.is_mode_lost() {
        true => Finding::key(
            Tone::Bad,
            Missing::Lost {
                modes,
                since,
                missed: least.missed,
                found,
                of,
            },
        ),
        false => Finding::key(
            Tone::Warn,
            Missing::LostOnce {
                modes,
                since,
                found,
                of,
            },
        ),
    };
    let began = lost.iter().filter_map(|lost| {
        let (from_hz, to_hz) = (watched.modes.get(lost.mode)?.track.frequency_hz, lost.began_hz?);
        let said = Missing::Began {
            from: hertz(from_hz),
            to: hertz(to_hz),
            by: percent(to_hz / from_hz - 1.0, 2),
        };
        Some(Finding::key(first.tone, said))
    });
    let began: Vec<Finding> = began.collect();
    [first].into_iter().chain(began).collect()
}

/// Modes that went with their direction.
pub(super) fn unseen(answer: &WatchAnswer) -> Vec<Finding> {
    let unseen = &answer.watched.unseen;
    let direction = |mode: usize| {
        let track = answer.watched.modes.get(mode).map(|mode| &mode.track);
        track
            .and_then(|track| track.direction.clone())
            .unwrap_or_default()
    };
    let groups: BTreeSet<(usize, String)> = unseen.iter().map(|of| (of.last, direction(of.mode))).collect();
    let each = groups.into_iter().map(|(last, along)| {
        let own = unseen
            .iter()
            .filter(|of| of.last == last && direction(of.mode) == along);
        let said = Missing::Unseen {
            modes: Values(own.map(|of| mode_hz(answer, of.mode)).collect()),
            last: name(answer, last),
            direction: along,
        };
        Finding::key(Tone::Warn, said)
    });
    each.collect()
}

/// Correlation of neighbouring surveys, and ratio of the scatter to the stated deviations, from which a disturbance may be several
/// steps. Our choice.
const WANDERS: (f64, f64) = (0.8, 3.0);

/// Modes that wander more than measurement and weather explain.
pub(super) fn wandering(answer: &WatchAnswer) -> Vec<Finding> {
    // a single survey far off increases the residual without being wandering
    let off = answer.last_far_off();
    let modes = answer.watched.modes.iter().enumerate();
    let calm = modes.filter(|(i, _)| off.iter().all(|of| of.mode != *i));
    let each = calm.filter_map(|(_, mode)| {
        let disturbance = mode.weather.as_ref()?.disturbance;
        let sds = mode.track.modes.iter().enumerate().filter_map(|(survey, at)| {
            let of = answer.surveys.get(survey)?;
            Some((*of.frequency_sds_hz.get((*at)?)?)? / mode.track.frequency_hz)
        });
        let stated = quantile(&sds.collect::<Vec<_>>(), 0.5).ok()?;
        let wanders = disturbance.correlation >= WANDERS.0 && disturbance.sd >= WANDERS.1 * stated;
        let said = Missing::Wanders {
            frequency: hertz(mode.track.frequency_hz),
            by: percent(disturbance.sd, 2),
            stated: percent(stated, 2),
        };
        (wanders && mode.changes.is_empty()).then(|| Finding::key(Tone::Unknown, said))
    });
    each.collect()
}

/// Number of deviations from the median of earlier surveys from which the last one is reported, if it has no verdict. Our choice.
const APART_FROM: f64 = 4.0;

/// Modes whose last survey differs from the earlier ones, the most different first.
pub(super) fn last_apart(answer: &WatchAnswer) -> Vec<Finding> {
    let Some(last) = answer.surveys.len().checked_sub(1) else {
        return Vec::new();
    };
    let mut apart: Vec<(f64, Missing)> = Vec::new();
    for mode in &answer.watched.modes {
        let read = |survey: usize| {
            let at = (*mode.track.modes.get(survey)?)?;
            let of = answer.surveys.get(survey)?;
            Some((
                *of.frequencies_hz.get(at)?,
                of.frequency_sds_hz.get(at)?.unwrap_or(0.0),
            ))
        };
        let before: Vec<(f64, f64)> = (0..last).filter_map(read).collect();
        let Some((now_hz, now_sd_hz)) = read(last).filter(|_| before.len() >= 2) else {
            continue;
        };
        let usual_hz = middle(&before.iter().map(|(hz, _)| *hz).collect::<Vec<_>>());
        let off: Vec<f64> = before.iter().map(|(hz, _)| (hz - usual_hz).abs()).collect();
        let stated = middle(&before.iter().map(|(_, sd)| *sd).collect::<Vec<_>>());
        // the scaled median absolute deviation, but at least the stated deviations
        let usual_sd_hz = stated.max(1.4826 * middle(&off));
        let times = (now_hz - usual_hz).abs() / now_sd_hz.hypot(usual_sd_hz);
        if times.is_finite() && times >= APART_FROM {
            let found = Missing::LastApart {
                last: name(answer, last),
                frequency: hertz(now_hz),
                change: percent(now_hz / usual_hz - 1.0, 1),
                usual: hertz(usual_hz),
                times: plain(times, 0),
            };
            apart.push((times, found));
        }
    }
    apart.sort_by(|a, b| b.0.total_cmp(&a.0));
    apart
        .into_iter()
        .map(|(_, found)| Finding::key(Tone::Warn, found))
        .collect()
}

/// The median; NaN for no values.
fn middle(values: &[f64]) -> f64 {
    quantile(values, 0.5).unwrap_or(f64::NAN)
}

fn mode_hz(answer: &WatchAnswer, mode: usize) -> Quantity {
    let track = answer.watched.modes.get(mode).map(|mode| &mode.track);
    hertz(track.map_or(f64::NAN, |track| track.frequency_hz))
}
