//! Options and result of a stack on moving supports.

use super::loads::StackLoads;
use super::mechanism::Mechanism;
use crate::structure::stack::Solid;

/// Options of moving supports.
#[derive(Clone, Debug, PartialEq)]
pub struct SupportMovementOptions {
    /// Loads in addition to the weight, with constant direction. Default none.
    pub loads: StackLoads,
    /// Largest rotation of a stone, rad, and largest displacement over the size of the stack, in one step. Default 0.004, our choice: half of it
    /// changes the movement at collapse of an arch with t/R = 0.15 by less than 0.1 %.
    pub step: f64,
    /// Movement at which the analysis ends, over the size of the stack. Default 0.1, our choice: beyond any repair, and stones that come to touch
    /// anew are not seen.
    pub movement_most: f64,
    /// Largest number of steps, including rejected ones. Default 1000, our choice.
    pub steps_most: usize,
}

impl Default for SupportMovementOptions {
    fn default() -> Self {
        SupportMovementOptions {
            loads: StackLoads::default(),
            step: 0.004,
            movement_most: 0.1,
            steps_most: 1000,
        }
    }
}

/// Force of the ground on one block.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SupportReaction {
    /// The block.
    pub block: usize,
    /// Force of the ground on the block, N, z up.
    pub force_n: [f64; 3],
}

/// A stack at one stage of the movement.
#[derive(Clone, Debug, PartialEq)]
pub struct MovedStack {
    /// Factor on the given movement.
    pub factor: f64,
    /// Its stones at this stage.
    pub solids: Vec<Solid>,
    /// Joints that have opened or slipped since the stack was drawn.
    pub mechanism: Option<Mechanism>,
    /// Force on each support, in the order of the blocks.
    pub reactions: Vec<SupportReaction>,
    /// Largest slip in a closed joint so far, m.
    pub slip_m: f64,
}

/// Stones that move on by themselves until they rest again, while the supports stand still: open joints close and others open.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SupportJump {
    /// Factor on the given movement at which it begins.
    pub factor: f64,
    /// Largest displacement of a stone, m.
    pub moved_m: f64,
    /// Largest rotation of a stone, rad.
    pub turned_rad: f64,
}

/// End of the analysis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MovementEnding {
    /// Beyond the last state, within less than one step, no joint forces balance the weight, and the stones find no other rest nearby.
    Falls {
        /// Factor on the given movement at which the stack falls.
        by_factor: f64,
    },
    /// The stack stood until the largest movement of the analysis.
    Stands,
    /// A step was not solved, the number of steps did not suffice, or the given movement is larger than the largest of the analysis: the result
    /// is unknown.
    NotFollowed,
}

/// Result of moving supports.
#[derive(Clone, Debug, PartialEq)]
pub struct MovedSupports {
    /// State after a very small movement, in which only the first joints have opened.
    pub small: MovedStack,
    /// State after the given movement; `None` if the stack falls before.
    pub given: Option<MovedStack>,
    /// The last state in which the stack stood.
    pub last: MovedStack,
    /// Jumps on the way there, in their order.
    pub jumps: Vec<SupportJump>,
    /// End of the analysis.
    pub ending: MovementEnding,
    /// Largest error of equilibrium in any step, over the weight.
    pub residual: f64,
    /// Number of steps tried.
    pub steps: usize,
}

impl MovedSupports {
    /// Slip in closed joints divided by the size of the stack: above this value, the movement at collapse depends on friction. Our choice.
    pub const SLIP_TELLS: f64 = 1e-3;
    /// Factor on the given movement below which a standing stack is marginal. Our choice, as for loads.
    pub const MARGINAL_BELOW: f64 = 1.5;

    /// Whether the largest movement in which it stood is less than a stable stack needs.
    pub fn is_near(&self) -> bool {
        self.last.factor < Self::MARGINAL_BELOW
    }
}
