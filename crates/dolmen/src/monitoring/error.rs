use crate::modal::ModalError;
use crate::numeric::NumericError;

/// Why a history cannot be watched.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MonitoringError {
    /// A number is refused.
    #[error(transparent)]
    Numeric(#[from] NumericError),
    /// Modes are refused.
    #[error(transparent)]
    Modal(#[from] ModalError),
    /// An option lies outside its range.
    #[error("{option} is {given}, but must be {allowed}")]
    Option {
        /// Which.
        option: &'static str,
        /// Its value.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// Surveys that do not follow one another.
    #[error(
        "survey {survey} is on day {day}, not after the one before it: give each survey its own day, in order"
    )]
    Order {
        /// Which.
        survey: String,
        /// Its day.
        day: f64,
    },
    /// Too few surveys.
    #[error("{given} surveys, but a history needs {least}: compare two surveys instead")]
    TooFewSurveys {
        /// Surveys given.
        given: usize,
        /// Surveys needed.
        least: usize,
    },
}
