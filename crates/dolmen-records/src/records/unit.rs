//! Units of samples in a file and in a project.

use super::RecordError;
use crate::quoted::shown;
use crate::unit::Unit;

/// The unit of numbers in a file.
#[derive(Clone, Debug, PartialEq)]
pub enum FileUnit {
    /// Not stated: the project may give the unit.
    Silent,
    /// A unit that is known here.
    Known(Unit),
    /// A different unit such as "V" or "counts": a scale converts it.
    Other(String),
}

impl Unit {
    /// The unit a text names: "m/s2", "cm/s2" or "gal", "mm/s2", "g", "mg", "%g", "m/s", "cm/s", "mm/s", "um/s", "m",
    /// "cm", "mm"; "unknown", "counts", "V" and "mV" say that the numbers are no SI quantity. Upper and lower case differ.
    ///
    /// # Errors
    /// [`RecordError::UnknownUnit`].
    ///
    /// # Example
    /// ```
    /// use dolmen_records::records::Unit;
    /// assert_eq!(Unit::parse("mg")?.si(), 0.00980665);
    /// # Ok::<(), dolmen_records::records::RecordError>(())
    /// ```
    pub fn parse(text: &str) -> Result<Self, RecordError> {
        let text = text.trim();
        Unit::of_spelling(text).ok_or_else(|| RecordError::UnknownUnit {
            given: text.to_string(),
        })
    }
}

/// The unit of a label in a file: brackets, blanks and other spellings of powers are ignored.
pub(super) fn unit_of_label(label: &str) -> FileUnit {
    let label = label.trim().trim_matches(['\0', ' ']);
    let plain: String = label
        .chars()
        .filter(|c| !c.is_whitespace() && !"[]()（）".contains(*c))
        .collect();
    let plain = plain
        .replace("**", "^")
        .replace("sec", "s")
        .replace(['µ', 'μ'], "u");
    let plain = plain
        .replace('㎨', "m/s2")
        .replace('㎝', "cm")
        .replace('㎜', "mm")
        .replace('㎎', "mg");
    let plain = match plain.as_str() {
        "G" => "g",
        "mG" => "mg",
        "%G" => "%g",
        "GAL" | "갈" => "gal",
        "중력가속도" => "g",
        "밀리지" => "mg",
        "미터" => "m",
        "센티미터" => "cm",
        "밀리미터" => "mm",
        plain => plain,
    };
    if plain.is_empty() || plain.eq_ignore_ascii_case("none") || plain.eq_ignore_ascii_case("unknown") {
        return FileUnit::Silent;
    }
    match Unit::parse(plain) {
        Ok(unit) if unit != Unit::Unknown => FileUnit::Known(unit),
        _ => FileUnit::Other(shown(label)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen::signal::Quantity;

    #[test]
    fn exact_units_in_si() {
        for (text, si, quantity) in [
            ("m/s2", 1.0, Quantity::Acceleration),
            ("gal", 0.01, Quantity::Acceleration),
            ("mm/s2", 0.001, Quantity::Acceleration),
            ("g", 9.80665, Quantity::Acceleration),
            ("mg", 0.00980665, Quantity::Acceleration),
            ("%g", 0.0980665, Quantity::Acceleration),
            ("mm/s", 0.001, Quantity::Velocity),
            ("mm", 0.001, Quantity::Displacement),
            ("", 1.0, Quantity::Unknown),
        ] {
            let unit = Unit::parse(text).unwrap();
            assert_eq!((unit.si(), unit.quantity()), (si, quantity), "{text}");
            assert_eq!(Unit::parse(unit.symbol()).unwrap(), unit);
        }
    }

    #[test]
    fn refuses_a_unit_that_is_not_known() {
        assert_eq!(
            Unit::parse("ft/s2").unwrap_err().to_string(),
            "the unit \"ft/s2\" is not known: write m/s2, cm/s2 (gal), mm/s2, g, mg, %g, m/s, cm/s, mm/s, um/s, m, cm, mm, \
             or \"unknown\" to keep the numbers as they are"
        );
    }
}
