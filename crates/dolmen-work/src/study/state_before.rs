//! The state of a structure after the motion before the runs of a study.

use super::measures::RunMeasures;
use super::run::{Run, RunOutcome};
use dolmen_words::message::Both;

/// The state of one case after the earlier motion.
#[derive(Clone, Debug, PartialEq)]
pub struct StateBefore {
    /// The case, from 0.
    pub case: usize,
    /// Largest horizontal peak of that motion, m/s²; 0 without one.
    pub peak_m_s2: f64,
    /// Outcome of the run under that motion alone.
    pub outcome: RunOutcome,
    /// 0 to 4.
    pub damage_state: u8,
    /// States of the joints of a stack.
    pub joint_states: Vec<u8>,
    /// Time of the fall, s; NaN without one.
    pub at_s: f64,
    /// The part that fell or lies on the brink.
    pub part: String,
    /// The joint that gave way.
    pub gave_way: String,
    /// The numbers of that run.
    pub measures: RunMeasures,
    /// Duration of still ground afterwards, s; NaN if nothing follows.
    pub still_s: f64,
    /// Largest speed of any part at the end of that time, m/s; NaN if nothing follows.
    pub speed_m_s: f64,
    /// Why nothing follows.
    pub why: Both,
}

impl StateBefore {
    pub(super) fn of(case: usize, peak_m_s2: f64, run: &Run) -> Self {
        StateBefore {
            case,
            peak_m_s2,
            outcome: run.outcome,
            damage_state: run.damage_state,
            joint_states: run.joint_states.clone(),
            at_s: run.at_s,
            part: run.part.clone(),
            gave_way: run.gave_way.clone(),
            measures: run.measures,
            still_s: f64::NAN,
            speed_m_s: f64::NAN,
            why: run.why.clone(),
        }
    }

    /// The row of a run for a structure that fell in the earlier motion.
    pub(super) fn fallen(&self, job: usize) -> Run {
        Run {
            outcome: RunOutcome::Fell,
            damage_state: self.damage_state,
            joint_states: self.joint_states.clone(),
            at_s: self.at_s,
            part: self.part.clone(),
            gave_way: self.gave_way.clone(),
            ..Run::empty(job)
        }
    }
}
