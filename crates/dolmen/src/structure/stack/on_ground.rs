//! Blocks on the ground, and movements of the ground below them.

use super::{Body, Stack, StackError, SupportMovement};

impl Stack {
    /// The stack with a movement of the ground below one of its blocks. The movement starts from the drawn position; a check follows it.
    ///
    /// # Errors
    /// [`StackError`] for a block that does not exist or does not stand on the ground, and for a movement that is not finite or has no
    /// length.
    pub fn with_support_movement(mut self, movement: SupportMovement) -> Result<Self, StackError> {
        let last = self.blocks().len() - 1;
        let given = movement.block;
        let Some(block) = self.blocks().get(given) else {
            return Err(StackError::NoBlock { given, last });
        };
        let length_m = movement.length_m();
        if !(length_m > 0.0 && length_m.is_finite()) {
            return Err(StackError::Dimension {
                quantity: "movement_m of a support",
                given: length_m,
                allowed: "a positive number: the length of the movement",
            });
        }
        let on_ground: Vec<usize> = self.on_ground();
        if !on_ground.contains(&given) {
            return Err(StackError::NotOnGround {
                block: block.name.clone(),
                on_ground: on_ground
                    .iter()
                    .map(|&block| self.name(Body::Block(block)).to_owned())
                    .collect(),
            });
        }
        self.support_movements.push(movement);
        Ok(self)
    }

    /// The blocks that stand on the ground, ascending.
    pub fn on_ground(&self) -> Vec<usize> {
        let on_ground = self.joints().iter().filter(|joint| joint.lower == Body::Ground);
        on_ground.map(|joint| joint.upper).collect()
    }

    /// Movements of the ground under single blocks.
    pub fn support_movements(&self) -> &[SupportMovement] {
        &self.support_movements
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Block, JointMaterial, Placement, Solid};
    use super::*;

    #[test]
    fn refuses_movements_of_what_does_not_stand_on_the_ground() {
        let block = |name: &str, z: f64| Block {
            name: name.into(),
            solid: Solid::cuboid(1.0, 1.0, 0.5).unwrap().placed(&Placement {
                position_m: [0.0, 0.0, z],
                ..Placement::default()
            }),
            density_kg_m3: 2600.0,
        };
        let blocks = vec![block("foot", 0.0), block("head", 0.5)];
        let stack = Stack::new(blocks, JointMaterial::default(), 9.81).unwrap();
        let moved = |block: usize, movement_m: [f64; 3]| {
            let movement = SupportMovement { block, movement_m };
            stack.clone().with_support_movement(movement)
        };
        assert_eq!(moved(0, [0.01, 0.0, 0.0]).unwrap().support_movements().len(), 1);
        let fault = moved(1, [0.01, 0.0, 0.0]).unwrap_err().to_string();
        assert!(fault.contains("'head'") && fault.contains("foot"), "{fault}");
        assert!(moved(2, [0.01, 0.0, 0.0]).is_err());
        assert!(moved(0, [0.0; 3]).is_err() && moved(0, [f64::NAN, 0.0, 0.0]).is_err());
    }
}
