//! Which faces of two bodies meet, and the patch on which they do.
//!
//! The patch lies in the plane of one body, P, and its points belong to a face of the other, S: the face clipped by P's.
//! It is clipped again when S has shifted on P, and other faces, or two edges, are chosen when others lie nearer.

use super::bodies::RigidBody;
use super::contact_points::{ContactPoint, ContactRule, contact_points};
use super::patch::{LANES, Law, Motion, Patch, Points};
use crate::structure::stack::{Joint, Polygon, Solid};
use glam::{DMat3, DVec3};

/// A pair of edges must lie this much farther apart than any face from the other body, in parts of the smaller body, to be
/// the contact: faces carry better. Chosen here.
const EDGE_FAVOUR: f64 = 0.01;
/// Another face of S must be this much more opposite to P's to take over, as cosine. Chosen here.
const OPPOSITE_FAVOUR: f64 = 0.02;
/// Sine of the angle below which two edges count as parallel. Chosen here.
const EDGES_PARALLEL: f64 = 0.05;
/// A patch that lacks less than this part of S's face is all of it: rounding. Chosen here.
const WHOLE: f64 = 1e-9;
/// Area of an edge that crosses an edge, in parts of the smaller body's radius squared. Chosen here: a corner point of a
/// face has a similar share.
const EDGE_AREA: f64 = 0.02;

/// Convex hull of a body: corners from its centroid in the axes as drawn, faces, their outward normals.
#[derive(Clone, Debug)]
pub(super) struct Hull {
    pub(super) corners: Vec<DVec3>,
    faces: Vec<Vec<usize>>,
    normals: Vec<DVec3>,
    edges: Vec<[usize; 2]>,
}

/// One of two bodies that may touch; the ground has no hull and is always the first.
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

    fn polygon(&self, face: usize) -> Vec<DVec3> {
        self.faces[face]
            .iter()
            .map(|&corner| self.corners[corner])
            .collect()
    }

    /// The face whose normal is nearest to a direction.
    pub(super) fn facing(&self, direction: DVec3) -> usize {
        let mut best = 0;
        for face in 1..self.normals.len() {
            if self.normals[face].dot(direction) > self.normals[best].dot(direction) {
                best = face;
            }
        }
        best
    }

    /// Area of its largest face, m².
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

/// The outlines of a patch, to clip it again.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    /// The axis along which it was found.
    axis: Axis,
    /// Index of S's face.
    opposite: usize,
    /// Face of S in the frame of its points; empty where two edges cross.
    points_face: Polygon,
    /// Face of P in the frame of its plane; empty for the ground, which has no edge.
    plane_face: Polygon,
    /// Its extent, m.
    size: f64,
    /// Whether the patch is all of S's face.
    whole: bool,
    /// Place and turn of S on P when it was clipped.
    clipped_at: Motion,
}

