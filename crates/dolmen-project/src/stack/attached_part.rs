//! Steps below a block and a mast on it, from the file.

use crate::quantity::Quantity;

/// Steps below a block, each set back from the one above it.
#[derive(Clone, Debug, PartialEq)]
pub struct CornicePart {
    /// Their number.
    pub steps: u32,
    /// Height of all together, m.
    pub height: Quantity,
    /// How far the side of each is set back from that above it, m.
    pub setback: Quantity,
}

/// An upright cylinder on a block.
#[derive(Clone, Debug, PartialEq)]
pub struct MastPart {
    /// Upwards, m.
    pub height: Quantity,
    /// Its diameter, m.
    pub diameter: Quantity,
    /// Density, kg/m³; `None` that of the block.
    pub density: Option<Quantity>,
}
