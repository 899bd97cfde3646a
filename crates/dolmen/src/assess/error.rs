use crate::numeric::NumericError;
use crate::stability::StabilityError;
use crate::structure::StructureError;

/// Why a structure cannot be assessed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AssessError {
    /// The structure or its stiffness is refused.
    #[error(transparent)]
    Structure(#[from] StructureError),
    /// Stability cannot be assessed.
    #[error(transparent)]
    Stability(#[from] StabilityError),
    /// A number is refused.
    #[error(transparent)]
    Numeric(#[from] NumericError),
}
