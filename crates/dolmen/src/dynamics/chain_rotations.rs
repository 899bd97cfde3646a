//! Linear or exact equations of a chain.

/// Size of rotations in the equations.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum ChainRotations {
    /// Any size, up to collapse: exact equations.
    #[default]
    Large,
    /// The linear equations of small rotations, whatever size the rotations reach.
    Small,
}
