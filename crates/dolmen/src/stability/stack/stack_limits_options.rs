//! Options of [`stack_limits`](super::stack_limits).

use super::StackLoads;

/// Input of the limits besides the stack.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StackLimits {
    /// Loads before any horizontal shaking. Default none.
    pub loads: StackLoads,
}
