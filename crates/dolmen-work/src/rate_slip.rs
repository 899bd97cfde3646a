//! Detects that all frequencies of two surveys differ by the ratio of their sampling rates: then one of the rates is probably wrong.

use crate::surveyed::SurveyAnswer;
use dolmen::assess::{ChangeNote, Surveyed};

/// Relative difference within which the ratio of frequencies is that of the rates. Our choice: frequencies of good records scatter less.
const ONE_RATIO: f64 = 0.005;
/// Fewest modes for that conclusion. Our choice.
const MODES_LEAST: usize = 2;

/// The wrong sampling rate that explains the change of all frequencies between two surveys; `None` without one.
pub(crate) fn rate_slip(
    before: (&Surveyed, Option<&SurveyAnswer>),
    after: (&Surveyed, Option<&SurveyAnswer>),
) -> Option<ChangeNote> {
    let rates_hz = [rate_hz(before.1?)?, rate_hz(after.1?)?];
    let factor = rates_hz[1] / rates_hz[0];
    if (factor - 1.0).abs() <= 2.0 * ONE_RATIO {
        return None;
    }
    let is_found_again = |wanted_hz: f64| {
        let modes = &after.0.modes;
        modes
            .iter()
            .any(|mode| (mode.frequency_hz / wanted_hz - 1.0).abs() <= ONE_RATIO)
    };
    let all = &before.0.modes;
    let count = |factor: f64| {
        let found = all
            .iter()
            .filter(|mode| is_found_again(mode.frequency_hz * factor));
        found.count()
    };
    let modes = count(factor);
    let least = all.len().min(after.0.modes.len()).max(MODES_LEAST);
    (modes >= least && count(1.0) == 0).then_some(ChangeNote::RateRatio {
        factor,
        rates_hz,
        modes,
    })
}

/// The sampling rate of the records of a survey, if they have the same.
fn rate_hz(answer: &SurveyAnswer) -> Option<f64> {
    let setups = answer.setups.iter().flat_map(|setups| &setups.records);
    let mut rates = answer
        .records
        .iter()
        .chain(setups)
        .map(|record| record.sampling_rate_hz);
    let first = rates.next()?;
    rates.all(|rate| rate == first).then_some(first)
}
