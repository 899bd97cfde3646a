//! Convex hull of points; coplanar facets are merged into one face.
//!
//! Quickhull (Barber, Dobkin & Huhdanpaa 1996) on coordinates rounded to integers, so that the side of a plane is always exact and rounding cannot
//! turn a facet inward.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | q | `GRID` | number of cells over the largest extent | – |
//! | (b − a) × (c − a) · (p − a) | `side` | six times the volume of a tetrahedron, > 0 if p is outside abc | cells³ |

use super::hull_faces::merged;
use super::{Solid, StackError};
use glam::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// Number of cells over the largest extent, 2⁴⁰: a product of three differences then fits in 128 bits. A cell is 1e-12 of the size, far below the
/// precision of any survey.
const GRID: f64 = 1_099_511_627_776.0;

/// Distance from a plane within which corners are in the plane, relative to the largest extent. Closer corners are merged, and a thinner solid is
/// flat. For a stone of one metre this is a micrometre. Our choice.
pub(super) const FLAT: f64 = 1e-6;

/// Possible units of rounded coordinates, m; coordinates that are all multiples of a unit are not more accurate than it. Our choice: surveys and
/// drawings give 1 mm to 0.01 mm.
const UNITS_M: [f64; 3] = [1e-3, 1e-4, 1e-5];
/// Largest distance by which merging flattens a face, relative to the largest extent. Our choice: 5 mm for a stone of one metre.
const FLATTENED_MOST: f64 = 0.005;

type Cell = [i64; 3];

/// A triangle of the growing hull.
struct Facet {
    corners: [usize; 3],
    /// The adjacent facet at the edge from corner i to the next.
    beyond: [usize; 3],
    /// Points outside this facet.
    outside: Vec<usize>,
    alive: bool,
}

impl Solid {
    /// The convex hull of points, of uniform density.
    ///
    /// Corners within 1e-6 of the largest extent from a plane share one face, and closer corners are merged: eight points of a box with errors of a
    /// nanometre give six faces. If all coordinates are multiples of 1, 0.1 or 0.01 mm they are assumed to be rounded: corners then share a face if
    /// the fitted plane is within that unit of each (and within 0.005 of the largest extent).
    ///
    /// # Errors
    /// [`StackError::Position`] for a point that is not finite, [`StackError::Points`] for fewer than four, [`StackError::Flat`] if all are in a
    /// plane or on a line within 1e-6 of the largest extent.
    ///
    /// # Limits
    /// Faces are flat within 1e-6 of the largest extent, or within the rounding of the points. Points that are not corners of the hull are dropped.
    ///
    /// # Source
    /// C. B. Barber, D. P. Dobkin, H. Huhdanpaa (1996), ACM Transactions on Mathematical Software 22, 469–483.
    /// Differs from the source: exact sides of rounded points in place of thick facets.
    ///
    /// # Example
    /// ```
    /// use dolmen::structure::stack::Solid;
    /// let corners = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.], [0.1, 0.1, 0.1]];
    /// let tetrahedron = Solid::convex(&corners)?;
    /// assert_eq!((tetrahedron.vertices_m().len(), tetrahedron.faces().len()), (4, 4));
    /// assert!((tetrahedron.volume_m3() - 1.0 / 6.0).abs() < 1e-15);
    /// # Ok::<(), dolmen::structure::stack::StackError>(())
    /// ```
    pub fn convex(points_m: &[[f64; 3]]) -> Result<Self, StackError> {
        Solid::convex_of(points_m, rounding_m(points_m))
    }

    /// The convex hull, with faces flat within `rounding_m` or 1e-6 of the largest extent, whichever is larger.
    pub(super) fn convex_of(points_m: &[[f64; 3]], rounding_m: f64) -> Result<Self, StackError> {
        for &given in points_m {
            if !given.iter().all(|value| value.is_finite()) {
                let quantity = "a point of a convex hull";
                return Err(StackError::Position { quantity, given });
            }
        }
        if points_m.len() < 4 {
            return Err(StackError::Points {
                given: points_m.len(),
            });
        }
        let points: Vec<DVec3> = points_m.iter().copied().map(DVec3::from).collect();
        let low = points.iter().copied().reduce(DVec3::min).unwrap_or_default();
        let high = points.iter().copied().reduce(DVec3::max).unwrap_or_default();
        let size = (high - low).max_element();
        let near = FLAT * size;
        let hull = Hull::of(&points, low, size)?;
        // merge corners closer than the tolerance; the hull of the remaining corners is exact again
        let kept = apart(&points, hull.corners(), near);
        let points: Vec<DVec3> = kept.into_iter().map(|i| points[i]).collect();
        let hull = Hull::of(&points, low, size)?;
        let triangles = hull.triangles();
        let flat = near.max(rounding_m.min(FLATTENED_MOST * size));
        let faces = merged(&points, &triangles, flat, near);
        let faces = faces.unwrap_or_else(|| triangles.iter().map(|t| t.to_vec()).collect());
        Ok(with_used_corners(&points, &faces))
    }
}

