//! The faces in contact of two bodies, and their contact patch.
//!
//! The patch lies in the plane of a face of one body, P. Its points belong to a face of the other body, S: they are the
//! corners of that face clipped by P's face. If other faces or two edges are nearer, they are chosen.

use super::contact_points::{ContactPoint, ContactRule};
use super::hulls::{Axis, Separation, Side, flat, frame};
use super::outline::{LOOK_AGAIN, Outline, grouped};
use super::patch::{Law, Patch};
use crate::structure::stack::{Joint, Polygon};
use glam::{DMat3, DVec3};

/// Contact area of two crossing edges, over the squared radius of the smaller body. Our choice: a corner point of a face
/// has a similar area.
const EDGE_AREA: f64 = 0.02;

/// The patch along an axis; patches of faces have no points yet. `None` only if the first body is not the ground and has
/// no hull.
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

/// The patch between a face of `plane` and the most opposite face of `points`.
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
    // the axes of the points are as close to those of the plane as their own face allows
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
        holds: false,
    };
    let outline = Outline {
        axis: separation.axis,
        opposite,
        points_face: flat(&points_hull.polygon(opposite), point_origin, &point_axes),
        plane_face,
        size: points.body.radius,
        lean_most: lean_most(&[(plane, Some(face)), (points, Some(opposite))]),
        whole: false,
        clipped_at: patch.motion_between(plane.body, points.body),
        bed: None,
    };
    Some((patch, outline))
}

/// Angle between two faces above which their neighbours may be in contact, as sine; the ground has no neighbours.
fn lean_most(faces: &[(Side<'_>, Option<usize>)]) -> f64 {
    let each = faces
        .iter()
        .filter_map(|(side, face)| Some(side.hull?.turn_most((*face)?)));
    each.fold(LOOK_AGAIN, f64::min)
}

/// The patch of two crossing edges: one point of the second edge, on a plane through the first.
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
        holds: false,
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
        lean_most: LOOK_AGAIN,
        whole: false,
        clipped_at: motion,
        bed: None,
    };
    Some((patch, outline))
}

/// The nearest points of two segments: computed for infinite lines, then limited to the ends.
fn nearest_points(first: [DVec3; 2], second: [DVec3; 2]) -> (DVec3, DVec3) {
    let (u, v) = (first[1] - first[0], second[1] - second[0]);
    let from = first[0] - second[0];
    let (a, b, c) = (u.length_squared(), u.dot(v), v.length_squared());
    let (d, e) = (u.dot(from), v.dot(from));
    let s = ((b * e - c * d) / (a * c - b * b)).clamp(0.0, 1.0);
    let t = ((b * s + e) / c).clamp(0.0, 1.0);
    (first[0] + u * s, second[0] + v * t)
}

/// The patch of a joint as drawn, with both faces in its plane. The points belong to the body whose face extends less
/// beyond the patch, so that its corners remain corners as it moves.
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
        holds: false,
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
        lean_most: lean_most(&[(plane, plane_face), (points, Some(points_face))]),
        whole: false,
        clipped_at: motion,
        bed: None,
    };
    outline.clip(&mut patch, &motion, rule);
    Some((patch, outline))
}
