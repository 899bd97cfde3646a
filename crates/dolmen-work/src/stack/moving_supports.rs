//! A stack with slowly moving supports, simulated by each law of contact.

use super::simulate::{Law, StackOptions, law_of};
use super::{RefusedRun, SupportsRun, SupportsSimulation};
use crate::error::WorkError;
use crate::progress::{Progress, simulating};
use crate::state::StackAnswer;
use crate::told::told;
use crate::version::Version;
use dolmen::blocks::{ContactLaw, Rigid, SlowMovement, move_supports};
use dolmen::stability::stack::{
    MovedSupports, MovementEnding, Standing, SupportMovementOptions, follow_support_movement,
};
use dolmen_project::StackPart;

/// Factor by which the supports continue beyond the movement at which no forces balance the weight. Our choice: friction and inertia may keep a
/// stack standing a little longer.
const BEYOND: f64 = 1.1;

/// Step of the rigid law over that for an earthquake. Our choice: while supports move slowly, stones pass through equilibria, and two arches fell at
/// the same four digits of the movement with it.
const STEPS: f64 = 5.0;

/// Result for a stack with moving supports.
pub(crate) enum Supported {
    /// It was simulated.
    Moved(Box<SupportsSimulation>),
    /// It does not stand as drawn.
    DoesNotStand(Standing),
}

/// The checked stack while its supports move, if it stands as drawn.
pub(crate) fn supports(
    version: &Version<'_>,
    part: &StackPart,
    (checked, options): (StackAnswer, &StackOptions),
    progress: &dyn Progress,
) -> Result<Supported, WorkError> {
    if options.law == Law::Sliding {
        return Err(WorkError::SlidingOfSupports);
    }
    let StackAnswer {
        stack, check, lean, ..
    } = checked;
    if !check.limits.standing.stands() {
        return Ok(Supported::DoesNotStand(check.limits.standing));
    }
    let followed = match check.supports {
        Some(followed) => followed,
        None => follow_support_movement(&stack, &SupportMovementOptions::default())?,
    };
    let factor_most = match followed.ending {
        MovementEnding::Falls { by_factor } => MovedSupports::MARGINAL_BELOW.max(BEYOND * by_factor),
        MovementEnding::Stands | MovementEnding::NotFollowed => MovedSupports::MARGINAL_BELOW,
    };
    let mut found = SupportsSimulation {
        file: version.file.to_owned(),
        name: version.project.name.clone(),
        variant: version.variant.map(str::to_owned),
        lean,
        stack,
        verdict: check.verdict,
        followed,
        factor_most,
        runs: Vec::new(),
        left_out: Vec::new(),
    };
    let laws: &[bool] = match options.law {
        Law::Springs | Law::Sliding => &[false],
        Law::Rigid => &[true],
        Law::AsKnown if part.has_measured_stiffness() => &[false],
        Law::AsKnown | Law::Both => &[false, true],
    };
    for is_rigid in laws {
        if progress.is_cancelled() {
            break;
        }
        let law = slowly(law_of(options, *is_rigid, &found.stack), options);
        match run(&found, law.clone(), progress) {
            Ok(run) => found.runs.push(run),
            // from a law that was not requested
            Err(why) if options.law == Law::AsKnown => {
                let why = told(&why);
                found.left_out.push(RefusedRun { law, why });
            }
            Err(why) => return Err(why),
        }
    }
    Ok(Supported::Moved(Box::new(found)))
}

/// The law with the step for slow supports, unless one is given.
fn slowly(law: ContactLaw, options: &StackOptions) -> ContactLaw {
    match law {
        ContactLaw::Rigid(rigid) if options.step_s.is_none() => ContactLaw::Rigid(Rigid {
            time_step_s: STEPS * rigid.time_step_s,
            ..rigid
        }),
        law => law,
    }
}

fn run(of: &SupportsSimulation, law: ContactLaw, progress: &dyn Progress) -> Result<SupportsRun, WorkError> {
    let slow = SlowMovement {
        factor_most: of.factor_most,
        ..SlowMovement::default()
    };
    let slow = slow.of(&of.stack, &law)?;
    let moved = simulating(progress, slow.ground.duration_s(), |reached| {
        move_supports(&of.stack, &law, &slow, reached)
    })?;
    Ok(SupportsRun { law, moved })
}
