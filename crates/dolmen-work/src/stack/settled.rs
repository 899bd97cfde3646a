//! Loose stones that settle under their own weight, by each law of contact.

use super::RefusedRun;
use super::simulate::{Law, StackOptions, law_of};
use crate::error::WorkError;
use crate::motion::MotionAnswer;
use crate::progress::{Progress, simulating};
use crate::told::told;
use crate::version::Version;
use dolmen::blocks::{ContactLaw, LooseEnding, LooseStones, StackHistory, settle_loose, shake_loose};
use dolmen::structure::stack::Stack;
use dolmen_project::{Names, Quantity, StackPart};

/// Loose stones by one law of contact.
#[derive(Clone, Debug, PartialEq)]
pub struct SettledRun {
    /// The law, with the options of the run.
    pub law: ContactLaw,
    /// The stones after they have settled.
    pub settled: LooseStones,
    /// The same stones after the motion, relative to their places of rest; `None` without a motion, and if they did not come to rest.
    pub shaken: Option<LooseStones>,
}

impl SettledRun {
    /// The last state of the stones.
    pub fn last(&self) -> &LooseStones {
        self.shaken.as_ref().unwrap_or(&self.settled)
    }

    /// How the stones ended: at rest in their places only if they settled and, with a motion, stayed.
    pub fn ending(&self) -> LooseEnding {
        match self.settled.ending {
            LooseEnding::Stood => self.last().ending,
            ending => ending,
        }
    }
}

/// Loose stones that settle, and then a motion if there is one.
#[derive(Clone, Debug, PartialEq)]
pub struct SettledSimulation {
    /// The project file, as the user named it.
    pub file: String,
    /// Name of the structure.
    pub name: Names,
    /// The variant of the file; `None` for the structure as given.
    pub variant: Option<String>,
    /// The stones as drawn.
    pub drawn: Stack,
    /// The motion of the ground after they have settled.
    pub motion: Option<MotionAnswer>,
    /// One run for each law, springs first.
    pub runs: Vec<SettledRun>,
    /// Laws that could not be run.
    pub left_out: Vec<RefusedRun>,
}

/// The stone whose places of rest by the two laws are farthest apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LawsApart {
    /// The stone, as an index of the blocks.
    pub block: usize,
    /// Distance of its two places, m.
    pub distance_m: f64,
    /// Half its least thickness, m.
    pub of_m: f64,
}

impl SettledSimulation {
    /// Distance of the places of rest by the two laws, over half the least thickness of the stone, above which the laws differ. Our choice: a tenth of
    /// the way at which a stone has left its place.
    pub const APART_MOST: f64 = 0.1;

    /// The stone whose places of rest by the two laws are farthest apart, relative to its size; `None` with one law.
    pub fn apart(&self) -> Option<LawsApart> {
        let [first, second] = self.runs.as_slice() else {
            return None;
        };
        let both = first.settled.stack.blocks().iter();
        let each = both.zip(second.settled.stack.blocks()).enumerate();
        let apart = each.map(|(block, (a, b))| {
            let (a, b) = (a.solid.centroid_m(), b.solid.centroid_m());
            LawsApart {
                block,
                distance_m: (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum::<f64>().sqrt(),
                of_m: first.settled.stones[block].allowed_m,
            }
        });
        apart.max_by(|a, b| (a.distance_m / a.of_m).total_cmp(&(b.distance_m / b.of_m)))
    }

    /// Whether the two laws differ in what happens to the stones, or in where they rest.
    pub fn laws_differ(&self) -> bool {
        let kind = |run: &SettledRun| std::mem::discriminant(&run.ending());
        let ends = self.runs.windows(2).any(|two| kind(&two[0]) != kind(&two[1]));
        ends || self
            .apart()
            .is_some_and(|apart| apart.distance_m > Self::APART_MOST * apart.of_m)
    }

    /// Whether there are runs, and in all of them the stones came to rest.
    pub fn is_whole(&self) -> bool {
        let rests = |run: &SettledRun| matches!(run.ending(), LooseEnding::Stood | LooseEnding::Fell);
        !self.runs.is_empty() && self.runs.iter().all(rests)
    }
}

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
