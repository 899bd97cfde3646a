//! The accelerations that can be balanced are a convex region: the point of its edge nearest to rest.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | ν | `towards` | unit vector in which the region is asked how far it reaches |
//! | h(ν) | `bound` | how far it reaches |
//! | S | `symmetries` | turns and mirrors that leave the region as it is |

use super::limit_programme::{ACCELERATION_MOST, Answer, Support};
use crate::stability::StabilityError;
use crate::structure::stack::Polygon;

/// A turn or mirror of the plane, by rows.
pub(super) type Symmetry = [[f64; 2]; 2];

/// Relative difference of both bounds below which no direction is asked any more. Chosen here: what a solution misses is 1e-8.
const SAME: f64 = 1e-6;
/// The same once [`ENOUGH`] directions were asked: a smooth edge would take very many. Chosen here.
const NEAR: f64 = 0.02;
/// Directions asked before [`NEAR`] suffices. Chosen here: straight edges are found in fewer.
const ENOUGH: usize = 12;
/// Points nearer to each other are one, over gravity: the line through them would be rounding. Chosen here.
const APART: f64 = 1e-5;
/// Directions that are asked at most; some 20 are usual. Chosen here.
const DIRECTIONS_MOST: usize = 200;

/// The least acceleration that leaves the region.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Nearest {
    /// Rest itself is within it.
    pub(super) stands: bool,
    /// Least h(ν) of all directions asked: an upper bound of the least.
    pub(super) bound: f64,
    /// Its ν.
    pub(super) towards: [f64; 2],
    /// All accelerations below this are within the region: a lower bound.
    pub(super) at_least: f64,
    /// Largest of what the solutions missed.
    pub(super) missed: f64,
    /// Solutions.
    pub(super) solved: usize,
}

/// All that the symmetries given make of each other, the identity first.
pub(super) fn group(generators: &[Symmetry]) -> Vec<Symmetry> {
    let mut all: Vec<Symmetry> = vec![[[1.0, 0.0], [0.0, 1.0]]];
    let mut next = 0;
    while next < all.len() {
        for generator in generators {
            let product = [0, 1].map(|row| turned(&transposed(&all[next]), generator[row]));
            if !all.contains(&product) {
                all.push(product);
            }
        }
        next += 1;
    }
    all
}

fn transposed(symmetry: &Symmetry) -> Symmetry {
    [[symmetry[0][0], symmetry[1][0]], [symmetry[0][1], symmetry[1][1]]]
}

pub(super) fn turned(symmetry: &Symmetry, point: [f64; 2]) -> [f64; 2] {
    symmetry.map(|row| row[0] * point[0] + row[1] * point[1])
}

