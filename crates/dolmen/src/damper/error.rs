//! Why a damper cannot be designed.

use dolmen_linalg::LinalgError;

/// Why a damper cannot be designed. Each variant carries the value that was refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DamperError {
    /// The mass ratio lies outside the range in which dampers are designed.
    #[error(
        "mass_ratio is {given}, but must lie in (0, {most}]: it is the damper's mass over the modal mass of the tuned mode, with the mode shape scaled to 1 where the damper stands"
    )]
    MassRatio {
        /// The value given, dimensionless.
        given: f64,
        /// The largest value that is allowed.
        most: f64,
    },
    /// A value out of its range.
    #[error("{argument} is {given}, but must be {allowed}")]
    Argument {
        /// Its name.
        argument: &'static str,
        /// The value given.
        given: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A search did not find an optimum.
    #[error("no optimum of {what} was found in {iterations} steps: start from another tuning")]
    NoOptimum {
        /// What was to be made small.
        what: &'static str,
        /// Steps that were made.
        iterations: usize,
    },
    /// A decomposition failed.
    #[error(transparent)]
    Linalg(#[from] LinalgError),
}
