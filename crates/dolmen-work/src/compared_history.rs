//! What all surveys of a structure say beside two that are compared.

use dolmen_project::WorkPart;

/// What all surveys say beside the two that are compared.
#[derive(Clone, Debug)]
pub struct ComparedHistory {
    /// Number of surveys.
    pub surveys: usize,
    /// Names of the first and the last.
    pub span: [String; 2],
    /// Lasting changes between the two, as `watch` finds them, by time.
    pub lasting: Vec<LastingChange>,
}

/// A lasting change between two surveys.
#[derive(Clone, Debug)]
pub struct LastingChange {
    /// Median frequency of the mode, Hz.
    pub frequency_hz: f64,
    /// When and how.
    pub course: Course,
    /// Relative change: of a drift, up to the last survey.
    pub ratio: f64,
    /// Its standard deviation.
    pub sd: f64,
}

/// The course of a lasting change.
#[derive(Clone, Debug)]
pub enum Course {
    /// A step after one survey and before another.
    Step {
        /// After this one,
        after: String,
        /// and before this one.
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
