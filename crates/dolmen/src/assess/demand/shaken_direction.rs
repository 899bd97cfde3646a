//! Direction of the shaking of a stack.

/// Direction of the shaking.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShakenDirection {
    /// Along x, to both sides.
    X,
    /// Along y, to both sides.
    Y,
    /// Anywhere in the plan.
    Any,
}
