//! Units in their common spellings, with their dimensions: "kN*m/rad", "kN/mm", "t", "m/s2", "g".

use super::wrong::{Common, WrongUnit};
pub(super) use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen_words::Language;
use dolmen_words::message::Both;
use dolmen_words::message::{Argument, Run};

/// Powers of metre, kilogram and second. An angle has none: N m/rad and N m are the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Dimension {
    metre: i32,
    kilogram: i32,
    second: i32,
}

const fn dimension(metre: i32, kilogram: i32, second: i32) -> Dimension {
    Dimension {
        metre,
        kilogram,
        second,
    }
}

impl Dimension {
    pub(super) const RATIO: Dimension = dimension(0, 0, 0);
    pub(super) const LENGTH: Dimension = dimension(1, 0, 0);
    pub(super) const AREA: Dimension = dimension(2, 0, 0);
    pub(super) const MASS: Dimension = dimension(0, 1, 0);
    pub(super) const FREQUENCY: Dimension = dimension(0, 0, -1);
    pub(super) const FORCE: Dimension = dimension(1, 1, -2);
    pub(super) const MOMENT: Dimension = dimension(2, 1, -2);
    pub(super) const FORCE_PER_LENGTH: Dimension = dimension(0, 1, -2);
    pub(super) const ROTATIONAL_DAMPING: Dimension = dimension(2, 1, -1);
    pub(super) const DASHPOT: Dimension = dimension(0, 1, -1);
    pub(super) const INERTIA: Dimension = dimension(2, 1, 0);
    pub(super) const VELOCITY: Dimension = dimension(1, 0, -1);
    pub(super) const ACCELERATION: Dimension = dimension(1, 0, -2);
    pub(super) const DENSITY: Dimension = dimension(-3, 1, 0);
    pub(super) const STRESS: Dimension = dimension(-1, 1, -2);
    pub(super) const STRESS_PER_LENGTH: Dimension = dimension(-2, 1, -2);

    fn times(self, other: Dimension, power: i32) -> Option<Dimension> {
        let sum = |a: i32, b: i32| a.checked_add(b.checked_mul(power)?);
        Some(Dimension {
            metre: sum(self.metre, other.metre)?,
            kilogram: sum(self.kilogram, other.kilogram)?,
            second: sum(self.second, other.second)?,
        })
    }
}

/// The dimension in words, for messages.
impl Dimension {
    pub(super) fn said(self) -> Both {
        let name = match self {
            Dimension::RATIO => WrongUnit::PlainNumberOrAngle,
            Dimension::LENGTH => WrongUnit::Length,
            Dimension::AREA => WrongUnit::Area,
            Dimension::MASS => WrongUnit::Mass,
            Dimension::FREQUENCY => WrongUnit::Frequency,
            Dimension::FORCE => WrongUnit::Force,
            Dimension::MOMENT => WrongUnit::MomentOrRotationalStiffness,
            Dimension::FORCE_PER_LENGTH => WrongUnit::ForcePerLengthLateral,
            Dimension::ROTATIONAL_DAMPING => WrongUnit::RotationalDamping,
            Dimension::DASHPOT => WrongUnit::ForcePerVelocityDashpot,
            Dimension::INERTIA => WrongUnit::MomentOfInertia,
            Dimension::VELOCITY => WrongUnit::Velocity,
            Dimension::ACCELERATION => return Common::Acceleration.into(),
            Dimension {
                metre: 0,
                kilogram: 0,
                second: 1,
            } => WrongUnit::Time,
            Dimension::DENSITY => WrongUnit::Density,
            Dimension::STRESS => WrongUnit::Stress,
            Dimension::STRESS_PER_LENGTH => WrongUnit::StressPerLengthStiffness,
            Dimension {
                metre,
                kilogram,
                second,
            } => return Both::from(format!("m^{metre} kg^{kilogram} s^{second}")),
        };
        name.into()
    }
}

