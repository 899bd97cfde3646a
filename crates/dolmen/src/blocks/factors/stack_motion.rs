//! Motions of a stack in its modes.

/// Motion of the stack in a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum StackMotion {
    /// It sways along x.
    X,
    /// It sways along y.
    Y,
    /// It twists about the vertical.
    Torsion,
}

impl StackMotion {
    /// Axis of a sway; `None` for torsion.
    pub(super) fn axis(self) -> Option<usize> {
        match self {
            StackMotion::X => Some(0),
            StackMotion::Y => Some(1),
            StackMotion::Torsion => None,
        }
    }
}
