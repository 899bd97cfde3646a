//! The check of a stack.

use super::frequencies;
use crate::error::WorkError;
use crate::state::{StackAnswer, StackFrequencies};
use dolmen::assess::{StackCheckOptions, check_stack_with_gaps, first_motion_beside, with_settle_run};
use dolmen::blocks::beside_in_small_motion;
use dolmen::structure::stack::Stack;
use dolmen_project::{Pick, StackPart};

/// Checks a stack, with the value of each input that `pick` chooses.
pub(crate) fn check(part: &StackPart, pick: Pick<'_>) -> Result<StackAnswer, WorkError> {
    let (stack, check) = check_stack_with_gaps(part.build(pick)?, &StackCheckOptions::default())?;
    let check = with_settle_run(&stack, check);
    let frequencies = frequencies::of(&stack, &check);
    let beside = match frequencies {
        Some(StackFrequencies::Known { .. }) => beside_in_small_motion(&stack, frequencies::RULE)?,
        _ => Vec::new(),
    };
    let frequencies_unheld = match beside.iter().any(|of| of.is_spring()) {
        true => frequencies::of(&stack.clone().without_side_supports(), &check),
        false => None,
    };
    Ok(StackAnswer {
        beside,
        frequencies_unheld,
        stack,
        check,
        lean: part.lean.clone(),
        frequencies,
        local_mechanisms: None,
        frequency_by_height: Vec::new(),
    })
}

/// Horizontal acceleration at which it begins to move, m/s², with inputs that differ little from those of an answer; `None` if no direction has
/// one.
pub(crate) fn first_motion_m_s2(
    part: &StackPart,
    answer: &StackAnswer,
    pick: Pick<'_>,
) -> Result<Option<f64>, WorkError> {
    let stack = part.build(pick)?;
    let options = StackCheckOptions::default();
    if stack.joints_drawn_open().is_empty() {
        return Ok(first_motion_beside(
            &stack,
            &options,
            (&answer.stack, &answer.check),
        )?);
    }
    let (_, check) = check_stack_with_gaps(stack, &options)?;
    Ok(check.capacity.map(|first| first.acceleration_m_s2))
}

/// A stack with open gaps in its joints, as used in a check.
pub(crate) fn with_gaps(stack: Stack) -> Result<Stack, WorkError> {
    match stack.joints_drawn_open().is_empty() {
        true => Ok(stack),
        false => Ok(check_stack_with_gaps(stack, &StackCheckOptions::default())?.0),
    }
}
