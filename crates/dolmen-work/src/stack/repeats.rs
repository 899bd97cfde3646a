//! Repeats the run of a stack under a motion with differences too small to measure.

use super::StackSimulation;
use super::simulation::came_to_its_end;
use crate::error::WorkError;
use crate::progress::Progress;
use dolmen::assess::{DamageState, DamageThresholds, stack_damage};
use dolmen::blocks::{BlocksError, ContactLaw, StackHistory};
use dolmen::blocks::{StackRun, simulate_rigid, simulate_springs_many};
use dolmen::numeric::{Random, quantile};
use dolmen::signal::GroundMotion;
use dolmen::structure::stack::{SmallDifferences, Stack};

/// Seed of the differences: the same in every run. Our choice.
const SEED: u64 = 1;
/// Default number of runs. Our choice.
const AS_NEEDED: usize = 8;

/// Largest number of updates of contact points for repeats by default. Our choice: some five seconds.
const REPEAT_UPDATES_MOST: f64 = 1e9;

/// Number of runs of the decisive law, all except the first with differences too small to measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Repeating {
    /// Eight if small differences may make one run worse: if no stone fell and the ground nearly reaches the threshold of motion.
    AsNeeded {
        /// Largest number of updates of contact points.
        updates_most: f64,
    },
    /// This number.
    Times(usize),
}

impl Repeating {
    /// As needed, if that takes only seconds.
    pub const QUICK: Repeating = Repeating::AsNeeded {
        updates_most: REPEAT_UPDATES_MOST,
    };
    /// As often as needed, without a time limit.
    pub const WHOLE: Repeating = Repeating::AsNeeded {
        updates_most: f64::INFINITY,
    };

    /// Number of runs.
    pub(super) fn times(self, run: &StackSimulation) -> usize {
        match self {
            Repeating::Times(times) => times,
            Repeating::AsNeeded { updates_most } => {
                let is_open = run.may_be_worse();
                let updates = run.history.contact_points as f64 * run.history.steps as f64;
                let more = (AS_NEEDED - 1) as f64;
                match is_open && run.is_whole() && more * updates <= updates_most {
                    true => AS_NEEDED,
                    false => 1,
                }
            }
        }
    }
}

/// Result of one run with small differences.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repeat {
    /// The state of damage.
    pub state: DamageState,
    /// Largest opening of any joint, m.
    pub peak_opening_m: f64,
    /// Largest slip of any joint, m.
    pub peak_slip_m: f64,
    /// Largest residual slip of any joint, m.
    pub residual_slip_m: f64,
}

/// Runs of one law with small differences, the first as given.
#[derive(Clone, Debug, PartialEq)]
pub struct Repeats {
    /// Size of the differences.
    pub differences: SmallDifferences,
    /// Whether edges of beds differ as well.
    pub moves_edges: bool,
    /// Seed of the differences.
    pub seed: u64,
    /// Runs with a verdict.
    pub runs: Vec<Repeat>,
    /// Whether the runs were stopped early.
    pub is_stopped: bool,
    /// Number of runs without a verdict: stopped, without a solution, or refused.
    pub undecided: usize,
}

/// Smallest, median and largest value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// The smallest.
    pub least: f64,
    /// The middle value, or the mean of the middle two.
    pub median: f64,
    /// The largest.
    pub most: f64,
}

impl StackSimulation {
    /// Whether none of its stones fell and the ground nearly moves one or does, so that immeasurably small differences may make it worse.
    pub fn may_be_worse(&self) -> bool {
        match self.damage.state {
            DamageState::None => self.nearly_moves(),
            DamageState::Begun | DamageState::Offset | DamageState::Severe => true,
            DamageState::Fallen => false,
        }
    }
}

impl Repeats {
    /// Smallest, median and largest of a value; `None` without a run.
    pub fn spread(&self, of: impl Fn(&Repeat) -> f64) -> Option<Spread> {
        let values: Vec<f64> = self.runs.iter().map(of).collect();
        let at = |probability: f64| quantile(&values, probability).ok();
        let [least, median, most] = [at(0.0)?, at(0.5)?, at(1.0)?];
        Some(Spread { least, median, most })
    }

    /// The worst state of damage of the runs.
    pub fn worst_state(&self) -> Option<DamageState> {
        self.states().last().map(|(state, _)| *state)
    }

    /// The states of damage of the runs, mildest first, with the number of runs of each.
    pub fn states(&self) -> Vec<(DamageState, usize)> {
        let mut states: Vec<DamageState> = self.runs.iter().map(|run| run.state).collect();
        states.sort_by_key(|state| state.number());
        let mut counted: Vec<(DamageState, usize)> = Vec::new();
        for state in states {
            match counted.last_mut().filter(|(last, _)| *last == state) {
                Some((_, count)) => *count += 1,
                None => counted.push((state, 1)),
            }
        }
        counted
    }
}

/// Repeats the run up to this number, all except the first with small differences.
pub(super) fn repeats(
    run: &StackSimulation,
    count: usize,
    progress: &dyn Progress,
) -> Result<Repeats, WorkError> {
    let differences = SmallDifferences::default();
    let mut found = Repeats {
        differences,
        moves_edges: differences.moves_edges(&run.stack),
        seed: SEED,
        runs: Vec::new(),
        is_stopped: false,
        undecided: 0,
    };
    found.add(run, Ok(run.history.clone()));
    let mut cases: Vec<(Stack, GroundMotion)> = Vec::new();
    for stream in 1..count {
        let mut random = Random::new(SEED, stream as u64);
        let factor = differences.motion_factor(&mut random);
        match differences.applied_to(&run.stack, &mut random) {
            Ok(stack) => cases.push((stack, run.motion.motion.clone().scaled(factor)?)),
            Err(_) => found.undecided += 1,
        }
    }
    let mut histories: Vec<Option<Result<StackHistory, BlocksError>>> = vec![None; cases.len()];
    let mut keep = |place: usize, history| histories[place] = Some(history);
    match &run.law {
        ContactLaw::Springs(options) => {
            let runs: Vec<StackRun<'_>> = cases
                .iter()
                .map(|(stack, motion)| StackRun {
                    stack,
                    motion: Some(motion),
                    options,
                })
                .collect();
            simulate_springs_many(&runs, &mut |_, _| !progress.is_cancelled(), &mut keep);
        }
        ContactLaw::Rigid(options) => {
            for (place, (stack, motion)) in cases.iter().enumerate() {
                let go_on = &mut |_: f64| !progress.is_cancelled();
                keep(place, simulate_rigid(stack, Some(motion), options, go_on));
            }
        }
    }
    for history in histories {
        match history {
            Some(history) => found.add(run, history),
            None => found.undecided += 1,
        }
    }
    found.is_stopped = found.undecided > 0 && progress.is_cancelled();
    Ok(found)
}

impl Repeats {
    fn add(&mut self, run: &StackSimulation, history: Result<StackHistory, BlocksError>) {
        let decided = history.ok().filter(|history| came_to_its_end(&history.outcome));
        let Some(history) = decided else {
            self.undecided += 1;
            return;
        };
        let damage = stack_damage(&run.stack, &run.limits, &history, &DamageThresholds::default());
        self.runs.push(Repeat {
            state: damage.state,
            peak_opening_m: damage.largest(|joint| joint.peak_uplift_m),
            peak_slip_m: damage.largest(|joint| joint.peak_slip_m),
            residual_slip_m: damage.largest(|joint| joint.residual_slip_m),
        });
    }
}
