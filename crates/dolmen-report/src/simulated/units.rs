//! Units of simulations.

use dolmen_words::{Digits, Quantity, Unit};

/// Energies from this value on are given in kJ.
const KILOJOULES_FROM_J: f64 = 1e3;
/// Residuals below this fraction of the largest are rounding.
const ROUNDING: f64 = 1e-9;

/// Seconds to the hundredth.
pub(crate) fn seconds(at_s: f64) -> Quantity {
    Quantity::new(at_s, Unit::si("s"), Digits::Fixed(2))
}

/// Seconds without trailing zeros: "600 s".
pub(crate) fn seconds_whole(length_s: f64) -> Quantity {
    Quantity::new(length_s, Unit::si("s"), Digits::Trimmed(6))
}

/// A thousandth of an SI unit: "mm", "mrad".
pub(crate) fn milli(symbol: &str) -> Unit {
    Unit {
        symbol: format!("m{symbol}"),
        factor: 1e3,
    }
}

/// A thousand SI units: "kN·m".
pub(crate) fn kilo(symbol: &str) -> Unit {
    Unit {
        symbol: format!("k{symbol}"),
        factor: 1e-3,
    }
}

/// The size of a length in mm.
pub(crate) fn millimetres(length_m: f64) -> Quantity {
    Quantity::new(length_m.abs(), milli("m"), Digits::Significant(4))
}

/// The size of an angle in mrad.
pub(crate) fn milliradians(angle_rad: f64) -> Quantity {
    Quantity::new(angle_rad.abs(), milli("rad"), Digits::Significant(4))
}

/// A residual value; 0 if it is rounding compared with the largest of its kind.
pub(crate) fn left(value_si: f64, largest_si: f64, unit: Unit) -> Quantity {
    let value_si = match value_si.abs() <= ROUNDING * largest_si.abs() {
        true => 0.0,
        false => value_si,
    };
    Quantity::new(value_si, unit, Digits::Significant(4))
}

/// J or kJ, by the largest of the energies.
pub(crate) fn energy_unit(energies_j: &[f64]) -> Unit {
    let most = energies_j
        .iter()
        .fold(0.0, |most: f64, energy| most.max(energy.abs()));
    match most >= KILOJOULES_FROM_J {
        true => kilo("J"),
        false => Unit::si("J"),
    }
}
