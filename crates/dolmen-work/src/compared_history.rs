//! Findings from all surveys of a structure, added to the comparison of two.

use dolmen_project::WorkPart;

/// Findings from all surveys, added to the comparison of two.
#[derive(Clone, Debug)]
pub struct ComparedHistory {
    /// Number of surveys.
    pub surveys: usize,
    /// Names of the first and last survey.
    pub span: [String; 2],
    /// Lasting changes between the two, as `watch` finds them, by time.
    pub lasting: Vec<LastingChange>,
    /// Surveys before the first and after the last one whose modes are compared: their weather is not known, so that no test would hold.
    pub passed_over: Vec<String>,
}

/// A lasting change between two surveys.
#[derive(Clone, Debug)]
pub struct LastingChange {
    /// Median frequency of the mode, Hz.
    pub frequency_hz: f64,
    /// Its course in time.
    pub course: Course,
    /// Relative change; for a drift, up to the last survey.
    pub ratio: f64,
    /// Its standard deviation.
    pub sd: f64,
}

/// The course of a lasting change.
#[derive(Clone, Debug)]
pub enum Course {
    /// A step after one survey and before another.
    Step {
        /// The survey before the step.
        after: String,
        /// The survey after the step.
        before: String,
    },
    /// A drift since about this survey.
    Drift {
        /// The survey.
        since: String,
    },
    /// The effect of a repair.
    Repair(WorkPart),
}
