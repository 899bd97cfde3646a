//! Loose stones that have settled under their own weight, by each law of contact.

use super::RefusedRun;
use crate::motion::MotionAnswer;
use dolmen::blocks::{ContactLaw, LooseEnding, LooseMargin, LooseStones};
use dolmen::structure::stack::Stack;
use dolmen_project::Names;

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

    /// How near to motion the stones rest, by the law with the smaller margin.
    pub fn margin(&self) -> LooseMargin {
        let least = self.least_margin_g();
        let mut settled = self.runs.iter().map(|run| &run.settled);
        match settled.find(|of| of.margin_g.is_none() || of.margin_g == least) {
            Some(of) => of.margin(),
            None => LooseMargin::Unknown,
        }
    }

    /// The smallest acceleration, over gravity, at which the stones begin to move from their rest; `None` if a law has none.
    pub fn least_margin_g(&self) -> Option<f64> {
        let each = self.runs.iter().map(|run| run.settled.margin_g);
        let all: Option<Vec<f64>> = each.collect();
        all?.into_iter().min_by(f64::total_cmp)
    }

    /// Whether there are runs, and in all of them the stones came to rest.
    pub fn is_whole(&self) -> bool {
        let rests = |run: &SettledRun| matches!(run.ending(), LooseEnding::Stood | LooseEnding::Fell);
        !self.runs.is_empty() && self.runs.iter().all(rests)
    }
}
