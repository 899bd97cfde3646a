//! A stack under a ground motion.

use super::check::with_gaps;
use super::repeats::{Repeating, repeats};
use super::sliding::sliding;
use super::{DrawnGaps, LeftOut, StackRuns, StackSimulation};
use crate::error::WorkError;
use crate::in_runs::LeftOutOfRuns;
use crate::judgement::{is_worse_stack_run, lowest_measured};
use crate::motion::MotionAnswer;
use crate::progress::{Progress, simulating};
use crate::survey_dates::date;
use crate::told::told;
use crate::version::Version;
use dolmen::assess::{DamageState, DamageThresholds, StackCheckOptions, check_stack, stack_damage};
use dolmen::blocks::{AfterFall, ContactLaw, ContactRule, Outcome, Rigid, Springs, simulate_stack};
use dolmen::stability::Verdict;
use dolmen::stability::stack::{StackLimitStates, StackLimits, Standing, stack_limits};
use dolmen::structure::stack::Stack;
use dolmen_project::{Project, Quantity, StackPart, Survey};

/// Largest number of updates of contact points (points times steps) for the rigid law by default. Our choice: about a minute where stones slide
/// on each other.
const RIGID_UPDATES_MOST: f64 = 3e7;

/// Step of the rigid law near the threshold of motion, s, rounded to a whole part of the usual step. Our choice: at the usual 1 ms, 8 of 64 slender blocks shaken by 1.08 to 1.3 of
/// their threshold seemed whole that are damaged at this step, none the other way round.
const STEP_NEAR_THRESHOLD_S: f64 = 2e-4;

/// The choice of laws of contact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Law {
    /// Springs; also the rigid law if the stiffness of the joints is not measured.
    #[default]
    AsKnown,
    /// Springs, dashpots, friction.
    Springs,
    /// Unilateral contact, friction, restitution.
    Rigid,
    /// Both, without a time limit for the second.
    Both,
    /// Springs, and also the sliding model.
    Sliding,
}

/// Options of a run.
pub(crate) struct StackOptions {
    pub(crate) law: Law,
    pub(crate) contact_rule: ContactRule,
    pub(crate) step_s: Option<f64>,
    pub(crate) duration_s: Option<f64>,
    pub(crate) output_step_s: f64,
    pub(crate) to_the_end: bool,
    pub(crate) however_long: bool,
    pub(crate) repeats: Repeating,
}

/// Result for a stack under a motion.
pub(crate) enum StackOutcome {
    /// It was simulated.
    Simulated(Box<StackRuns>),
    /// It does not stand without any shaking.
    DoesNotStand(Standing),
}

/// The stack under the motion, if it stands without shaking.
pub(crate) fn simulate(
    version: &Version<'_>,
    part: &StackPart,
    motion: MotionAnswer,
    options: &StackOptions,
    progress: &dyn Progress,
) -> Result<StackOutcome, WorkError> {
    let drawn = part.build(&mut Quantity::nominal)?;
    let gaps = drawn.widest_gap();
    let joints = drawn.joints().len();
    let stack = with_gaps(drawn)?;
    let gaps = gaps.map(|gap| DrawnGaps {
        gap,
        are_open: stack.joints().len() < joints,
    });
    let limits = stack_limits(&stack, &StackLimits::default())?;
    if !limits.standing.stands() {
        return Ok(StackOutcome::DoesNotStand(limits.standing));
    }
    if let Some(crushes) = crushes_together(&stack, &limits)? {
        return Ok(StackOutcome::DoesNotStand(crushes));
    }
    let shaken = Shakable {
        version,
        part,
        stack,
        gaps,
        limits,
        motion,
    };
    let first = shaken.run(
        law_of(options, options.law == Law::Rigid, &shaken.stack),
        options,
        progress,
    )?;
    let is_alone = match options.law {
        Law::Springs | Law::Rigid | Law::Sliding => true,
        Law::AsKnown => part.has_measured_stiffness(),
        Law::Both => false,
    };
    let mut runs = match is_alone || progress.is_cancelled() {
        true => StackRuns::of(first),
        false => shaken.beside(first, options, progress)?,
    };
    if options.law == Law::Sliding && !progress.is_cancelled() {
        runs.sliding = Some(sliding(
            &shaken.stack,
            &shaken.motion.motion,
            options.duration_s,
            options.output_step_s,
            progress,
        )?);
    }
    let times = options.repeats.times(&runs.deciding);
    if times > 1 && !progress.is_cancelled() {
        runs.repeats = Some(repeats(&runs.deciding, times, progress)?);
    }
    Ok(StackOutcome::Simulated(Box::new(runs)))
}

