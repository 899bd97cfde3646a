//! Loose stones: rubble and boulders, which have no beds and settle under their own weight.

use super::beds::BED_GAP_M;
use super::overlap::overlap_depth;
use super::stack_of_blocks::{apart, check_values, overlap};
use super::{Block, Body, Joint, JointMaterial, Stack, StackError};
use glam::{DMat3, DVec3};

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
        let mut stack = Stack::bare(blocks, Vec::new(), gravity_m_s2);
        stack.loose = Some(material);
        match stack.first_overlap() {
            Some((upper, lower, depth_m)) => Err(overlap(
                stack.name(Body::Block(upper)),
                stack.name(lower),
                depth_m,
            )),
            None => Ok(stack),
        }
    }

    /// The first block that overlaps the ground or an earlier block by more than [`BED_GAP_M`], that body, and the depth, m.
    fn first_overlap(&self) -> Option<(usize, Body, f64)> {
        for (upper, block) in self.blocks.iter().enumerate() {
            let sunk = -block.solid.bounds_m()[0][2];
            if sunk > BED_GAP_M {
                return Some((upper, Body::Ground, sunk));
            }
            for (lower, other) in self.blocks.iter().enumerate().take(upper) {
                if apart(&block.solid, &other.solid) {
                    continue;
                }
                let depth = overlap_depth(&other.solid, &block.solid);
                if depth > BED_GAP_M {
                    return Some((upper, Body::Block(lower), depth));
                }
            }
        }
        None
    }

    /// The first block that overlaps the ground or another block by more than [`BED_GAP_M`], as an index.
    pub(crate) fn first_sunk(&self) -> Option<usize> {
        self.first_overlap().map(|(block, _, _)| block)
    }

    /// The same stones at other places: each rotated about its centroid and moved.
    pub(crate) fn at_places(&self, places: impl Iterator<Item = (DMat3, DVec3)>) -> Self {
        let mut moved = self.clone();
        for (block, (rotation, centroid)) in moved.blocks.iter_mut().zip(places) {
            let shift = centroid - rotation * DVec3::from(block.solid.centroid_m());
            block.solid = block.solid.moved(rotation, shift);
        }
        moved
    }

    /// The same stones with joints, as they touch.
    pub(crate) fn with_contacts(&self, joints: Vec<Joint>) -> Self {
        Stack::bare(self.blocks.clone(), joints, self.gravity_m_s2())
    }

    /// Contact material of loose stones; `None` for stones with joints.
    pub fn loose_material(&self) -> Option<&JointMaterial> {
        self.loose.as_ref()
    }
}