/// The largest unit of which all coordinates are multiples, m; 0 if they have more digits.
fn rounding_m(points_m: &[[f64; 3]]) -> f64 {
    const ROUND_OFF: f64 = 1e-6;
    let whole = |unit: &&f64| {
        let cells = points_m.iter().flatten().map(|value| value / **unit);
        cells
            .into_iter()
            .all(|cell| (cell - cell.round()).abs() <= ROUND_OFF)
    };
    UNITS_M.iter().find(whole).copied().unwrap_or_default()
}

/// Corners in the order of x, without those close to an earlier one.
fn apart(points: &[DVec3], mut corners: Vec<usize>, near: f64) -> Vec<usize> {
    corners.sort_by(|&a, &b| points[a].x.total_cmp(&points[b].x).then(a.cmp(&b)));
    let mut kept: Vec<usize> = Vec::with_capacity(corners.len());
    for corner in corners {
        let close = kept
            .iter()
            .rev()
            .take_while(|&&k| points[corner].x - points[k].x <= near);
        if close
            .into_iter()
            .all(|&k| points[corner].distance(points[k]) > near)
        {
            kept.push(corner);
        }
    }
    kept
}

/// The solid with these faces; its corners are numbered in the order of the points.
fn with_used_corners(points: &[DVec3], faces: &[Vec<usize>]) -> Solid {
    let used: BTreeSet<usize> = faces.iter().flatten().copied().collect();
    let numbers: BTreeMap<usize, usize> = used.iter().enumerate().map(|(new, &old)| (old, new)).collect();
    let renumbered = faces
        .iter()
        .map(|face| face.iter().map(|corner| numbers[corner]).collect());
    Solid::of_faces(
        used.iter().map(|&i| points[i].into()).collect(),
        renumbered.collect(),
    )
}

struct Hull {
    cells: Vec<Cell>,
    facets: Vec<Facet>,
}

impl Hull {
    fn of(points: &[DVec3], low: DVec3, size: f64) -> Result<Self, StackError> {
        let start = first_tetrahedron(points, FLAT * size).ok_or(StackError::Flat {
            size_m: size,
            allowed_m: FLAT * size,
        })?;
        let cell = |p: &DVec3| ((*p - low) * (GRID / size)).round().to_array().map(|v| v as i64);
        let cells: Vec<Cell> = points.iter().map(cell).collect();
        let mut hull = Hull {
            cells,
            facets: Vec::new(),
        };
        let [a, mut b, mut c, d] = start;
        if hull.side([a, b, c], d) > 0 {
            std::mem::swap(&mut b, &mut c);
        }
        // facet i is opposite corner i of [a, b, c, d]
        for (corners, beyond) in [
            ([b, d, c], [2, 1, 3]),
            ([a, c, d], [3, 0, 2]),
            ([a, d, b], [1, 0, 3]),
            ([a, b, c], [2, 0, 1]),
        ] {
            hull.facets.push(Facet {
                corners,
                beyond,
                outside: Vec::new(),
                alive: true,
            });
        }
        hull.share_out((0..points.len()).collect(), 0);
        let mut next = 0;
        while next < hull.facets.len() {
            if hull.facets[next].alive && !hull.facets[next].outside.is_empty() {
                hull.grow(next);
            }
            next += 1;
        }
        Ok(hull)
    }

    /// Six times the volume of the tetrahedron; positive if `p` is outside the facet.
    fn side(&self, [a, b, c]: [usize; 3], p: usize) -> i128 {
        let from = |i: usize| {
            let (to, at) = (self.cells[i], self.cells[a]);
            [0, 1, 2].map(|axis| i128::from(to[axis] - at[axis]))
        };
        let (b, c, p) = (from(b), from(c), from(p));
        p[0] * (b[1] * c[2] - b[2] * c[1])
            + p[1] * (b[2] * c[0] - b[0] * c[2])
            + p[2] * (b[0] * c[1] - b[1] * c[0])
    }

    /// Assigns each point to the first facet, from `from` on, that has the point outside.
    fn share_out(&mut self, points: Vec<usize>, from: usize) {
        for point in points {
            let sees = |facet: &usize| self.side(self.facets[*facet].corners, point) > 0;
            if let Some(facet) = (from..self.facets.len()).find(sees) {
                self.facets[facet].outside.push(point);
            }
        }
    }

