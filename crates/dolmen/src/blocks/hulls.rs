//! Convex hulls of bodies, and the axis along which two bodies are farthest apart.

use super::bodies::RigidBody;
use crate::structure::stack::{Polygon, Solid};
use glam::{DMat3, DVec3};
use std::collections::BTreeMap;

/// A pair of edges becomes the contact only if its separation exceeds that of every face by this fraction of the size of the smaller body, so that
/// contact on faces is preferred. Our choice.
const EDGE_FAVOUR: f64 = 0.01;
/// Sine of the angle below which two edges are parallel. Our choice.
const EDGES_PARALLEL: f64 = 0.05;

/// Fraction of the required separation up to which the bound of an edge excludes it; allows for rounding. Our choice.
const NO_EDGE: f64 = 0.9;

/// Distance below which two points coincide, relative to the size of the larger body; allows for rounding. Our choice.
const SAME_PLACE: f64 = 1e-9;

/// Convex hull of a body: corners relative to its centroid in the axes of the drawing, faces, and their outward normals.
#[derive(Clone, Debug)]
pub(super) struct Hull {
    pub(super) corners: Vec<DVec3>,
    pub(super) faces: Vec<Vec<usize>>,
    pub(super) normals: Vec<DVec3>,
    edges: Vec<[usize; 2]>,
    /// The two faces of each edge; `None` if one is missing.
    faces_of_edges: Vec<Option<[usize; 2]>>,
    /// For each face, the sine of the smallest angle to a neighbour.
    turns: Vec<f64>,
}

/// One of two bodies that may touch. The ground has no hull and always comes first.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side<'a> {
    pub(super) index: usize,
    pub(super) hull: Option<&'a Hull>,
    pub(super) body: &'a RigidBody,
}

impl Hull {
    pub(super) fn of(solid: &Solid) -> Self {
        let centroid = DVec3::from(solid.centroid_m());
        let faces = solid.faces().to_vec();
        let mut edges = Vec::new();
        let mut owners: BTreeMap<[usize; 2], usize> = BTreeMap::new();
        for (number, face) in faces.iter().enumerate() {
            for (&start, &end) in face.iter().zip(face.iter().cycle().skip(1)) {
                if start < end {
                    edges.push([start, end]);
                }
                owners.insert([start, end], number);
            }
        }
        let of_edge = |&[a, b]: &[usize; 2]| Some([*owners.get(&[a, b])?, *owners.get(&[b, a])?]);
        let faces_of_edges: Vec<Option<[usize; 2]>> = edges.iter().map(of_edge).collect();
        let normals: Vec<DVec3> = (0..faces.len()).map(|face| solid.normal(face)).collect();
        let mut turns = vec![1.0_f64; faces.len()];
        for &[a, b] in faces_of_edges.iter().flatten() {
            let (a_to_b, is_sharp) = (
                normals[a].cross(normals[b]).length(),
                normals[a].dot(normals[b]) < 0.0,
            );
            for face in [a, b] {
                turns[face] = turns[face].min(if is_sharp { 1.0 } else { a_to_b });
            }
        }
        Hull {
            corners: solid
                .vertices_m()
                .iter()
                .map(|v| DVec3::from(*v) - centroid)
                .collect(),
            normals,
            faces,
            edges,
            faces_of_edges,
            turns,
        }
    }

    /// Sine of the angle between a face and the face in contact above which its neighbours must be considered: a quarter of the angle to the nearest
    /// neighbour.
    pub(super) fn turn_most(&self, face: usize) -> f64 {
        0.25 * self.turns[face]
    }

    pub(super) fn polygon(&self, face: usize) -> Vec<DVec3> {
        self.faces[face]
            .iter()
            .map(|&corner| self.corners[corner])
            .collect()
    }

    /// The face whose normal is closest to a direction.
    pub(super) fn facing(&self, direction: DVec3) -> usize {
        let mut best = 0;
        for face in 1..self.normals.len() {
            if self.normals[face].dot(direction) > self.normals[best].dot(direction) {
                best = face;
            }
        }
        best
    }

    pub(super) fn largest_face(&self) -> f64 {
        let areas = (0..self.faces.len()).map(|face| {
            let axes = frame(self.normals[face]);
            flat(&self.polygon(face), self.corners[self.faces[face][0]], &axes)
                .moments()
                .area_m2
        });
        areas.fold(0.0, f64::max)
    }
}

