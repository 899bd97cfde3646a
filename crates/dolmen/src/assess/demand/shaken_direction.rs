//! Where a stack is shaken.

/// Where the shaking goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShakenDirection {
    /// Along x, to both sides.
    X,
    /// Along y, to both sides.
    Y,
    /// Anywhere in the plan.
    Any,
}