    /// Replaces all facets visible from the farthest point of a facet by a cone from this point to the horizon.
    fn grow(&mut self, start: usize) {
        let corners = self.facets[start].corners;
        let farthest = self.facets[start].outside.iter().copied();
        let Some(apex) = farthest.max_by_key(|&p| (self.side(corners, p), std::cmp::Reverse(p))) else {
            return;
        };
        self.facets[start].alive = false;
        let (mut visible, mut at) = (vec![start], 0);
        let mut horizon = BTreeMap::new(); // first corner of each edge -> second corner, facet beyond
        while at < visible.len() {
            let facet = visible[at];
            at += 1;
            for edge in 0..3 {
                let beyond = self.facets[facet].beyond[edge];
                if !self.facets[beyond].alive {
                    continue;
                }
                if self.side(self.facets[beyond].corners, apex) > 0 {
                    self.facets[beyond].alive = false;
                    visible.push(beyond);
                }
            }
        }
        for &facet in &visible {
            for edge in 0..3 {
                let beyond = self.facets[facet].beyond[edge];
                if self.facets[beyond].alive {
                    let corners = self.facets[facet].corners;
                    horizon.insert(corners[edge], (corners[(edge + 1) % 3], beyond));
                }
            }
        }
        let first_new = self.facets.len();
        let numbers: BTreeMap<usize, usize> = horizon
            .keys()
            .enumerate()
            .map(|(i, &corner)| (corner, first_new + i))
            .collect();
        for (&from, &(to, beyond)) in &horizon {
            let number = numbers[&from];
            let across = &mut self.facets[beyond];
            for edge in 0..3 {
                if across.corners[edge] == to && across.corners[(edge + 1) % 3] == from {
                    across.beyond[edge] = number;
                }
            }
            // the neighbour at from–to is the old facet, at to–apex the next of the cone; at apex–from it is set below
            self.facets.push(Facet {
                corners: [from, to, apex],
                beyond: [beyond, numbers.get(&to).copied().unwrap_or(number), number],
                outside: Vec::new(),
                alive: true,
            });
        }
        for facet in first_new..self.facets.len() {
            let next = self.facets[facet].beyond[1];
            self.facets[next].beyond[2] = facet;
        }
        let orphans = visible
            .iter()
            .flat_map(|&facet| std::mem::take(&mut self.facets[facet].outside));
        let orphans: Vec<usize> = orphans.filter(|&p| p != apex).collect();
        self.share_out(orphans, first_new);
    }

    fn triangles(&self) -> Vec<[usize; 3]> {
        let alive = self.facets.iter().filter(|facet| facet.alive);
        alive.map(|facet| facet.corners).collect()
    }

    fn corners(&self) -> Vec<usize> {
        let all: BTreeSet<usize> = self.triangles().into_iter().flatten().collect();
        all.into_iter().collect()
    }
}

/// Four points that span a body thicker than `thin`.
fn first_tetrahedron(points: &[DVec3], thin: f64) -> Option<[usize; 4]> {
    let farthest = |distance: &dyn Fn(DVec3) -> f64| {
        let all = (0..points.len()).map(|i| (i, distance(points[i])));
        all.max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)))
    };
    let (a, _) = farthest(&|p| -p.x)?;
    let (b, length) = farthest(&|p| p.distance(points[a]))?;
    let along = (points[b] - points[a]).normalize_or_zero();
    let (c, width) = farthest(&|p| (p - points[a]).cross(along).length())?;
    let normal = along.cross(points[c] - points[a]).normalize_or_zero();
    let (d, thickness) = farthest(&|p| (p - points[a]).dot(normal).abs())?;
    (length > 0.0 && width > thin && thickness > thin).then_some([a, b, c, d])
}

#[cfg(test)]
mod tests {
    use super::super::Placement;
    use super::*;
    use proptest::prelude::*;

    fn box_points(noise: f64) -> Vec<[f64; 3]> {
        let wobble = |i: usize| noise * ((i * 7919 % 13) as f64 / 6.0 - 1.0);
        let bit = |i: usize, axis: usize| ((i >> axis) & 1) as f64 * [0.7, 1.1, 0.4][axis];
        (0..8)
            .map(|i| [0, 1, 2].map(|axis| bit(i, axis) + wobble(3 * i + axis)))
            .collect()
    }

