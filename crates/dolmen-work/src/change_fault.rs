//! Why surveys cannot be compared.

use crate::known::known_beside;
use dolmen::assess::AssessError;
use dolmen::monitoring::MonitoringError;

/// Why surveys cannot be compared.
#[derive(Debug, thiserror::Error)]
pub enum ChangeFault {
    /// There is no survey of that name.
    #[error(
        "there is no survey \"{given}\" with frequencies, modes or records: the file has {}",
        known_beside(given, known)
    )]
    NoSurvey {
        /// The name given.
        given: String,
        /// Those that can be compared.
        known: String,
    },
    /// It is not clear which two.
    #[error(
        "the file has no two surveys whose names begin with a date (2019, 2019-04 or 2019-04-02), so that it is not clear which came \
         first: name them with --from and --to (it has {known})"
    )]
    Unclear {
        /// Surveys that can be compared.
        known: String,
    },
    /// Twice the same.
    #[error("survey \"{given}\" cannot be compared with itself")]
    Same {
        /// Its name.
        given: String,
    },
    /// Too few surveys to watch.
    #[error(
        "{given} surveys of the file have modes and a name that begins with a date, but a history needs {least}: measure again, or compare \
         two surveys with dolmen compare"
    )]
    TooFewToWatch {
        /// Surveys that can be watched.
        given: usize,
        /// Surveys needed.
        least: usize,
    },
    /// The history is refused.
    #[error(transparent)]
    Monitoring(#[from] MonitoringError),
    /// The comparison is refused.
    #[error(transparent)]
    Assess(#[from] AssessError),
}
