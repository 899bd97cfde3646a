//! Smallest increase of a motion that is reported.

/// Ratio from which a value counts as increased: visible in four digits.
pub(crate) const GROWN: f64 = 1.0005;
