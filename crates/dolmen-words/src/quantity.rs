//! Values with units and a number of digits.

use crate::number::{NARROW_SPACE, beside_one, fixed, prefix, significant, trimmed, with_sd};

/// A display unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    /// "kN·m/rad"; empty for a ratio.
    pub symbol: String,
    /// Value in this unit = SI value × factor.
    pub factor: f64,
}

impl Unit {
    /// No unit, for a ratio or a count.
    pub fn ratio() -> Self {
        Self::si("")
    }

    /// An SI unit without a prefix: "Hz".
    pub fn si(symbol: &str) -> Self {
        Unit {
            symbol: symbol.to_owned(),
            factor: 1.0,
        }
    }

    /// The unit with the prefix that suits the largest of `values_si`, as [`prefix`].
    pub fn of(values_si: &[f64], symbol: &str) -> Self {
        let found = prefix(values_si, symbol);
        Unit {
            symbol: found.unit,
            factor: found.factor,
        }
    }

    /// Per cent, for a fraction.
    pub fn percent() -> Self {
        Unit {
            symbol: "%".to_owned(),
            factor: 100.0,
        }
    }
}

/// Values with a common unit, which the text gives only once.
#[derive(Clone, Debug, PartialEq)]
pub struct Values(pub Vec<Quantity>);

/// Number of digits of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Digits {
    /// Significant digits.
    Significant(usize),
    /// Digits after the point.
    Fixed(usize),
    /// At most this many significant digits, without trailing zeros.
    Trimmed(usize),
    /// Significant digits, and more if the value would otherwise read 1 without being 1.
    BesideOne(usize),
}

/// An SI value with its display unit and digits.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// The value, in SI.
    pub value_si: f64,
    /// Its standard deviation in SI, if it has one.
    pub sd_si: Option<f64>,
    /// The unit.
    pub unit: Unit,
    /// The digits of a value without a deviation.
    pub digits: Digits,
}

impl Quantity {
    /// A value without a deviation.
    pub fn new(value_si: f64, unit: Unit, digits: Digits) -> Self {
        Quantity {
            value_si,
            sd_si: None,
            unit,
            digits,
        }
    }

    /// A ratio with a limit at 1: a load factor, a margin.
    pub fn beside_one(value: f64, digits: usize) -> Self {
        Self::new(value, Unit::ratio(), Digits::BesideOne(digits))
    }

    /// A ratio with `digits` significant digits.
    pub fn ratio(value: f64, digits: usize) -> Self {
        Self::new(value, Unit::ratio(), Digits::Significant(digits))
    }

    /// A fraction as per cent.
    pub fn percent(share: f64, digits: usize) -> Self {
        Self::new(share, Unit::percent(), Digits::Significant(digits))
    }

    /// A value under the prefix that suits it.
    pub fn engineering(value_si: f64, symbol: &str, digits: usize) -> Self {
        Self::new(
            value_si,
            Unit::of(&[value_si], symbol),
            Digits::Significant(digits),
        )
    }

    /// The same without the symbol of its unit.
    pub(crate) fn without_symbol(&self) -> Self {
        let mut bare = self.clone();
        bare.unit.symbol.clear();
        bare
    }

    /// The number alone, for a cell whose column names the unit.
    ///
    /// ```
    /// use dolmen_words::{Digits, Quantity, Unit};
    /// let stiffness = Quantity::engineering(253_827.1, "N·m/rad", 4);
    /// assert_eq!((stiffness.number().as_str(), stiffness.text().as_str()), ("253.8", "253.8\u{202f}kN·m/rad"));
    /// let frequency = Quantity { sd_si: Some(0.004), ..Quantity::new(1.882, Unit::si("Hz"), Digits::Significant(4)) };
    /// assert_eq!(frequency.text(), "1.882 ± 0.004\u{202f}Hz");
    /// ```
    pub fn number(&self) -> String {
        let value = self.value_si * self.unit.factor;
        match (self.sd_si, self.digits) {
            (Some(sd), _) => with_sd(value, sd * self.unit.factor),
            (None, Digits::Significant(digits)) => significant(value, digits),
            (None, Digits::Fixed(decimals)) => fixed(value, decimals),
            (None, Digits::Trimmed(digits)) => trimmed(value, digits),
            (None, Digits::BesideOne(digits)) => beside_one(value, digits),
        }
    }

    /// The number with its unit.
    pub fn text(&self) -> String {
        match self.unit.symbol.as_str() {
            "" => self.number(),
            // no space before the degree sign (ISO 80000-1)
            "°" => format!("{}°", self.number()),
            symbol => format!("{}{NARROW_SPACE}{symbol}", self.number()),
        }
    }
}