/// An axis that separates two bodies best.
#[derive(Clone, Copy, Debug)]
pub(super) struct Separation {
    /// Distance along the axis, m; negative if they overlap.
    pub(super) distance: f64,
    /// Axis from the first body to the second, in the ground's frame.
    normal: DVec3,
    axis: Axis,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Axis {
    FaceOfFirst(usize),
    FaceOfSecond(usize),
    Edges([usize; 2], [usize; 2]),
}

/// Right-handed axes as columns, the last along `normal`.
pub(super) fn frame(normal: DVec3) -> DMat3 {
    let near = if normal.x.abs() < 0.9 { DVec3::X } else { DVec3::Y };
    let first = (near - normal * normal.dot(near)).normalize();
    DMat3::from_cols(first, normal.cross(first), normal)
}

/// Corners in a plane's frame, counterclockwise.
fn flat(corners: &[DVec3], origin: DVec3, axes: &DMat3) -> Polygon {
    let seen = corners.iter().map(|corner| {
        let from = *corner - origin;
        [from.dot(axes.x_axis), from.dot(axes.y_axis)]
    });
    counterclockwise(seen.collect())
}

fn counterclockwise(mut corners_m: Vec<[f64; 2]>) -> Polygon {
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

/// How far two bodies are apart, and along which axis.
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
    for edge_1 in &hull_1.edges {
        let along_1 = corners_1[edge_1[1]] - corners_1[edge_1[0]];
        for edge_2 in &hull_2.edges {
            let along_2 = corners_2[edge_2[1]] - corners_2[edge_2[0]];
            let across = along_1.cross(along_2);
            let length = across.length();
            if length < EDGES_PARALLEL * along_1.length() * along_2.length() {
                continue; // a face's axis says the same
            }
            let axis = across * (across.dot(between).signum() / length);
            let highest_1 = -lowest(&corners_1, -axis);
            offer(
                lowest(&corners_2, axis) - highest_1,
                axis,
                Axis::Edges(*edge_1, *edge_2),
                favour,
            );
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

    /// Outward normal of a face, in the ground's frame.
    fn outward(&self, face: usize) -> DVec3 {
        self.hull
            .map_or(DVec3::Z, |hull| self.body.rotation * hull.normals[face])
    }

    /// Distance of another body from the plane of a face, m.
    fn distance_to(&self, face: usize, other: &Side<'_>) -> f64 {
        let outward = self.outward(face);
        let corner = self
            .hull
            .map_or(DVec3::ZERO, |hull| hull.corners[hull.faces[face][0]]);
        let plane = (self.body.position + self.body.rotation * corner).dot(outward);
        lowest(&other.corners(), outward) - plane
    }

    /// A direction of the ground's frame in this body's axes.
    fn inward(&self, direction: DVec3) -> DVec3 {
        self.body.rotation.transpose() * direction
    }
}

/// The patch along an axis, without points yet where faces meet; `None` only if the first body is no ground and has no
/// hull.
pub(super) fn patch_along(
    first: Side<'_>,
    second: Side<'_>,
    separation: &Separation,
    law: Law,
) -> Option<(Patch, Outline)> {
    match separation.axis {
        Axis::FaceOfFirst(face) => faces_patch(first, face, second, separation, law),
        Axis::FaceOfSecond(face) => faces_patch(second, face, first, separation, law),
        Axis::Edges(edge_1, edge_2) => edges_patch((first, edge_1), (second, edge_2), separation, law),
    }
}

/// A face of `plane` and the face of `points` most opposite to it.
fn faces_patch(
    plane: Side<'_>,
    face: usize,
    points: Side<'_>,
    separation: &Separation,
    law: Law,
) -> Option<(Patch, Outline)> {
    let points_hull = points.hull?;
    let opposite = points_hull.facing(points.inward(-plane.outward(face)));
    let (plane_origin, plane_axes, plane_face) = match plane.hull {
        Some(hull) => {
            let origin = hull.corners[hull.faces[face][0]];
            let axes = frame(hull.normals[face]);
            (origin, axes, flat(&hull.polygon(face), origin, &axes))
        }
        None => (DVec3::ZERO, DMat3::IDENTITY, Polygon::default()),
    };
    let point_origin = points_hull.corners[points_hull.faces[opposite][0]];
    // the points' axes are as near to the plane's as their own face allows
    let near = points.body.rotation.transpose() * (plane.body.rotation * plane_axes);
    let inward = -points_hull.normals[opposite];
    let first_axis = (near.x_axis - inward * inward.dot(near.x_axis)).normalize();
    let point_axes = DMat3::from_cols(first_axis, inward.cross(first_axis), inward);
    let patch = Patch {
        plane_body: plane.index,
        point_body: points.index,
        plane_origin,
        plane_axes,
        point_origin,
        point_axes,
        law,
        points: Vec::new(),
        touching: law.area,
    };
    let outline = Outline {
        axis: separation.axis,
        opposite,
        points_face: flat(&points_hull.polygon(opposite), point_origin, &point_axes),
        plane_face,
        size: points.body.radius,
        whole: false,
        clipped_at: patch.motion_between(plane.body, points.body),
    };
    Some((patch, outline))
}

/// Two edges that cross: one point of the second on a plane through the first.
fn edges_patch(
    first: (Side<'_>, [usize; 2]),
    second: (Side<'_>, [usize; 2]),
    separation: &Separation,
    law: Law,
) -> Option<(Patch, Outline)> {
    let ends = |(side, edge): (Side<'_>, [usize; 2])| {
        let hull = side.hull?;
        Some(edge.map(|corner| side.body.position + side.body.rotation * hull.corners[corner]))
    };
    let ([a, b], [c, d]) = (ends(first)?, ends(second)?);
    let (on_first, on_second) = nearest_points([a, b], [c, d]);
    let axes = frame(separation.normal);
    let (plane, points) = (first.0, second.0);
    let mut patch = Patch {
        plane_body: plane.index,
        point_body: points.index,
        plane_origin: plane.inward(on_first - plane.body.position),
        plane_axes: plane.body.rotation.transpose() * axes,
        point_origin: points.inward(on_second - points.body.position),
        point_axes: points.body.rotation.transpose() * axes,
        law,
        points: Vec::new(),
        touching: law.area,
    };
    let radius = plane.body.radius.min(points.body.radius);
    let point = ContactPoint {
        place_m: [0.0, 0.0],
        area_m2: EDGE_AREA * radius * radius,
    };
    let motion = patch.motion_between(plane.body, points.body);
    patch.points = grouped(&[point], &law);
    patch.unstretch(&motion);
    let outline = Outline {
        axis: separation.axis,
        opposite: 0,
        points_face: Polygon::default(),
        plane_face: Polygon::default(),
        size: points.body.radius,
        whole: false,
        clipped_at: motion,
    };
    Some((patch, outline))
}

/// The nearest points of two segments, taken as lines and kept within their ends.
fn nearest_points(first: [DVec3; 2], second: [DVec3; 2]) -> (DVec3, DVec3) {
    let (u, v) = (first[1] - first[0], second[1] - second[0]);
    let from = first[0] - second[0];
    let (a, b, c) = (u.length_squared(), u.dot(v), v.length_squared());
    let (d, e) = (u.dot(from), v.dot(from));
    let s = ((b * e - c * d) / (a * c - b * b)).clamp(0.0, 1.0);
    let t = ((b * s + e) / c).clamp(0.0, 1.0);
    (first[0] + u * s, second[0] + v * t)
}

/// Points in groups of [`LANES`], padded with points of no area.
pub(super) fn grouped(points: &[ContactPoint], law: &Law) -> Vec<Points> {
    let bond = if law.cohesion > 0.0 || law.tension > 0.0 {
        1.0
    } else {
        0.0
    };
    let groups = points.chunks(LANES).map(|chunk| {
        let mut group = Points {
            friction: [law.friction_static; LANES],
            bond: [bond; LANES],
            ..Points::default()
        };
        for (lane, point) in chunk.iter().enumerate() {
            (group.x[lane], group.y[lane]) = (point.place_m[0], point.place_m[1]);
            group.area[lane] = point.area_m2;
            group.give[lane] = 1.0 / (point.area_m2 * law.shear_stiffness);
        }
        group
    });
    groups.collect()
}

impl Outline {
    /// Whether two edges cross here.
    pub(super) fn of_edges(&self) -> bool {
        self.points_face.corners_m.is_empty()
    }

    /// Whether the points' frame has shifted on the plane by more than `shift` m since the patch was clipped, or its normal
    /// has turned by more than `lean`, as sine.
    pub(super) fn has_drifted(&self, motion: &Motion, shift: f64, lean: f64) -> bool {
        let (now, then) = (motion, &self.clipped_at);
        let moved = (now.shift - then.shift).abs();
        let turned = (now.along_x.y - then.along_x.y).abs() * self.size;
        let leaned = (now.along_x.z - then.along_x.z)
            .abs()
            .max((now.along_y.z - then.along_y.z).abs());
        moved.x.max(moved.y) + turned > shift || leaned > lean
    }

    /// Sine of the angle between the two faces, about.
    pub(super) fn lean(&self, motion: &Motion) -> f64 {
        motion.along_x.z.hypot(motion.along_y.z)
    }

    /// Whether the present faces are as good as the best axis, but for less than `favour`, m.
    pub(super) fn still_serves(
        &self,
        best: &Separation,
        first: Side<'_>,
        second: Side<'_>,
        favour: f64,
    ) -> bool {
        let (distance, plane, points, face) = match self.axis {
            Axis::FaceOfFirst(face) => (first.distance_to(face, &second), first, second, face),
            Axis::FaceOfSecond(face) => (second.distance_to(face, &first), second, first, face),
            Axis::Edges(..) => return false,
        };
        if best.distance > distance + favour {
            return false;
        }
        let Some(hull) = points.hull else {
            return false;
        };
        let down = points.inward(-plane.outward(face));
        let now = hull.facing(down);
        hull.normals[now].dot(down) <= hull.normals[self.opposite].dot(down) + OPPOSITE_FAVOUR
    }

    /// Clips the patch where its bodies now are. Keeps its points if it was and is the whole face of S; else new points
    /// take over the stretch and bond of the nearest old one.
    pub(super) fn clip(&mut self, patch: &mut Patch, motion: &Motion, rule: ContactRule) {
        if self.of_edges() {
            return;
        }
        self.clipped_at = *motion;
        let seen = self.points_face.corners_m.iter().map(|&[x, y]| {
            let at = motion.at(x, y);
            [at.x, at.y]
        });
        let face = counterclockwise(seen.collect());
        let (clipped, whole) = if self.plane_face.corners_m.is_empty() {
            (face, true)
        } else {
            let clipped = face.clipped(&self.plane_face);
            let whole = clipped.moments().area_m2 >= (1.0 - WHOLE) * face.moments().area_m2;
            (clipped, whole)
        };
        if whole && self.whole && !patch.points.is_empty() {
            return;
        }
        self.whole = whole;
        let points = match whole {
            true => contact_points(&self.points_face, rule),
            false => self.lifted(contact_points(&clipped, rule), motion),
        };
        let memories = memories_of(patch, motion);
        patch.points = grouped(&points, &patch.law);
        inherit(patch, motion, &memories);
    }

    /// Points of the plane carried along its normal onto the face of S, in the frame of that face.
    fn lifted(&self, points: Vec<ContactPoint>, motion: &Motion) -> Vec<ContactPoint> {
        let (a, b) = (motion.along_x, motion.along_y);
        let determinant = a.x * b.y - b.x * a.y;
        let carried = points.into_iter().map(|point| {
            let (x, y) = (
                point.place_m[0] - motion.shift.x,
                point.place_m[1] - motion.shift.y,
            );
            ContactPoint {
                place_m: [
                    (b.y * x - b.x * y) / determinant,
                    (a.x * y - a.y * x) / determinant,
                ],
                area_m2: point.area_m2,
            }
        });
        carried.collect()
    }
}

/// What a point remembers, in the frame of the plane.
#[derive(Clone, Copy, Debug)]
struct Memory {
    place: [f64; 2],
    stretch: [f64; 2],
    friction: f64,
    bond: f64,
}

fn memories_of(patch: &Patch, motion: &Motion) -> Vec<Memory> {
    let mut memories = Vec::with_capacity(LANES * patch.points.len());
    for group in &patch.points {
        for lane in (0..LANES).filter(|&lane| group.area[lane] > 0.0) {
            let at = motion.at(group.x[lane], group.y[lane]);
            memories.push(Memory {
                place: [at.x, at.y],
                stretch: [at.x - group.anchor_x[lane], at.y - group.anchor_y[lane]],
                friction: group.friction[lane],
                bond: group.bond[lane],
            });
        }
    }
    memories
}

/// Gives each point the memory of the nearest; none if there are none.
fn inherit(patch: &mut Patch, motion: &Motion, memories: &[Memory]) {
    patch.unstretch(motion);
    for group in &mut patch.points {
        for lane in 0..LANES {
            let at = motion.at(group.x[lane], group.y[lane]);
            let distance =
                |memory: &Memory| (memory.place[0] - at.x).powi(2) + (memory.place[1] - at.y).powi(2);
            let nearest = memories.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
            if let Some(memory) = nearest {
                group.anchor_x[lane] = at.x - memory.stretch[0];
                group.anchor_y[lane] = at.y - memory.stretch[1];
                group.friction[lane] = memory.friction;
                group.bond[lane] = memory.bond;
            }
        }
    }
}

/// Carries the stretch of a patch over to another of the same two bodies.
pub(super) fn take_over(patch: &mut Patch, motion: &Motion, old: &Patch, old_motion: &Motion) {
    // stretch is of S against P: with the roles exchanged it is the opposite
    let sign = if old.point_body == patch.point_body {
        1.0
    } else {
        -1.0
    };
    let from_old = motion.to_ground.transpose() * old_motion.to_ground;
    let shift = motion.to_ground.transpose() * (old_motion.origin - motion.origin);
    let carried = memories_of(old, old_motion).into_iter().map(|memory| {
        let place = from_old * DVec3::new(memory.place[0], memory.place[1], 0.0) + shift;
        let stretch = from_old * DVec3::new(memory.stretch[0], memory.stretch[1], 0.0) * sign;
        Memory {
            place: [place.x, place.y],
            stretch: [stretch.x, stretch.y],
            ..memory
        }
    });
    let carried: Vec<Memory> = carried.collect();
    inherit(patch, motion, &carried);
}

/// The patch of a joint as drawn: both faces count as lying in its plane. Points belong to the body whose face is less
/// overlapped beyond the patch, so that its corners stay corners as it moves.
pub(super) fn patch_of_joint(
    joint: &Joint,
    lower: Side<'_>,
    upper: Side<'_>,
    rule: ContactRule,
) -> Option<(Patch, Outline)> {
    let axes = DMat3::from_cols_array_2d(&joint.axes);
    let origin = DVec3::from(joint.origin_m);
    let seen = |side: Side<'_>, direction: DVec3, axes: &DMat3| {
        let hull = side.hull?;
        let face = hull.facing(direction);
        Some((face, flat(&hull.polygon(face), origin - side.body.drawn, axes)))
    };
    let normal = axes.z_axis;
    let (upper_face, upper_polygon) = seen(upper, -normal, &axes)?;
    let lower_seen = seen(lower, normal, &axes);
    let upper_area = upper_polygon.moments().area_m2;
    let lower_smaller = lower_seen
        .as_ref()
        .filter(|(_, polygon)| polygon.moments().area_m2 < upper_area);
    // (plane, its face, points, their face, axes with the normal out of the plane's body)
    let (plane, plane_face, points, points_face, axes) = match lower_smaller {
        Some((face, _)) => {
            let turned = DMat3::from_cols(axes.x_axis, -axes.y_axis, -axes.z_axis);
            (upper, Some(upper_face), lower, *face, turned)
        }
        None => (lower, lower_seen.map(|(face, _)| face), upper, upper_face, axes),
    };
    let polygon = |side: Side<'_>, face: Option<usize>| {
        let corners = side.hull.zip(face).map(|(hull, face)| hull.polygon(face));
        corners.map_or_else(Polygon::default, |corners| {
            flat(&corners, origin - side.body.drawn, &axes)
        })
    };
    let inverse_mass = plane.body.inverse_mass + points.body.inverse_mass;
    let law = Law::of(&joint.material, joint.patch.moments().area_m2, inverse_mass);
    let mut patch = Patch {
        plane_body: plane.index,
        point_body: points.index,
        plane_origin: origin - plane.body.drawn,
        plane_axes: axes,
        point_origin: origin - points.body.drawn,
        point_axes: axes,
        law,
        points: Vec::new(),
        touching: law.area,
    };
    let motion = patch.motion_between(plane.body, points.body);
    // bodies are ordered with the ground first, then by index
    let plane_first = plane.index < points.index;
    let mut outline = Outline {
        axis: match plane_first {
            true => Axis::FaceOfFirst(plane_face.unwrap_or(0)),
            false => Axis::FaceOfSecond(plane_face.unwrap_or(0)),
        },
        opposite: points_face,
        points_face: polygon(points, Some(points_face)),
        plane_face: polygon(plane, plane_face),
        size: points.body.radius,
        whole: false,
        clipped_at: motion,
    };
    outline.clip(&mut patch, &motion, rule);
    Some((patch, outline))
}