/// Why stones that share their load do not stand although they would without crushing edges: runs take the strips that crush from the forces on
/// elastic joints, which may stand.
pub(super) fn crushes_together(
    stack: &Stack,
    limits: &StackLimitStates,
) -> Result<Option<Standing>, WorkError> {
    if limits.statically_determinate || stack.least_strength_pa().is_none() {
        return Ok(None);
    }
    let check = check_stack(stack, &StackCheckOptions::default())?;
    let crushing = check
        .crushing
        .filter(|of| of.verdict == Verdict::Unstable && of.uncrushed_verdict != Verdict::Unstable);
    Ok(crushing.map(|of| Standing::CrushesTogether {
        strength_pa: of.strength_pa,
    }))
}

/// The latest survey with a measured frequency of sway.
fn measured_by(project: &Project) -> Option<String> {
    let has_sway = |survey: &&Survey| {
        let mut each = survey.modes.values();
        each.any(|modes| lowest_measured(modes).is_some())
    };
    let latest = project
        .surveys
        .iter()
        .filter(has_sway)
        .max_by_key(|survey| date(&survey.name));
    latest.map(|survey| survey.name.clone())
}

/// A stack and its motion.
struct Shakable<'a> {
    version: &'a Version<'a>,
    part: &'a StackPart,
    stack: Stack,
    gaps: Option<DrawnGaps>,
    limits: StackLimitStates,
    motion: MotionAnswer,
}

