//! Convex hulls of bodies, and the axis along which two bodies are farthest apart.

use super::bodies::RigidBody;
use crate::structure::stack::{Polygon, Solid};
use glam::{DMat3, DVec3};

/// A pair of edges becomes the contact only if its separation exceeds that of every face by this fraction of the size of
/// the smaller body: contact on a face is preferred. Chosen here.
const EDGE_FAVOUR: f64 = 0.01;
/// Sine of the angle below which two edges count as parallel. Chosen here.
const EDGES_PARALLEL: f64 = 0.05;

/// Distance below which two points coincide, relative to the size of the larger body, for rounding. Chosen here.
const SAME_PLACE: f64 = 1e-9;

/// Convex hull of a body: corners relative to its centroid in the axes of the drawing, faces, and their outward normals.
#[derive(Clone, Debug)]
pub(super) struct Hull {
    pub(super) corners: Vec<DVec3>,
    pub(super) faces: Vec<Vec<usize>>,
    pub(super) normals: Vec<DVec3>,
    edges: Vec<[usize; 2]>,
}

/// One of two bodies that may touch. The ground has no hull and is always the first.
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
        for face in &faces {
            for (&start, &end) in face.iter().zip(face.iter().cycle().skip(1)) {
                if start < end {
                    edges.push([start, end]);
                }
            }
        }
        Hull {
            corners: solid
                .vertices_m()
                .iter()
                .map(|v| DVec3::from(*v) - centroid)
                .collect(),
            normals: (0..faces.len()).map(|face| solid.normal(face)).collect(),
            faces,
            edges,
        }
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

    /// Area of the largest face, m².
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
    let mut offer = |distance: f64, normal: DVec3, axis: Axis, favour: f64| {
        if distance > best.distance + favour {
            best = Separation {
                distance,
                normal,
                axis,
            };
        }
    };
    let (Some(hull_1), Some(hull_2)) = (first.hull, second.hull) else {
        offer(lowest(&corners_2, DVec3::Z), DVec3::Z, Axis::FaceOfFirst(0), 0.0);
        return best;
    };
    for (face, normal) in hull_1.normals.iter().enumerate() {
        let axis = first.body.rotation * *normal;
        let plane = corners_1[hull_1.faces[face][0]].dot(axis);
        offer(
            lowest(&corners_2, axis) - plane,
            axis,
            Axis::FaceOfFirst(face),
            0.0,
        );
    }
    for (face, normal) in hull_2.normals.iter().enumerate() {
        let axis = second.body.rotation * *normal;
        let plane = corners_2[hull_2.faces[face][0]].dot(axis);
        offer(
            lowest(&corners_1, axis) - plane,
            -axis,
            Axis::FaceOfSecond(face),
            0.0,
        );
    }
    let between = second.body.position - first.body.position;
    let favour = EDGE_FAVOUR * first.body.radius.min(second.body.radius);
    let same = SAME_PLACE * first.body.radius.max(second.body.radius);
    for edge_1 in &hull_1.edges {
        let along_1 = corners_1[edge_1[1]] - corners_1[edge_1[0]];
        for edge_2 in &hull_2.edges {
            let along_2 = corners_2[edge_2[1]] - corners_2[edge_2[0]];
            let across = along_1.cross(along_2);
            let length = across.length();
            if length < EDGES_PARALLEL * along_1.length() * along_2.length() {
                continue; // the axis of a face is the same
            }
            let axis = across * (across.dot(between).signum() / length);
            let (highest_1, lowest_2) = (-lowest(&corners_1, -axis), lowest(&corners_2, axis));
            // of several parallel edges, take those that face the other body
            if corners_1[edge_1[0]].dot(axis) < highest_1 - same
                || corners_2[edge_2[0]].dot(axis) > lowest_2 + same
            {
                continue;
            }
            offer(lowest_2 - highest_1, axis, Axis::Edges(*edge_1, *edge_2), favour);
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

impl Side<'_> {
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
}
