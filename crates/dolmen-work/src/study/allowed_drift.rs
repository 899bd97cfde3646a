//! The allowable drift of the file compared with the scans of a study, whose damage states begin at other drifts.

use super::answer::StudyAnswer;
use super::measures::RunMeasures;
use super::run::{Run, RunOutcome};
use super::scans::{ALLOWED_DRIFT, CapacityOf, RunInformation, ScanVerdict, first_seen};
use dolmen::assess::{Reached, Trial};
use std::collections::BTreeSet;

/// Comparison of scans with the allowable drift of a storey.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AllowedDrift {
    /// The allowable drift ratio of the storey.
    pub limit: f64,
    /// Its largest reduction by the surveyed lean; 0 for a structure without one.
    pub lean: f64,
    /// Number of scans in which the earlier motion already exceeds it; they are not counted elsewhere.
    pub before: usize,
    /// Number of scans with a known drift.
    pub scans: usize,
    /// Number of those that exceed it in some run, including the surveyed lean, lean beyond it at rest, or fall under their own weight.
    pub beyond: usize,
    /// Number of those that fall under their own weight, or fell in the motion before.
    pub fell_alone: usize,
    /// Number of those that stand, but lean beyond it without any shaking.
    pub at_rest: usize,
    /// The largest lean of these, –.
    pub at_rest_most: f64,
    /// The smallest peak of the ground at which a structure that is within it at rest exceeds it, m/s²; `None` if none does.
    pub least_m_s2: Option<f64>,
    /// The largest peak that was tried, m/s².
    pub largest_m_s2: f64,
}

/// The drift ratio of a run; for a frame that leans as surveyed, including its lean.
fn drift(measures: &RunMeasures) -> Option<f64> {
    match measures {
        RunMeasures::Frame(of) => Some(of.peak_lean_ratio),
        RunMeasures::Building(of) => Some(of.peak_corner_drift_ratio),
        RunMeasures::None | RunMeasures::Stack(_) | RunMeasures::Chain(_) => None,
    }
}

/// The part of the surveyed lean in it.
fn lean(run: &Run) -> f64 {
    match run.measures {
        RunMeasures::Frame(of) => of.peak_lean_ratio - of.peak_drift_ratio,
        RunMeasures::None | RunMeasures::Stack(_) | RunMeasures::Chain(_) | RunMeasures::Building(_) => 0.0,
    }
}

/// The drift ratio of a run; infinite for a frame that leans by [`DRIFT_RATIO_MOST`](dolmen::assess::demand::DRIFT_RATIO_MOST), where its run
/// ends and no limit of a file is larger.
fn drift_of(run: &Run) -> Option<f64> {
    match run.measures {
        RunMeasures::Frame(_) if run.outcome == RunOutcome::Fell => Some(f64::INFINITY),
        _ => drift(&run.measures),
    }
}

fn is_beyond(drift: f64, limit: f64) -> bool {
    drift > limit || drift.is_nan()
}

impl CapacityOf {
    /// With the allowable drift of the file reached without any shaking, by a structure that leans beyond it; one that falls under its own weight
    /// or is refused stays as it is.
    pub(super) fn with_drift_at_rest(mut self) -> Self {
        if matches!(self.verdict, ScanVerdict::FellAlone | ScanVerdict::Refused) {
            return self;
        }
        if let Some(first) = &mut self.first_m_s2 {
            first[ALLOWED_DRIFT] = Reached::At(0.0);
        }
        self.is_beyond_at_rest = true;
        self
    }

    /// With the peak at which the allowable drift of the file is first exceeded.
    pub(super) fn with_allowed_drift(mut self, runs: &[Run], limit: f64) -> Self {
        let runs = runs.iter().filter(|run| run.scale > 0.0);
        let each = runs.filter_map(|run| {
            let seen = match (is_beyond(drift_of(run)?, limit), run.outcome.trial()) {
                (true, _) => RunInformation::Reached,
                (false, Trial::Unknown) => RunInformation::Unknown,
                (false, Trial::Fell | Trial::Survived) => RunInformation::NotReached,
            };
            Some((run.peak_ground_acceleration_m_s2, seen))
        });
        let each: Vec<(f64, RunInformation)> = each.collect();
        let beyond = each.iter().filter(|(_, seen)| *seen == RunInformation::Reached);
        let least = beyond.map(|(peak, _)| *peak).reduce(f64::min);
        if let (Some(first), Some(least)) = (&mut self.first_m_s2, least) {
            first[ALLOWED_DRIFT] = Reached::At(least);
        }
        self.seen_m_s2[ALLOWED_DRIFT] = first_seen(each.into_iter());
        self
    }
}

impl StudyAnswer {
    /// Cases in which the earlier motion already exceeds the allowable drift.
    pub(super) fn cases_beyond_before(&self, limit: f64) -> BTreeSet<usize> {
        let states = self.before.iter();
        let beyond = states.filter(|state| drift(&state.measures).is_some_and(|of| is_beyond(of, limit)));
        beyond.map(|state| state.case).collect()
    }

    /// Whether a case leans beyond the allowable drift before it is shaken.
    pub(super) fn is_beyond_at_rest(&self, case: usize) -> bool {
        let lean = self.leans_at_rest.get(case).copied().flatten();
        lean.zip(self.drift_limit)
            .is_some_and(|(lean, limit)| is_beyond(lean, limit))
    }

    /// Compares the scans with the allowable drift of the file; `None` if it gives none, varies it, or nothing was run.
    pub fn allowed_drift(&self) -> Option<AllowedDrift> {
        let limit = self.drift_limit?;
        let is_beyond = |drift: f64| is_beyond(drift, limit);
        let beyond_before = self.cases_beyond_before(limit);
        let known = self.runs.iter().filter_map(|run| Some((run, drift_of(run)?)));
        let (at_rest, known): (Vec<_>, Vec<_>) =
            known.partition(|(run, _)| self.is_beyond_at_rest(self.case_of(run.job)));
        let (before, known): (Vec<_>, Vec<_>) = known
            .into_iter()
            .partition(|(run, _)| beyond_before.contains(&self.case_of(run.job)));
        let tried = match known.is_empty() {
            true => &at_rest,
            false => &known,
        };
        let largest_m_s2 = peaks(tried).reduce(f64::max)?;
        let beyond: Vec<(&Run, f64)> = known.iter().copied().filter(|one| is_beyond(one.1)).collect();
        let fell_alone = self.runs.iter().filter(|run| run.fell_alone()).count();
        let leans = at_rest
            .iter()
            .filter_map(|(run, _)| self.leans_at_rest.get(self.case_of(run.job)).copied().flatten());
        Some(AllowedDrift {
            limit,
            before: jobs(&before),
            lean: known.iter().map(|one| lean(one.0)).fold(0.0, f64::max),
            scans: fell_alone + jobs(&at_rest) + jobs(&known),
            beyond: fell_alone + jobs(&at_rest) + jobs(&beyond),
            fell_alone,
            at_rest: jobs(&at_rest),
            at_rest_most: leans.fold(0.0, f64::max),
            least_m_s2: peaks(&beyond).reduce(f64::min),
            largest_m_s2,
        })
    }
}

/// Number of scans of runs, each with its drift.
fn jobs(runs: &[(&Run, f64)]) -> usize {
    let jobs: BTreeSet<usize> = runs.iter().map(|(run, _)| run.job).collect();
    jobs.len()
}

/// Peaks of the ground in runs, m/s².
fn peaks(runs: &[(&Run, f64)]) -> impl Iterator<Item = f64> {
    runs.iter().map(|(run, _)| run.peak_ground_acceleration_m_s2)
}
