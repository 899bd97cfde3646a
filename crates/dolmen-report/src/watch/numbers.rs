//! Numbers of a history, with suitable digits.

use dolmen_words::{Digits, Quantity, Unit};
use dolmen_work::watched::WatchAnswer;

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
