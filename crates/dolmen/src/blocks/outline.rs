//! The outlines of a patch: it is clipped again if S has shifted on P, and its points keep their state.

use super::bodies::RigidBody;
use super::contact_points::{ContactPoint, ContactRule, contact_points};
use super::crushing::{Bed, Load};
use super::history::PeakBearing;
use super::hulls::{Axis, Separation, Side, counterclockwise};
use super::patch::{LANES, Law, Motion, Patch, Points};
use crate::structure::stack::Polygon;
use glam::DVec3;

/// Difference of cosines by which another face of S must be more opposite to P's face to replace the current one. Our choice.
const OPPOSITE_FAVOUR: f64 = 0.02;
/// The same, as a fraction of 1 minus the cosine of the angle between the two faces: on a rounded stone, the next face must replace the current one
/// before it penetrates P.
const OPPOSITE_PART: f64 = 0.1;
/// Sine of the angle between two faces above which other faces may be in contact. Our choice.
pub(super) const LOOK_AGAIN: f64 = 0.03;
/// Fraction of S's face that may be missing if the patch counts as the whole face; allows for rounding. Our choice.
const WHOLE: f64 = 1e-9;

/// The force in a joint at one time: the normal force, N, and the moments about the first two axes of the plane at its origin, N m.
#[derive(Clone, Copy, Debug)]
pub(super) struct JointLoad {
    pub(super) normal_n: f64,
    pub(super) about: [f64; 2],
    pub(super) at_s: f64,
}

impl JointLoad {
    pub(super) fn of(normal_n: f64, about: [f64; 2], at_s: f64) -> Self {
        JointLoad {
            normal_n,
            about,
            at_s,
        }
    }
}

/// The outlines of a patch, for clipping it again.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    pub(super) axis: Axis,
    /// Index of S's face.
    pub(super) opposite: usize,
    /// Face of S in the frame of its points; empty for two crossing edges.
    pub(super) points_face: Polygon,
    /// Face of P in the frame of its plane; empty for the ground, which is unbounded.
    pub(super) plane_face: Polygon,
    pub(super) size: f64,
    /// Sine of the angle between the two faces above which other faces may be in contact.
    pub(super) lean_most: f64,
    /// Whether the patch is the whole face of S.
    pub(super) whole: bool,
    /// Pose of S on P when the patch was clipped.
    pub(super) clipped_at: Motion,
    /// The patch in the frame of its points, if its edges crush.
    pub(super) bed: Option<Bed>,
}

/// Points in groups of [`LANES`], padded with points without area.
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
    /// Whether the patch is that of two crossing edges.
    pub(super) fn of_edges(&self) -> bool {
        self.points_face.corners_m.is_empty()
    }

    /// Whether the frame of the points has shifted on the plane by more than `shift` m since the patch was clipped, or its normal has rotated by more
    /// than [`Outline::lean_most`].
    pub(super) fn has_drifted(&self, motion: &Motion, shift: f64) -> bool {
        let (now, then) = (motion, &self.clipped_at);
        let moved = (now.shift - then.shift).abs();
        let turned = (now.along_x.y - then.along_x.y).abs() * self.size;
        let leaned = (now.along_x.z - then.along_x.z)
            .abs()
            .max((now.along_y.z - then.along_y.z).abs());
        moved.x.max(moved.y) + turned > shift || leaned > self.lean_most
    }

    /// Approximate sine of the angle between the two faces.
    pub(super) fn lean(&self, motion: &Motion) -> f64 {
        motion.along_x.z.hypot(motion.along_y.z)
    }

    /// Whether the current faces separate the bodies as well as the best axis, within `favour`, m.
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
        let between = 1.0 - hull.normals[now].dot(hull.normals[self.opposite]);
        let favour = OPPOSITE_FAVOUR.min(OPPOSITE_PART * between);
        hull.normals[now].dot(down) <= hull.normals[self.opposite].dot(down) + favour
    }

    /// Clips the patch at the current positions of its bodies. A patch that was and is the whole face of S keeps its points; otherwise each new point
    /// takes the stretch and bond of the nearest old point.
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
            false => Self::lifted(contact_points(&clipped, rule), motion),
        };
        let points = match patch.law.strength.crushes() {
            true => self.moved_in(points, &clipped, motion, patch.law.strength.strip_m2),
            false => points,
        };
        let memories = memories_of(patch, motion);
        let before = patch.stored(motion);
        patch.points = grouped(&points, &patch.law);
        inherit(patch, motion, &memories);
        if !memories.is_empty() {
            patch.hold_at_most(motion, before);
        }
    }

    /// The points of a patch whose edges crush, moved in; `clipped` is the patch in the plane.
    fn moved_in(
        &mut self,
        points: Vec<ContactPoint>,
        clipped: &Polygon,
        motion: &Motion,
        strip_m2: f64,
    ) -> Vec<ContactPoint> {
        let corners = match self.whole {
            true => self.points_face.corners_m.clone(),
            false => {
                let corners = clipped.corners_m.iter().map(|corner| motion.lifted(*corner));
                corners.collect()
            }
        };
        let bed = Bed::of(corners);
        let points = bed.moved_in(points, strip_m2);
        self.bed = Some(bed);
        points
    }

    /// Raises the peak load of a joint that crushes to the present one, if that is larger.
    pub(super) fn see_load(
        &self,
        patch: &Patch,
        bodies: &[RigidBody],
        now: JointLoad,
        peak: &mut Option<PeakBearing>,
    ) {
        let (
            Some(bed),
            JointLoad {
                normal_n,
                about,
                at_s,
            },
        ) = (&self.bed, now)
        else {
            return;
        };
        if normal_n <= 0.0 {
            return;
        }
        let at = patch
            .motion(bodies)
            .lifted([-about[1] / normal_n, about[0] / normal_n]);
        let strength_pa = patch.law.strength.strength_pa;
        let before = peak.map_or(0.0, |peak| peak.ratio);
        if let Some(bears_n) = bed.exceeded_n(strength_pa, Load { normal_n, at }, before) {
            let place = patch.point_origin + patch.point_axes * DVec3::new(at[0], at[1], 0.0);
            *peak = Some(PeakBearing {
                ratio: normal_n / bears_n,
                at_s,
                force_n: normal_n,
                bears_n,
                place_m: (bodies[patch.point_body].drawn + place).into(),
            });
        }
    }

    /// Points of the plane projected along its normal onto the face of S, in the frame of that face.
    fn lifted(points: Vec<ContactPoint>, motion: &Motion) -> Vec<ContactPoint> {
        let carried = points.into_iter().map(|point| ContactPoint {
            place_m: motion.lifted(point.place_m),
            area_m2: point.area_m2,
        });
        carried.collect()
    }
}

/// State of a point, in the axes of the plane.
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

/// Gives each point the state of the nearest old point; no change without old points.
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

/// Transfers the stretch of a patch to another patch of the same two bodies.
pub(super) fn take_over(patch: &mut Patch, motion: &Motion, old: &Patch, old_motion: &Motion) {
    // stretch is that of S relative to P: exchanged roles change its sign
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