/// Symbols with their size in SI units and their dimension.
const SYMBOLS: &[(&str, f64, Dimension)] = &[
    ("m", 1.0, Dimension::LENGTH),
    ("mm", 1e-3, Dimension::LENGTH),
    ("cm", 1e-2, Dimension::LENGTH),
    ("km", 1e3, Dimension::LENGTH),
    ("kg", 1.0, Dimension::MASS),
    ("t", 1e3, Dimension::MASS),
    ("s", 1.0, dimension(0, 0, 1)),
    ("ms", 1e-3, dimension(0, 0, 1)),
    ("h", 3600.0, dimension(0, 0, 1)),
    ("Hz", 1.0, Dimension::FREQUENCY),
    ("kHz", 1e3, Dimension::FREQUENCY),
    ("N", 1.0, Dimension::FORCE),
    ("kN", 1e3, Dimension::FORCE),
    ("MN", 1e6, Dimension::FORCE),
    ("GN", 1e9, Dimension::FORCE),
    ("Pa", 1.0, Dimension::STRESS),
    ("kPa", 1e3, Dimension::STRESS),
    ("MPa", 1e6, Dimension::STRESS),
    ("GPa", 1e9, Dimension::STRESS),
    ("kgf", STANDARD_GRAVITY_M_S2, Dimension::FORCE),
    ("tf", 1e3 * STANDARD_GRAVITY_M_S2, Dimension::FORCE),
    ("Nm", 1.0, Dimension::MOMENT),
    ("kNm", 1e3, Dimension::MOMENT),
    ("MNm", 1e6, Dimension::MOMENT),
    ("g", STANDARD_GRAVITY_M_S2, Dimension::ACCELERATION),
    ("gal", 1e-2, Dimension::ACCELERATION),
    ("rad", 1.0, Dimension::RATIO),
    ("mrad", 1e-3, Dimension::RATIO),
    ("deg", std::f64::consts::PI / 180.0, Dimension::RATIO),
    ("°", std::f64::consts::PI / 180.0, Dimension::RATIO),
    ("%", 1e-2, Dimension::RATIO),
];

/// No unit of the field has a higher power: m⁴ is a second moment of area.
const POWER_MOST: i32 = 4;

/// A unit: its size in SI units, and its dimension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Unit {
    pub(super) factor: f64,
    pub(super) dimension: Dimension,
    /// Power of its angle: 1 for rad/s, -1 for N m/rad. An angle has no dimension, but turns a frequency into an angular one.
    angle: i32,
}

impl Unit {
    /// The unit in a needed dimension: itself; a unit weight, kN/m³, as a density; an angular frequency, rad/s, as a frequency, f = ω/2π;
    /// `None` for another dimension.
    pub(super) fn measuring(self, needed: Dimension) -> Option<Unit> {
        let of_factor = |factor: f64| Unit {
            factor,
            dimension: needed,
            angle: 0,
        };
        match (needed, self.dimension, self.angle) {
            (Dimension::DENSITY, Dimension::STRESS_PER_LENGTH, _) => {
                Some(of_factor(self.factor / STANDARD_GRAVITY_M_S2))
            }
            (Dimension::FREQUENCY, Dimension::FREQUENCY, 1) => {
                Some(of_factor(self.factor / std::f64::consts::TAU))
            }
            (Dimension::FREQUENCY, Dimension::FREQUENCY, power) if power != 0 => None,
            (_, own, _) => (own == needed).then_some(self),
        }
    }
}

/// Why a text is not a unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum UnitError {
    Empty,
    Unknown {
        symbol: String,
        nearest: Option<&'static str>,
    },
    ProductAfterSlash,
    /// "ton": a mass, or its weight.
    Ton {
        symbol: String,
    },
    Power {
        symbol: String,
    },
}

impl UnitError {
    pub(super) fn said(&self) -> Both {
        Both::from(match self {
            UnitError::Empty => WrongUnit::ThereIsNoUnit,
            UnitError::Unknown { symbol, .. } | UnitError::Ton { symbol } => {
                WrongUnit::IsNotKnownUnit(symbol.clone())
            }
            UnitError::ProductAfterSlash => WrongUnit::WhatStandsBelowIs,
            UnitError::Power { symbol } => WrongUnit::PowerIsNot {
                symbol: symbol.clone(),
                most: POWER_MOST.to_string(),
            },
        })
    }

