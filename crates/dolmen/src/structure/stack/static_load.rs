//! A static force on a stone of a stack.

/// A permanent force: a lamp, a cable, a roof on a wall. It keeps its direction, and its point of application moves with the stone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StaticLoad {
    /// The block.
    pub block: usize,
    /// Point of application in the drawn position, m.
    pub position_m: [f64; 3],
    /// The force, N, z up. It has no mass, so an earthquake does not act on it.
    pub force_n: [f64; 3],
}
