//! Loose stones: rubble and boulders, which have no beds and settle under their own weight.

use super::beds::BED_GAP_M;
use super::overlap::overlap_depth;
use super::stack_of_blocks::{apart, check_values, overlap};
use super::{Block, JointMaterial, Stack, StackError};

impl Stack {
    /// Stones near their drawn positions, without joints: [`crate::blocks::settle_loose`] finds their positions at rest.
    ///
    /// # Errors
    /// [`StackError`] for no blocks, repeated names, a density, gravity or material out of range, and blocks that overlap each other or the ground
    /// by more than [`BED_GAP_M`].
    ///
    /// # Limits
    /// Contact is between convex hulls. A loose stack has no joints, and therefore no limits or modes.
    pub fn loose(blocks: Vec<Block>, material: JointMaterial, gravity_m_s2: f64) -> Result<Self, StackError> {
        let material = material.checked()?;
        check_values(&blocks, gravity_m_s2)?;
        for (upper, block) in blocks.iter().enumerate() {
            let sunk = -block.solid.bounds_m()[0][2];
            if sunk > BED_GAP_M {
                return Err(overlap(&block.name, "the ground", sunk));
            }
            for other in blocks.iter().take(upper) {
                if apart(&block.solid, &other.solid) {
                    continue;
                }
                let depth = overlap_depth(&other.solid, &block.solid);
                if depth > BED_GAP_M {
                    return Err(overlap(&block.name, &other.name, depth));
                }
            }
        }
        let mut stack = Stack::bare(blocks, Vec::new(), gravity_m_s2);
        stack.loose = Some(material);
        Ok(stack)
    }

    /// Contact material of loose stones; `None` for stones with joints.
    pub fn loose_material(&self) -> Option<&JointMaterial> {
        self.loose.as_ref()
    }
}
