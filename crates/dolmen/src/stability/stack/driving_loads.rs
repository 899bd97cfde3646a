//! Static loads that drive the first mechanism, and those that resist it.
//!
//! The largest balanced factor is concave in the size of every steady load, so the least over loads that each may be there or not is reached with
//! each of them there or not. From a first mechanism, the loads that do work in it stay and the others go, until none changes.

use super::StackLoads;
use super::limit_along::{DirectionLimit, along, shaken_pieces, unit};
use super::limit_options::Holding;
use super::limit_pieces::Piece;
use super::load_factor::{GROWS, SteadyLoads, pieces_of};
use crate::stability::StabilityError;
use crate::structure::stack::{Stack, StaticLoad};
use glam::DVec3;

/// Power over force and largest velocity below which a load does no work. Our choice: far above rounding.
const WORKS: f64 = 1e-6;

/// For each of the asked loads, whether it does work in the first mechanism of a stack under shaking towards a direction. Its static loads act.
/// `None` if nothing moves, or if it does not stand.
///
/// # Errors
/// Those of [`limit_analysis`](super::limit_analysis()).
pub(crate) fn driving_shaken(
    stack: &Stack,
    loads: &StackLoads,
    direction: [f64; 2],
    asked: &[StaticLoad],
) -> Result<Option<Vec<bool>>, StabilityError> {
    let loads = loads.on_blocks(stack)?;
    let pieces = shaken_pieces(stack, &loads, Holding::Cohesion);
    driving(&pieces, unit(direction)?, (stack, asked))
}

/// For each of the asked loads, whether it does work in the first mechanism under growing loads. Only the loads given here act. `None` as in
/// [`driving_shaken`].
///
/// # Errors
/// Those of [`load_factor`](super::load_factor()).
pub(crate) fn driving_under_growth(
    stack: &Stack,
    steady: &SteadyLoads<'_>,
    growing: &[StaticLoad],
    asked: &[StaticLoad],
) -> Result<Option<Vec<bool>>, StabilityError> {
    let bare = stack.clone().without_static_loads();
    let (pieces, _) = pieces_of(&bare, steady, growing)?;
    driving(&pieces, GROWS, (&bare, asked))
}

fn driving(
    pieces: &[Piece],
    way: [f64; 2],
    (stack, asked): (&Stack, &[StaticLoad]),
) -> Result<Option<Vec<bool>>, StabilityError> {
    let mut first: Option<(&Piece, DirectionLimit)> = None;
    for piece in pieces {
        let limit = along(piece, way)?;
        if !limit.found.stands {
            return Ok(None);
        }
        if first
            .as_ref()
            .is_none_or(|(_, least)| limit.found.bound < least.found.bound)
        {
            first = Some((piece, limit));
        }
    }
    let Some((piece, limit)) = first else {
        return Ok(None);
    };
    let motions = piece.motions(&limit.velocities, stack.blocks().len());
    let velocity = |load: &StaticLoad| -> DVec3 {
        let at = DVec3::from(load.position_m);
        motions[load.block].iter().map(|motion| motion.at(at)).sum()
    };
    let fastest = asked
        .iter()
        .map(|load| velocity(load).length())
        .fold(0.0, f64::max);
    let drives = asked.iter().map(|load| {
        let force = DVec3::from(load.force_n);
        force.dot(velocity(load)) > WORKS * force.length() * fastest
    });
    Ok(Some(drives.collect()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::stack::{Block, JointMaterial, Solid};

    /// A block of 0.6 × 0.6 × 3 m that overturns about an edge: a weight beyond the edge drives it, one on this side of the edge resists.
    #[test]
    fn exact_a_load_beyond_the_edge_drives_and_one_before_it_resists() {
        let block = Block {
            name: "pillar".into(),
            solid: Solid::cuboid(0.6, 0.6, 3.0).unwrap(),
            density_kg_m3: 2300.0,
        };
        let stack = Stack::new(vec![block], JointMaterial::with_friction(0.6), 9.81).unwrap();
        let at = |x: f64, force_n: [f64; 3]| StaticLoad {
            block: 0,
            position_m: [x, 0.0, 2.5],
            force_n,
        };
        let down = [0.0, 0.0, -1e3];
        let asked = [
            at(1.3, down),
            at(0.29, down),
            at(-0.3, down),
            at(0.0, [1e3, 0.0, 0.0]),
        ];
        let shaken = driving_shaken(&stack, &StackLoads::default(), [1.0, 0.0], &asked).unwrap();
        assert_eq!(shaken, Some(vec![true, false, false, true]));
        let steady = SteadyLoads {
            weight: 1.0,
            loads: &[],
        };
        let pushed = driving_under_growth(&stack, &steady, &[at(0.0, [-1e3, 0.0, 0.0])], &asked).unwrap();
        assert_eq!(pushed, Some(vec![false, false, false, false]));
    }
}
