//! One run of a study: its key and its outcome.

use super::measures::RunMeasures;
use dolmen_words::message::Both;

/// End of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum RunOutcome {
    /// Nothing moved except within springs; for a frame: the run is complete.
    Stood,
    /// Joints opened.
    Uplifted,
    /// A stone lies on the brink.
    Slid,
    /// A stone or a link fell; for a frame: it leaned beyond the drift limit.
    Fell,
    /// Still in motion at the end of the run: no verdict.
    StillMoving,
    /// The run is unusable.
    Diverged,
    /// Its inputs were refused: nothing was run.
    Refused,
}

impl RunOutcome {
    const ALL: [(RunOutcome, &'static str); 7] = [
        (RunOutcome::Stood, "stood"),
        (RunOutcome::Uplifted, "uplifted"),
        (RunOutcome::Slid, "slid"),
        (RunOutcome::Fell, "fell"),
        (RunOutcome::StillMoving, "still moving"),
        (RunOutcome::Diverged, "diverged"),
        (RunOutcome::Refused, "refused"),
    ];

    /// The word of tables and of JSON.
    pub fn word(self) -> &'static str {
        let found = Self::ALL.iter().find(|(outcome, _)| *outcome == self);
        found.map_or("refused", |(_, word)| word)
    }

    pub(super) fn of_word(word: &str) -> Option<Self> {
        let found = Self::ALL.iter().find(|(_, known)| *known == word);
        found.map(|(outcome, _)| *outcome)
    }
}

/// One run: a row of the table.
#[derive(Clone, Debug)]
pub struct Run {
    /// Index of the case, motion and direction: its scan.
    pub job: usize,
    /// Factor on the motion, –; 0 if the inputs were refused, or if the structure falls by its own weight.
    pub scale: f64,
    /// Largest horizontal peak of the ground, before the rotation, m/s².
    pub peak_ground_acceleration_m_s2: f64,
    /// Largest velocity of that component, m/s.
    pub peak_ground_velocity_m_s: f64,
    /// Its outcome.
    pub outcome: RunOutcome,
    /// 0 to 4: DS1 to DS4. For a building the number of drift limits reached; for a frame 1 if it slips or crushes a tenon and 4 at the drift limit; for a chain 1
    /// if a joint opens or turns against friction.
    pub damage_state: u8,
    /// For a stack: the damage state of each joint, 0 to 4, in the order of its joints.
    pub joint_states: Vec<u8>,
    /// Time at which a stone or a link fell or the limit was reached, s; NaN without one.
    pub at_s: f64,
    /// The stone that fell or lies on the brink, the link that fell, or the storey at its limit.
    pub part: String,
    /// The joint that gave way.
    pub gave_way: String,
    /// Its numbers.
    pub measures: RunMeasures,
    /// Why its inputs were refused, or why it falls by itself.
    pub why: Both,
}

impl Run {
    /// The row of a scan without results.
    pub(super) fn empty(job: usize) -> Self {
        Run {
            job,
            scale: 0.0,
            peak_ground_acceleration_m_s2: f64::NAN,
            peak_ground_velocity_m_s: f64::NAN,
            outcome: RunOutcome::Stood,
            damage_state: 0,
            joint_states: Vec::new(),
            at_s: f64::NAN,
            part: String::new(),
            gave_way: String::new(),
            measures: RunMeasures::None,
            why: Both::default(),
        }
    }

    /// Whether nothing was run because the inputs were refused.
    pub fn is_refused(&self) -> bool {
        self.scale == 0.0 && self.outcome == RunOutcome::Refused
    }

    /// Whether nothing was run because the structure falls under its own weight, or fell in the motion before.
    pub fn fell_alone(&self) -> bool {
        self.scale == 0.0 && self.outcome == RunOutcome::Fell
    }

    /// Equal to the last bit.
    pub fn is_same(&self, other: &Run) -> bool {
        let bits = |run: &Run| -> Vec<u64> {
            let own = [
                run.scale,
                run.peak_ground_acceleration_m_s2,
                run.peak_ground_velocity_m_s,
                run.at_s,
            ];
            own.iter()
                .chain(&run.measures.values())
                .map(|value| value.to_bits())
                .collect()
        };
        let words = |run: &Run| (run.part.clone(), run.gave_way.clone(), run.why.clone());
        let states = |run: &Run| (run.job, run.outcome, run.damage_state, run.joint_states.clone());
        states(self) == states(other) && bits(self) == bits(other) && words(self) == words(other)
    }
}
