/// Why a number cannot be computed. Each variant carries the value that was refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NumericError {
    /// A quantity lies outside the range in which the function is defined.
    #[error("{quantity} is {given}, but must be {allowed}")]
    Range {
        /// Name of the argument.
        quantity: &'static str,
        /// The value given.
        given: f64,
        /// What is allowed.
        allowed: &'static str,
    },
}
