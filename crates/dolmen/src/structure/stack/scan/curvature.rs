//! Finds faces that are part of a curved surface: the crown of a boulder is no bed, because it rolls.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | u | `across` | distance of a vertex from the middle of the face along a direction, m; or in any direction |
//! | h | `height` | height of a vertex above the plane of the face, m |
//! | κ | `curvature` | curvature of the face, 1/m; positive if its middle sticks out |

use super::regions::Region;
use super::surface::Surface;
use glam::DVec3;
use std::collections::BTreeSet;

/// Directions of curvature that are tried, besides all directions at once.
const DIRECTIONS: usize = 8;
/// Least improvement of the fit by a curved instead of a plane face: the F value of one additional parameter, with so many trial directions.
const BETTER_LEAST: f64 = 25.0;
/// A face bulges by at least this part of the tolerance of its plane; less is as flat as dressed stone. Our choice.
const BULGE_LEAST: f64 = 1.0 / 3.0;
/// The middle of a face, as a part of its outline: a flat face with rounded edges is curved beyond it only.
const MIDDLE: f64 = 0.7;
/// Ends of the flat part of a face with rounded edges, as parts of its outline, that are tried.
const FLAT_ENDS: [f64; 3] = [0.6, 0.75, 0.9];
/// A face has rounded edges if they fit better than one curvature by this much: twice the logarithm of the likelihood. Our choice.
const LIKELIER: f64 = 6.0;
/// The middle of a curved face has at least this part of its curvature, but for two standard errors.
const MIDDLE_LEAST: f64 = 0.5;
/// With fewer vertices, or a face narrower than so many edges of the mesh, the triangles around the face tell too whether it is curved.
const VERTICES_LEAST: usize = 12;
const EDGES_LEAST: f64 = 5.0;
/// Cosine of 30°, the largest angle across an edge of a curved surface. Our choice.
pub(super) const SMOOTH: f64 = 0.866;

/// A vertex in the plane of its face: two coordinates and the height, m.
type Point = [f64; 3];

/// The radius of curvature of a face that bulges outwards like a curved surface, m; `None` for a bed, whose vertices leave its plane by noise alone
/// but for rounded edges. `tolerance_m` is how flat dressed stone is.
pub(super) fn radius_m(surface: &Surface, region: &Region, tolerance_m: f64) -> Option<f64> {
    let points = points(surface, region);
    let reach = reaches_m(&points);
    let widths = (0..DIRECTIONS).map(|number| reach[number].1 + reach[number + DIRECTIONS].1);
    let narrowest_m = widths.fold(f64::INFINITY, f64::min);
    let is_narrow = points.len() < VERTICES_LEAST || narrowest_m < EDGES_LEAST * surface.edge_m;
    let around = || radius_around_m(surface, region, BULGE_LEAST * tolerance_m);
    if let Some(radius_m) = is_narrow.then(around).flatten() {
        return Some(radius_m);
    }
    let mut best: Option<(Fit, Option<usize>)> = None;
    for direction in std::iter::once(None).chain((0..DIRECTIONS).map(Some)) {
        let Some(fit) = fit(&points, |p| -0.5 * across_m2(p, direction)) else {
            continue;
        };
        if fit.size > 0.0 && best.as_ref().is_none_or(|(most, _)| fit.left < most.left) {
            best = Some((fit, direction));
        }
    }
    let (curved, direction) = best?;
    let far_m2 = points.iter().map(|p| across_m2(p, direction)).fold(0.0, f64::max);
    if curved.better < BETTER_LEAST || 0.5 * curved.size * far_m2 < BULGE_LEAST * tolerance_m {
        return None;
    }
    let middle: Vec<Point> = points
        .iter()
        .filter(|p| outward(p, &reach) <= MIDDLE)
        .copied()
        .collect();
    let flat_middle = fit(&middle, |p| -0.5 * across_m2(p, direction))
        .is_some_and(|inner| inner.size + 2.0 * inner.standard_error < MIDDLE_LEAST * curved.size);
    let rounded_edges = FLAT_ENDS.iter().any(|end| {
        fit(&points, |p| -(outward(p, &reach) - end).max(0.0).powi(2))
            .is_some_and(|edges| points.len() as f64 * (curved.left / edges.left).ln() > LIKELIER)
    });
    (!flat_middle && !rounded_edges).then(|| 1.0 / curved.size)
}

/// The vertices of a face in axes of its plane, from their mean.
fn points(surface: &Surface, region: &Region) -> Vec<Point> {
    let normal = region.plane.normal;
    let along = normal.any_orthonormal_vector();
    let other = normal.cross(along);
    let used: BTreeSet<usize> = region
        .triangles
        .iter()
        .flat_map(|&t| surface.triangles[t])
        .collect();
    let mut points: Vec<Point> = used
        .into_iter()
        .map(|vertex| {
            let at = surface.vertices[vertex];
            [along.dot(at), other.dot(at), region.plane.height_m(at)]
        })
        .collect();
    for axis in 0..2 {
        let mean = points.iter().map(|p| p[axis]).sum::<f64>() / points.len() as f64;
        points.iter_mut().for_each(|p| p[axis] -= mean);
    }
    points
}

