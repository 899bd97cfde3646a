//! The simulation of a stack with slowly moving supports, by each law of contact.

use dolmen::blocks::{ContactLaw, MovedInTime, Outcome};
use dolmen::stability::Verdict;
use dolmen::stability::stack::{MovedSupports, MovementEnding};
use dolmen::structure::stack::{Stack, SupportMovement};
use dolmen_project::{Names, SurveyedLean};

/// The run by one law of contact.
#[derive(Clone, Debug, PartialEq)]
pub struct SupportsRun {
    /// The law, with the options of the run.
    pub law: ContactLaw,
    /// The history.
    pub moved: MovedInTime,
}

/// A stack whose supports move slowly, and its inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct SupportsSimulation {
    /// The project file, as the user named it.
    pub file: String,
    /// Name of the structure.
    pub name: Names,
    /// The variant of the file; `None` for the structure as given.
    pub variant: Option<String>,
    /// Its measured lean.
    pub lean: Option<SurveyedLean>,
    /// The stack as drawn, with its movements.
    pub stack: Stack,
    /// The check, with its supports moved.
    pub verdict: Verdict,
    /// The sequence of equilibria in the check.
    pub followed: MovedSupports,
    /// Factor on the movements at which the supports stop.
    pub factor_most: f64,
    /// One run for each law, springs first.
    pub runs: Vec<SupportsRun>,
    /// Laws that could not be run.
    pub left_out: Vec<RefusedRun>,
}

/// A law of contact that refused the stack.
#[derive(Clone, Debug, PartialEq)]
pub struct RefusedRun {
    /// The law.
    pub law: ContactLaw,
    /// The reason, with the remedy.
    pub why: String,
}

impl SupportsRun {
    /// Whether the run is complete, at rest or by a fall.
    pub fn is_whole(&self) -> bool {
        match self.moved.history.outcome {
            Outcome::Fell { .. } => true,
            Outcome::Stood | Outcome::Uplifted { .. } | Outcome::Slid { .. } => {
                self.moved.reached() >= self.moved.slow.ground.factor_most
            }
            Outcome::Stopped { .. }
            | Outcome::Diverged { .. }
            | Outcome::NotConverged { .. }
            | Outcome::StillMoving { .. } => false,
        }
    }

    /// The stone on the brink at the end, if there is one.
    pub fn on_the_brink(&self) -> Option<usize> {
        match self.moved.history.outcome {
            Outcome::Slid { block, .. } => Some(block),
            _ => None,
        }
    }

    /// The factor on the movements from which it fell; `None` if it did not fall.
    pub fn falls_at(&self) -> Option<f64> {
        self.moved.gave_way.map(|gave_way| gave_way.factor)
    }
}

impl SupportsSimulation {
    /// Smallest factor on the movements at which it falls, in any run or in the check; `None` if it does not fall.
    pub fn falls_at(&self) -> Option<f64> {
        let of_check = self.followed_falls().then_some(self.followed.last.factor);
        let each = self.runs.iter().filter_map(SupportsRun::falls_at).chain(of_check);
        each.reduce(f64::min)
    }

    /// Whether the check finds a movement beyond which no forces balance the weight.
    pub fn followed_falls(&self) -> bool {
        matches!(self.followed.ending, MovementEnding::Falls { .. })
    }

    /// Whether there are runs, and all are complete.
    pub fn is_whole(&self) -> bool {
        !self.runs.is_empty() && self.runs.iter().all(SupportsRun::is_whole)
    }

    /// Largest displacement of the ground at a factor, m.
    pub fn length_m(&self, factor: f64) -> f64 {
        let each = self.stack.support_movements().iter();
        factor * each.map(SupportMovement::length_m).fold(0.0, f64::max)
    }
}