    pub(super) fn help(&self) -> Both {
        Both::from(match self {
            UnitError::Unknown {
                nearest: Some(nearest),
                ..
            } => WrongUnit::DidYouMean((*nearest).to_owned()),
            UnitError::Unknown { symbol, .. } if symbol.contains(['.', '・', '･']) => {
                WrongUnit::DidYouMean(symbol.replace(['.', '・', '･'], "*"))
            }
            UnitError::Ton { .. } => WrongUnit::TonOrTf,
            UnitError::ProductAfterSlash => WrongUnit::WriteProductsBeforeOne,
            _ => {
                let symbols: Vec<&str> = SYMBOLS.iter().map(|(symbol, ..)| *symbol).collect();
                WrongUnit::UnitsAreProductsAnd(symbols.join(" "))
            }
        })
    }
}

fn is_product(character: char) -> bool {
    matches!(character, '*' | '·' | '⋅' | '×' | '-' | ' ')
}

/// Reads a unit. Products are `*`, `·`, `-` or a space, quotients `/`, powers `2`, `^2` or `²`.
pub(super) fn parse_unit(text: &str) -> Result<Unit, UnitError> {
    let text = text.trim();
    if text.is_empty() {
        return Err(UnitError::Empty);
    }
    let mut unit = Unit {
        factor: 1.0,
        dimension: Dimension::RATIO,
        angle: 0,
    };
    let mut parts = text.split('/');
    let above = parts.next().unwrap_or_default();
    for symbol in above.split(is_product).filter(|symbol| !symbol.is_empty()) {
        if symbol != "1" {
            multiply(&mut unit, symbol, 1)?;
        }
    }
    if let Some(below) = parts.next() {
        let below = below.trim();
        if parts.next().is_some() || below.contains(is_product) {
            return Err(UnitError::ProductAfterSlash);
        }
        multiply(&mut unit, below, -1)?;
    }
    Ok(unit)
}

fn multiply(unit: &mut Unit, written: &str, sign: i32) -> Result<(), UnitError> {
    let is_power = |c: char| c.is_ascii_digit() || matches!(c, '^' | '²' | '³');
    let symbol = written.trim_end_matches(is_power);
    let power = match &written[symbol.len()..] {
        "" => 1,
        "²" => 2,
        "³" => 3,
        digits => digits
            .trim_start_matches('^')
            .parse()
            .ok()
            .filter(|power| (1..=POWER_MOST).contains(power))
            .ok_or_else(|| UnitError::Power {
                symbol: symbol.to_owned(),
            })?,
    };
    if matches!(symbol.to_lowercase().as_str(), "ton" | "tons" | "톤") {
        let symbol = symbol.to_owned();
        return Err(UnitError::Ton { symbol });
    }
    let Some((_, factor, dimension)) = SYMBOLS.iter().find(|(known, ..)| *known == symbol) else {
        return Err(UnitError::Unknown {
            symbol: symbol.to_owned(),
            nearest: nearest_symbol(symbol),
        });
    };
    let power = sign * power;
    unit.factor *= factor.powi(power);
    let product = unit.dimension.times(*dimension, power);
    unit.dimension = product.ok_or(UnitError::ProductAfterSlash)?;
    if is_angle(symbol) {
        unit.angle += power;
    }
    Ok(())
}

/// Only differences of case and common spellings, such as "KN" and "HZ". "ton" is left out on purpose (t or tf?).
fn nearest_symbol(symbol: &str) -> Option<&'static str> {
    let spelled = match symbol {
        "metre" | "meter" | "metres" | "meters" => "m",
        "kilonewton" | "kilonewtons" => "kN",
        "tonne" | "tonnes" => "t",
        "tonf" | "ton-f" | "톤중" | "톤f" => "tf",
        "hertz" => "Hz",
        "degree" | "degrees" => "deg",
        "Gal" => "gal",
        other => {
            let lower = other.to_lowercase();
            let same = |known: &&(&'static str, f64, Dimension)| known.0.to_lowercase() == lower;
            return SYMBOLS.iter().find(same).map(|(known, ..)| *known);
        }
    };
    Some(spelled)
}

/// The minus of typesetting, U+2212.
const MINUS: &str = "−";

