//! Static forces on moving stones: each force keeps its direction and acts at a fixed point of its
//! stone.

use super::bodies::RigidBody;
use super::forces::Forces;
use crate::structure::stack::StaticLoad;
use glam::DVec3;

/// A static force on a body.
#[derive(Clone, Copy, Debug)]
pub(super) struct DeadLoad {
    pub(super) body: usize,
    pub(super) drawn: DVec3,
    pub(super) force: DVec3,
}

impl DeadLoad {
    pub(super) fn of(load: &StaticLoad) -> Self {
        DeadLoad {
            body: load.block + 1,
            drawn: load.position_m.into(),
            force: load.force_n.into(),
        }
    }

    /// Its torque about the centroid of its body.
    pub(super) fn torque(&self, body: &RigidBody) -> DVec3 {
        (body.now(self.drawn) - body.position).cross(self.force)
    }

    /// Adds its force.
    pub(super) fn push(&self, bodies: &[RigidBody], forces: &mut Forces) {
        forces.force[self.body] += self.force;
        forces.torque[self.body] += self.torque(&bodies[self.body]);
    }

    /// Its potential energy, J; 0 in the position as drawn.
    pub(super) fn stored(&self, bodies: &[RigidBody]) -> f64 {
        -self.force.dot(bodies[self.body].now(self.drawn) - self.drawn)
    }
}
