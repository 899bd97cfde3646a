//! A possible force of a joint or tie at one point, and its law.

use glam::DVec3;

/// Relative difference below which capacities count as equal. Our choice, as for the pieces of a stack.
const SAME: f64 = 1e-9;

/// Possible forces of a joint or tie at one point: on a block, with the opposite forces on the body below.
#[derive(Clone, Copy)]
pub(super) struct PossibleForce {
    /// Index of its link: the joints, then the ties.
    pub(super) link: usize,
    pub(super) at: DVec3,
    /// First the normal of a joint or the axis of a tie, along which it pushes its block; then two perpendicular axes.
    pub(super) axes: [DVec3; 3],
    pub(super) law: Law,
}

/// The law of possible forces.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Law {
    /// Push along the first axis; across it at most the friction coefficient times as much.
    Friction(f64),
    /// Push along the first axis; across it at most the friction coefficient times as much. All toes of a joint together carry at most its
    /// full capacity.
    Toe {
        friction: f64,
        /// Capacity of this toe alone, N.
        capacity_n: f64,
    },
    /// Any force across the first axis up to this value, N.
    Shear(f64),
    /// Any force across the first axis up to this value, N, at one of the points of its joint where it may slide.
    Held(f64),
    /// Pull against the first axis up to this value, N.
    Pull(f64),
}

impl Law {
    /// Whether two laws are equal within rounding of a capacity.
    pub(super) fn is_like(self, other: Law) -> bool {
        match (self, other) {
            (
                Law::Toe { friction, capacity_n },
                Law::Toe {
                    friction: of_other,
                    capacity_n: other_n,
                },
            ) => friction == of_other && (capacity_n - other_n).abs() <= SAME * capacity_n,
            _ => self == other,
        }
    }
}
