//! Smallest increase of a motion that is reported.

/// Ratio above which a value has increased: visible in four digits.
pub(crate) const GROWN: f64 = 1.0005;
