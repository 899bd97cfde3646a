//! Stacks compared at rest, where springs and damping of joints do not matter.

use super::{JointMaterial, Stack};

impl Stack {
    /// The same stack with the default stiffness, damping and restitution in every joint. Stacks that are then equal have the same limits:
    /// they differ only in how they move.
    #[must_use]
    pub fn with_usual_springs(mut self) -> Self {
        let usual = JointMaterial::default();
        let joints = self.joints.iter_mut().map(|joint| &mut joint.material);
        for material in joints.chain(&mut self.loose) {
            *material = JointMaterial {
                normal_stiffness_pa_m: usual.normal_stiffness_pa_m,
                shear_stiffness_pa_m: usual.shear_stiffness_pa_m,
                damping_ratio: usual.damping_ratio,
                normal_restitution: usual.normal_restitution,
                rocking_restitution: usual.rocking_restitution,
                ..*material
            };
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::stack::{Block, Solid};

    #[test]
    fn holds_only_what_acts_at_rest_tells_stacks_apart() {
        let of = |material: JointMaterial| {
            let stone = Block {
                name: "stone".into(),
                solid: Solid::cuboid(0.4, 0.4, 1.0).unwrap(),
                density_kg_m3: 2600.0,
            };
            Stack::new(vec![stone], material, 9.81)
                .unwrap()
                .with_usual_springs()
        };
        let usual = of(JointMaterial::default());
        let softer = JointMaterial {
            normal_stiffness_pa_m: 1e7,
            shear_stiffness_pa_m: 4e6,
            damping_ratio: 0.1,
            normal_restitution: 0.2,
            rocking_restitution: Some(0.9),
            ..JointMaterial::default()
        };
        assert_eq!(of(softer), usual);
        let bonded = JointMaterial {
            cohesion_pa: 1e3,
            ..softer
        };
        assert_ne!(of(bonded), usual);
        assert_ne!(of(JointMaterial::with_friction(0.5)), usual);
    }
}