impl Shakable<'_> {
    /// A run by a law. Where the ground nearly reaches the threshold of motion and a step of [`STEP_NEAR_THRESHOLD_S`] is not too costly, the rigid
    /// law takes it: stones that lift for some milliseconds land again within a few usual steps, which damps their motion away.
    fn run(
        &self,
        law: ContactLaw,
        options: &StackOptions,
        progress: &dyn Progress,
    ) -> Result<StackSimulation, WorkError> {
        let run = self.run_once(law.clone(), progress)?;
        let ContactLaw::Rigid(rigid) = law else {
            return Ok(run);
        };
        let parts = (rigid.time_step_s / STEP_NEAR_THRESHOLD_S).round().max(1.0);
        let finer = ContactLaw::Rigid(Rigid {
            time_step_s: rigid.time_step_s / parts,
            ..rigid
        });
        let is_given = options.law == Law::Rigid && options.step_s.is_some();
        let is_open = run.is_whole() && run.damage.state < DamageState::Severe;
        let is_finer = is_open
            && parts > 1.0
            && run.nearly_moves()
            && !is_given
            && !progress.is_cancelled()
            && (options.however_long || updates(&finer, &run) <= RIGID_UPDATES_MOST);
        match is_finer {
            true => self.run_once(finer, progress),
            false => Ok(run),
        }
    }

    fn run_once(&self, law: ContactLaw, progress: &dyn Progress) -> Result<StackSimulation, WorkError> {
        let (stack, motion) = (&self.stack, &self.motion.motion);
        let whole_s = law.run_length_s(motion.duration_s());
        let history = simulating(progress, whole_s, |reached| {
            simulate_stack(stack, Some(motion), &law, reached)
        })?;
        let version = self.version;
        let left_out = LeftOutOfRuns::of(version.project);
        Ok(StackSimulation {
            damage: stack_damage(stack, &self.limits, &history, &DamageThresholds::default()),
            limits: self.limits.clone(),
            file: version.file.to_owned(),
            name: version.project.name.clone(),
            variant: version.variant.map(str::to_owned),
            stack: stack.clone(),
            lean: self.part.lean.clone(),
            measured_by: measured_by(version.project),
            loosened: left_out.loosened,
            without_wind: left_out.wind,
            tilt_left_out: left_out.tilt,
            gaps: self.gaps.clone(),
            motion: self.motion.clone(),
            law,
            history,
        })
    }

    /// The run by the rigid law, in addition to that on springs.
    fn beside(
        &self,
        springs: StackSimulation,
        options: &StackOptions,
        progress: &dyn Progress,
    ) -> Result<StackRuns, WorkError> {
        let is_asked = options.law == Law::Both;
        let law = law_of(options, true, &self.stack);
        let updates = updates(&law, &springs);
        let left_out = |why| StackRuns {
            left_out: Some(why),
            ..StackRuns::of(springs.clone())
        };
        if !is_asked && updates > RIGID_UPDATES_MOST {
            return Ok(left_out(LeftOut::TooLong {
                updates,
                most: RIGID_UPDATES_MOST,
            }));
        }
        let rigid = match self.run(law, options, progress) {
            Ok(run) => run,
            Err(why) if is_asked => return Err(why),
            Err(why) => return Ok(left_out(LeftOut::Refused { why: told(&why) })),
        };
        let is_worse = is_worse_stack_run(&rigid, &springs);
        match rigid.history.outcome {
            Outcome::NotConverged { at_s, .. } | Outcome::Diverged { at_s }
                if !is_asked && !shows_more(&rigid, &springs) =>
            {
                return Ok(left_out(LeftOut::NoSolution { at_s }));
            }
            _ => {}
        }
        let (deciding, other) = match is_worse {
            true => (rigid, springs),
            false => (springs, rigid),
        };
        Ok(StackRuns {
            deciding,
            other: Some(other),
            left_out: None,
            repeats: None,
            sliding: None,
        })
    }
}

/// Whether a run that was cut short shows more damage than another.
fn shows_more(cut: &StackSimulation, other: &StackSimulation) -> bool {
    let is_used = !matches!(cut.history.outcome, Outcome::Diverged { .. });
    is_used && cut.damage.state.number() > other.damage.state.number()
}

/// Contact points of all joints times the steps of the motion.
fn updates(law: &ContactLaw, beside: &StackSimulation) -> f64 {
    let step_s = match law {
        ContactLaw::Springs(_) => beside.history.time_step_s,
        ContactLaw::Rigid(rigid) => rigid.time_step_s,
    };
    let length_s = law.run_length_s(beside.motion.motion.duration_s());
    beside.history.contact_points as f64 * length_s / step_s
}

pub(super) fn law_of(options: &StackOptions, is_rigid: bool, stack: &Stack) -> ContactLaw {
    let contact_rule = options.contact_rule;
    let (duration_s, output_step_s) = (options.duration_s, options.output_step_s);
    let after_fall = match options.to_the_end {
        true => AfterFall::Continue,
        false => AfterFall::Stop,
    };
    if is_rigid {
        // a given step applies to the requested law
        let given = options.step_s.filter(|_| options.law == Law::Rigid);
        return ContactLaw::Rigid(Rigid {
            contact_rule,
            time_step_s: given.unwrap_or_else(|| Rigid::usual_step_s(stack)),
            duration_s,
            output_step_s,
            after_fall,
            however_long: options.however_long,
            ..Rigid::default()
        });
    }
    ContactLaw::Springs(Springs {
        contact_rule,
        time_step_s: options.step_s,
        duration_s,
        output_step_s,
        after_fall,
        however_long: options.however_long,
        ..Springs::default()
    })
}
