//! Beds that have lost stiffness, by inspections.

use super::fault::StackFault;
use super::part::StackPart;
use dolmen::structure::stack::{Body, Joint, Stack};

impl StackPart {
    /// The stack with the remaining stiffness of loosened beds.
    pub(super) fn with_loosened_beds(&self, mut stack: Stack) -> Result<Stack, StackFault> {
        for loosened in &self.loosened_beds {
            let Some(block) = stack
                .blocks()
                .iter()
                .position(|block| block.name == loosened.block)
            else {
                continue;
            };
            let stands_on = |body: Body| self.blocks.get(block).is_some_and(|own| own.on.contains(&body));
            let is_below = |joint: &Joint| {
                joint.upper == block
                    || (joint.lower == Body::Block(block) && stands_on(Body::Block(joint.upper)))
            };
            for joint in 0..stack.joints().len() {
                let of = &stack.joints()[joint];
                if !is_below(of) {
                    continue;
                }
                let mut material = of.material;
                material.normal_stiffness_pa_m *= loosened.factor;
                material.shear_stiffness_pa_m *= loosened.factor;
                stack = stack
                    .with_material(joint, material)
                    .map_err(|why| StackFault::part(loosened.path.clone(), why))?;
            }
        }
        Ok(stack)
    }

    /// The survey from which the stiffness of the bed below a block was identified, if it was.
    pub(crate) fn bed_identified_from(&self, block: &str) -> Option<&str> {
        let index = self.blocks.iter().position(|own| own.name == block);
        let own = index.map(|index| &self.blocks[index].joint);
        let contacts = self
            .contacts
            .iter()
            .filter(|contact| Some(contact.upper) == index);
        let beds = contacts.map(|contact| &contact.joint).chain(own);
        let mut given = beds
            .chain([&self.joint])
            .filter_map(|bed| bed.normal_stiffness.as_ref());
        given.next()?.survey.as_deref()
    }
}
