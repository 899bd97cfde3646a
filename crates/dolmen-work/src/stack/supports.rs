//! What becomes of a stack whose supports move slowly, in time, by each law of contact.

use dolmen::blocks::{ContactLaw, MovedInTime, Outcome};
use dolmen::stability::Verdict;
use dolmen::stability::stack::{MovedSupports, MovementEnding};
use dolmen::structure::stack::{Stack, SupportMovement};
use dolmen_project::{Names, SurveyedLean};

/// One law of contact.
#[derive(Clone, Debug, PartialEq)]
pub struct SupportsRun {
    /// The law, with the options of the run.
    pub law: ContactLaw,
    /// What happened.
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
    /// How it leans as surveyed.
    pub lean: Option<SurveyedLean>,
    /// The stack as drawn, with its movements.
    pub stack: Stack,
    /// What the check says of it, its supports moved.
    pub verdict: Verdict,
    /// From equilibrium to equilibrium, as the check follows it.
    pub followed: MovedSupports,
    /// Factor on the movements up to which the supports move.
    pub factor_most: f64,
    /// One run a law, springs first.
    pub runs: Vec<SupportsRun>,
    /// Laws that could not be run.
    pub left_out: Vec<RefusedRun>,
}

/// A law of contact that refused the stack.
#[derive(Clone, Debug, PartialEq)]
pub struct RefusedRun {
    /// The law.
    pub law: ContactLaw,
    /// Why, with what can be done.
    pub why: String,
}

impl SupportsRun {
    /// Whether it came to its end, at rest or by falling.
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

    /// The factor on the movements from which it was on its way down; `None` if it did not fall.
    pub fn falls_at(&self) -> Option<f64> {
        self.moved.gave_way.map(|gave_way| gave_way.factor)
    }
}

impl SupportsSimulation {
    /// Least factor on the movements at which it falls, by any run or by the check; `None` if it falls by none.
    pub fn falls_at(&self) -> Option<f64> {
        let of_check = self.followed_falls().then_some(self.followed.last.factor);
        let each = self.runs.iter().filter_map(SupportsRun::falls_at).chain(of_check);
        each.reduce(f64::min)
    }

    /// Whether the check finds a movement beyond which no forces balance the weight.
    pub fn followed_falls(&self) -> bool {
        matches!(self.followed.ending, MovementEnding::Falls { .. })
    }

    /// Whether there are runs, and every one came to its end.
    pub fn is_whole(&self) -> bool {
        !self.runs.is_empty() && self.runs.iter().all(SupportsRun::is_whole)
    }

    /// How far the ground moves that moves farthest, at a factor, m.
    pub fn length_m(&self, factor: f64) -> f64 {
        let each = self.stack.support_movements().iter();
        factor * each.map(SupportMovement::length_m).fold(0.0, f64::max)
    }
}
