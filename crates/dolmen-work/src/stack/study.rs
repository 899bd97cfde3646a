//! Runs of stacks, in batches.

use crate::at_rest::AtRest;
use crate::progress::{Progress, Silent};
use crate::study::{Run, RunMeasures, RunOutcome, StackMeasures};
use crate::told::told_both;
use crate::wrong::RunEnded;
use dolmen::assess::{DamageState, stack_damage};
use dolmen::blocks::{
    BlocksError, ContactRule, Outcome, Rigid, Springs, StackHistory, StackRun, simulate_rigid,
    simulate_springs_many,
};
use dolmen::signal::GroundMotion;
use dolmen::stability::stack::StackLimitStates;
use dolmen::structure::stack::{Body, Joint, Stack};
use dolmen_project::{LawPart, StudyPart};

/// Runs a batch; `each` receives the index of a run and its history, in the order in which runs end. The result of a run does not depend on
/// its batch. Ctrl-C stops the current runs. Runs on springs go in parallel; those by the rigid law, which uses the same points and time to
/// rest, go one after another.
pub(crate) fn run_stacks(
    law: LawPart,
    batch: &[StackRun<'_>],
    progress: &dyn Progress,
    each: &mut dyn FnMut(usize, Result<StackHistory, BlocksError>),
) {
    if law == LawPart::Springs {
        return simulate_springs_many(batch, &mut |_, _| !progress.is_cancelled(), each);
    }
    for (place, run) in batch.iter().enumerate() {
        let rigid = Rigid {
            contact_rule: run.options.contact_rule,
            rest_s: run.options.rest_s,
            time_step_s: Rigid::usual_step_s(run.stack),
            ..Rigid::default()
        };
        let history = simulate_rigid(run.stack, run.motion, &rigid, &mut |_| !progress.is_cancelled());
        each(place, history);
    }
}

/// Options for the runs of a study.
pub(crate) fn springs(study: &StudyPart) -> Springs {
    let usual = Springs::default();
    Springs {
        contact_rule: match study.points {
            4 => ContactRule::Corners,
            9 => ContactRule::Three,
            36 => ContactRule::Six,
            _ => ContactRule::Four,
        },
        rest_s: study.rest_s.unwrap_or(usual.rest_s),
        ..usual
    }
}

/// The row of a stack and the end of its run; `None` if it was stopped.
pub(crate) fn row_and_rest(
    study: &StudyPart,
    run: Run,
    (stack, limits): (&Stack, &StackLimitStates),
    motion: &GroundMotion,
) -> Option<(Run, Option<AtRest>)> {
    let options = springs(study);
    let alone = [StackRun {
        stack,
        motion: Some(motion),
        options: &options,
    }];
    let mut found = None;
    run_stacks(study.law, &alone, &Silent, &mut |_, history| {
        let rest = history.as_ref().ok().map(AtRest::of_stack);
        found = row(study, run.clone(), (stack, limits), history).map(|run| (run, rest));
    });
    found
}

/// The stones of each joint.
pub(crate) fn joint_words(stack: &Stack, joint: &Joint) -> String {
    format!(
        "{} on {}",
        stack.name(Body::Block(joint.upper)),
        stack.name(joint.lower)
    )
}

/// The row of a run; `None` if it was stopped.
pub(crate) fn row(
    study: &StudyPart,
    mut run: Run,
    (stack, limits): (&Stack, &StackLimitStates),
    history: Result<StackHistory, BlocksError>,
) -> Option<Run> {
    let history = match history {
        Ok(history) => history,
        Err(why) => {
            run.outcome = RunOutcome::Refused;
            run.why = told_both(&why);
            return Some(run);
        }
    };
    let block = |index: usize| stack.name(Body::Block(index)).to_owned();
    (run.outcome, run.part) = match &history.outcome {
        Outcome::Stood => (RunOutcome::Stood, String::new()),
        Outcome::Uplifted { .. } => (RunOutcome::Uplifted, String::new()),
        Outcome::Slid { block: index, .. } => (RunOutcome::Slid, block(*index)),
        Outcome::Fell {
            block: index,
            joint,
            at_s,
        } => {
            run.at_s = *at_s;
            if let Some(joint) = stack.joints().get(*joint) {
                run.gave_way = joint_words(stack, joint);
            }
            (RunOutcome::Fell, block(*index))
        }
        Outcome::StillMoving {
            block: index, at_s, ..
        } => {
            run.at_s = *at_s;
            let longer = format!("{:.0}", StackHistory::LONGER_MOST_S);
            run.why = RunEnded::NotAtRest { longer }.into();
            (RunOutcome::StillMoving, block(*index))
        }
        Outcome::Diverged { at_s } => {
            run.at_s = *at_s;
            (RunOutcome::Diverged, String::new())
        }
        Outcome::NotConverged { at_s, residual_m_s } => {
            run.at_s = *at_s;
            let left = format!("{residual_m_s:.1e}");
            run.why = RunEnded::NoSolution { left }.into();
            (RunOutcome::Diverged, String::new())
        }
        _ => return None,
    };
    let damage = stack_damage(stack, limits, &history, &study.damage);
    let state = if run.outcome == RunOutcome::Diverged {
        DamageState::None
    } else {
        damage.state
    };
    run.damage_state = state.number();
    if run.outcome != RunOutcome::Diverged {
        run.joint_states = damage.joints.iter().map(|joint| joint.state.number()).collect();
    }
    run.measures = RunMeasures::Stack(StackMeasures {
        peak_uplift_m: damage.largest(|joint| joint.peak_uplift_m),
        peak_slip_m: damage.largest(|joint| joint.peak_slip_m),
        residual_slip_m: damage.largest(|joint| joint.residual_slip_m),
        residual_slip_ratio: damage.largest(|joint| joint.residual_slip_ratio),
        peak_rocking_ratio: damage.largest(|joint| joint.peak_rocking_ratio),
        peak_tilt_rad: damage.peak_tilt_rad,
        residual_tilt_rad: damage.residual_tilt_rad,
        peak_yaw_rad: damage.largest(|joint| joint.peak_yaw_rad),
        energy_made_ratio: history.energy_made_ratio(),
        time_step_s: history.time_step_s,
    });
    Some(run)
}