    /// Planes through three points with all others on one side, by brute force over all triples.
    fn brute_force_planes(points: &[DVec3]) -> Vec<(DVec3, f64)> {
        let mut planes = Vec::new();
        for i in 0..points.len() {
            for j in 0..points.len() {
                for k in 0..points.len() {
                    if i < j && j != k && i < k {
                        let normal = (points[j] - points[i]).cross(points[k] - points[i]);
                        let height = normal.dot(points[i]);
                        if points.iter().all(|p| normal.dot(*p) <= height + 1e-12) {
                            planes.push((normal, height));
                        }
                    }
                }
            }
        }
        planes
    }

    #[test]
    fn exact_a_box_known_to_a_nanometre_has_six_faces() {
        for noise in [0.0, 1e-9] {
            let mut points = box_points(noise);
            points.push([0.35, 0.55, 0.4]); // in the middle of the top
            points.push([0.35, 0.0, 0.4]); // in the middle of an edge
            points.push([0.0, 1.1, 0.4]); // a corner again
            for yaw_rad in [0.0, 0.3] {
                let place = Placement {
                    yaw_rad,
                    tilt: [0.02, 0.01],
                    position_m: [300.0, -200.0, 5.0],
                };
                let turned = Solid::convex(&box_points(noise)).unwrap().placed(&place);
                assert_eq!(Solid::convex(turned.vertices_m()).unwrap().faces().len(), 6);
            }
            let solid = Solid::convex(&points).unwrap();
            assert_eq!((solid.faces().len(), solid.vertices_m().len()), (6, 8));
            assert!((solid.volume_m3() - 0.7 * 1.1 * 0.4).abs() < 1e-8);
            assert!(solid.faces().iter().all(|face| face.len() == 4));
        }
    }

    /// Boxes and frusta at odd angles, with corners rounded as in surveys: six faces, each with its area.
    #[test]
    fn exact_rounded_corners_of_turned_boxes_have_six_faces() {
        for case in 1..=60_u32 {
            let odd = |k: f64| (f64::from(case) * k).sin();
            let taper = 1.0 - 0.3 * odd(7.3).abs();
            let size = [0.7 + 0.3 * odd(1.1), 0.9 + 0.3 * odd(2.3), 0.5 + 0.2 * odd(3.7)];
            let top = [taper * size[0], taper * size[1]];
            let exact = Solid::frustum([size[0], size[1]], top, size[2]).unwrap();
            let axis = DVec3::new(odd(5.1), odd(6.7), odd(8.9)).normalize();
            let turn = glam::DMat3::from_axis_angle(axis, 3.0 * odd(4.3));
            for unit in [1e-3, 1e-4, 0.0] {
                let rounded = |v: &[f64; 3]| {
                    let turned = (turn * DVec3::from(*v)).to_array();
                    turned.map(|x| if unit > 0.0 { (x / unit).round() * unit } else { x })
                };
                let points: Vec<[f64; 3]> = exact.vertices_m().iter().map(rounded).collect();
                let solid = Solid::convex(&points).unwrap();
                assert_eq!(
                    (solid.faces().len(), solid.vertices_m().len()),
                    (6, 8),
                    "{case} {unit}"
                );
                assert!((solid.volume_m3() / exact.volume_m3() - 1.0).abs() < 1e-9 + 6.0 * unit);
                for face in 0..6 {
                    let normal = turn * exact.normal(face);
                    let nearest = (0..6).map(|f| solid.normal(f).distance(normal));
                    assert!(nearest.fold(f64::INFINITY, f64::min) < 1e-9 + 5.0 * unit);
                }
            }
        }
    }

    /// A chamfer of 5 mm and a plate of 2 mm are not taken for rounding.
    #[test]
    fn holds_chamfers_and_thin_plates_keep_their_faces() {
        let mut chamfered = Vec::new();
        for (x, y) in [(0.0, 0.0), (0.6, 0.0), (0.6, 0.4), (0.0, 0.4)] {
            let inward = |v: f64, most: f64| if v == 0.0 { 0.005 } else { most - 0.005 };
            chamfered.extend([[x, y, 0.0], [x, y, 0.295]]);
            chamfered.push([inward(x, 0.6), inward(y, 0.4), 0.3]);
        }
        assert_eq!(Solid::convex(&chamfered).unwrap().faces().len(), 10);
        let plate = Solid::cuboid(1.0, 0.5, 0.002).unwrap();
        let plate = Solid::convex(plate.vertices_m()).unwrap();
        assert_eq!(plate.faces().len(), 6);
        assert!((plate.volume_m3() - 0.001).abs() < 1e-15);
    }

