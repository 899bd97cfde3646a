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
