//! How far the equations of a chain go.

/// How far rotations go.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum ChainRotations {
    /// Any size, up to collapse.
    #[default]
    Large,
    /// The linear equations of small rotations, whatever size they reach.
    Small,
}
