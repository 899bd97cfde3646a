//! Units of samples in a file.

use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::signal::Quantity;

/// Unit of the numbers in a file. Samples of a record are in SI.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Unit {
    /// Not given: numbers are not converted.
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
    /// 0.01 of standard gravity.
    PercentGravity,
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

/// Each unit with its spellings; the first is printed.
const SPELLINGS: [(Unit, &[&str]); 14] = [
    (Unit::Unknown, &["", "unknown", "counts", "V", "mV"]),
    (Unit::MetrePerSecondSquared, &["m/s2", "m/s²", "m/s^2", "m/s/s"]),
    (Unit::Gal, &["cm/s2", "cm/s²", "cm/s^2", "gal", "Gal"]),
    (Unit::MillimetrePerSecondSquared, &["mm/s2", "mm/s²", "mm/s^2"]),
    (Unit::Gravity, &["g"]),
    (Unit::MilliGravity, &["mg"]),
    (Unit::PercentGravity, &["%g"]),
    (Unit::MetrePerSecond, &["m/s"]),
    (Unit::CentimetrePerSecond, &["cm/s"]),
    (Unit::MillimetrePerSecond, &["mm/s"]),
    (Unit::MicrometrePerSecond, &["um/s", "µm/s", "μm/s"]),
    (Unit::Metre, &["m"]),
    (Unit::Centimetre, &["cm"]),
    (Unit::Millimetre, &["mm"]),
];

impl Unit {
    /// The unit with this spelling; case matters.
    pub(crate) fn of_spelling(text: &str) -> Option<Self> {
        let found = SPELLINGS.iter().find(|(_, spellings)| spellings.contains(&text));
        found.map(|(unit, _)| *unit)
    }

    /// Its printed form; "" if unknown.
    pub fn symbol(self) -> &'static str {
        SPELLINGS
            .iter()
            .find(|(unit, _)| *unit == self)
            .map_or("", |(_, spellings)| spellings[0])
    }

    /// Its value in SI; 1 if unknown.
    pub fn si(self) -> f64 {
        match self {
            Unit::Unknown | Unit::MetrePerSecondSquared | Unit::MetrePerSecond | Unit::Metre => 1.0,
            Unit::Gal | Unit::CentimetrePerSecond | Unit::Centimetre => 1e-2,
            Unit::MillimetrePerSecondSquared | Unit::MillimetrePerSecond | Unit::Millimetre => 1e-3,
            Unit::MicrometrePerSecond => 1e-6,
            Unit::Gravity => STANDARD_GRAVITY_M_S2,
            Unit::MilliGravity => 1e-3 * STANDARD_GRAVITY_M_S2,
            Unit::PercentGravity => 1e-2 * STANDARD_GRAVITY_M_S2,
        }
    }

    /// The quantity that it measures.
    pub fn quantity(self) -> Quantity {
        match self {
            Unit::Unknown => Quantity::Unknown,
            Unit::MetrePerSecondSquared
            | Unit::Gal
            | Unit::MillimetrePerSecondSquared
            | Unit::Gravity
            | Unit::MilliGravity
            | Unit::PercentGravity => Quantity::Acceleration,
            Unit::MetrePerSecond
            | Unit::CentimetrePerSecond
            | Unit::MillimetrePerSecond
            | Unit::MicrometrePerSecond => Quantity::Velocity,
            Unit::Metre | Unit::Centimetre | Unit::Millimetre => Quantity::Displacement,
        }
    }
}
