//! The allowable drift of the file beside the scans of a study: its damage states begin elsewhere.

use super::answer::StudyAnswer;
use super::measures::RunMeasures;
use super::run::Run;

/// Scans against the allowable drift of a storey.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AllowedDrift {
    /// The allowable drift over the height of the storey.
    pub limit: f64,
    /// Scans of which a drift is known.
    pub scans: usize,
    /// How many of them drift farther in some run, or fall under their own weight.
    pub beyond: usize,
    /// The least peak of the ground at which one that stands does, m/s²; `None` where none does.
    pub least_m_s2: Option<f64>,
    /// The largest peak that was tried, m/s².
    pub largest_m_s2: f64,
}

/// The largest drift of a run over the height of its storey.
fn drift(run: &Run) -> Option<f64> {
    match run.measures {
        RunMeasures::Frame(of) => Some(of.peak_drift_ratio),
        RunMeasures::Building(of) => Some(of.peak_corner_drift_ratio),
        RunMeasures::None | RunMeasures::Stack(_) | RunMeasures::Chain(_) => None,
    }
}

impl StudyAnswer {
    /// The scans against the allowable drift of the file; `None` where it sets none, varies it, or nothing was run.
    pub fn allowed_drift(&self) -> Option<AllowedDrift> {
        let limit = self.drift_limit?;
        let known: Vec<(&Run, f64)> = self
            .runs
            .iter()
            .filter_map(|run| Some((run, drift(run)?)))
            .collect();
        let jobs = |of: &dyn Fn(f64) -> bool| {
            let mut jobs: Vec<usize> = known
                .iter()
                .filter(|one| of(one.1))
                .map(|one| one.0.job)
                .collect();
            jobs.sort_unstable();
            jobs.dedup();
            jobs.len()
        };
        let peaks = |of: &dyn Fn(f64) -> bool| -> Vec<f64> {
            let chosen = known.iter().filter(|one| of(one.1));
            chosen.map(|one| one.0.peak_ground_acceleration_m_s2).collect()
        };
        let is_beyond = |drift: f64| drift > limit || drift.is_nan();
        let largest_m_s2 = peaks(&|_| true).into_iter().reduce(f64::max)?;
        let alone = self.runs.iter().filter(|run| run.fell_alone()).count();
        Some(AllowedDrift {
            limit,
            scans: alone + jobs(&|_| true),
            beyond: alone + jobs(&is_beyond),
            least_m_s2: peaks(&is_beyond).into_iter().reduce(f64::min),
            largest_m_s2,
        })
    }
}
