//! Decides by equilibrium alone whether a stack moves rigidly with the ground. Every stone must stand on exactly one joint, so that
//! the force in each joint is known. The stack holds if some distribution of this force over the contact points satisfies the
//! contact law.

use super::assembly::Assembly;
use super::rigid_bed::{fit_bed, on_bed};
use super::rigid_faces::Face;
use super::rigid_point::{ForceTorque, Part};
use glam::{DMat3, DVec3};

/// Relative tolerance of the force balance; allows for rounding. Our choice.
const BALANCED: f64 = 1e-12;
/// Largest fraction of the friction that may be used; allows for rounding. Our choice.
const FRICTION_PART: f64 = 1.0 - 1e-9;

/// A joint and the mass above it.
#[derive(Clone, Debug)]
struct JointReaction {
    face: Face,
    /// Mass above the joint, kg, and its centroid relative to the joint's origin, m, in the axes of the ground.
    mass: f64,
    arm: DVec3,
    /// 1 if body S is above the joint, −1 if body P is.
    sign: f64,
    from_ground: DMat3,
    bed: [f64; 3],
}

/// A stack at rest on the ground in which each stone stands on one joint.
#[derive(Clone, Debug)]
pub(super) struct AtRest {
    joints: Vec<JointReaction>,
    held: bool,
}

impl AtRest {
    /// The stack with these contact faces; `None` if a stone stands on no joint or on several.
    pub(super) fn of(assembly: &Assembly, faces: &[Face]) -> Option<Self> {
        let bodies = assembly.bodies.len();
        let touches = |face: &&Face| face.points.iter().any(|point| point.part == Part::Near);
        let faces: Vec<&Face> = faces.iter().filter(touches).collect();
        if faces.len() != bodies - 1 {
            return None;
        }
        // from the ground upwards: (body, the face it stands on, the body below)
        let mut found: Vec<(usize, usize, usize)> = Vec::with_capacity(faces.len());
        let mut reached = vec![false; bodies];
        reached[0] = true;
        let mut at = 0;
        let mut from = 0;
        loop {
            for (index, face) in faces.iter().enumerate() {
                let (p, s) = (face.plane_body, face.point_body);
                let next = if p == from { s } else { p };
                if (p == from || s == from) && !reached[next] {
                    reached[next] = true;
                    found.push((next, index, from));
                }
            }
            match found.get(at) {
                Some((body, _, _)) => from = *body,
                None => break,
            }
            at += 1;
        }
        if found.len() != faces.len() {
            return None;
        }
        let mut above: Vec<(f64, DVec3)> = assembly
            .bodies
            .iter()
            .map(|b| (b.mass, b.position * b.mass))
            .collect();
        let mut joints = Vec::with_capacity(found.len());
        for (body, index, below) in found.into_iter().rev() {
            let (mass, moment) = above[body];
            above[below].0 += mass;
            above[below].1 += moment;
            let face = faces[index];
            let origin = face.arms[1] + assembly.bodies[face.point_body].position;
            joints.push(JointReaction {
                face: face.clone(),
                mass,
                arm: moment / mass - origin,
                sign: if face.point_body == body { 1.0 } else { -1.0 },
                from_ground: face.to_ground.transpose(),
                bed: [0.0; 3],
            });
        }
        Some(AtRest { joints, held: false })
    }

    /// Whether the stack stays at rest while a force of `pull`, N/kg, acts on all masses. `false` means that this method cannot
    /// decide.
    pub(super) fn holds(&mut self, pull: DVec3) -> bool {
        self.held = self.joints.iter_mut().all(|joint| joint.holds(pull));
        self.held
    }

    /// The force and torque that each joint must transmit if nothing moves: pair, body of the plane, force and torque on S about the
    /// origin of the plane.
    pub(super) fn carried(&self, pull: DVec3) -> impl Iterator<Item = (usize, usize, ForceTorque)> {
        self.joints
            .iter()
            .map(move |joint| (joint.face.pair, joint.face.plane_body, joint.wrench(pull)))
    }

    /// Result of the last call of [`AtRest::holds`].
    pub(super) fn held(&self) -> bool {
        self.held
    }
}

impl JointReaction {
    /// Force and torque on S about the origin of the plane, in the axes of the plane.
    fn wrench(&self, pull: DVec3) -> ForceTorque {
        let force = pull * (self.mass * self.sign);
        let torque = self.from_ground * self.arm.cross(force);
        let force = self.from_ground * force;
        [force.x, force.y, force.z, torque.x, torque.y, torque.z]
    }

    fn holds(&mut self, pull: DVec3) -> bool {
        let wrench = self.wrench(pull);
        if !fit_bed(&self.face.points, &wrench, &mut self.bed, BALANCED) {
            return false;
        }
        let (mut sum, mut at) = (0.0, [0.0; 2]);
        for point in &self.face.points {
            let p = point.area * on_bed(&self.bed, point);
            sum += p;
            at[0] += p * point.x;
            at[1] += p * point.y;
        }
        let at = at.map(|moment| moment / sum);
        let [force_x, force_y, _, _, _, torque_z] = wrench;
        let twist = torque_z - (at[0] * force_y - at[1] * force_x);
        let shear = [force_x / sum, force_y / sum];
        if twist == 0.0 {
            let size = shear[0].hypot(shear[1]);
            return self
                .face
                .points
                .iter()
                .all(|point| size <= FRICTION_PART * point.friction);
        }
        let mut around = 0.0;
        for point in &self.face.points {
            around += point.area
                * on_bed(&self.bed, point)
                * ((point.x - at[0]).powi(2) + (point.y - at[1]).powi(2));
        }
        let turn = if around > 0.0 {
            twist / around
        } else {
            f64::INFINITY
        };
        self.face.points.iter().all(|point| {
            let part = [
                shear[0] - turn * (point.y - at[1]),
                shear[1] + turn * (point.x - at[0]),
            ];
            on_bed(&self.bed, point) == 0.0 || part[0].hypot(part[1]) <= FRICTION_PART * point.friction
        })
    }
}
