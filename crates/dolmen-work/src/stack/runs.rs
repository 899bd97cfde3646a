//! A stack under a motion by one law of contact or by both.

use super::{Repeats, SlidingRun, StackSimulation};
use dolmen::assess::DamageState;

/// Every run of a stack under one motion.
#[derive(Clone, Debug, PartialEq)]
pub struct StackRuns {
    /// The run that decides word and exit status: the worse one of two laws.
    pub deciding: StackSimulation,
    /// The run of the other law of contact.
    pub other: Option<StackSimulation>,
    /// Why one of two laws was not run although no joint stiffness is measured.
    pub left_out: Option<LeftOut>,
    /// The run that decides again and again with small differences, if that was asked for.
    pub repeats: Option<Repeats>,
    /// The sliding model beside it, if that was asked for. It decides nothing: its blocks cannot rock.
    pub sliding: Option<SlidingRun>,
}

/// Why a law of contact was left out.
#[derive(Clone, Debug, PartialEq)]
pub enum LeftOut {
    /// It is slow: estimated updates of contact points, the points of all joints times the steps.
    TooLong {
        /// How many it would take.
        updates: f64,
        /// How many are run without being asked for.
        most: f64,
    },
    /// It does not know what this stack has.
    Refused {
        /// Why, with what can be done.
        why: String,
    },
    /// It found no solution, and what it showed until then is no worse than what the springs show.
    NoSolution {
        /// When, s.
        at_s: f64,
    },
}

impl StackRuns {
    /// One run alone.
    pub fn of(deciding: StackSimulation) -> Self {
        StackRuns {
            deciding,
            other: None,
            left_out: None,
            repeats: None,
            sliding: None,
        }
    }

    /// The runs, that which decides first.
    pub fn each(&self) -> impl Iterator<Item = &StackSimulation> {
        std::iter::once(&self.deciding).chain(&self.other)
    }

    /// The states of damage that count, of deciding and other law, if they differ.
    pub fn differing_states(&self) -> Option<[DamageState; 2]> {
        let states = [
            self.deciding.counted_damage(),
            self.other.as_ref()?.counted_damage(),
        ];
        (states[0] != states[1]).then_some(states)
    }
}