/// A text such as "38.95 kN": the number, and the rest after it.
pub(super) fn split_number(text: &str) -> Option<(f64, &str)> {
    let text = text.trim();
    let bytes = text.as_bytes();
    let digits = |from: usize| from + bytes[from..].iter().take_while(|b| b.is_ascii_digit()).count();
    // the minus in printed numbers is the typographic one
    let signed = |at: usize| match bytes.get(at) {
        Some(b'+' | b'-') => at + 1,
        _ if bytes[at.min(bytes.len())..].starts_with(MINUS.as_bytes()) => at + MINUS.len(),
        _ => at,
    };
    let start = signed(0);
    let mut end = digits(start);
    if bytes.get(end) == Some(&b'.') {
        end = digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let exponent = signed(end + 1);
        if digits(exponent) > exponent {
            end = digits(exponent);
        }
    }
    let value: f64 = text[..end].replace(MINUS, "-").parse().ok()?;
    Some((value, text[end..].trim()))
}

/// Whether a unit is one of angles, which have the dimension of ratios.
pub(super) fn is_angle(unit: &str) -> bool {
    ["deg", "rad", "mrad", "°"].contains(&unit.trim())
}

pub(super) fn tilt_ratio(text: &str) -> Option<f64> {
    let (number, rest) = split_number(text)?;
    let ratio = match rest.strip_prefix(['/', ':']) {
        Some(below) => match split_number(below)? {
            (below, "") => number / below,
            _ => return None,
        },
        None if rest.is_empty() => number,
        None => {
            let rest = if rest == "도" { "deg" } else { rest };
            let unit = parse_unit(rest)
                .ok()
                .filter(|unit| unit.dimension == Dimension::RATIO)?;
            let value = number * unit.factor;
            if is_angle(rest) { value.tan() } else { value }
        }
    };
    ratio.is_finite().then_some(ratio)
}

/// "1e-4 rad", "0.5 deg", "2 mrad" as rad; the unit is required.
///
/// # Errors
/// The error in a sentence.
pub fn parse_angle_rad(text: &str) -> Result<f64, AngleError> {
    let refuse = |said: Both| AngleError {
        text: text.to_owned(),
        why: WrongUnit::Refused {
            said,
            help: WrongUnit::WriteItAsE.into(),
        }
        .into(),
    };
    let Some((value, unit)) = split_number(text) else {
        return Err(refuse(WrongUnit::ItBeginsWithNo.into()));
    };
    if unit.is_empty() {
        return Err(refuse(WrongUnit::ItHasNoUnit.into()));
    }
    let unit = match parse_unit(unit) {
        Ok(known) if known.dimension == Dimension::RATIO && unit != "%" => known,
        Ok(_) => return Err(refuse(WrongUnit::ItsUnitIsNot.into())),
        Err(fault) => return Err(refuse(fault.said())),
    };
    if value.is_finite() {
        Ok(value * unit.factor)
    } else {
        Err(refuse(WrongUnit::ItIsNoNumber.into()))
    }
}

/// Why a text is no angle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AngleError {
    /// The text.
    pub text: String,
    /// The error, and the remedy.
    pub why: Both,
}

impl std::fmt::Display for AngleError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.text(Language::English))
    }
}

impl std::error::Error for AngleError {}

impl Argument for AngleError {
    fn said(&self, language: Language) -> Vec<Run> {
        vec![Run::Name(self.text(language))]
    }
}

