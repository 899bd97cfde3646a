//! Units of samples in a file.

use super::{FileUnit, RecordError};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::signal::Quantity;

/// Unit of the numbers in a file. Samples of a record are in SI.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Unit {
    /// Not given: numbers are kept as they are.
    #[default]
    Unknown,
    /// m/s².
    MetrePerSecondSquared,
    /// cm/s², the gal of seismology.
    Gal,
    /// mm/s².
    MillimetrePerSecondSquared,
    /// Standard gravity, 9.80665 m/s².
    Gravity,
    /// 0.001 of standard gravity.
    MilliGravity,
    /// m/s.
    MetrePerSecond,
    /// cm/s.
    CentimetrePerSecond,
    /// mm/s.
    MillimetrePerSecond,
    /// µm/s.
    MicrometrePerSecond,
    /// m.
    Metre,
    /// cm.
    Centimetre,
    /// mm.
    Millimetre,
}

/// Each unit with its spellings; the first is how it is printed.
const SPELLINGS: [(Unit, &[&str]); 13] = [
    (Unit::Unknown, &["", "unknown", "counts", "V", "mV"]),
    (Unit::MetrePerSecondSquared, &["m/s2", "m/s²", "m/s^2", "m/s/s"]),
    (Unit::Gal, &["cm/s2", "cm/s²", "cm/s^2", "gal", "Gal"]),
    (Unit::MillimetrePerSecondSquared, &["mm/s2", "mm/s²", "mm/s^2"]),
    (Unit::Gravity, &["g"]),
    (Unit::MilliGravity, &["mg"]),
    (Unit::MetrePerSecond, &["m/s"]),
    (Unit::CentimetrePerSecond, &["cm/s"]),
    (Unit::MillimetrePerSecond, &["mm/s"]),
    (Unit::MicrometrePerSecond, &["um/s", "µm/s", "μm/s"]),
    (Unit::Metre, &["m"]),
    (Unit::Centimetre, &["cm"]),
    (Unit::Millimetre, &["mm"]),
];

/// The unit that a label in a file means: brackets, blanks and other spellings of powers are passed over.
pub(super) fn unit_of_label(label: &str) -> FileUnit {
    let label = label.trim().trim_matches(['\0', ' ']);
    let plain: String = label
        .chars()
        .filter(|c| !c.is_whitespace() && !"[]()".contains(*c))
        .collect();
    let plain = plain.replace("**", "^").replace("sec", "s").replace("µ", "u");
    if plain.is_empty() || plain.eq_ignore_ascii_case("none") || plain.eq_ignore_ascii_case("unknown") {
        return FileUnit::Silent;
    }
    match Unit::parse(&plain) {
        Ok(unit) if unit != Unit::Unknown => FileUnit::Known(unit),
        _ => FileUnit::Other(label.to_owned()),
    }
}

impl Unit {
    /// The unit a text names: "m/s2", "cm/s2" or "gal", "mm/s2", "g", "mg", "m/s", "cm/s", "mm/s", "um/s", "m", "cm",
    /// "mm"; "unknown", "counts", "V" and "mV" say that the numbers are no SI quantity. Upper and lower case differ.
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
        let found = SPELLINGS.iter().find(|(_, spellings)| spellings.contains(&text));
        found
            .map(|(unit, _)| *unit)
            .ok_or_else(|| RecordError::UnknownUnit {
                given: text.to_string(),
            })
    }

    /// How it is printed; "" if not known.
    pub fn symbol(self) -> &'static str {
        SPELLINGS
            .iter()
            .find(|(unit, _)| *unit == self)
            .map_or("", |(_, spellings)| spellings[0])
    }

    /// One of it in SI; 1 if not known.
    pub fn si(self) -> f64 {
        match self {
            Unit::Unknown | Unit::MetrePerSecondSquared | Unit::MetrePerSecond | Unit::Metre => 1.0,
            Unit::Gal | Unit::CentimetrePerSecond | Unit::Centimetre => 1e-2,
            Unit::MillimetrePerSecondSquared | Unit::MillimetrePerSecond | Unit::Millimetre => 1e-3,
            Unit::MicrometrePerSecond => 1e-6,
            Unit::Gravity => STANDARD_GRAVITY_M_S2,
            Unit::MilliGravity => 1e-3 * STANDARD_GRAVITY_M_S2,
        }
    }

    /// What it measures.
    pub fn quantity(self) -> Quantity {
        match self {
            Unit::Unknown => Quantity::Unknown,
            Unit::MetrePerSecondSquared
            | Unit::Gal
            | Unit::MillimetrePerSecondSquared
            | Unit::Gravity
            | Unit::MilliGravity => Quantity::Acceleration,
            Unit::MetrePerSecond
            | Unit::CentimetrePerSecond
            | Unit::MillimetrePerSecond
            | Unit::MicrometrePerSecond => Quantity::Velocity,
            Unit::Metre | Unit::Centimetre | Unit::Millimetre => Quantity::Displacement,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_units_in_si() {
        for (text, si, quantity) in [
            ("m/s2", 1.0, Quantity::Acceleration),
            ("gal", 0.01, Quantity::Acceleration),
            ("mm/s2", 0.001, Quantity::Acceleration),
            ("g", 9.80665, Quantity::Acceleration),
            ("mg", 0.00980665, Quantity::Acceleration),
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
            "the unit \"ft/s2\" is not known: write m/s2, cm/s2 (gal), mm/s2, g, mg, m/s, cm/s, mm/s, um/s, m, cm, mm, \
             or \"unknown\" to keep the numbers as they are"
        );
    }
}