/// The point of the region's edge nearest to rest; ends early where it is known not to come below `enough`.
///
/// ```text
/// points reached: their hull lies within the region; directions asked: the region lies within their half planes
/// the nearest edge of the hull is asked next, until it is an edge of the region
/// ```
///
/// # Source
/// van den Bergen (2001), expanding polytopes. Differs from the source: in the plane, and with symmetries.
pub(super) fn nearest(
    mut ask: impl FnMut([f64; 2]) -> Result<Answer, StabilityError>,
    symmetries: &[Symmetry],
    enough: f64,
) -> Result<Nearest, StabilityError> {
    let mut found = Nearest {
        stands: true,
        bound: f64::INFINITY,
        towards: [1.0, 0.0],
        at_least: 0.0,
        missed: 0.0,
        solved: 0,
    };
    let mut asked: Vec<([f64; 2], f64)> = Vec::new();
    let mut points: Vec<[f64; 2]> = Vec::new();
    let mut axes = vec![[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
    axes.reverse();
    loop {
        let axis = axes.pop();
        let (towards, reached) = match axis {
            Some(axis) => (axis, f64::NEG_INFINITY),
            None => nearest_edge(&points),
        };
        if axis.is_none() {
            found.at_least = reached.clamp(0.0, found.bound);
            let near = if found.solved >= ENOUGH { NEAR } else { SAME };
            if reached >= enough
                || found.bound - reached <= near * found.bound
                || reached >= ACCELERATION_MOST * (1.0 - NEAR)
            {
                return Ok(found);
            }
        }
        let same = |other: &[f64; 2]| other[0] * towards[0] + other[1] * towards[1] > 1.0 - 1e-14;
        let known = asked
            .iter()
            .find(|(other, _)| same(other))
            .map(|(_, bound)| *bound);
        let bound = match known {
            Some(_) if axis.is_some() => continue,
            Some(bound) => bound,
            None => {
                found.solved += 1;
                let Answer::Reaches(Support { point, bound, missed }) = ask(towards)? else {
                    found.stands = false;
                    return Ok(found);
                };
                found.missed = found.missed.max(missed);
                if bound < found.bound {
                    (found.bound, found.towards) = (bound, towards);
                }
                for symmetry in symmetries {
                    asked.push((turned(symmetry, towards), bound));
                    let image = turned(symmetry, point);
                    let apart = |other: &[f64; 2]| (image[0] - other[0]).hypot(image[1] - other[1]) > APART;
                    if points.iter().all(apart) {
                        points.push(image);
                    }
                }
                bound
            }
        };
        if bound <= 0.0 {
            found.stands = false;
            return Ok(found);
        }
        if axis.is_some()
            || bound - reached > SAME * bound && known.is_none() && found.solved < DIRECTIONS_MOST
        {
            continue;
        }
        // an edge of the region, or what rounding leaves of one
        if found.bound - reached <= NEAR * found.bound + SAME {
            return Ok(found);
        }
        return Err(StabilityError::ConicProgramme {
            reason: format!(
                "after {} directions the least acceleration lies between {reached} and {} g",
                found.solved, found.bound
            ),
        });
    }
}

/// Outward normal of the edge of the points' hull that is nearest to rest, and how far it is; negative beyond it.
fn nearest_edge(points: &[[f64; 2]]) -> ([f64; 2], f64) {
    let corners = Polygon::hull(points.to_vec()).corners_m;
    let ends = if corners.is_empty() {
        farthest(points)
    } else {
        corners
    };
    let mut least = ([1.0, 0.0], f64::INFINITY);
    for (a, b) in ends.iter().zip(ends.iter().cycle().skip(1)) {
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        if length > 0.0 {
            let outward = [(b[1] - a[1]) / length, (a[0] - b[0]) / length];
            let distance = outward[0] * a[0] + outward[1] * a[1];
            if distance < least.1 {
                least = (outward, distance);
            }
        }
    }
    least
}

/// The two ends of points on a line.
fn farthest(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let by = |a: &&[f64; 2], b: &&[f64; 2]| (a[0] + a[1] * 1e-3).total_cmp(&(b[0] + b[1] * 1e-3));
    let ends = [points.iter().min_by(by), points.iter().max_by(by)];
    ends.into_iter().flatten().copied().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn least(corners: &[[f64; 2]], generators: &[Symmetry]) -> Nearest {
        let ask = |towards: [f64; 2]| {
            let along = |point: &[f64; 2]| point[0] * towards[0] + point[1] * towards[1];
            let far = corners
                .iter()
                .copied()
                .reduce(|a, b| if along(&b) > along(&a) { b } else { a });
            let point = far.unwrap();
            Ok(Answer::Reaches(Support {
                point,
                bound: along(&point),
                missed: 0.0,
            }))
        };
        nearest(ask, &group(generators), f64::INFINITY).unwrap()
    }

    #[test]
    fn exact_edge_of_a_polygon() {
        // a triangle with an edge 3 x + 4 y = 5 at distance 1 in no direction that is asked first
        let found = least(&[[3.0, -1.0], [-1.0, 2.0], [-4.0, -9.0]], &[]);
        assert!((found.bound - 1.0).abs() < 1e-12 && (found.at_least - 1.0).abs() < 1e-12);
        assert!((found.towards[0] - 0.6).abs() < 1e-12 && (found.towards[1] - 0.8).abs() < 1e-12);
        assert!(found.stands && found.solved < 12, "{found:?}");
    }

    #[test]
    fn exact_rest_outside_or_on_a_line_falls() {
        assert!(!least(&[[3.0, 1.0], [3.0, -1.0], [1.0, 0.0]], &[]).stands);
        assert!(!least(&[[2.0, 2.0], [2.0, -1.0], [-1.0, 2.0], [0.4, 0.4]], &[]).stands);
        assert!(!least(&[[1.0, 1.0], [-1.0, -1.0]], &[]).stands);
    }

    #[test]
    fn holds_symmetries_spare_directions_and_change_nothing() {
        let square = [[0.4, 0.4], [-0.4, 0.4], [-0.4, -0.4], [0.4, -0.4]];
        let mirrors = [[[-1.0, 0.0], [0.0, 1.0]], [[0.0, 1.0], [1.0, 0.0]]];
        assert_eq!(group(&mirrors).len(), 8);
        let (all, few) = (least(&square, &[]), least(&square, &mirrors));
        assert!((all.bound - 0.4).abs() < 1e-12 && (few.bound - 0.4).abs() < 1e-12);
        assert!(few.solved <= 2 && all.solved >= 4, "{few:?} {all:?}");
    }

    #[test]
    fn holds_both_bounds_on_a_disc() {
        let ask = |towards: [f64; 2]| {
            Ok(Answer::Reaches(Support {
                point: towards.map(|part| 0.3 * part),
                bound: 0.3,
                missed: 0.0,
            }))
        };
        let found = nearest(ask, &group(&[]), f64::INFINITY).unwrap();
        assert!(
            found.bound == 0.3 && found.at_least >= 0.98 * 0.3 && found.solved <= 16,
            "{found:?}"
        );
        // known to be above .2 after the axes and little more
        let early = nearest(ask, &group(&[]), 0.2).unwrap();
        assert!(early.solved <= 4 && early.at_least >= 0.2, "{early:?}");
    }
}
