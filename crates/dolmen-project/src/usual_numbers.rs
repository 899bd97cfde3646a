//! Numbers in the form for doubts.

use dolmen_words::{Digits, Quantity, Unit};

const DIGITS: Digits = Digits::Significant(3);

pub(crate) fn ratio(value: f64) -> Quantity {
    Quantity::ratio(value, 3)
}

pub(crate) fn metres(value: f64) -> Quantity {
    Quantity::new(value, Unit::si("m"), DIGITS)
}

pub(crate) fn kilonewtons(newtons: f64) -> Quantity {
    let unit = Unit {
        symbol: "kN".to_owned(),
        factor: 1e-3,
    };
    Quantity::new(newtons, unit, DIGITS)
}

pub(crate) fn hertz(value: f64) -> Quantity {
    Quantity::new(value, Unit::si("Hz"), DIGITS)
}

pub(crate) fn tonnes_per_m2(kg_per_m2: f64) -> Quantity {
    let unit = Unit {
        symbol: "t/m²".to_owned(),
        factor: 1e-3,
    };
    Quantity::new(kg_per_m2, unit, DIGITS)
}
