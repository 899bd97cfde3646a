//! A stack under a motion by one law of contact or by both.

use super::{Repeats, SlidingRun, StackSimulation};
use dolmen::assess::DamageState;

/// Every run of a stack under one motion.
#[derive(Clone, Debug, PartialEq)]
pub struct StackRuns {
    /// The run that determines words and exit status: the worse of two laws.
    pub deciding: StackSimulation,
    /// The run of the other law of contact.
    pub other: Option<StackSimulation>,
    /// Why the second law was not run although no joint stiffness is measured.
    pub left_out: Option<LeftOut>,
    /// The repeats of the deciding run with small differences, if requested.
    pub repeats: Option<Repeats>,
    /// The sliding model, if requested. It decides nothing, because its blocks cannot rock.
    pub sliding: Option<SlidingRun>,
}

/// Why a law of contact was left out.
#[derive(Clone, Debug, PartialEq)]
pub enum LeftOut {
    /// It would be slow: the estimated number of updates of contact points, which is the points of all joints times the steps.
    TooLong {
        /// The estimate.
        updates: f64,
        /// The limit without a request.
        most: f64,
    },
    /// It does not support a property of this stack.
    Refused {
        /// The reason, with the remedy.
        why: String,
    },
    /// It found no solution, and its results up to then are no worse than those of the springs.
    NoSolution {
        /// Time of the failure, s.
        at_s: f64,
    },
}

impl StackRuns {
    /// A single run.
    pub fn of(deciding: StackSimulation) -> Self {
        StackRuns {
            deciding,
            other: None,
            left_out: None,
            repeats: None,
            sliding: None,
        }
    }

    /// The runs, the deciding one first.
    pub fn each(&self) -> impl Iterator<Item = &StackSimulation> {
        std::iter::once(&self.deciding).chain(&self.other)
    }

    /// The number of repeats in which a stone fell, if none fell in the run itself; 0 otherwise.
    pub fn falls_in_repeats(&self) -> usize {
        let counted = self.repeats.iter().filter(|_| !self.deciding.falls());
        let runs = counted.flat_map(|of| &of.runs);
        runs.filter(|run| run.state == DamageState::Fallen).count()
    }

    /// The states of damage of the deciding and the other law, if they differ.
    pub fn differing_states(&self) -> Option<[DamageState; 2]> {
        let states = [
            self.deciding.counted_damage(),
            self.other.as_ref()?.counted_damage(),
        ];
        (states[0] != states[1]).then_some(states)
    }
}
