//! Logs near their limit, and logs that were at it before.

use super::numbers::{label, logged, percent};
use crate::document::{Finding, Tone};
use dolmen_words::message::Both;
use dolmen_words::{Quantity, messages};
use dolmen_work::date_text;
use dolmen_work::watched_log::WatchedLog;

messages! {
    /// Logs and their limits.
    pub(crate) enum Limited in "watch.logs.limits" {
        Near { label: Both, now: Quantity, date: String, share: Quantity, limit: Quantity } => {
            en: "{label}: NEAR ITS LIMIT: {now} ({date}), {share} of {limit}.",
            ko: "{label}: 한계에 가까움. {now}({date})(으)로 한계 {limit}의 {share}이다.",
        },
        WasAtLimit { label: Both, limit: Quantity, days: usize, last: String } => {
            en: "{label} was at its limit of {limit} or beyond; days: {days}, the last one {last}.",
            ko: "{label}의 측정값이 한계 {limit}에 이른 날이 {days}일 있었다(마지막 {last}).",
        },
    }
}

/// Finding that a log is near its limit.
pub(super) fn near(log: &WatchedLog) -> Option<Finding> {
    let limit = log.trend.limit.filter(|_| log.is_near())?;
    let ([_, last], judged, is_tilt) = (log.span()?, log.trend.size_to_judge(), log.is_tilt());
    let said = Limited::Near {
        label: label(log),
        now: logged(judged, is_tilt, 2),
        date: date_text(last),
        share: percent((judged / limit.size).abs(), 0),
        limit: logged(limit.size.copysign(judged), is_tilt, 2),
    };
    Some(Finding::key(Tone::Warn, said))
}

/// Finding that the log was at its limit earlier, but is not now.
pub(super) fn was_at_limit(log: &WatchedLog) -> Option<Finding> {
    let limit = log.trend.limit.filter(|_| !log.is_beyond())?;
    let last = log.trend.at_limit.last()?;
    let said = Limited::WasAtLimit {
        label: label(log),
        limit: logged(limit.size, log.is_tilt(), 2),
        days: log.trend.at_limit.len(),
        last: date_text(*last),
    };
    Some(Finding::key(Tone::Warn, said))
}
