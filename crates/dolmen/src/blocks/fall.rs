//! Detects falls of stones, relative to their initial supports and not to the ground.

use super::assembly::Assembly;
use super::bodies::{RigidBody, index_of};
use super::hulls::Hull;
use super::patch::{LANES, Patch};
use super::watch::lower_body;
use crate::structure::stack::{Body, Stack};
use glam::{DMat3, DVec3};

/// Drop of a stone's centroid relative to its support at which it has fallen, as a fraction of its least thickness. Our choice.
const DROP: f64 = 0.5;
/// Cosine of 45°, the rotation of a bed relative to its support at which the stone has fallen.
const TURN_LEAST: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// Time without contact after which a stone counts as fallen, s: in this time it falls several metres. Our choice.
const APART_MOST_S: f64 = 1.0;
/// Time without contact after which a stone of a stack at rest counts as fallen, s; a shorter time is a jump.
const REST_S: f64 = 0.5;
/// Gap up to which two stones are in contact, m. Our choice: ten times that of an open joint.
const TOUCHES_M: f64 = 1e-3;
/// Cosine of 10°, the angle between two faces above which a stone counts as lying on another face. Our choice: beds are within 5° of each other.
const SAME_FACE: f64 = 0.985;

/// Support of a stone at rest.
#[derive(Clone, Debug)]
struct Support {
    body: usize,
    /// Centroid of the stone at rest relative to that of the support, m, in the axes of the support as drawn.
    place: DVec3,
    /// Normal of the joint, from the support into the stone, in the axes as drawn.
    normal: DVec3,
}

#[derive(Clone, Debug)]
struct Stone {
    supports: Vec<Support>,
    /// Drop at which the stone has fallen, m.
    drop: f64,
    /// Whether the ground below one of its supports moves. A stone that still lies on such a support has not fallen, however far it has dropped
    /// relative to its other supports.
    on_moved_ground: bool,
    /// Time from which it has had no contact with a support, s; `None` while it has contact.
    apart_since_s: Option<f64>,
}

impl Stone {
    /// Whether its bed has turned over on one of its supports, or it has dropped too far relative to one support (on moving ground: relative to
    /// all).
    fn has_left(&self, assembly: &Assembly, body: &RigidBody) -> bool {
        let dropped = |of: &Support| of.is_above(assembly, body, self.drop);
        let has_dropped = match self.on_moved_ground {
            true => self.supports.iter().all(dropped),
            false => self.supports.iter().any(dropped),
        };
        has_dropped || self.supports.iter().any(|of| of.is_turned_over(assembly, body))
    }
}

#[derive(Clone, Debug)]
pub(super) struct Falls {
    stones: Vec<Stone>,
}

impl Falls {
    /// Records the supports of all stones at rest.
    pub(super) fn of(stack: &Stack, assembly: &Assembly) -> Self {
        if stack.loose_material().is_some() {
            return Falls { stones: Vec::new() }; // loose stones are judged by their final positions
        }
        let bodies = &assembly.bodies;
        let each = stack.blocks().iter().enumerate().map(|(block, of)| {
            let joints = stack.joints().iter().filter(|joint| joint.upper == block);
            let mut supports: Vec<Support> = joints
                .map(|joint| {
                    let axes = DMat3::from_cols_array_2d(&joint.axes);
                    Support::of(bodies, lower_body(joint, assembly), block + 1, axes.z_axis)
                })
                .collect();
            if supports.is_empty() {
                // supported only by ties or side supports
                supports.push(Support::of(bodies, index_of(Body::Ground), block + 1, DVec3::Z));
            }
            Stone {
                supports,
                drop: DROP * least_thickness(&Hull::of(&of.solid)),
                on_moved_ground: !stack.support_movements().is_empty(),
                apart_since_s: None,
            }
        });
        Falls {
            stones: each.collect(),
        }
    }

