/// Reason why a decomposition cannot be computed. Each variant contains the refused value.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum LinalgError {
    /// An entry is NaN or infinite.
    #[error(
        "{what}: the entry in row {row}, column {column} is {value}, but every entry must be a finite number"
    )]
    NotFinite {
        /// The operation that refused it.
        what: &'static str,
        /// Row, from 0.
        row: usize,
        /// Column, from 0.
        column: usize,
        /// The entry.
        value: f64,
    },
    /// The shape does not fit the operation.
    #[error("{what}: the matrix is {rows} × {columns}, but must be {needed}")]
    Shape {
        /// The operation that refused it.
        what: &'static str,
        /// Number of rows.
        rows: usize,
        /// Number of columns.
        columns: usize,
        /// The allowed range.
        needed: &'static str,
    },
    /// A Cholesky pivot is not positive.
    #[error("{what}: the matrix is not positive definite")]
    NotPositiveDefinite {
        /// The operation that refused it.
        what: &'static str,
    },
    /// A pivot is zero to working precision.
    #[error("{what}: the matrix is singular to working precision")]
    Singular {
        /// The operation that refused it.
        what: &'static str,
    },
    /// An iteration did not converge.
    #[error("{what}: the iteration did not converge")]
    NoConvergence {
        /// The operation that failed.
        what: &'static str,
    },
}

impl LinalgError {
    /// Whether an iteration ended before it converged: the input may be valid.
    pub fn did_not_converge(&self) -> bool {
        match self {
            Self::NoConvergence { .. } => true,
            Self::NotFinite { .. }
            | Self::Shape { .. }
            | Self::NotPositiveDefinite { .. }
            | Self::Singular { .. } => false,
        }
    }
}
