//! Run under its own weight of a stack that stands by friction: equilibrium is necessary, but only the run shows that the stack stays.

use super::stack::{StackCheck, by_margins, with_movement};
use super::stack_notes::{SettleRun, StackNote};
use crate::blocks::{Outcome, Springs, simulate_springs};
use crate::stability::Verdict;
use crate::structure::stack::Stack;

/// Length of the run after settlement on the joint springs, s. Our choice: a slipping stone falls a metre in half of it.
const LENGTH_S: f64 = 1.0;

/// The check with a run of the stack under its own weight on joint springs, if friction carries stones that share their load; otherwise the check
/// unchanged.
///
/// A stack that stood has the verdict of its margins; one that fell is unstable; otherwise the verdict is unknown.
///
/// # Limits
/// The run starts from the position of rest that Newton steps find. It does not include static loads.
pub fn with_settle_run(stack: &Stack, check: StackCheck) -> StackCheck {
    let Some(carries) = check
        .notes
        .iter()
        .position(|note| *note == StackNote::FrictionCarries)
    else {
        return check;
    };
    let found = settle_run(stack);
    let (note, verdict) = match &found {
        SettleRun::Stood { .. } => (StackNote::FrictionStood, by_margins(&check)),
        SettleRun::Fell { block } => (StackNote::FrictionFell { block: *block }, Verdict::Unstable),
        SettleRun::NoRest { .. } => (StackNote::FrictionNoRest, Verdict::Unknown),
        SettleRun::TooMany { stones } => {
            let most = SettleRun::STONES_MOST;
            (
                StackNote::FrictionNotRun {
                    stones: *stones,
                    most,
                },
                Verdict::Unknown,
            )
        }
    };
    let mut check = check;
    check.notes[carries] = note;
    check.verdict = with_movement(verdict, check.supports.as_ref());
    check.settle_run = Some(found);
    check
}

fn settle_run(stack: &Stack) -> SettleRun {
    let stones = stack.blocks().len();
    if stones > SettleRun::STONES_MOST {
        return SettleRun::TooMany { stones };
    }
    let options = Springs {
        duration_s: Some(LENGTH_S),
        ..Springs::default()
    };
    match simulate_springs(stack, None, &options, &mut |_| true) {
        Err(why) => SettleRun::NoRest { why: Some(why) },
        Ok(history) => match history.outcome {
            Outcome::Stood | Outcome::Uplifted { .. } => SettleRun::Stood {
                settlement_m: history.settlement_m,
                length_s: LENGTH_S,
            },
            Outcome::Fell { block, .. } => SettleRun::Fell { block },
            Outcome::Slid { .. }
            | Outcome::StillMoving { .. }
            | Outcome::Stopped { .. }
            | Outcome::NotConverged { .. }
            | Outcome::Diverged { .. } => SettleRun::NoRest { why: None },
        },
    }
}
