//! Upright joints without their friction: those that slide in a mechanism, and those that only touch.

use super::StackLoads;
use super::cuts::carries;
use super::limit_along::falling_blocks;
use super::mechanism::Mechanism;
use crate::stability::StabilityError;
use crate::structure::stack::{Body, Stack};

/// Direction of the shaking under which a stack without some of its joints must stand, in both senses.
const WAY: [f64; 2] = [1.0, 0.0];

fn rubs_upright(stack: &Stack, joint: usize) -> bool {
    let joint = &stack.joints()[joint];
    !carries(joint) && joint.material.friction_static > 0.0
}

/// The upright joints with friction that slide in a mechanism.
fn sliding_with_friction(stack: &Stack, mechanism: Option<&Mechanism>) -> Vec<usize> {
    let moving = mechanism.into_iter().flat_map(|mechanism| &mechanism.joints);
    let sliding = moving
        .filter(|moving| moving.motion.slides())
        .map(|moving| moving.joint);
    sliding.filter(|&joint| rubs_upright(stack, joint)).collect()
}

/// The stack without friction in the upright joints that slide in a mechanism; `None` if none of them has friction.
pub(crate) fn without_sliding_friction(stack: &Stack, mechanism: Option<&Mechanism>) -> Option<Stack> {
    let rubbing = sliding_with_friction(stack, mechanism);
    (!rubbing.is_empty()).then(|| without_friction(stack, &rubbing))
}

/// The stacks with which a search without friction in upright joints begins: without that of the joints that only touch at rest, and, if others slide
/// in the mechanism with all friction, without that of the sliding joints. `at_rest`: the stack under its loads at rest.
pub(crate) fn smoother_starts(
    stack: &Stack,
    (at_rest, loads): (&Stack, &StackLoads),
    mechanism: Option<&Mechanism>,
) -> Result<Vec<Stack>, StabilityError> {
    let touching = side_contacts(at_rest, loads)?;
    let sliding = sliding_with_friction(stack, mechanism);
    let is_covered = sliding.iter().all(|joint| touching.contains(joint));
    let starts = [touching, if is_covered { Vec::new() } else { sliding }];
    let given = starts.iter().filter(|joints| !joints.is_empty());
    Ok(given.map(|joints| without_friction(stack, joints)).collect())
}

/// The stack without friction in some joints.
fn without_friction(stack: &Stack, joints: &[usize]) -> Stack {
    joints.iter().fold(stack.clone(), |smoother, &joint| {
        let mut material = smoother.joints()[joint].material;
        (material.friction_static, material.friction_kinetic) = (0.0, 0.0);
        let known = smoother.clone();
        smoother.with_material(joint, material).unwrap_or(known)
    })
}

/// The upright joints with friction that only touch: without them, the stack still stands.
///
/// ```text
/// left out    all upright joints with friction, but those of blocks that have no other
/// until the rest stands: those of blocks that fall are put back
/// ```
///
/// The joints of a keystone stay, because it falls without them; those between the leaves of a wall do not.
fn side_contacts(stack: &Stack, loads: &StackLoads) -> Result<Vec<usize>, StabilityError> {
    let count = stack.joints().len();
    let mut left_out: Vec<usize> = (0..count).filter(|&joint| rubs_upright(stack, joint)).collect();
    let ends = |joint: usize| {
        let joint = &stack.joints()[joint];
        let lower = match joint.lower {
            Body::Ground => None,
            Body::Block(block) => Some(block),
        };
        lower.into_iter().chain([joint.upper])
    };
    let mut holds = vec![false; stack.blocks().len()];
    for joint in (0..count).filter(|joint| !left_out.contains(joint)) {
        ends(joint).for_each(|block| holds[block] = true);
    }
    left_out.retain(|&joint| ends(joint).all(|block| holds[block]));
    while !left_out.is_empty() {
        let falling = falling_blocks(&stack.without_joints(&left_out), loads, WAY, false)?;
        if falling.is_empty() {
            break;
        }
        let before = left_out.len();
        left_out.retain(|&joint| ends(joint).all(|block| !falling.contains(&block)));
        if left_out.len() == before {
            left_out.clear(); // it falls with them, too
        }
    }
    Ok(left_out)
}
