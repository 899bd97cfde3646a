//! What an inspection found: damage of a part, how large, how bad, where.

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
    /// Another, in the engineer's words.
    Other(OtherDamage),
}

/// Damage in the engineer's words.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct OtherDamage {
    /// English, or Korean where there is no other.
    pub english: String,
    /// Korean, or English where there is no other.
    pub korean: String,
}

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// To be noted.
    Slight,
    /// To be watched or mended.
    Moderate,
    /// To be mended now.
    Severe,
}

/// One thing that an inspection found.
#[derive(Clone, Debug, PartialEq)]
pub struct Inspection {
    /// The part, by its name.
    pub part: String,
    /// What it is.
    pub what: DamageKind,
    /// Its size: the width of a crack or gap, else the largest extent, m.
    pub size: Option<Quantity>,
    /// How bad.
    pub severity: Option<Severity>,
    /// Where: x right, y away, z up, m; the middle of the part if not given.
    pub at: Option<[f64; 3]>,
    /// A photograph of it.
    pub photo: Option<PhotoPart>,
    /// Anything to add.
    pub note: Option<Names>,
}
