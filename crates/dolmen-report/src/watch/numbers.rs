//! Numbers of a history, with suitable digits.

use dolmen_words::message::Both;
use dolmen_words::{Digits, Language, Quantity, Unit};
use dolmen_work::date_text;
use dolmen_work::watched::WatchAnswer;
use dolmen_work::watched_log::WatchedLog;

pub(super) fn hertz(frequency_hz: f64) -> Quantity {
    Quantity::new(frequency_hz, Unit::si("Hz"), Digits::Significant(4))
}

pub(super) fn percent(share: f64, decimals: usize) -> Quantity {
    Quantity::new(share, Unit::percent(), Digits::Fixed(decimals))
}

/// The same without its unit, for "1.52 ± 0.12 %".
pub(super) fn bare_percent(share: f64, decimals: usize) -> Quantity {
    let mut bare = percent(share, decimals);
    bare.unit.symbol.clear();
    bare
}

pub(super) fn plain(value: f64, decimals: usize) -> Quantity {
    Quantity::new(value, Unit::ratio(), Digits::Fixed(decimals))
}

/// A tilt as mm a metre.
pub(super) fn slope(ratio: f64, decimals: usize) -> Quantity {
    Quantity::new(1000.0 * ratio, Unit::ratio(), Digits::Fixed(decimals))
}

/// Half width of a 95 % interval, in standard deviations.
pub(super) const HALF_95: f64 = 1.959963984540054;

/// Days of a mean Gregorian year.
pub(super) const YEAR_DAYS: f64 = 365.2425;

/// A tilt in mm/m, or a width in mm.
pub(super) fn logged(value: f64, is_tilt: bool, decimals: usize) -> Quantity {
    Quantity::new(1000.0 * value, logged_unit(is_tilt), Digits::Fixed(decimals))
}

/// The same without its unit, for "1.52 ± 0.12 mm".
pub(super) fn bare_logged(value: f64, is_tilt: bool, decimals: usize) -> Quantity {
    let mut bare = logged(value, is_tilt, decimals);
    bare.unit.symbol.clear();
    bare
}

pub(super) fn logged_unit(is_tilt: bool) -> Unit {
    Unit::si(if is_tilt { "mm/m" } else { "mm" })
}

pub(super) fn name(answer: &WatchAnswer, survey: usize) -> String {
    answer
        .surveys
        .get(survey)
        .map_or_else(String::new, |survey| survey.name.clone())
}

/// The month of a day: "2026-11".
pub(super) fn month_of(day: f64) -> String {
    date_text(day).chars().take("2026-11".len()).collect()
}

/// Name of a log.
pub(crate) fn label(log: &WatchedLog) -> Both {
    match &log.part.label {
        None => log.part.name.as_str().into(),
        Some(names) => Both::of(|language| match language {
            Language::English => names.english(),
            Language::Korean => names.korean(),
        }),
    }
}
