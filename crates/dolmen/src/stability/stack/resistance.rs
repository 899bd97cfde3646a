//! One way in which a part of a stack begins to move.

use super::LimitKind;

/// One way in which a part begins to move: f · F + m · M ≤ s.
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
