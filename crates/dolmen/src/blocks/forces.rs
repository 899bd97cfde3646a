//! Forces on bodies.

use glam::DVec3;

/// Forces on bodies at one time, and the energy lost in the step.
#[derive(Clone, Debug, Default)]
pub(super) struct Forces {
    pub(super) force: Vec<DVec3>,
    pub(super) torque: Vec<DVec3>,
    pub(super) friction_loss: f64,
}

impl Forces {
    /// Sets the forces on `count` bodies to zero.
    pub(super) fn clear(&mut self, count: usize) {
        self.force.clear();
        self.force.resize(count, DVec3::ZERO);
        self.torque.clear();
        self.torque.resize(count, DVec3::ZERO);
        self.friction_loss = 0.0;
    }
}
