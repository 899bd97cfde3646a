//! Words and units for buildings and their dampers.

use dolmen_words::message::Run;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

/// Values below this fraction of the largest of their kind are rounding. Our choice: sums of some thousand products keep 12 digits.
const ROUNDING: f64 = 1e-9;

messages! {
    /// Names, floors, directions.
    pub(crate) enum Words in "building.words" {
        Name(name: String) => { en: "{name}", ko: "{name}" },
        Number(number: usize) => { en: "{number}", ko: "{number}" },
        Numbered(floor: String) => { en: "{floor}", ko: "{floor}번" },
        Named(floor: String) => { en: "‘{floor}’", ko: "‘{floor}’" },
        Liquid(damper: String) => { en: "{damper} liquid", ko: "{damper} 액체" },
        Turned(degrees: Quantity) => { en: "{degrees}° from x", ko: "x축에서 {degrees}°" },
    }
}

/// A name from the user.
pub(crate) fn name(name: &str) -> Sentence {
    Words::Name(name.to_owned()).into()
}

/// A number that names something: a mode, a floor.
pub(crate) fn number(number: usize) -> Sentence {
    Words::Number(number).into()
}

/// A floor in a sentence: "3", "3번", or its name in quotes.
pub(crate) fn floor_words(name: &str) -> Sentence {
    let floor = name.to_owned();
    match name.bytes().all(|b| b.is_ascii_digit()) {
        true => Words::Numbered(floor).into(),
        false => Words::Named(floor).into(),
    }
}

/// The moving part of a damper, from the name of its stroke: "tmd", or "tmd liquid".
pub(crate) fn stroke_words(of: &str) -> Sentence {
    match of.strip_suffix(" liquid") {
        Some(damper) => Words::Liquid(damper.to_owned()).into(),
        None => name(of),
    }
}

/// A direction in plan: "x", "y", or degrees.
pub(crate) fn direction_words(degrees: f64) -> Sentence {
    match degrees.rem_euclid(180.0) {
        0.0 => Sentence::of_symbol("x"),
        90.0 => Sentence::of_symbol("y"),
        turned => Words::Turned(Quantity::new(turned, Unit::ratio(), Digits::Trimmed(6))).into(),
    }
}

/// A text given in both languages.
pub(crate) fn of_both([english, korean]: &[String; 2]) -> Sentence {
    let run = |text: &String| vec![Run::Text(text.clone())];
    Sentence::of_runs("both", run(english), run(korean))
}

/// x (0) or y (1).
pub(crate) fn axis_words(axis: usize) -> Sentence {
    Sentence::of_symbol(["x", "y"][axis])
}

pub(crate) fn millimetres() -> Unit {
    scaled("mm", 1e3)
}

pub(crate) fn tonnes() -> Unit {
    scaled("t", 1e-3)
}

pub(crate) fn kilonewtons() -> Unit {
    scaled("kN", 1e-3)
}

/// A unit with this factor to the SI unit.
pub(crate) fn scaled(symbol: &str, factor: f64) -> Unit {
    Unit {
        symbol: symbol.to_owned(),
        factor,
    }
}

/// A value with this many significant digits.
pub(crate) fn significant(value_si: f64, unit: Unit, digits: usize) -> Quantity {
    Quantity::new(value_si, unit, Digits::Significant(digits))
}

/// A value with this many digits after the point.
pub(crate) fn fixed(value_si: f64, unit: Unit, decimals: usize) -> Quantity {
    Quantity::new(value_si, unit, Digits::Fixed(decimals))
}

/// Four significant digits; 0 for values that are rounding compared with the largest of their kind.
pub(crate) fn beside(value_si: f64, largest_si: f64, unit: Unit) -> Quantity {
    let rounding = value_si.abs() <= ROUNDING * largest_si.abs();
    significant(if rounding { 0.0 } else { value_si }, unit, 4)
}
