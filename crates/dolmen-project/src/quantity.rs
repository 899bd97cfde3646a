//! One number of a project file: its value in SI, its scatter and its source.

use super::units::{parse_unit, split_number};

/// Source of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Evidence {
    /// Measured on this structure.
    Measured,
    /// A test on material or joints of this kind.
    Test,
    /// Published.
    Literature,
    /// Identified from vibration of this structure in a survey.
    Identified,
    /// Not measured: results that depend on it say so.
    Assumed,
}

impl Evidence {
    /// The word in the file: "measured", "test", "literature", "identified", "assumed".
    pub fn word(self) -> &'static str {
        match self {
            Evidence::Measured => "measured",
            Evidence::Test => "test",
            Evidence::Literature => "literature",
            Evidence::Identified => "identified",
            Evidence::Assumed => "assumed",
        }
    }
}

/// A number of the file, converted to SI.
///
/// With a `cov` it stands for a lognormal variable of mean `value` and that coefficient of variation: positive, as
/// weights, lengths, stiffnesses and frequencies are, and close to normal when the cov is small.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// In SI units: N, kg, m, N/m, N m/rad, N m s/rad, N s/m, kg m², Hz; a ratio unchanged.
    pub value: f64,
    /// The SI unit of `value`, "N m/rad"; "" for a ratio.
    pub unit: &'static str,
    /// Coefficient of variation, standard deviation / mean, 0 to 1; `None` if the file gives none.
    pub cov: Option<f64>,
    /// Its source; `None` if the file gives none.
    pub source: Option<Evidence>,
    /// Source of the cov: `source` if the file gives no other; `None` without a cov or a source.
    pub cov_source: Option<Evidence>,
    /// The survey from which it was identified, if it was.
    pub survey: Option<String>,
    /// A note of the author.
    pub note: Option<String>,
    /// Its path in the file, parts counted from 1: `links[1].weight`.
    pub path: String,
    /// The text of the file, with its unit: "38.95 kN".
    pub written: String,
}

impl Quantity {
    /// The unit in which the file gives it, with its size in SI: "kN*m/rad", 1000; `None` without one.
    pub fn written_unit(&self) -> Option<(String, f64)> {
        // damage of an inspection is written as a factor: "3000 kN*m/rad × 0.3430"
        let (_, unit) = split_number(self.written.split(" × ").next()?)?;
        let needed = parse_unit(self.unit).ok()?.dimension;
        let size = parse_unit(unit).ok()?.measuring(needed)?.factor;
        Some((unit.to_owned(), size))
    }

    /// Its value without scatter: the `pick` of the nominal structure.
    pub fn nominal(quantity: &Quantity) -> f64 {
        quantity.value
    }

    /// Standard deviation, SI; 0 without a cov.
    pub fn standard_deviation(&self) -> f64 {
        self.cov.unwrap_or(0.0) * self.value.abs()
    }

    /// Whether the file marks its value as assumed.
    pub fn is_assumed(&self) -> bool {
        self.source == Some(Evidence::Assumed)
    }

    /// Whether the file marks its scatter as assumed: probabilities then depend on an assumption.
    pub fn is_scatter_assumed(&self) -> bool {
        self.cov_source == Some(Evidence::Assumed)
    }
}

/// How a caller chooses the value of each input: `&mut Quantity::nominal`, or a sample, or one input changed.
pub type Pick<'a> = &'a mut dyn FnMut(&Quantity) -> f64;
