//! Notes on the kinetic friction of a stack: a joint that has moved once has no other.

use super::AssessError;
use super::stack_notes::StackNote;
use crate::stability::stack::{
    Holding, LimitAnalysis, LimitAnalysisStatus, OnSoil, StackLimitStates, StackLimits, limit_analysis,
    stack_limits,
};
use crate::structure::stack::Stack;

/// Note on sliding with every static friction replaced by the kinetic friction, where that is smaller.
pub(super) fn of_single_joints(
    stack: &Stack,
    asked: &StackLimits,
    limits: &StackLimitStates,
) -> Result<Option<StackNote>, AssessError> {
    // if stones share their load, single joints do not show this
    if !limits.statically_determinate || limits.sliding.is_none() {
        return Ok(None);
    }
    let Some(moving) = with_kinetic_friction(stack)? else {
        return Ok(None);
    };
    let limits = stack_limits(&moving, asked)?;
    Ok(Some(match limits.sliding {
        Some(sliding) if limits.standing.stands() => StackNote::KineticLess {
            slides_at_g: sliding.threshold.acceleration_g,
        },
        _ => StackNote::KineticFalls,
    }))
}

/// If stones share their load: limit analysis with the kinetic friction in every joint, because a joint that has slid keeps it.
pub(super) fn of_shared_loads(
    stack: &Stack,
    asked: &StackLimits,
    limits: &StackLimitStates,
) -> Result<Option<StackNote>, AssessError> {
    if limits.statically_determinate {
        return Ok(None);
    }
    let Some(moving) = with_kinetic_friction(stack)? else {
        return Ok(None);
    };
    let analysis = LimitAnalysis {
        loads: asked.loads.clone(),
        holding: Holding::Cohesion,
        ..LimitAnalysis::default()
    };
    let note = match limit_analysis(&moving, &analysis)?.status {
        LimitAnalysisStatus::DoesNotStand => StackNote::KineticFalls,
        LimitAnalysisStatus::Unlimited => return Ok(None),
        LimitAnalysisStatus::Limited(threshold) => StackNote::KineticShared {
            moves_at_g: OnSoil::of(stack, &asked.loads)?
                .threshold(&threshold)
                .acceleration_g,
        },
    };
    Ok(Some(note))
}

/// The stack with the kinetic friction in every joint; `None` if it is smaller in no joint.
fn with_kinetic_friction(stack: &Stack) -> Result<Option<Stack>, AssessError> {
    let mut moving = stack.clone();
    let mut less = false;
    for (index, joint) in stack.joints().iter().enumerate() {
        let mut material = joint.material;
        less |= material.friction_kinetic < material.friction_static;
        material.friction_static = material.friction_kinetic;
        moving = moving.with_material(index, material)?;
    }
    Ok(less.then_some(moving))
}
