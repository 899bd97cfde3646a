//! A piece of a stack under shaking in any direction, or near given ones: the smallest limit and its mechanism.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | ν | `towards` | direction along which the acceleration is maximised |
//! | r | `support.bound` | the largest balanced acceleration along ν |
//! | n | `normal` | power of the loads of 1 g along x and y in the mechanism that bounds r; n·ν = 1 |

use super::limit_along::DirectionLimit;
use super::limit_pieces::Piece;
use super::limit_programme::{AccelerationSet, ProgrammeOutcome};
use super::limit_region::{Nearest, is_near, nearest, turned};
use crate::stability::StabilityError;

/// Largest difference of n·ν from 1 with which the mechanism bounds the region and not the search. Our choice: a solution is accurate to 1e-8.
const SAME: f64 = 1e-6;

/// The smallest limit over all directions, or one that is certainly above `enough`.
pub(super) fn any_way(piece: &Piece, enough: f64) -> Result<DirectionLimit, StabilityError> {
    let mut programme = piece.programme(AccelerationSet::Plane);
    let unknowns = programme.unknowns();
    let (mut least, mut velocities) = (f64::INFINITY, Vec::new());
    let ask = |towards: [f64; 2]| {
        let outcome = programme.support(towards)?;
        if let ProgrammeOutcome::Reaches(support) = outcome
            && support.bound < least
        {
            least = support.bound;
            velocities = programme.velocities().to_vec();
        }
        Ok(outcome)
    };
    Ok(DirectionLimit {
        found: nearest(ask, piece.symmetries(), enough)?,
        unknowns,
        velocities,
    })
}

/// The smallest limit near given directions and their opposites.
///
/// ```text
/// mechanism at r ν:    n·a ≤ r for all balanced accelerations a, so that |a| along n is at most r/|n|
/// ```
///
/// Where the region of balanced accelerations has a straight edge, one solution gives its distance from rest, even if ν is not its normal.
/// Directions that are images of an earlier one by a symmetry of the piece are left out.
pub(super) fn near(piece: &Piece, ways: &[[f64; 2]]) -> Result<DirectionLimit, StabilityError> {
    let mut near = DirectionLimit {
        found: Nearest::unasked([1.0, 0.0]),
        unknowns: 0,
        velocities: Vec::new(),
    };
    near.found.at_least = f64::INFINITY;
    let mut asked: Vec<[f64; 2]> = Vec::new();
    for &way in ways {
        let mut images = piece.symmetries().iter().map(|symmetry| turned(symmetry, way));
        if images.any(|image| asked.iter().any(|known| is_near(*known, image))) {
            continue;
        }
        asked.push(way);
        let mut programme = piece.programme(AccelerationSet::Line(way));
        near.unknowns = programme.unknowns();
        for towards in [way, way.map(|part| -part)] {
            let found = &mut near.found;
            found.solved += 1;
            let support = match programme.support(towards)? {
                ProgrammeOutcome::Reaches(support) if support.bound > 0.0 => support,
                _ => {
                    found.stands = false;
                    return Ok(near);
                }
            };
            let normal = piece.shaking_power(programme.velocities());
            let is_edge = (normal[0] * towards[0] + normal[1] * towards[1] - 1.0).abs() < SAME;
            let (bound, nearest) = match normal[0].hypot(normal[1]) {
                length if is_edge => (support.bound / length, normal.map(|part| part / length)),
                _ => (support.bound, towards),
            };
            let reached = support.point[0] * towards[0] + support.point[1] * towards[1];
            found.missed = found.missed.max(support.missed);
            found.at_least = found.at_least.min(reached).min(bound);
            found.asked.push((nearest, bound));
            if bound < found.bound {
                (found.bound, found.towards) = (bound, nearest);
                near.velocities = programme.velocities().to_vec();
            }
        }
    }
    Ok(near)
}

#[cfg(test)]
mod tests {
    use super::super::towers::tower;
    use super::super::{LimitAnalysis, LimitAnalysisResult, LimitAnalysisStatus, Shaking, limit_analysis};
    use crate::structure::stack::{JointMaterial, Stack, TowerFactors, TowerPlan, tower as tower_of_stones};

    fn near(stack: &Stack, ways: Vec<[f64; 2]>) -> LimitAnalysisResult {
        let options = LimitAnalysis {
            shaking: Shaking::Near(ways),
            ..LimitAnalysis::default()
        };
        limit_analysis(stack, &options).unwrap()
    }

    fn limit_g(found: &LimitAnalysisResult) -> f64 {
        match found.status {
            LimitAnalysisStatus::Limited(threshold) => threshold.acceleration_g,
            other => panic!("{other:?}"),
        }
    }

    /// A column .4 m wide and 2 m high tips over each edge at .2: along a direction .1 rad beside the normal of an edge it tips at .2/cos .1.
    #[test]
    fn exact_edge_of_one_solution_beside_its_normal() {
        let stack = tower(&[(0.4, 2.0)], 0.6);
        let way = [0.1_f64.cos(), 0.1_f64.sin()];
        let found = near(&stack, vec![way]);
        assert!((limit_g(&found) - 0.2).abs() < 1e-8, "{found:?}");
        let [direction] = found.directions[..] else {
            panic!("{found:?}")
        };
        assert!((direction[0].abs() - 1.0).abs() < 1e-8, "{direction:?}");
        assert!(found.solved == 2 && found.at_least_g <= limit_g(&found));
        // the perpendicular direction is its image by a quarter turn
        assert_eq!(near(&stack, vec![way, [-way[1], way[0]]]).solved, 2);
    }

    #[test]
    fn holds_directions_of_all_edges_that_tie() {
        let found = limit_analysis(&tower(&[(0.4, 2.0)], 0.6), &LimitAnalysis::default()).unwrap();
        assert_eq!(found.directions.len(), 2, "{:?}", found.directions);
        assert!(found.directions.iter().all(|way| (way[0] * way[1]).abs() < 1e-8));
    }

    /// A hollow tower in bond, whose region has round edges near the axes.
    #[test]
    fn holds_between_the_least_of_all_directions_and_the_ray() {
        let blocks = tower_of_stones(&TowerFactors {
            plan: TowerPlan::Square,
            width_m: 2.0,
            top_width_m: 1.8,
            courses: 4,
            course_height_m: 0.5,
            thickness_m: Some(0.4),
            density_kg_m3: 2600.0,
        })
        .unwrap();
        let stack = Stack::new(blocks, JointMaterial::with_friction(0.9), 9.81).unwrap();
        let all = limit_analysis(&stack, &LimitAnalysis::default()).unwrap();
        let way = [0.05, 1.0];
        let ray = LimitAnalysis {
            shaking: Shaking::Along(way),
            ..LimitAnalysis::default()
        };
        let ray_g = limit_g(&limit_analysis(&stack, &ray).unwrap());
        let near_g = limit_g(&near(&stack, vec![way]));
        assert!(
            near_g >= all.at_least_g && near_g < ray_g - 1e-5,
            "{near_g} {ray_g} {all:?}"
        );
    }
}
