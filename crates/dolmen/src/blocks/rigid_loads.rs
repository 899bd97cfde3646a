//! Loads of joints that crush under the rigid law.

use super::rigid_run::Run;
use glam::DVec3;

impl Run {
    /// Compares the force in each joint, over the kick at the beginning of a step, with what its bed bears. After an impact, a kick of less than half a
    /// step is left out: it contains the rest of the impact.
    pub(super) fn see_loads(&mut self, time_s: f64, shaking: DVec3) {
        self.assembly.clock_s = time_s;
        if let Some(at_rest) = self.at_rest.as_ref().filter(|of| of.held()) {
            let pull = DVec3::new(0.0, 0.0, self.assembly.gravity) + shaking;
            for (pair, _, force) in at_rest.carried(pull) {
                self.assembly.see_load(pair, &force);
            }
        } else if self.kick_s >= 0.5 * self.h {
            for face in &self.faces {
                let force = face.wrench().map(|impulse| impulse / self.kick_s);
                self.assembly.see_load(face.pair, &force);
            }
        }
    }
}