/// How far the vertices reach from their mean in each of many directions, m.
fn reaches_m(points: &[Point]) -> Vec<([f64; 2], f64)> {
    let along = |number: usize| {
        let (sin, cos) = (std::f64::consts::PI * number as f64 / DIRECTIONS as f64).sin_cos();
        let reach = points.iter().map(|p| p[0] * cos + p[1] * sin).fold(0.0, f64::max);
        ([cos, sin], reach)
    };
    (0..2 * DIRECTIONS).map(along).collect()
}

/// Place of a vertex between the middle of a face, 0, and its outline, 1.
fn outward(point: &Point, reaches_m: &[([f64; 2], f64)]) -> f64 {
    let part = |(direction, reach): &([f64; 2], f64)| {
        (point[0] * direction[0] + point[1] * direction[1]) / reach.max(f64::MIN_POSITIVE)
    };
    reaches_m.iter().map(part).fold(0.0, f64::max)
}

/// u²: along a direction, or from the middle.
fn across_m2(point: &Point, direction: Option<usize>) -> f64 {
    match direction {
        None => point[0] * point[0] + point[1] * point[1],
        Some(number) => {
            let (sin, cos) = (std::f64::consts::PI * number as f64 / DIRECTIONS as f64).sin_cos();
            (cos * point[0] + sin * point[1]).powi(2)
        }
    }
}

/// The heights of a face as those of a plane and a multiple of one shape.
struct Fit {
    /// The multiple of the shape.
    size: f64,
    standard_error: f64,
    /// Sum of the squares that are left, m².
    left: f64,
    /// F value against the plane alone.
    better: f64,
}

/// Least squares; `None` if the vertices do not tell.
///
/// ```text
/// h = a + b x + c y + size shape(x, y)      for a curved face the shape is −u²/2, and its size is κ
/// ```
fn fit(points: &[Point], shape: impl Fn(&Point) -> f64) -> Option<Fit> {
    if points.len() < 6 {
        return None;
    }
    let column = |of: &dyn Fn(&Point) -> f64| points.iter().map(of).collect::<Vec<f64>>();
    let mut known: Vec<Vec<f64>> = Vec::new();
    for of in [&|_: &Point| 1.0, &|p: &Point| p[0], &|p: &Point| p[1], &shape] as [&dyn Fn(&Point) -> f64; 4]
    {
        let whole = column(of);
        let own = beside(&known, whole.clone());
        if inner(&own, &own) <= 1e-12 * inner(&whole, &whole) {
            return None; // all in a line, or at one distance
        }
        known.push(own);
    }
    let height = column(&|p| p[2]);
    let own = known.pop()?;
    let square = inner(&own, &own);
    let size = inner(&own, &height) / square;
    known.push(own);
    let rest = beside(&known, height);
    let left = inner(&rest, &rest).max(f64::MIN_POSITIVE);
    let mean = left / (points.len() as f64 - 4.0);
    Some(Fit {
        size,
        standard_error: (mean / square).sqrt(),
        left,
        better: size * size * square / mean,
    })
}

/// What is left of values beside orthogonal columns.
fn beside(columns: &[Vec<f64>], mut values: Vec<f64>) -> Vec<f64> {
    for _ in 0..2 {
        for column in columns {
            let part = inner(column, &values) / inner(column, column);
            values.iter_mut().zip(column).for_each(|(v, c)| *v -= part * c);
        }
    }
    values
}