/// The axis along which two bodies are farthest apart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Separation {
    /// Distance along the axis, m; negative if they overlap.
    pub(super) distance: f64,
    /// Unit vector from the first body to the second, in the axes of the ground.
    pub(super) normal: DVec3,
    pub(super) axis: Axis,
}

impl Separation {
    /// Accepts another axis if the distance along it is larger by more than `favour`.
    fn offer(&mut self, distance: f64, normal: DVec3, axis: Axis, favour: f64) {
        if distance > self.distance + favour {
            *self = Separation {
                distance,
                normal,
                axis,
            };
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Axis {
    FaceOfFirst(usize),
    FaceOfSecond(usize),
    Edges([usize; 2], [usize; 2]),
}

/// Right-handed orthonormal axes as columns, the last along `normal`.
pub(super) fn frame(normal: DVec3) -> DMat3 {
    let near = if normal.x.abs() < 0.9 { DVec3::X } else { DVec3::Y };
    let first = (near - normal * normal.dot(near)).normalize();
    DMat3::from_cols(first, normal.cross(first), normal)
}

/// Corners in the axes of a plane, counterclockwise.
pub(super) fn flat(corners: &[DVec3], origin: DVec3, axes: &DMat3) -> Polygon {
    let seen = corners.iter().map(|corner| {
        let from = *corner - origin;
        [from.dot(axes.x_axis), from.dot(axes.y_axis)]
    });
    counterclockwise(seen.collect())
}

pub(super) fn counterclockwise(mut corners_m: Vec<[f64; 2]>) -> Polygon {
    let doubled: f64 = corners_m
        .iter()
        .zip(corners_m.iter().cycle().skip(1))
        .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
        .sum();
    if doubled < 0.0 {
        corners_m.reverse();
    }
    Polygon { corners_m }
}

/// Largest separation of two bodies over all candidate axes.
pub(super) fn separation(first: Side<'_>, second: Side<'_>) -> Separation {
    let corners_1 = first.corners();
    let corners_2 = second.corners();
    let mut best = Separation {
        distance: f64::NEG_INFINITY,
        normal: DVec3::Z,
        axis: Axis::FaceOfFirst(0),
    };
    let (Some(hull_1), Some(hull_2)) = (first.hull, second.hull) else {
        best.offer(lowest(&corners_2, DVec3::Z), DVec3::Z, Axis::FaceOfFirst(0), 0.0);
        return best;
    };
    for (face, normal) in hull_1.normals.iter().enumerate() {
        let axis = first.body.rotation * *normal;
        let plane = corners_1[hull_1.faces[face][0]].dot(axis);
        best.offer(
            lowest(&corners_2, axis) - plane,
            axis,
            Axis::FaceOfFirst(face),
            0.0,
        );
    }
    for (face, normal) in hull_2.normals.iter().enumerate() {
        let axis = second.body.rotation * *normal;
        let plane = corners_2[hull_2.faces[face][0]].dot(axis);
        best.offer(
            lowest(&corners_1, axis) - plane,
            -axis,
            Axis::FaceOfSecond(face),
            0.0,
        );
    }
    let between = second.body.position - first.body.position;
    let favour = EDGE_FAVOUR * first.body.radius.min(second.body.radius);
    let same = SAME_PLACE * first.body.radius.max(second.body.radius);
    let near_2 = extreme(&corners_2, -best.normal);
    let near_1 = extreme(&corners_1, best.normal);
    let least = best.distance + NO_EDGE * favour;
    let edges_1 = first.edges_below(&corners_1, near_2, least);
    let edges_2 = second.edges_below(&corners_2, near_1, least);
    for edge_1 in &edges_1 {
        let along_1 = corners_1[edge_1[1]] - corners_1[edge_1[0]];
        for edge_2 in &edges_2 {
            let along_2 = corners_2[edge_2[1]] - corners_2[edge_2[0]];
            let across = along_1.cross(along_2);
            let length = across.length();
            if length < EDGES_PARALLEL * along_1.length() * along_2.length() {
                continue; // parallel to the axis of a face
            }
            let axis = across * (across.dot(between).signum() / length);
            let (highest_1, lowest_2) = (-lowest(&corners_1, -axis), lowest(&corners_2, axis));
            // of several parallel edges, take those nearest to the other body
            if corners_1[edge_1[0]].dot(axis) < highest_1 - same
                || corners_2[edge_2[0]].dot(axis) > lowest_2 + same
            {
                continue;
            }
            best.offer(lowest_2 - highest_1, axis, Axis::Edges(*edge_1, *edge_2), favour);
        }
    }
    best
}

fn lowest(corners: &[DVec3], axis: DVec3) -> f64 {
    corners
        .iter()
        .map(|corner| corner.dot(axis))
        .fold(f64::INFINITY, f64::min)
}

/// The corner farthest along an axis.
fn extreme(corners: &[DVec3], axis: DVec3) -> DVec3 {
    let farthest = corners
        .iter()
        .copied()
        .max_by(|a, b| a.dot(axis).total_cmp(&b.dot(axis)));
    farthest.unwrap_or_default()
}

impl Side<'_> {
    /// Edges that may separate the body by at least a given distance from another body, of which one point is given.
    ///
    /// ```text
    /// the axis of an edge lies between the normals of its faces, n = α n_a + β n_b with α, β ≥ 0 and α + β ≤ √(2/(1 + n_a·n_b)), so that
    /// the separation ≤ n · (x − p) = α h_a + β h_b        h: heights of the point x over the two faces
    /// ```
    fn edges_below(&self, corners: &[DVec3], point: DVec3, least: f64) -> Vec<[usize; 2]> {
        let Some(hull) = self.hull else {
            return Vec::new();
        };
        let heights: Vec<f64> = (hull.faces.iter().zip(&hull.normals))
            .map(|(face, normal)| (self.body.rotation * *normal).dot(point - corners[face[0]]))
            .collect();
        let reaches = |&(_, faces): &(&[usize; 2], &Option<[usize; 2]>)| {
            let Some([a, b]) = *faces else {
                return true;
            };
            let height = heights[a].max(heights[b]);
            let cos_half = (0.5 * (1.0 + hull.normals[a].dot(hull.normals[b])))
                .max(0.0)
                .sqrt();
            match height > 0.0 {
                true => height >= least * cos_half,
                false => height >= least,
            }
        };
        let each = hull.edges.iter().zip(&hull.faces_of_edges);
        each.filter(reaches).map(|(edge, _)| *edge).collect()
    }

    fn corners(&self) -> Vec<DVec3> {
        let corners = self.hull.iter().flat_map(|hull| &hull.corners);
        corners
            .map(|corner| self.body.position + self.body.rotation * *corner)
            .collect()
    }

    /// Outward normal of a face, in the axes of the ground.
    pub(super) fn outward(&self, face: usize) -> DVec3 {
        self.hull
            .map_or(DVec3::Z, |hull| self.body.rotation * hull.normals[face])
    }

    /// Distance of another body from the plane of a face, m; negative if it reaches behind the plane.
    pub(super) fn distance_to(&self, face: usize, other: &Side<'_>) -> f64 {
        let outward = self.outward(face);
        let corner = self
            .hull
            .map_or(DVec3::ZERO, |hull| hull.corners[hull.faces[face][0]]);
        let plane = (self.body.position + self.body.rotation * corner).dot(outward);
        lowest(&other.corners(), outward) - plane
    }

    /// Transforms a direction from the axes of the ground to those of this body.
    pub(super) fn inward(&self, direction: DVec3) -> DVec3 {
        self.body.rotation.transpose() * direction
    }
}

#[cfg(test)]
mod tests {
    use super::super::bodies::bodies_of;
    use super::*;
    use crate::structure::stack::{Block, JointMaterial, Placement, Stack};

    #[test]
    fn exact_edges_that_cross_are_those_that_face_each_other() {
        let cube = |name: &str, z: f64| Block {
            name: name.into(),
            solid: Solid::cuboid(0.2, 0.2, 0.2).unwrap().placed(&Placement {
                position_m: [0.0, 0.0, z],
                ..Placement::default()
            }),
            density_kg_m3: 2600.0,
        };
        let stack = Stack::new(
            vec![cube("low", 0.0), cube("high", 0.2)],
            JointMaterial::default(),
            9.81,
        )
        .unwrap();
        let mut bodies = bodies_of(&stack);
        let quarter = std::f64::consts::FRAC_PI_4;
        bodies[1].turn_by(DVec3::X * quarter); // an edge along x on top
        bodies[2].turn_by(DVec3::Y * quarter); // an edge along y beneath
        for gap in [0.01, -0.01] {
            bodies[2].position =
                bodies[1].position + DVec3::new(0.02, 0.03, 2.0 * 0.1 * 2.0_f64.sqrt() + gap);
            let hulls: Vec<Hull> = stack
                .blocks()
                .iter()
                .map(|block| Hull::of(&block.solid))
                .collect();
            let side = |index: usize| Side {
                index,
                hull: Some(&hulls[index - 1]),
                body: &bodies[index],
            };
            let found = separation(side(1), side(2));
            assert!((found.distance - gap).abs() < 1e-12, "{found:?}");
            let Axis::Edges(low, high) = found.axis else {
                panic!("{found:?}")
            };
            for (index, edge, height) in [(1, low, 0.1), (2, high, -0.1)] {
                for corner in edge {
                    let at = bodies[index].rotation * hulls[index - 1].corners[corner];
                    assert!((at.z - height * 2.0_f64.sqrt()).abs() < 1e-12, "{index}: {at}");
                }
            }
        }
    }

    /// The separation of two bodies over every pair of edges, without exclusion.
    fn of_all_edges(first: Side<'_>, second: Side<'_>, of_faces: f64) -> f64 {
        let (corners_1, corners_2) = (first.corners(), second.corners());
        let (Some(hull_1), Some(hull_2)) = (first.hull, second.hull) else {
            return of_faces;
        };
        let between = second.body.position - first.body.position;
        let favour = EDGE_FAVOUR * first.body.radius.min(second.body.radius);
        let mut best = of_faces;
        for [a, b] in &hull_1.edges {
            for [c, d] in &hull_2.edges {
                let (u, v) = (corners_1[*b] - corners_1[*a], corners_2[*d] - corners_2[*c]);
                let across = u.cross(v);
                if across.length() < EDGES_PARALLEL * u.length() * v.length() {
                    continue;
                }
                let axis = across.normalize() * across.dot(between).signum();
                let (high, low) = (-lowest(&corners_1, -axis), lowest(&corners_2, axis));
                let are_outermost =
                    corners_1[*a].dot(axis) > high - 1e-9 && corners_2[*c].dot(axis) < low + 1e-9;
                if are_outermost && low - high > best + favour {
                    best = low - high;
                }
            }
        }
        best
    }

    #[test]
    fn agrees_no_edge_that_separates_is_left_out() {
        let mut state = 7_u64;
        let mut draw = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        let mut with_edges = 0;
        for _ in 0..60 {
            let mut stone = |name: &str, z: f64| {
                let points: Vec<[f64; 3]> = (0..24)
                    .map(|_| {
                        let at = DVec3::new(draw(), draw(), draw()).normalize();
                        [0.3 * at.x, 0.2 * at.y, z + 0.2 * at.z]
                    })
                    .collect();
                Block {
                    name: name.into(),
                    solid: Solid::convex(&points).unwrap(),
                    density_kg_m3: 2600.0,
                }
            };
            let blocks = vec![stone("low", 1.0), stone("high", 2.0)];
            let stack = Stack::loose(blocks, JointMaterial::default(), 9.81).unwrap();
            let mut bodies = bodies_of(&stack);
            for body in &mut bodies[1..] {
                body.turn_by(DVec3::new(draw(), draw(), draw()) * 6.0);
            }
            bodies[2].position = bodies[1].position + DVec3::new(draw(), draw(), draw()).normalize() * 0.42;
            let hulls: Vec<Hull> = (stack.blocks().iter())
                .map(|block| Hull::of(&block.solid))
                .collect();
            let side = |index: usize| Side {
                index,
                hull: Some(&hulls[index - 1]),
                body: &bodies[index],
            };
            let found = separation(side(1), side(2));
            let faces = |one: Side<'_>, other: Side<'_>| {
                let each = (0..one.hull.unwrap().faces.len()).map(|face| one.distance_to(face, &other));
                each.fold(f64::NEG_INFINITY, f64::max)
            };
            let of_faces = faces(side(1), side(2)).max(faces(side(2), side(1)));
            let all = of_all_edges(side(1), side(2), of_faces);
            assert!((found.distance - all).abs() < 1e-12, "{found:?} {all}");
            with_edges += usize::from(matches!(found.axis, Axis::Edges(..)));
        }
        assert!(with_edges > 5, "{with_edges}");
    }
}
