//! A piece of a stack under shaking along one direction: the largest balanced acceleration, and the mechanism.

use super::StackLoads;
use super::limit_acts::{LimitProblem, acts};
use super::limit_options::Holding;
use super::limit_pieces::{GrowingLoad, Piece, pieces};
use super::limit_programme::{AccelerationSet, ProgrammeOutcome, rough};
use super::limit_region::{Nearest, turned};
use super::loads::Load;
use crate::stability::StabilityError;
use crate::structure::stack::Stack;

/// Acceleration over gravity that a rough solution, accurate to 1e-6, must exceed for the piece to count as standing. Our choice.
const CLEAR: f64 = 1e-3;

/// Largest difference from 1 of the scalar product of equal directions. Our choice: it is rounding.
const SAME_WAY: f64 = 1e-14;

/// The limit of a piece along one direction, near some, or over all.
pub(super) struct DirectionLimit {
    /// The limit, its direction and evidence.
    pub(super) found: Nearest,
    /// Number of unknown forces and accelerations.
    pub(super) unknowns: usize,
    /// Velocities [rows] of the mechanism at the limit; empty if the piece does not stand.
    pub(super) velocities: Vec<f64>,
}

/// The senses of a direction in which a piece may move, the given one last; without the opposite one if it is the image of the given one by a
/// symmetry of the piece.
fn senses(piece: &Piece, way: [f64; 2]) -> Vec<[f64; 2]> {
    let back = way.map(|part| -part);
    let is_back = |image: [f64; 2]| image[0] * back[0] + image[1] * back[1] > 1.0 - SAME_WAY;
    let mut images = piece.symmetries().iter().map(|symmetry| turned(symmetry, way));
    match images.any(is_back) {
        true => vec![way],
        false => vec![back, way],
    }
}

/// The largest balanced acceleration along one direction. The piece stands if the opposite direction also gives a positive limit.
pub(super) fn along(piece: &Piece, way: [f64; 2]) -> Result<DirectionLimit, StabilityError> {
    let mut programme = piece.programme(AccelerationSet::Line(way));
    let mut along = DirectionLimit {
        found: Nearest {
            stands: false,
            ..Nearest::unasked(way)
        },
        unknowns: programme.unknowns(),
        velocities: Vec::new(),
    };
    for towards in senses(piece, way) {
        let found = &mut along.found;
        found.solved += 1;
        match programme.support(towards)? {
            ProgrammeOutcome::Reaches(support) if support.bound > 0.0 => {
                found.missed = found.missed.max(support.missed);
                found.bound = support.bound;
                found.at_least = support.point[0] * way[0] + support.point[1] * way[1];
            }
            _ => return Ok(along),
        }
    }
    along.found.stands = true;
    along.found.asked.push((way, along.found.bound));
    along.velocities = programme.velocities().to_vec();
    Ok(along)
}

/// Whether a piece stands, by the same criterion as [`along`], but with rough solutions if both limits are clearly positive.
fn stands_along(piece: &Piece, way: [f64; 2]) -> Result<bool, StabilityError> {
    let mut programme = piece.programme_by(AccelerationSet::Line(way), rough());
    let is_clear = senses(piece, way).into_iter().all(
        |towards| matches!(programme.support(towards), Ok(ProgrammeOutcome::Reaches(support)) if support.bound > CLEAR),
    );
    match is_clear {
        true => Ok(true),
        false => Ok(along(piece, way)?.found.stands),
    }
}

/// The pieces of a stack under shaking along any direction.
pub(super) fn shaken_pieces(stack: &Stack, loads: &[Load], holding: Holding) -> Vec<Piece> {
    let problem = LimitProblem {
        stack,
        loads,
        towards: None,
        grows: false,
        is_coarse: false,
    };
    let acts = acts(&problem, holding);
    pieces(stack, loads, &acts, GrowingLoad::Shaking, false)
}

/// Whether forces in the joints certainly balance weight and static loads, with shaking in both senses of one direction.
///
/// # Errors
/// Those of [`limit_analysis`](super::limit_analysis()).
pub(crate) fn stands_by_limit_analysis(
    stack: &Stack,
    loads: &StackLoads,
    direction: [f64; 2],
) -> Result<bool, StabilityError> {
    Ok(falling_blocks(stack, loads, direction, true)?.is_empty())
}

/// The blocks of all pieces for which that is not certain, or of the first such piece.
pub(super) fn falling_blocks(
    stack: &Stack,
    loads: &StackLoads,
    direction: [f64; 2],
    is_first_enough: bool,
) -> Result<Vec<usize>, StabilityError> {
    let way = unit(direction)?;
    let loads = loads.on_blocks(stack)?;
    let problem = LimitProblem {
        stack,
        loads: &loads,
        towards: Some(way),
        grows: false,
        is_coarse: false,
    };
    let acts = acts(&problem, Holding::FrictionOnly);
    let mut falling = Vec::new();
    for piece in &pieces(stack, &loads, &acts, GrowingLoad::Shaking, false) {
        if !stands_along(piece, way)? {
            falling.extend(piece.blocks());
            if is_first_enough {
                break;
            }
        }
    }
    Ok(falling)
}

pub(super) fn unit(direction: [f64; 2]) -> Result<[f64; 2], StabilityError> {
    let length = direction[0].hypot(direction[1]);
    if !(length > 0.0 && length.is_finite()) {
        return Err(StabilityError::Direction {
            quantity: "direction of shaking",
            given: direction,
        });
    }
    Ok(direction.map(|part| part / length))
}

#[cfg(test)]
mod tests {
    use super::super::towers::arch_that_crushes;
    use super::*;

    /// An arch with a strength: the limit with a few stress blocks of each joint, chosen by its mechanisms, is that with all.
    #[test]
    fn agrees_with_the_programme_of_all_stress_blocks() {
        let stack = arch_that_crushes();
        let loads = StackLoads::default().on_blocks(&stack).unwrap();
        let pieces = shaken_pieces(&stack, &loads, Holding::FrictionOnly);
        let mut few = pieces[0].programme(AccelerationSet::Plane);
        let mut all = pieces[0].programme(AccelerationSet::Plane).with_all_toes();
        for towards in [[1.0, 0.0], [0.6, 0.8]] {
            let [few, all] =
                [&mut few, &mut all].map(|programme| match programme.support(towards).unwrap() {
                    ProgrammeOutcome::Reaches(support) => support.bound,
                    ProgrammeOutcome::Falls => panic!("{towards:?}"),
                });
            assert!((few - all).abs() < 1e-8 && few > 0.05, "{few} {all}");
        }
        assert_eq!((few.unknowns(), all.left_out()), (all.unknowns(), 0));
        assert!(9 * few.left_out() > 2 * few.unknowns(), "{}", few.left_out());
    }
}
