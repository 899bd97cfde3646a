use crate::structure::StructureError;
use dolmen_linalg::LinalgError;

/// Why stability cannot be assessed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StabilityError {
    /// The stiffnesses do not fit the structure.
    #[error(transparent)]
    Structure(#[from] StructureError),
    /// A decomposition failed.
    #[error(transparent)]
    Linalg(#[from] LinalgError),
}
