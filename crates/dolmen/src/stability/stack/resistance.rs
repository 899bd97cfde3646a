//! One limit on the forces on a part of a stack.

use super::LimitKind;

/// The resistance of a part to one motion: f · F + m · M ≤ s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resistance {
    /// Tipping about an edge, or sliding.
    pub kind: LimitKind,
    /// f; for tipping in m, for sliding dimensionless.
    pub force: [f64; 3],
    /// m, dimensionless.
    pub moment: [f64; 3],
    /// s: N m for tipping, N for sliding.
    pub reserve: f64,
}
