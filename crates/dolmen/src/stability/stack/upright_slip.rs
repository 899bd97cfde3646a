//! Upright joints that slide in a mechanism, without their friction.

use super::cuts::carries;
use super::mechanism::Mechanism;
use crate::structure::stack::Stack;

/// The stack without friction in the upright joints that slide in a mechanism; `None` if none of them has friction.
pub(crate) fn without_sliding_friction(stack: &Stack, mechanism: Option<&Mechanism>) -> Option<Stack> {
    let mut smoother = stack.clone();
    let mut is_other = false;
    for moving in &mechanism?.joints {
        let joint = &stack.joints()[moving.joint];
        let slides = moving.motion.slides();
        if slides && !carries(joint) && joint.material.friction_static > 0.0 {
            let mut material = joint.material;
            (material.friction_static, material.friction_kinetic) = (0.0, 0.0);
            smoother = smoother.with_material(moving.joint, material).ok()?;
            is_other = true;
        }
    }
    is_other.then_some(smoother)
}
