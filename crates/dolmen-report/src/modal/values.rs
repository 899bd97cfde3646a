//! Values of records and modes with suitable digits.

use dolmen::modal::Mode;
use dolmen_words::{Digits, Quantity, Unit, Values};

/// A frequency in a sentence.
pub(super) fn hertz(frequency_hz: f64) -> Quantity {
    Quantity::new(frequency_hz, Unit::si("Hz"), Digits::Fixed(3))
}

/// Several frequencies.
pub(super) fn all_hertz(frequency_hz: &[f64]) -> Values {
    Values(frequency_hz.iter().map(|hz| hertz(*hz)).collect())
}

/// A share in per cent.
pub(super) fn percent(share: f64, decimals: usize) -> Quantity {
    Quantity::new(share, Unit::percent(), Digits::Fixed(decimals))
}

/// A time.
pub(super) fn seconds(time_s: f64) -> Quantity {
    Quantity::new(time_s, Unit::si("s"), Digits::Trimmed(6))
}

/// A number without a unit and without trailing zeros.
pub(super) fn plain(value: f64) -> Quantity {
    Quantity::new(value, Unit::ratio(), Digits::Trimmed(6))
}

/// A number without a unit, with this many decimals.
pub(super) fn fixed(value: f64, decimals: usize) -> Quantity {
    Quantity::new(value, Unit::ratio(), Digits::Fixed(decimals))
}

/// The frequency of a mode with its standard deviation.
pub(super) fn frequency(mode: &Mode) -> Quantity {
    Quantity {
        sd_si: mode.frequency_sd_hz,
        ..Quantity::new(mode.frequency_hz, Unit::si("Hz"), Digits::Significant(5))
    }
}

/// The damping ratio of a mode with its standard deviation, if it has one.
pub(super) fn damping(mode: &Mode) -> Option<Quantity> {
    mode.damping_ratio.map(|damping_ratio| Quantity {
        sd_si: mode.damping_ratio_sd,
        ..Quantity::new(damping_ratio, Unit::percent(), Digits::Significant(3))
    })
}
