//! A piece of a stack under shaking along one direction: the largest balanced acceleration, and the mechanism.

use super::StackLoads;
use super::limit_acts::{LimitProblem, acts};
use super::limit_options::Holding;
use super::limit_pieces::{GrowingLoad, Piece, pieces};
use super::limit_programme::{AccelerationSet, ProgrammeOutcome, rough};
use super::limit_region::Nearest;
use crate::stability::StabilityError;
use crate::structure::stack::Stack;

/// Acceleration over gravity that a rough solution, accurate to 1e-6, must exceed for the piece to count as standing. Our choice.
const CLEAR: f64 = 1e-3;

/// The limit of a piece along one direction, near some, or over all.
pub(super) struct DirectionLimit {
    /// The limit, its direction and evidence.
    pub(super) found: Nearest,
    /// Number of unknown forces and accelerations.
    pub(super) unknowns: usize,
    /// Velocities [rows] of the mechanism at the limit; empty if the piece does not stand.
    pub(super) velocities: Vec<f64>,
}

/// The largest balanced acceleration along one direction. The piece stands if the opposite direction also gives a positive limit.
pub(super) fn along(piece: &Piece, way: [f64; 2]) -> Result<DirectionLimit, StabilityError> {
    let mut programme = piece.programme(AccelerationSet::Line(way))?;
    let mut along = DirectionLimit {
        found: Nearest {
            stands: false,
            ..Nearest::unasked(way)
        },
        unknowns: programme.unknowns(),
        velocities: Vec::new(),
    };
    for towards in [way.map(|part| -part), way] {
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
    let mut programme = piece.programme_by(AccelerationSet::Line(way), rough())?;
    let is_clear = [way.map(|part| -part), way].into_iter().all(
        |towards| matches!(programme.support(towards), Ok(ProgrammeOutcome::Reaches(support)) if support.bound > CLEAR),
    );
    match is_clear {
        true => Ok(true),
        false => Ok(along(piece, way)?.found.stands),
    }
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
