//! A static force on a stone of a stack.

/// A force that acts all the time: a lamp, a cable, what a roof presses on a wall. It keeps its direction, and its point moves with the stone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StaticLoad {
    /// The block.
    pub block: usize,
    /// Point of application in the stack as drawn, m.
    pub position_m: [f64; 3],
    /// The force, N, z up. It has no mass: an earthquake does not shake it.
    pub force_n: [f64; 3],
}
