//! How much larger a motion may become before it is worth saying.

/// From this ratio on a value counts as grown: what is printed with four digits.
pub(crate) const GROWN: f64 = 1.0005;
