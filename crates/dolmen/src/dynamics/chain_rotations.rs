//! Linear or exact equations of a chain.

/// Size of rotations in the equations.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum ChainRotations {
    /// Any size, up to collapse: exact equations.
    #[default]
    Large,
    /// Linear equations of small rotations, for rotations of any size.
    Small,
}
