//! One way in which a part of a stack begins to move.

use super::LimitKind;

/// One way in which a part begins to move: f · F + m · M ≤ s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resistance {
    /// Tipping about an edge, or sliding.
    pub kind: LimitKind,
    /// f; m when tipping, without unit when sliding.
    pub force: [f64; 3],
    /// m, without unit.
    pub moment: [f64; 3],
    /// s: N m when tipping, N when sliding.
    pub reserve: f64,
}
