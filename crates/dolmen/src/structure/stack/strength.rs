//! Stacks whose joints crush.

use super::Stack;

impl Stack {
    /// Least compressive strength of its joints, Pa; `None` if none crushes.
    pub fn least_strength_pa(&self) -> Option<f64> {
        let given = self
            .joints
            .iter()
            .filter_map(|joint| joint.material.compressive_strength_pa);
        given.reduce(f64::min)
    }

    /// The same stack with joints that never crush.
    #[must_use]
    pub fn without_strength(mut self) -> Self {
        for joint in &mut self.joints {
            joint.material.compressive_strength_pa = None;
        }
        self
    }
}