    #[test]
    fn exact_a_prism_comes_back_from_its_corners() {
        for sides in [3, 8, 32] {
            let prism = Solid::prism_frustum(sides, 1.0, 0.8, 0.5).unwrap();
            let hull = Solid::convex(prism.vertices_m()).unwrap();
            assert_eq!(hull.faces().len(), sides as usize + 2);
            assert!((hull.volume_m3() - prism.volume_m3()).abs() < 1e-14);
        }
    }

    proptest! {
        #[test]
        fn holds_euler_containment_and_brute_force(
            raw in prop::collection::vec([-1.0..1.0_f64, -1.0..1.0, -1.0..1.0], 4..14)
        ) {
            let Ok(solid) = Solid::convex(&raw) else { return Ok(()) };
            let edges: usize = solid.faces().iter().map(Vec::len).sum::<usize>() / 2;
            prop_assert_eq!(solid.vertices_m().len() + solid.faces().len(), edges + 2);
            for face in 0..solid.faces().len() {
                let on = DVec3::from(solid.vertices_m()[solid.faces()[face][0]]);
                let beyond = raw.iter().map(|p| solid.normal(face).dot(DVec3::from(*p) - on));
                prop_assert!(beyond.fold(f64::NEG_INFINITY, f64::max) < 4e-6);
            }
            // every plane through three points with no point outside is a face, and bounds the volume from the centroid
            let points: Vec<DVec3> = raw.iter().copied().map(DVec3::from).collect();
            let centroid = DVec3::from(solid.centroid_m());
            let mut volume = 0.0;
            for (normal, height) in brute_force_planes(&points) {
                volume += (height - normal.dot(centroid)) / 6.0; // twice the triangle's area times its distance
            }
            prop_assert!((volume - solid.volume_m3()).abs() < 1e-4 * solid.volume_m3().max(0.01));
        }

        #[test]
        fn holds_lattices_of_many_coplanar_points(
            raw in prop::collection::vec([0..4_i32, 0..4_i32, 0..4_i32], 4..40)
        ) {
            let points: Vec<[f64; 3]> = raw.iter().map(|p| p.map(f64::from)).collect();
            let Ok(solid) = Solid::convex(&points) else { return Ok(()) };
            let edges: usize = solid.faces().iter().map(Vec::len).sum::<usize>() / 2;
            prop_assert_eq!(solid.vertices_m().len() + solid.faces().len(), edges + 2);
            // no two faces in one plane, every point inside, and six times the volume an integer
            for face in 0..solid.faces().len() {
                let normal = solid.normal(face);
                let on = DVec3::from(solid.vertices_m()[solid.faces()[face][0]]);
                prop_assert!(points.iter().all(|p| normal.dot(DVec3::from(*p) - on) < 1e-9));
                prop_assert!((0..face).all(|other| solid.normal(other).dot(normal) < 1.0 - 1e-6));
            }
            let whole = 6.0 * solid.volume_m3();
            prop_assert!((whole - whole.round()).abs() < 1e-9);
        }
    }

    #[test]
    fn exact_volume_of_many_points_on_a_sphere() {
        // a spiral of 20 000 points: the volume of the hull approaches that of the sphere from below
        let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
        let points: Vec<[f64; 3]> = (0..20_000)
            .map(|i| {
                let z = 1.0 - (2.0 * f64::from(i) + 1.0) / 20_000.0;
                let (r, angle) = ((1.0 - z * z).sqrt(), golden * f64::from(i));
                [r * angle.cos(), r * angle.sin(), z]
            })
            .collect();
        let solid = Solid::convex(&points).unwrap();
        let ball = 4.0 / 3.0 * std::f64::consts::PI;
        assert!(solid.volume_m3() < ball && solid.volume_m3() > ball * (1.0 - 5e-4));
        assert_eq!(solid.vertices_m().len(), 20_000);
    }

    #[test]
    fn refuses_flat_and_few_points() {
        let flat = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [1.0, 1.0, 5e-7],
            [0.3, 0.2, 0.0],
        ];
        assert_eq!(
            Solid::convex(&flat).unwrap_err().to_string(),
            "the points are flat: within 0.000001 m they lie in a plane or on a line 1 m long, and a stone needs a thickness"
        );
        assert!(
            Solid::convex(&flat[..3])
                .unwrap_err()
                .to_string()
                .contains("3 points")
        );
        assert!(Solid::convex(&[[1.0; 3]; 5]).is_err());
        let line: Vec<[f64; 3]> = (0..9).map(|i| [f64::from(i), 0.0, 0.0]).collect();
        assert!(matches!(Solid::convex(&line), Err(StackError::Flat { .. })));
        assert!(matches!(
            Solid::convex(&[[f64::NAN; 3]; 4]),
            Err(StackError::Position { .. })
        ));
    }
}
