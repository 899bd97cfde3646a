//! Lets loose stones settle under their own weight, by each law of contact.

use super::RefusedRun;
use super::settled::{SettledRun, SettledSimulation};
use super::simulate::{Law, StackOptions, law_of};
use crate::error::WorkError;
use crate::motion::MotionAnswer;
use crate::progress::{Progress, simulating};
use crate::told::told;
use crate::version::Version;
use dolmen::blocks::{ContactLaw, LooseEnding, StackHistory, settle_loose, shake_loose};
use dolmen_project::{Quantity, StackPart};

/// The loose stones of a project after they have settled, and then under the motion if there is one.
pub(crate) fn settle(
    version: &Version<'_>,
    part: &StackPart,
    motion: Option<MotionAnswer>,
    options: &StackOptions,
    progress: &dyn Progress,
) -> Result<SettledSimulation, WorkError> {
    if options.law == Law::Sliding {
        return Err(WorkError::SlidingOfLoose);
    }
    let drawn = part.build_loose(&mut Quantity::nominal)?;
    let laws: &[bool] = match options.law {
        Law::Springs | Law::Sliding => &[false],
        Law::Rigid => &[true],
        Law::AsKnown | Law::Both => &[false, true],
    };
    let mut found = SettledSimulation {
        file: version.file.to_owned(),
        name: version.project.name.clone(),
        variant: version.variant.map(str::to_owned),
        drawn,
        motion,
        runs: Vec::new(),
        left_out: Vec::new(),
    };
    for is_rigid in laws {
        if progress.is_cancelled() {
            break;
        }
        let law = law_of(options, *is_rigid, &found.drawn);
        match run(&found, law.clone(), progress) {
            Ok(run) => found.runs.push(run),
            // from a law that was not requested
            Err(why) if options.law == Law::AsKnown && *is_rigid => {
                let why = told(&why);
                found.left_out.push(RefusedRun { law, why });
            }
            Err(why) => return Err(why),
        }
    }
    Ok(found)
}

fn run(of: &SettledSimulation, law: ContactLaw, progress: &dyn Progress) -> Result<SettledRun, WorkError> {
    let settled = simulating(progress, StackHistory::LONGER_MOST_S, |reached| {
        settle_loose(&of.drawn, &law, reached)
    })?;
    let rests = matches!(settled.ending, LooseEnding::Stood | LooseEnding::Fell);
    let shaken = match &of.motion {
        Some(motion) if rests => {
            let whole_s = law.run_length_s(motion.motion.duration_s());
            Some(simulating(progress, whole_s, |reached| {
                shake_loose(&settled.stack, &motion.motion, &law, reached)
            })?)
        }
        _ => None,
    };
    Ok(SettledRun { law, settled, shaken })
}
