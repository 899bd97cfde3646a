//! Stacks with joints that can crush.

use super::Stack;

impl Stack {
    /// Smallest compressive strength of the joints, Pa; `None` if none can crush.
    pub fn least_strength_pa(&self) -> Option<f64> {
        let given = self
            .joints
            .iter()
            .filter_map(|joint| joint.material.compressive_strength_pa);
        given.reduce(f64::min)
    }

    /// The same stack with joints that cannot crush.
    #[must_use]
    pub fn without_strength(mut self) -> Self {
        for joint in &mut self.joints {
            joint.material.compressive_strength_pa = None;
        }
        self
    }
}
