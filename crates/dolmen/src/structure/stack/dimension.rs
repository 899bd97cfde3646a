//! Checks of the dimensions of generated structures.

use super::StackError;

/// Checks that each dimension is a positive number.
///
/// # Errors
/// [`StackError::Dimension`] for the first dimension that is not positive.
pub(super) fn all_positive(dimensions: &[(&'static str, f64)]) -> Result<(), StackError> {
    for &(quantity, given) in dimensions {
        if !(given > 0.0 && given.is_finite()) {
            return Err(refused(quantity, given, "a positive number"));
        }
    }
    Ok(())
}

/// The error for a dimension out of its range.
pub(super) fn refused(quantity: &'static str, given: f64, allowed: &'static str) -> StackError {
    StackError::Dimension {
        quantity,
        given,
        allowed,
    }
}
