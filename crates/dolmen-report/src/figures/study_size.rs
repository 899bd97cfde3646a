//! How large the figures of studies are.

/// Size of a figure, px.
pub(super) const SIZE_PX: [f64; 2] = [640.0, 380.0];
