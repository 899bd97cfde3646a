/// Why a number cannot be computed. Each variant contains the refused value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NumericError {
    /// A quantity lies outside the range in which the function is defined.
    #[error("{quantity} is {given}, but must be {allowed}")]
    Range {
        /// Name of the argument.
        quantity: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// A count lies outside the range in which the function is defined.
    #[error("{quantity} is {given}, but must be between {least} and {most}")]
    Count {
        /// Name of the argument.
        quantity: &'static str,
        /// The value given.
        given: u64,
        /// Smallest allowed value.
        least: u64,
        /// Largest allowed value.
        most: u64,
    },
    /// One of many values is not finite.
    #[error("value {number} of {quantity} is {given}, but must be a finite number")]
    NotFinite {
        /// Name of the quantity.
        quantity: &'static str,
        /// Position of the value, from 1.
        number: usize,
        /// The value given.
        given: f64,
    },
    /// The function has the same sign at both ends.
    #[error(
        "no sign change: the function is {at_a} at {a} and {at_b} at {b}; choose ends where it differs in sign"
    )]
    NoSignChange {
        /// One end.
        a: f64,
        /// The other end.
        b: f64,
        /// Value at one end.
        at_a: f64,
        /// Value at the other end.
        at_b: f64,
    },
    /// The function gave NaN.
    #[error("the function is not a number at {x}")]
    NotANumber {
        /// Argument at which it occurred.
        x: f64,
    },
    /// A search did not converge.
    #[error("no root within {most} evaluations: raise evaluations_most or width_most")]
    Evaluations {
        /// Largest number of evaluations.
        most: usize,
    },
}
