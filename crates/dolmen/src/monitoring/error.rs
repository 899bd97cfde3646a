use crate::modal::ModalError;
use crate::numeric::NumericError;

/// Why a history cannot be analysed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MonitoringError {
    /// A number is invalid.
    #[error(transparent)]
    Numeric(#[from] NumericError),
    /// Modes are invalid.
    #[error(transparent)]
    Modal(#[from] ModalError),
    /// An option is outside its range.
    #[error("{option} is {given}, but must be {allowed}")]
    Option {
        /// Its name.
        option: &'static str,
        /// Its value.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// Surveys are not in order of time.
    #[error(
        "survey {survey} is on day {day}, not after the one before it: give each survey its own day, in order"
    )]
    Order {
        /// The name of the survey.
        survey: String,
        /// Its day.
        day: f64,
    },
    /// Too few surveys.
    #[error("{given} surveys, but a history needs {least}: compare two surveys instead")]
    TooFewSurveys {
        /// Number of surveys.
        given: usize,
        /// Smallest number of surveys.
        least: usize,
    },
}
