//! Options of [`stack_limits`](super::stack_limits).

use super::StackLoads;

/// What the limits depend on besides the stack.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StackLimits {
    /// What acts before any horizontal shaking. Default nothing.
    pub loads: StackLoads,
}
