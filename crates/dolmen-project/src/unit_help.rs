//! Help for a unit with another dimension than that of its value.

use super::measure::Measure;
use super::units::Dimension;
use super::wrong::{Common, WrongNumber};
use dolmen_words::message::Both;

/// `of` is the path of the value, `text` the unit in the file, which measures `found`.
pub(super) fn help_of_unit((of, text): (&str, &str), found: Dimension, measure: Measure) -> Both {
    let (part, key) = of.rsplit_once('.').unwrap_or(("", of));
    let part = part.to_owned();
    match (key, found) {
        ("weight", Dimension::MASS) => WrongNumber::WriteMassInsteadOf(part).into(),
        ("mass", Dimension::FORCE) => WrongNumber::WriteWeightInsteadOf(part).into(),
        _ if measure == Measure::Density && text.trim_start().starts_with("g/") => {
            WrongNumber::GramsAreNone.into()
        }
        _ => {
            let example = measure.example();
            Common::UseUnitSuchAs(example).into()
        }
    }
}

/// Why a number cannot be bare, with units to offer.
pub(super) fn with_its_unit(measure: Measure) -> Option<(Both, [&'static str; 2])> {
    match measure {
        Measure::Angle => Some((WrongNumber::Angle.into(), ["deg", "rad"])),
        Measure::GroundAcceleration => Some((Common::Acceleration.into(), ["g", "m/s2"])),
        _ => None,
    }
}

pub(super) fn write_with_one(number: &str, units: [&'static str; 2]) -> WrongNumber {
    let [one, other] = units.map(|unit| format!("\"{number} {unit}\""));
    WrongNumber::WriteOr { one, other }
}
