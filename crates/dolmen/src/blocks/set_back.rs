//! The bodies of a stack with the contact points of joints that crush moved in from their edges.

use super::assembly::Assembly;
use super::contact_points::ContactRule;
use super::crushing::Strength;
use super::error::BlocksError;
use super::rest::settle;
use crate::structure::stack::Stack;
use std::collections::BTreeMap;

/// As [`Assembly::of`]. In each joint with a strength f that bears a normal force N₀ under its own weight, a stone rotates about the middle of a strip
/// of area N₀/f instead of about the edge.
///
/// # Errors
/// [`BlocksError`] for a stack with a strength that does not come to rest on its springs.
///
/// # Limits
/// The strip stays that of the force at rest. Where stones share their load, that force is the one on elastic joints.
pub(super) fn assembly_that_crushes(stack: &Stack, rule: ContactRule) -> Result<Assembly, BlocksError> {
    let mut assembly = Assembly::of(stack, rule);
    if stack.least_strength_pa().is_some() && stack.loose_material().is_none() {
        let mut at_rest = assembly.clone();
        settle(&mut at_rest, stack)?;
        let carried: BTreeMap<usize, f64> = at_rest
            .contacts()
            .map(|(pair, patch, ..)| (pair, patch.normal_at_rest_n(&at_rest.bodies)))
            .collect();
        for (pair, patch, outline, strength_pa) in assembly.contacts_mut() {
            let normal_n = carried.get(&pair).copied().filter(|normal_n| *normal_n > 0.0);
            let (Some(normal_n), Some(strength_pa)) = (normal_n, strength_pa) else {
                continue;
            };
            patch.law.strength = Strength {
                strength_pa,
                strip_m2: normal_n / strength_pa,
            };
            patch.points.clear();
            let as_drawn = outline.clipped_at;
            outline.clip(patch, &as_drawn, rule);
        }
    }
    Ok(assembly)
}
