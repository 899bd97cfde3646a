//! Dowels, clamps and side supports.

use super::bodies::{RigidBody, index_of};
use super::forces::Forces;
use crate::structure::stack::{SideSupport, Tie};
use glam::DVec3;

/// A dowel or clamp between two points that coincide in the drawing, one on each of two bodies.
#[derive(Clone, Debug)]
pub(super) struct Link {
    pub(super) lower: usize,
    pub(super) upper: usize,
    pub(super) drawn: DVec3,
    /// Axis, in the axes as drawn.
    pub(super) axis: DVec3,
    pub(super) axial_stiffness: f64,
    pub(super) shear_stiffness: f64,
    tension_strength: f64,
    shear_strength: f64,
    pub(super) broken: bool,
}

impl Link {
    pub(super) fn of(tie: &Tie) -> Self {
        Link {
            lower: index_of(tie.lower),
            upper: tie.upper + 1,
            drawn: tie.position_m.into(),
            axis: DVec3::from(tie.axis).normalize(),
            axial_stiffness: tie.axial_stiffness_n_m,
            shear_stiffness: tie.shear_stiffness_n_m,
            tension_strength: tie.tension_strength_n,
            shear_strength: tie.shear_strength_n,
            broken: false,
        }
    }

    /// Extension between the two points, in the axes of the lower body: along the axis (tension only), and across it.
    fn stretch(&self, bodies: &[RigidBody]) -> (f64, DVec3) {
        let (lower, upper) = (&bodies[self.lower], &bodies[self.upper]);
        let apart = lower.rotation.transpose() * (upper.now(self.drawn) - lower.now(self.drawn));
        let along = apart.dot(self.axis);
        (along.max(0.0), apart - self.axis * along)
    }

    /// Adds the force of the link; returns the energy lost if it breaks now, J.
    pub(super) fn pull(&mut self, bodies: &[RigidBody], forces: &mut Forces) -> f64 {
        if self.broken {
            return 0.0;
        }
        let (along, across) = self.stretch(bodies);
        let (tension, shear) = (self.axial_stiffness * along, across * self.shear_stiffness);
        if tension > self.tension_strength || shear.length() > self.shear_strength {
            self.broken = true;
            return 0.5 * (tension * along + shear.dot(across));
        }
        let (lower, upper) = (&bodies[self.lower], &bodies[self.upper]);
        let (force, at) = self.force(bodies);
        forces.force[self.upper] += force;
        forces.torque[self.upper] += (at - upper.position).cross(force);
        forces.force[self.lower] -= force;
        forces.torque[self.lower] -= (at - lower.position).cross(force);
        0.0
    }

    /// Force of the intact link on the upper body, and its point of application on both bodies, in the axes of the
    /// ground.
    pub(super) fn force(&self, bodies: &[RigidBody]) -> (DVec3, DVec3) {
        let (along, across) = self.stretch(bodies);
        let pull = self.axis * (self.axial_stiffness * along) + across * self.shear_stiffness;
        let (lower, upper) = (&bodies[self.lower], &bodies[self.upper]);
        (lower.rotation * -pull, upper.now(self.drawn))
    }

    pub(super) fn stored(&self, bodies: &[RigidBody]) -> f64 {
        if self.broken {
            return 0.0;
        }
        let (along, across) = self.stretch(bodies);
        0.5 * (self.axial_stiffness * along * along + self.shear_stiffness * across.length_squared())
    }
}

/// A side support of a block, in contact after a gap.
#[derive(Clone, Debug)]
pub(super) struct Prop {
    pub(super) body: usize,
    pub(super) drawn: DVec3,
    pub(super) direction: DVec3,
    pub(super) gap: f64,
    pub(super) stiffness: f64,
}

impl Prop {
    pub(super) fn of(support: &SideSupport) -> Self {
        Prop {
            body: support.block + 1,
            drawn: support.position_m.into(),
            direction: DVec3::from(support.direction).normalize(),
            gap: support.gap_m,
            stiffness: support.stiffness_n_m,
        }
    }

    /// Penetration of its body, m; 0 before contact.
    pub(super) fn depth(&self, body: &RigidBody) -> f64 {
        let moved = body.now(self.drawn) - self.drawn;
        (moved.dot(self.direction) - self.gap).max(0.0)
    }

    /// Adds the force of the support, averaged over a step of `h` seconds as for contacts.
    pub(super) fn push(&self, bodies: &[RigidBody], forces: &mut Forces, h: f64) {
        let body = &bodies[self.body];
        let at = body.now(self.drawn);
        let depth = (at - self.drawn).dot(self.direction) - self.gap;
        let closing = (body.velocity + body.spin.cross(at - body.position)).dot(self.direction);
        let half = 0.5 * h * closing.abs();
        if depth <= -half {
            return;
        }
        let into = (depth + half).min(2.0 * half);
        let mean = if half > 0.0 {
            into * into / (4.0 * half)
        } else {
            0.0
        } + (depth - half).max(0.0);
        let force = self.direction * (-self.stiffness * mean);
        forces.force[self.body] += force;
        forces.torque[self.body] += (at - body.position).cross(force);
    }

    pub(super) fn stored(&self, bodies: &[RigidBody]) -> f64 {
        let depth = self.depth(&bodies[self.body]);
        0.5 * self.stiffness * depth * depth
    }
}
