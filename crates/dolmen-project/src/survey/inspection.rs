//! Findings of an inspection: damage of a part, its size, severity and place.

use crate::damage::InModel;
use crate::names::Names;
use crate::quantity::Quantity;
use crate::report::PhotoPart;

/// Kinds of damage, by the words of the glossary.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum DamageKind {
    /// A crack.
    Crack,
    /// Pieces have broken off.
    Spalling,
    /// The surface comes off in layers.
    Exfoliation,
    /// A joint gapes.
    OpenJoint,
    /// A part leans.
    Tilt,
    /// A part has settled.
    Settlement,
    /// A part is missing.
    Loss,
    /// Lichen, moss, plants.
    Growth,
    /// Another kind, in the engineer's words.
    Other(OtherDamage),
}

impl DamageKind {
    /// The English word in a project file: "crack", "open joint"; for another kind the engineer's own word.
    pub fn word(&self) -> &str {
        match self {
            DamageKind::Crack => "crack",
            DamageKind::Spalling => "spalling",
            DamageKind::Exfoliation => "exfoliation",
            DamageKind::OpenJoint => "open joint",
            DamageKind::Tilt => "tilt",
            DamageKind::Settlement => "settlement",
            DamageKind::Loss => "loss",
            DamageKind::Growth => "growth",
            DamageKind::Other(other) => &other.english,
        }
    }
}

/// A kind of damage in the engineer's words.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct OtherDamage {
    /// English, or Korean where there is no other.
    pub english: String,
    /// Korean, or English where there is no other.
    pub korean: String,
}

/// Severity of a damage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// To be noted.
    Slight,
    /// To be watched or mended.
    Moderate,
    /// To be mended now.
    Severe,
}

impl Severity {
    /// The word in a project file: "slight", "moderate", "severe".
    pub fn word(self) -> &'static str {
        match self {
            Severity::Slight => "slight",
            Severity::Moderate => "moderate",
            Severity::Severe => "severe",
        }
    }
}

/// One finding of an inspection.
#[derive(Clone, Debug, PartialEq)]
pub struct Inspection {
    /// The part, by its name.
    pub part: String,
    /// Its kind.
    pub what: DamageKind,
    /// Its name among others of its kind at this part, the same in every inspection: "C1".
    pub name: Option<String>,
    /// Its size: the width of a crack or gap, else the largest extent, m.
    pub size: Option<Quantity>,
    /// The size that it must not reach, m.
    pub limit: Option<Quantity>,
    /// Its severity.
    pub severity: Option<Severity>,
    /// Its place: x right, y away, z up, m; the middle of the part if not given.
    pub at: Option<[f64; 3]>,
    /// A photograph of it.
    pub photo: Option<PhotoPart>,
    /// Anything to add.
    pub note: Option<Names>,
    /// Its effect on the model.
    pub model: Option<InModel>,
}

impl Inspection {
    /// Whether another entry is of the same damage.
    pub fn is_like(&self, other: &Inspection) -> bool {
        self.part == other.part && self.what == other.what && self.name == other.name
    }

    /// Standard deviation of its size by the error of reading, m: as its cov says, and at least what the last digit that is written leaves open,
    /// its step over √12. 0 without a size.
    pub fn reading_sd_m(&self) -> f64 {
        let Some(size) = &self.size else {
            return 0.0;
        };
        let rounding = last_digit(size).unwrap_or(0.0) / 12f64.sqrt();
        size.standard_deviation().max(rounding)
    }
}

/// The value of one unit of the last digit of a written quantity, SI: 0.0001 for "0.4 mm".
fn last_digit(of: &Quantity) -> Option<f64> {
    let written = of.written.trim();
    let end = written
        .find(|sign: char| !(sign.is_ascii_digit() || matches!(sign, '.' | '+' | '-')))
        .unwrap_or(written.len());
    let number = &written[..end];
    let value: f64 = number.parse().ok()?;
    let decimals = number.split_once('.').map_or(0, |(_, behind)| behind.len());
    let step = 10f64.powi(-i32::try_from(decimals).ok()?);
    let unit = of.value / value;
    (unit.is_finite() && unit > 0.0 && !written[end..].starts_with(['e', 'E'])).then_some(step * unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(written: &str, value: f64, cov: Option<f64>) -> f64 {
        let size = Quantity {
            value,
            unit: "m",
            cov,
            source: None,
            cov_source: None,
            survey: None,
            note: None,
            path: String::new(),
            written: written.to_owned(),
        };
        let of = Inspection {
            part: "1".to_owned(),
            what: DamageKind::Crack,
            name: None,
            size: Some(size),
            limit: None,
            severity: None,
            at: None,
            photo: None,
            note: None,
            model: None,
        };
        of.reading_sd_m()
    }

    #[test]
    fn exact_the_last_digit_that_is_written_says_how_well_a_size_was_read() {
        let sd_of = |step_m: f64| step_m / 12f64.sqrt();
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}");
        close(written("0.4 mm", 4e-4, None), sd_of(1e-4));
        close(written("0.45 mm", 4.5e-4, None), sd_of(1e-5));
        close(written("7 mm", 7e-3, None), sd_of(1e-3));
        close(written("0.0004 m", 4e-4, None), sd_of(1e-4));
        // a stated cov counts where it is larger
        close(written("0.4 mm", 4e-4, Some(0.5)), 2e-4);
        close(written("4e-1 mm", 4e-4, None), 0.0);
    }
}