impl AngleError {
    /// The sentence in a language.
    pub fn text(&self, language: Language) -> String {
        let said = WrongUnit::IsNoAngle {
            text: self.text.clone(),
            why: self.why.clone(),
        };
        Both::from(said).text(language).to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> (f64, Dimension) {
        let unit = parse_unit(text).unwrap();
        (unit.factor, unit.dimension)
    }

    #[test]
    fn exact_a_tilt_in_degrees_may_say_so_in_korean() {
        assert_eq!(tilt_ratio("0.6도"), tilt_ratio("0.6 deg"));
        assert!((tilt_ratio("45 도").unwrap() - 1.0).abs() < 1e-15);
        assert_eq!(tilt_ratio("0.6도쯤"), None);
    }

    #[test]
    fn exact_units_of_the_field_convert_to_si() {
        assert_eq!(of("kN*m/rad"), (1e3, Dimension::MOMENT));
        for same in ["kN m/rad", "kN·m/rad", "kN-m/rad", "kNm/rad", "kN*m", "N*km"] {
            assert_eq!(of(same), of("kN*m/rad"), "{same}");
        }
        assert_eq!(of("kN/mm"), (1e6, Dimension::FORCE_PER_LENGTH));
        assert_eq!(of("tf"), (9806.65, Dimension::FORCE));
        assert_eq!(of("g"), (9.80665, Dimension::ACCELERATION));
        for same in ["m/s2", "m/s^2", "m/s²"] {
            assert_eq!(of(same), (1.0, Dimension::ACCELERATION), "{same}");
        }
        assert_eq!(of("1/s"), of("Hz"));
        assert_eq!(of("t*m2"), (1e3, Dimension::INERTIA));
        assert_eq!(of("kN*m*s/rad"), (1e3, Dimension::ROTATIONAL_DAMPING));
        let per_degree = of("kN*m/deg").0;
        assert!((per_degree - 57_295.779_513_082_32).abs() < 1e-9, "{per_degree}");
    }

    #[test]
    fn exact_an_angular_frequency_is_turned_into_hertz() {
        let hertz = |text: &str| Some(parse_unit(text).ok()?.measuring(Dimension::FREQUENCY)?.factor);
        let tau = std::f64::consts::TAU;
        for (text, expected) in [
            ("Hz", 1.0),
            ("1/s", 1.0),
            ("rad/s", 1.0 / tau),
            ("mrad/ms", 1.0 / tau),
            ("deg/s", 1.0 / 360.0),
            ("°/s", 1.0 / 360.0),
        ] {
            let found = hertz(text).unwrap();
            assert!((found / expected - 1.0).abs() < 1e-15, "{text}: {found}");
        }
        for text in ["rad*rad/s", "Hz/rad", "rad", "s", "m/s", "rad/s2"] {
            assert_eq!(hertz(text), None, "{text}");
        }
        // only frequencies: a damping per angular velocity stays as it is
        let damping = parse_unit("kN*m*s/rad").unwrap();
        assert_eq!(
            damping.measuring(Dimension::ROTATIONAL_DAMPING).unwrap().factor,
            1e3
        );
    }

    #[test]
    fn exact_angles_with_their_unit() {
        assert_eq!(parse_angle_rad("1e-4 rad"), Ok(1e-4));
        assert_eq!(parse_angle_rad("-2mrad"), Ok(-2e-3));
        assert!((parse_angle_rad("180 deg").unwrap() - std::f64::consts::PI).abs() < 1e-15);
        for (text, why) in [
            ("0.1", "it has no unit"),
            ("rad", "it begins with no number"),
            ("1 m", "not one of an angle"),
            ("1 %", "not one of an angle"),
            ("1 dag", "not a known unit"),
        ] {
            let said = parse_angle_rad(text).unwrap_err().to_string();
            assert!(said.contains(why), "{said}");
        }
    }

    #[test]
    fn refuses_what_is_not_a_unit_and_names_the_nearest() {
        let fault = |text: &str| {
            let fault = parse_unit(text).unwrap_err();
            format!("{}; {}", fault.said().english, fault.help().english)
        };
        assert_eq!(fault("KN"), "\"KN\" is not a known unit; did you mean \"kN\"?");
        assert!(fault("ton").starts_with("\"ton\" is not a known unit; is it \"t\""));
        assert!(fault("tonf").ends_with("did you mean \"tf\"?"));
        assert!(fault("kN.m/rad").ends_with("did you mean \"kN*m\"?"));
        assert_eq!(
            fault("N/m*s"),
            "what stands below the / is not clear; write products before one / at the end: \"kN*m/rad\""
        );
        assert!(fault("m9").starts_with("the power of \"m\" is not one of 1 to 4"));
        assert!(fault("").starts_with("there is no unit"));
        assert!(fault("m/").starts_with("\"\" is not a known unit"));
    }

    #[test]
    fn exact_a_number_is_split_from_its_unit() {
        assert_eq!(split_number("38.95 kN"), Some((38.95, "kN")));
        assert_eq!(split_number("1150mm"), Some((1150.0, "mm")));
        assert_eq!(split_number("-2.5e3 N"), Some((-2500.0, "N")));
        assert_eq!(split_number("−2.5 N"), Some((-2.5, "N"))); // the minus of typesetting
        assert_eq!(split_number("5 e"), Some((5.0, "e")));
        assert_eq!(split_number("kN"), None);
        assert_eq!(split_number("1,150 mm"), Some((1.0, ",150 mm")));
        assert_eq!(split_number(""), None);
        assert_eq!(split_number("."), None);
    }
}
