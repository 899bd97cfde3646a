//! Quantities of a structure in the wind that can be requested.

/// The quantity of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GustQuantity {
    /// Its displacement, mean and gusts.
    Displacement,
    /// Its acceleration; the mean is 0.
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
