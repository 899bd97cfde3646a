//! Options of [`stack_limits`](super::stack_limits).

use super::StackLoads;

/// Options of the limits of a stack.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StackLimits {
    /// Loads before any horizontal shaking. Default none.
    pub loads: StackLoads,
}
