//! Tenons that crush in the runs of a frame.

use super::answer::StudyAnswer;
use super::measures::RunMeasures;
use super::run::Run;
use std::collections::BTreeSet;

/// Scans in which tenons crush.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrushedTenons {
    /// Number of scans that were run.
    pub scans: usize,
    /// Number of those in which a tenon crushes.
    pub crushed: usize,
    /// The smallest peak of the ground at which one does, m/s²; `None` if none does.
    pub least_m_s2: Option<f64>,
    /// The largest peak that was tried, m/s².
    pub largest_m_s2: f64,
    /// The deepest crushing of a face, m.
    pub depth_m: f64,
}

/// The deepest crushing of a face of a tenon in a run of a frame with tenons, m; `None` for others.
fn depth_m(run: &Run) -> Option<f64> {
    match run.measures {
        RunMeasures::Frame(of) => Some(of.crushed_depth_m).filter(|depth| !depth.is_nan()),
        RunMeasures::None | RunMeasures::Stack(_) | RunMeasures::Chain(_) | RunMeasures::Building(_) => None,
    }
}

/// Whether a run crushes tenons.
pub(super) fn crushes(run: &Run) -> bool {
    depth_m(run).is_some_and(|depth| depth > 0.0)
}

impl StudyAnswer {
    /// The scans in which tenons crush; `None` if no run has tenons that can.
    pub fn crushed_tenons(&self) -> Option<CrushedTenons> {
        let with_tenons = self.runs.iter().filter(|run| depth_m(run).is_some());
        let with_tenons: Vec<&Run> = with_tenons.collect();
        let crushed: Vec<&Run> = with_tenons.iter().copied().filter(|run| crushes(run)).collect();
        let peaks = |of: &[&Run], pick: fn(f64, f64) -> f64| {
            let each = of.iter().map(|run| run.peak_ground_acceleration_m_s2);
            each.reduce(pick)
        };
        Some(CrushedTenons {
            scans: jobs(&with_tenons),
            crushed: jobs(&crushed),
            least_m_s2: peaks(&crushed, f64::min),
            largest_m_s2: peaks(&with_tenons, f64::max)?,
            depth_m: crushed.iter().filter_map(|run| depth_m(run)).fold(0.0, f64::max),
        })
    }
}

/// Number of scans of runs.
fn jobs(runs: &[&Run]) -> usize {
    let jobs: BTreeSet<usize> = runs.iter().map(|run| run.job).collect();
    jobs.len()
}
