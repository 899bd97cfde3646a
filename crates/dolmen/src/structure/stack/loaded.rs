//! Stacks with static forces on single stones.

use super::{Stack, StackError, StaticLoad};

/// Largest distance of a load from the bounds of its stone, m, for example at the end of a bracket or a pole. Our choice.
const REACH_M: f64 = 3.0;

impl Stack {
    /// The same stack with a static force on one of its blocks.
    ///
    /// # Errors
    /// [`StackError`] for a block that does not exist, values that are not finite, or a point farther than 3 m from the bounds of the block.
    pub fn with_static_load(mut self, load: StaticLoad) -> Result<Self, StackError> {
        self.check_block(load.block)?;
        for (quantity, given) in [
            ("position_m of a static load", load.position_m),
            ("force_n of a static load", load.force_n),
        ] {
            if !given.iter().all(|value| value.is_finite()) {
                return Err(StackError::Position { quantity, given });
            }
        }
        self.check_near("a static load", load.position_m, (load.block, REACH_M))?;
        self.static_loads.push(load);
        Ok(self)
    }

    /// Whether static loads act on blocks.
    pub fn is_pressed(&self) -> bool {
        self.static_loads.iter().any(|load| load.force_n[2] < 0.0)
    }

    /// Static forces on the blocks.
    pub fn static_loads(&self) -> &[StaticLoad] {
        &self.static_loads
    }

    /// The same stack with those of its static loads that act.
    pub fn with_static_loads(&self, acts: &[bool]) -> Self {
        let mut stack = self.clone();
        let mut each = acts.iter();
        stack
            .static_loads
            .retain(|_| each.next().is_some_and(|acts| *acts));
        stack
    }

    /// The same stack under its weight alone.
    pub fn without_static_loads(mut self) -> Self {
        self.static_loads.clear();
        self
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Block, JointMaterial, Solid};
    use super::*;

    #[test]
    fn refuses_loads_off_their_stone_and_numbers_that_are_none() {
        let block = Block {
            name: "stone".into(),
            solid: Solid::cuboid(1.0, 1.0, 0.5).unwrap(),
            density_kg_m3: 2600.0,
        };
        let stack = Stack::new(vec![block], JointMaterial::default(), 9.81).unwrap();
        let with = |block: usize, position_m: [f64; 3], force_n: [f64; 3]| {
            let load = StaticLoad {
                block,
                position_m,
                force_n,
            };
            stack.clone().with_static_load(load)
        };
        let loaded = with(0, [0.0, 0.0, 3.4], [1.0, 0.0, 0.0]).unwrap();
        assert_eq!(loaded.static_loads().len(), 1);
        assert!(loaded.without_static_loads().static_loads().is_empty());
        let fault = with(0, [0.0, 0.0, 3.6], [1.0, 0.0, 0.0]).unwrap_err().to_string();
        assert!(
            fault.contains("a static load") && fault.contains("stone"),
            "{fault}"
        );
        assert!(with(1, [0.0; 3], [1.0, 0.0, 0.0]).is_err());
        assert!(with(0, [f64::NAN, 0.0, 0.0], [1.0, 0.0, 0.0]).is_err());
        assert!(with(0, [0.0; 3], [f64::INFINITY, 0.0, 0.0]).is_err());
    }
}