fn inner(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The radius of curvature of a face of few vertices, from the angles to the triangles around it that lie deeper than `deep_m`; `None` if most of
/// its border is an edge.
fn radius_around_m(surface: &Surface, region: &Region, deep_m: f64) -> Option<f64> {
    let own: BTreeSet<usize> = region.triangles.iter().copied().collect();
    let first = |sum: DVec3, t: &usize| sum + surface.centre(*t) * surface.areas[*t].length();
    let middle = region.triangles.iter().fold(DVec3::ZERO, first) / region.area_m2;
    let (mut whole_m, mut smooth_m, mut turned, mut apart_m) = (0.0, 0.0, 0.0, 0.0);
    for &t in &region.triangles {
        let corners = surface.corners(t);
        for (edge, &beyond) in surface.across[t].iter().enumerate() {
            if own.contains(&beyond) {
                continue;
            }
            let length = corners[edge].distance(corners[(edge + 1) % 3]);
            let cosine = surface.areas[beyond].normalize_or_zero().dot(region.plane.normal);
            whole_m += length;
            if cosine >= SMOOTH && region.plane.height_m(surface.centre(beyond)) < -deep_m {
                smooth_m += length;
                turned += length * cosine.min(1.0).acos();
                apart_m += length * surface.centre(beyond).distance(middle);
            }
        }
    }
    (smooth_m > 0.5 * whole_m).then(|| apart_m / turned.max(f64::MIN_POSITIVE))
}

#[cfg(test)]
mod tests {
    use crate::numeric::Random;
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid, Stack, StackError};

    /// A sphere of 1,280 or more triangles, stretched to half-axes, lifted onto a height, its vertices off by noise.
    fn ellipsoid(axes_m: [f64; 3], lift_m: f64, noise_m: f64, divided: usize) -> Solid {
        let unit = |p: [f64; 3]| {
            let length = p.iter().map(|x| x * x).sum::<f64>().sqrt();
            p.map(|x| x / length)
        };
        // an octahedron, each triangle divided into divided² ones
        let mut corners: Vec<[i64; 3]> = Vec::new();
        let mut triangles = Vec::new();
        let n = divided as i64;
        for signs in (0..8).map(|k| [0, 1, 2].map(|axis| 1 - 2 * ((k >> axis) & 1))) {
            let mut number = |a: i64, b: i64| {
                let key = [a * signs[0], b * signs[1], (n - a - b) * signs[2]];
                corners.iter().position(|known| *known == key).unwrap_or_else(|| {
                    corners.push(key);
                    corners.len() - 1
                })
            };
            for (a, b) in (0..n).flat_map(|a| (0..n - a).map(move |b| (a, b))) {
                let mut two = vec![[number(a, b), number(a + 1, b), number(a, b + 1)]];
                if a + b + 2 <= n {
                    two.push([number(a + 1, b), number(a + 1, b + 1), number(a, b + 1)]);
                }
                let is_turned = signs.iter().product::<i64>() < 0;
                triangles.extend(
                    two.into_iter()
                        .map(|[p, q, r]| if is_turned { [p, r, q] } else { [p, q, r] }),
                );
            }
        }
        let mut random = Random::new(3, 0);
        let vertices: Vec<[f64; 3]> = corners
            .iter()
            .map(|key| {
                let on = unit(key.map(|k| k as f64));
                let mut at = [0, 1, 2].map(|axis| axes_m[axis] * on[axis] + noise_m * random.normal());
                at[2] += axes_m[2] + lift_m;
                at
            })
            .collect();
        Solid::mesh(&vertices, &triangles).unwrap()
    }

    fn refused(solids: Vec<Solid>) -> StackError {
        let block = |(number, solid): (usize, Solid)| Block {
            name: format!("stone {number}"),
            solid,
            density_kg_m3: 2600.0,
        };
        let blocks = solids.into_iter().enumerate().map(block).collect();
        Stack::new(blocks, JointMaterial::default(), 9.81).unwrap_err()
    }

    /// The crown of a spheroid with half-axes a and c has the radius a²/c. A face is fitted up to some 3 mm off its plane, where the section is a
    /// little flatter or steeper.
    #[test]
    fn exact_radius_of_the_crowns_of_boulders() {
        for (axes_m, noise_m, divided) in [
            ([0.25, 0.25, 0.15], 0.0, 13),
            ([0.25, 0.25, 0.25], 5e-4, 13),
            ([0.5, 0.5, 0.25], 0.0, 13),
            ([0.5, 0.5, 0.25], 1e-3, 20),
            ([0.4, 0.4, 0.08], 1e-3, 20),
        ] {
            let exact = axes_m[0] * axes_m[1] / axes_m[2];
            let fault = refused(vec![ellipsoid(axes_m, 0.0, noise_m, divided)]);
            let StackError::JointRounded {
                upper,
                rounded,
                radius_m,
                ..
            } = &fault
            else {
                panic!("{fault}")
            };
            assert_eq!((upper.as_str(), rounded.as_str()), ("stone 0", "stone 0"));
            assert!((radius_m / exact - 1.0).abs() < 0.25, "{radius_m} for {exact}");
        }
    }

    #[test]
    fn refuses_a_boulder_on_a_stone_and_a_stone_on_a_boulder() {
        let slab = |z: f64| {
            let place = Placement {
                position_m: [0.0, 0.0, z],
                ..Placement::default()
            };
            Solid::cuboid(0.6, 0.6, 0.3).unwrap().placed(&place)
        };
        for solids in [
            vec![slab(0.0), ellipsoid([0.25, 0.2, 0.15], 0.3, 0.0, 13)],
            vec![slab(-0.0), ellipsoid([0.25, 0.2, 0.15], 0.3, 1e-3, 13), slab(0.6)],
        ] {
            let said = refused(solids).to_string();
            assert!(
                said.contains("'stone 1' rests on a rounded face (radius of curvature 0."),
                "{said}"
            );
        }
    }
}
