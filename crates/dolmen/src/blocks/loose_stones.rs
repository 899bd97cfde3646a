//! Loose stones under their own weight: their positions of rest, and the stones that leave their places.

use super::contact_law::{ContactLaw, simulate_stack};
use super::error::BlocksError;
use super::fall::least_thickness;
use super::history::{Outcome, StackHistory};
use super::hulls::Hull;
use crate::structure::stack::Stack;
use glam::{DQuat, DVec3};

/// Energy created by contacts, over the energy of the lost height, above which a run is unusable. Our choice, as for springs.
const MADE_MOST: f64 = 1e-2;

/// State of loose stones at the end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LooseEnding {
    /// All stones are at rest, each near its drawn position.
    Stood,
    /// All stones are at rest, and some left their places.
    Fell,
    /// Stones still moved when the run ended.
    StillMoving {
        /// One of these stones, as an index of the blocks.
        block: usize,
    },
    /// The run is unusable: it was stopped, diverged, or a step had no solution.
    Unusable,
}

/// Motion of a loose stone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LooseStone {
    /// Distance of its centroid from the drawn position, m.
    pub moved_m: f64,
    /// Vertical part of this distance, downwards, m.
    pub dropped_m: f64,
    /// Angle of its rotation, rad.
    pub turned_rad: f64,
    /// Half its least thickness, m: if its centroid moved farther, the stone left its place.
    pub allowed_m: f64,
}

impl LooseStone {
    /// Rotation above which a stone has left its place, rad: 45°, as for a stone on a bed.
    pub const TURN_MOST_RAD: f64 = std::f64::consts::FRAC_PI_4;

    /// Whether it left its place: it moved by more than half its least thickness, or rotated by more than 45°.
    pub fn has_left(&self) -> bool {
        self.moved_m > self.allowed_m || self.turned_rad > LooseStone::TURN_MOST_RAD
    }
}

/// Loose stones after a run under their own weight.
#[derive(Clone, Debug, PartialEq)]
pub struct SettledStones {
    /// How the run ended.
    pub ending: LooseEnding,
    /// Motion of each stone, in the order of the blocks.
    pub stones: Vec<LooseStone>,
    /// The run.
    pub history: StackHistory,
}

impl SettledStones {
    /// The stone with the largest displacement relative to its allowed one, as an index of the blocks.
    pub fn farthest(&self) -> usize {
        let part = |stone: &LooseStone| stone.moved_m / stone.allowed_m;
        let most = self
            .stones
            .iter()
            .enumerate()
            .max_by(|a, b| part(a.1).total_cmp(&part(b.1)));
        most.map_or(0, |(block, _)| block)
    }

    /// The stones that left their places.
    pub fn left(&self) -> Vec<usize> {
        let each = self.stones.iter().enumerate();
        each.filter(|(_, stone)| stone.has_left())
            .map(|(block, _)| block)
            .collect()
    }

    /// Time of the end of the run, s.
    pub fn end_s(&self) -> f64 {
        self.history.time_s.last().copied().unwrap_or_default()
    }
}

/// Lets loose stones fall from their drawn positions until they are at rest, by either contact law.
///
/// # Errors
/// [`BlocksError`] of the law; [`BlocksError::Option`] for a stack with joints.
///
/// # Limits
/// Contact is between convex hulls, with one patch for two stones. Stones start at rest in their drawn positions; drawn overlaps are not pushed
/// apart. Once a stone of a heap rolls, its position of rest is chaotic. Tested by `loose_stones`.
pub fn settle_loose(
    stack: &Stack,
    law: &ContactLaw,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<SettledStones, BlocksError> {
    if stack.loose_material().is_none() {
        return Err(BlocksError::Option {
            option: "joints of the stack",
            given: stack.joints().len() as f64,
            allowed: "none: the stones must be loose",
        });
    }
    let history = simulate_stack(stack, None, law, progress)?;
    let last = history.time_s.len().saturating_sub(1);
    let stones = stack.blocks().iter().enumerate().map(|(block, of)| {
        let pose = history.pose(last, block);
        let moved = DVec3::from(pose.centroid_m) - DVec3::from(of.solid.centroid_m());
        let [w, x, y, z] = pose.rotation;
        let turn = DQuat::from_xyzw(x, y, z, w);
        LooseStone {
            moved_m: moved.length(),
            dropped_m: -moved.z,
            turned_rad: 2.0 * turn.w.abs().min(1.0).acos(),
            allowed_m: 0.5 * least_thickness(&Hull::of(&of.solid)),
        }
    });
    let stones: Vec<LooseStone> = stones.collect();
    let ending = match history.outcome {
        _ if history.energy_made_ratio() > MADE_MOST => LooseEnding::Unusable,
        Outcome::StillMoving { block, .. } => LooseEnding::StillMoving { block },
        Outcome::Stopped { .. } | Outcome::NotConverged { .. } | Outcome::Diverged { .. } => {
            LooseEnding::Unusable
        }
        _ if stones.iter().any(LooseStone::has_left) => LooseEnding::Fell,
        _ => LooseEnding::Stood,
    };
    Ok(SettledStones {
        ending,
        stones,
        history,
    })
}
