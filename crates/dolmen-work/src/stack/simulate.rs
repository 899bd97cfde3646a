//! A stack under a ground motion.

use super::StackSimulation;
use crate::error::WorkError;
use crate::motion::MotionAnswer;
use crate::progress::{Progress, simulating};
use crate::version::Version;
use dolmen::assess::{DamageThresholds, stack_damage};
use dolmen::blocks::{AfterFall, ContactLaw, ContactRule, Rigid, Springs, simulate_stack};
use dolmen::stability::stack::{StackLimits, Standing, stack_limits};
use dolmen::structure::stack::Stack;
use dolmen_project::{Quantity, StackPart};

/// The law of contact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Law {
    /// Springs, dashpots, friction.
    #[default]
    Springs,
    /// Unilateral contact, friction, restitution.
    Rigid,
}

/// How a stack is run.
pub(crate) struct StackOptions {
    pub(crate) law: Law,
    pub(crate) contact_rule: ContactRule,
    pub(crate) step_s: Option<f64>,
    pub(crate) duration_s: Option<f64>,
    pub(crate) output_step_s: f64,
    pub(crate) to_the_end: bool,
    pub(crate) however_long: bool,
}

/// What came of a stack that was to be shaken.
pub(crate) enum Shaken {
    /// It was simulated.
    Simulated(Box<StackSimulation>),
    /// It does not stand without any shaking.
    DoesNotStand(Standing),
}

/// The stack under the motion, if it stands without.
pub(crate) fn simulate(
    version: &Version<'_>,
    part: &StackPart,
    motion: MotionAnswer,
    options: &StackOptions,
    progress: &dyn Progress,
) -> Result<Shaken, WorkError> {
    let stack = part.build(&mut Quantity::nominal)?;
    let limits = stack_limits(&stack, &StackLimits::default())?;
    if !limits.standing.stands() {
        return Ok(Shaken::DoesNotStand(limits.standing));
    }
    let law = law(options, &stack);
    let whole_s = law.run_length_s(motion.motion.duration_s());
    let history = simulating(progress, whole_s, |reached| {
        simulate_stack(&stack, Some(&motion.motion), &law, reached)
    })?;
    Ok(Shaken::Simulated(Box::new(StackSimulation {
        damage: stack_damage(&stack, &limits, &history, &DamageThresholds::default()),
        limits,
        file: version.file.to_owned(),
        name: version.project.name.clone(),
        variant: version.variant.map(str::to_owned),
        stack,
        lean: part.lean.clone(),
        motion,
        law,
        history,
    })))
}

fn law(options: &StackOptions, stack: &Stack) -> ContactLaw {
    let contact_rule = options.contact_rule;
    let (duration_s, output_step_s) = (options.duration_s, options.output_step_s);
    let after_fall = match options.to_the_end {
        true => AfterFall::Continue,
        false => AfterFall::Stop,
    };
    match options.law {
        Law::Springs => ContactLaw::Springs(Springs {
            contact_rule,
            time_step_s: options.step_s,
            duration_s,
            output_step_s,
            after_fall,
            however_long: options.however_long,
            ..Springs::default()
        }),
        Law::Rigid => ContactLaw::Rigid(Rigid {
            contact_rule,
            time_step_s: options.step_s.unwrap_or_else(|| Rigid::usual_step_s(stack)),
            duration_s,
            output_step_s,
            after_fall,
            however_long: options.however_long,
            ..Rigid::default()
        }),
    }
}
