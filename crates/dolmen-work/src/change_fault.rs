//! Reasons why surveys cannot be compared.

use dolmen::assess::AssessError;
use dolmen::monitoring::MonitoringError;

/// Why surveys cannot be compared.
#[derive(Debug)]
pub enum ChangeFault {
    /// There is no survey of that name.
    NoSurvey {
        /// The name given.
        given: String,
        /// Names of comparable surveys.
        known: String,
    },
    /// Which two surveys to compare is unclear.
    Unclear {
        /// Surveys that can be compared.
        known: String,
    },
    /// Both surveys are the same.
    Same {
        /// Its name.
        given: String,
    },
    /// Two dates have the same record.
    SameRecord {
        /// Names of both surveys.
        surveys: [String; 2],
        /// The file of each.
        files: [String; 2],
    },
    /// Too few surveys to watch.
    TooFewToWatch {
        /// Surveys that can be watched.
        given: usize,
        /// Surveys needed.
        least: usize,
    },
    /// The history is refused.
    Monitoring(MonitoringError),
    /// The comparison is refused.
    Assess(AssessError),
}
