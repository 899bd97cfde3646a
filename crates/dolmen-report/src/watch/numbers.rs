//! Numbers of a history, with the digits that they deserve.

use dolmen_words::{Digits, Quantity, Unit};

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

/// Half of a 95 % interval, of a standard deviation.
pub(super) const HALF_95: f64 = 1.959963984540054;
