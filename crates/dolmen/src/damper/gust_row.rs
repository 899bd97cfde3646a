//! What is wanted of a structure in the wind.

/// What of a row over the structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GustQuantity {
    /// Its displacement, mean and gusts.
    Displacement,
    /// Its acceleration; the mean is 0.
    Acceleration,
}

/// A value of a structure in the wind.
#[derive(Clone, Debug, PartialEq)]
pub struct GustRow {
    /// Which of the cases of columns, from 0.
    pub case: usize,
    /// The combination of degrees of freedom.
    pub row: Vec<f64>,
    /// What of it.
    pub quantity: GustQuantity,
}