    /// The first stone that has fallen, and the time, s. Must be called in order of time.
    pub(super) fn look(&mut self, assembly: &Assembly, time_s: f64) -> Option<(usize, f64)> {
        for (block, stone) in self.stones.iter_mut().enumerate() {
            let body = &assembly.bodies[block + 1];
            if stone.has_left(assembly, body) {
                return Some((block, time_s));
            }
            let touches = |of: &Support| touches(assembly, of.body, block + 1);
            if stone.supports.iter().any(touches) {
                stone.apart_since_s = None;
                continue;
            }
            let since_s = *stone.apart_since_s.get_or_insert(time_s);
            if time_s - since_s > APART_MOST_S {
                return Some((block, since_s));
            }
        }
        None
    }

    /// For a stack that came to rest: a stone that no longer touches its support, or lies on another face, and the time at which this was first
    /// observed, s.
    pub(super) fn at_rest(&self, assembly: &Assembly, time_s: f64) -> Option<(usize, f64)> {
        let fallen = |(block, stone): (usize, &Stone)| {
            if let Some(since_s) = stone.apart_since_s {
                let rests = time_s - since_s >= REST_S;
                return rests.then_some((block, since_s));
            }
            let lies = |of: &Support| lies_on_another_face(assembly, of, block + 1);
            stone.supports.iter().any(lies).then_some((block, time_s))
        };
        self.stones.iter().enumerate().find_map(fallen)
    }
}

impl Support {
    fn of(bodies: &[RigidBody], body: usize, stone: usize, normal: DVec3) -> Self {
        let (support, stone) = (&bodies[body], &bodies[stone]);
        Support {
            body,
            place: support.rotation.transpose() * (stone.position - support.position),
            normal,
        }
    }

    /// Whether a stone has dropped too far relative to one support.
    fn is_above(&self, assembly: &Assembly, stone: &RigidBody, drop: f64) -> bool {
        let support = &assembly.bodies[self.body];
        let place = support.position + support.rotation * self.place;
        place.z - stone.position.z > drop
    }

    /// Whether the bed of a stone has turned over relative to this support.
    fn is_turned_over(&self, assembly: &Assembly, stone: &RigidBody) -> bool {
        let support = &assembly.bodies[self.body];
        let turn = (support.rotation * self.normal).dot(stone.rotation * self.normal);
        turn < TURN_LEAST
    }
}

/// Smallest distance between two parallel planes that enclose a body, m, one of them along a face.
pub(super) fn least_thickness(hull: &Hull) -> f64 {
    let along = |normal: &DVec3| {
        let places = hull.corners.iter().map(|corner| corner.dot(*normal));
        let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| {
            (low.min(place), high.max(place))
        });
        high - low
    };
    hull.normals.iter().map(along).fold(f64::INFINITY, f64::min)
}

/// Whether two bodies are in contact.
fn touches(assembly: &Assembly, first: usize, second: usize) -> bool {
    let Some((patch, _)) = assembly.contact_of(first, second) else {
        return false;
    };
    let motion = patch.motion(&assembly.bodies);
    let gap = |lane: usize, points: &super::patch::Points| motion.at(points.x[lane], points.y[lane]).z;
    let mut points = patch.points.iter();
    points.any(|group| (0..LANES).any(|lane| group.area[lane] > 0.0 && gap(lane, group) < TOUCHES_M))
}

/// Whether a stone rests on a support with a face other than its bed.
fn lies_on_another_face(assembly: &Assembly, support: &Support, stone: usize) -> bool {
    let Some((patch, outline)) = assembly.contact_of(support.body, stone) else {
        return false;
    };
    let inward = face_of(patch, stone);
    !outline.of_edges() && touches(assembly, support.body, stone) && inward.dot(support.normal) < SAME_FACE
}

/// Normal of the face of a body under a patch, into the body, in the axes as drawn.
fn face_of(patch: &Patch, body: usize) -> DVec3 {
    match patch.point_body == body {
        true => patch.point_axes.z_axis,
        false => -patch.plane_axes.z_axis,
    }
}
