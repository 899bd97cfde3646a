//! Why a stack of blocks cannot exist.

/// Why a stack, a block or a joint cannot be. Each variant carries the value that was refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StackError {
    /// No blocks.
    #[error("the stack has no blocks, but needs at least 1")]
    Empty,
    /// Two blocks of one name.
    #[error("two blocks are named '{name}': give each its own name")]
    Name {
        /// The name.
        name: String,
    },
    /// A dimension that must be positive and finite is not.
    #[error("{quantity} is {given}, but must be {allowed}")]
    Dimension {
        /// Which dimension, with its unit.
        quantity: &'static str,
        /// The value given.
        given: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A prism with too few or too many sides.
    #[error("a prism of {given} sides: it must have 3 to {most}; more than that is a drum")]
    Sides {
        /// The number given.
        given: u32,
        /// The most there may be.
        most: u32,
    },
    /// An opening that is not inside.
    #[error(
        "an opening must lie inside its stone and leave some of it, but its corner {corner:?} lies {beyond_m:.4} m outside: check its size and place"
    )]
    Opening {
        /// The corner that lies farthest out, m.
        corner: [f64; 3],
        /// How far, m.
        beyond_m: f64,
    },
    /// Two openings in the same place.
    #[error(
        "two openings of a stone overlap by {depth_m:.4} m, and what they share would be taken out twice: move or join them"
    )]
    Openings {
        /// Least distance by which one must move to be free of the other, m.
        depth_m: f64,
    },
    /// A density or gravity out of its range.
    #[error("{part}: {quantity} is {given}, but must be a positive number")]
    NotPositive {
        /// The block, or "the stack".
        part: String,
        /// Name of the quantity with its unit.
        quantity: &'static str,
        /// The value given.
        given: f64,
    },
    /// A value of a joint out of its range.
    #[error("{quantity} of a joint is {given}, but must be {allowed}")]
    Material {
        /// Name of the quantity with its unit.
        quantity: &'static str,
        /// The value given.
        given: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// Two blocks share space.
    #[error(
        "'{first}' and '{second}' overlap by {depth_m:.4} m, but stones may touch only (within {allowed_m} m): check their sizes and offsets"
    )]
    Overlap {
        /// One block.
        first: String,
        /// The other, or "the ground".
        second: String,
        /// Least distance by which one must move to be free of the other, m.
        depth_m: f64,
        /// What is allowed, m.
        allowed_m: f64,
    },
    /// A block rests on nothing.
    #[error(
        "'{block}' floats: the nearest bed below it, of {nearest}, is {gap_m:.4} m away, and a bed must lie within {allowed_m} m"
    )]
    Floating {
        /// The block.
        block: String,
        /// The nearest block below it, or "the ground".
        nearest: String,
        /// Distance to it, m.
        gap_m: f64,
        /// What is allowed, m.
        allowed_m: f64,
    },
    /// There is no such block.
    #[error("there is no block {given}, only 0 to {last}")]
    NoBlock {
        /// The index given.
        given: usize,
        /// The last one there is.
        last: usize,
    },
    /// There is no such joint.
    #[error("there is no joint {given}: the stack has {count}")]
    NoJoint {
        /// The index given.
        given: usize,
        /// How many there are.
        count: usize,
    },
    /// A vector that must have a direction has none.
    #[error("{quantity} is {given:?}, but must be a vector of finite, not all zero numbers")]
    Direction {
        /// Which vector.
        quantity: &'static str,
        /// The value given.
        given: [f64; 3],
    },
    /// A place that is not finite.
    #[error("{quantity} is {given:?}, but must be three finite numbers")]
    Position {
        /// Which place.
        quantity: &'static str,
        /// The value given, m.
        given: [f64; 3],
    },
}
