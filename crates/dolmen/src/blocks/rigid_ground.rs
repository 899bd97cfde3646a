//! Moving ground in the rigid law: a body so heavy that stones do not change its velocity.

use super::rigid_run::{Run, six};
use super::rigid_solve::Inertia;
use glam::{DMat3, DVec3};

/// Mass of moving ground over that of all stones. Our choice: stones change its velocity by less than a billionth of g ×
/// step.
const HEAVY: f64 = 1e9;

impl Run {
    fn ground_mass(&self) -> f64 {
        HEAVY * self.assembly.bodies.iter().map(|body| body.mass).sum::<f64>()
    }

    /// Adds the moving ground to a solution, with its velocity and a mass so large that the velocity does not change.
    pub(super) fn hold_ground(&mut self) {
        let mass = self.ground_mass();
        for index in self.assembly.stones().end..self.assembly.bodies.len() {
            let velocity = self.assembly.bodies[index].velocity;
            self.inertia[index] = Inertia {
                mass,
                turning: DMat3::from_diagonal(DVec3::splat(mass)),
                radius: 1.0,
            };
            self.momentum[index] = six(velocity * mass, DVec3::ZERO);
            self.velocity[index] = six(velocity, DVec3::ZERO);
        }
    }

    /// Impulse of the stones on moving ground in the solution, N s.
    pub(super) fn push_on_ground(&self, index: usize) -> DVec3 {
        let [x, y, z, ..] = self.velocity[index];
        (DVec3::new(x, y, z) - self.assembly.bodies[index].velocity) * self.ground_mass()
    }
}
