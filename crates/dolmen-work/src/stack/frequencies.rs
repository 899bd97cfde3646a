//! Natural frequencies of a stack compared with those of surveys.

use crate::error::WorkError;
use crate::judgement::lowest_measured;
use crate::state::{SpringFit, StackAnswer, StackFrequencies};
use crate::told::told_both;
use dolmen::assess::StackCheck;
use dolmen::blocks::{
    ContactRule, StackMode, calibrate_springs, first_sway, lowest_stack_modes, stack_modes,
};
use dolmen::stability::Verdict;
use dolmen::structure::stack::Stack;
use dolmen_project::Survey;

/// The springs of a joint: exact for small motion of faces that stay closed.
pub(crate) const RULE: ContactRule = ContactRule::Four;

/// Fewest modes computed for many stones: more than are shown, and for a tower the first ones that sway in each direction. Our choice.
const MODES_LEAST: usize = 24;

/// Frequencies of a stack that stands.
pub(crate) fn of(stack: &Stack, check: &StackCheck) -> Option<StackFrequencies> {
    if check.verdict == Verdict::Unstable {
        return None;
    }
    let mut count = MODES_LEAST;
    loop {
        let modes = match lowest_stack_modes(stack, RULE, count) {
            Ok(modes) => modes,
            Err(why) => return Some(StackFrequencies::Refused(told_both(&why))),
        };
        let sways = [0, 1].map(|axis| first_sway(&modes, axis).map(|mode| (mode, modes[mode].frequency_hz)));
        let has_all = modes.len() == 6 * stack.blocks().len();
        if has_all || sways.iter().all(Option::is_some) {
            return Some(StackFrequencies::Known { modes, sways });
        }
        count *= 4;
    }
}

/// All modes of a stack without its side supports, for demands; with many stones a check computes only the lowest. `None` if they are
/// unknown.
pub(crate) fn all_modes(answer: &StackAnswer) -> Option<Vec<StackMode>> {
    let known = answer.frequencies_of_demand()?.modes()?;
    match known.len() == 6 * answer.stack.blocks().len() {
        true => Some(known.to_vec()),
        false => stack_modes(&answer.stack.clone().without_side_supports(), RULE).ok(),
    }
}

/// For each survey, the factor on the springs that gives the measured first frequencies along x and y.
pub(crate) fn fits(answer: &StackAnswer, surveys: &[Survey]) -> Result<Vec<SpringFit>, WorkError> {
    let Some(known) = &answer.frequencies else {
        return Ok(Vec::new());
    };
    let drawn = match known {
        StackFrequencies::Known { modes, .. } => Some(modes.as_slice()),
        StackFrequencies::Refused(_) => None,
    };
    let mut fits = Vec::new();
    for survey in surveys {
        let (mut directions, mut measured, mut not_compared) = (Vec::new(), Vec::new(), Vec::new());
        for (direction, modes) in &survey.modes {
            match (lowest_measured(modes), known.sway(direction)) {
                (Some(lowest), Some((mode, _))) => {
                    directions.push(direction.clone());
                    measured.push((mode, lowest.frequency.value));
                }
                (Some(_), None) => not_compared.push(direction.clone()),
                (None, _) => {}
            }
        }
        let (factor, frequencies) = if measured.is_empty() {
            (None, Vec::new())
        } else {
            let found = calibrate_springs(&answer.stack, RULE, &measured, drawn)?;
            (
                Some(found.factor),
                directions.into_iter().zip(found.frequencies).collect(),
            )
        };
        if factor.is_some() || !not_compared.is_empty() {
            fits.push(SpringFit {
                survey: survey.name.clone(),
                factor,
                frequencies,
                not_compared,
            });
        }
    }
    Ok(fits)
}
