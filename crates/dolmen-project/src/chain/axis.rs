//! The directions of a chain by name.

/// A direction of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChainAxis {
    /// Of bed_width, breadth, along: x.
    Along,
    /// Of bed_depth, depth, across: y.
    Across,
}

impl ChainAxis {
    /// Its name in surveys and motions.
    pub fn name(self) -> &'static str {
        match self {
            ChainAxis::Along => "x",
            ChainAxis::Across => "y",
        }
    }
}
