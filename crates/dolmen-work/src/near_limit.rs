//! How near a reading may come to its limit.

/// Share of its limit from which a reading is near it. Our choice.
pub(crate) const NEAR_FROM: f64 = 0.9;
