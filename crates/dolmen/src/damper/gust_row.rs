//! Quantities that can be requested for a structure in wind.

/// The quantity of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GustQuantity {
    /// Displacement: mean and gusts.
    Displacement,
    /// Acceleration; its mean is 0.
    Acceleration,
}

/// A requested value of a structure in the wind.
#[derive(Clone, Debug, PartialEq)]
pub struct GustRow {
    /// The case of columns, from 0.
    pub case: usize,
    /// The combination of degrees of freedom.
    pub row: Vec<f64>,
    /// The quantity.
    pub quantity: GustQuantity,
}
