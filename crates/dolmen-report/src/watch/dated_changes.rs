//! Steps and changes of slope of a trend, with the surveys before and after them.

use super::cause::{Cause, cause};
use crate::document::{Finding, Tone};
use dolmen::monitoring::{TiltChange, TiltTrend};
use dolmen_words::Sentence;
use dolmen_work::watched::WatchAnswer;

/// A change of a trend.
pub(super) struct DatedChange<'a> {
    /// Index among the changes of the trend.
    pub(super) at: usize,
    /// The change.
    pub(super) of: &'a TiltChange,
    /// The survey of the change.
    pub(super) about: String,
    /// The survey before it.
    pub(super) after: String,
    /// The survey after it.
    pub(super) before: String,
    /// The work between both.
    pub(super) cause: Cause,
}

/// Sentences about each change of a trend; `survey` gives the survey of a reading.
pub(super) fn changes_said<S: Into<Sentence>>(
    answer: &WatchAnswer,
    trend: &TiltTrend,
    survey: &dyn Fn(usize) -> String,
    said: impl Fn(DatedChange<'_>) -> S,
) -> Vec<Finding> {
    let day = |reading: usize| trend.series.days.get(reading).copied().unwrap_or(f64::NAN);
    let each = trend.changes.iter().enumerate().map(|(at, of)| DatedChange {
        at,
        of,
        about: survey(of.from),
        after: survey(of.after),
        before: survey(of.before),
        cause: cause(answer, [day(of.after), day(of.before)]),
    });
    each.map(|of| Finding::key(Tone::Warn, said(of))).collect()
}
