//! The few matrix decompositions that Dolmen uses, on [faer](https://docs.rs/faer), non-generic so that they
//! compile here once, optimised, and not in each caller.
//!
//! Every function checks first that its input is finite and of a fitting shape: faer's symmetric eigensolver
//! returns `Ok` on NaN. All of them run on one thread: the same input gives the same bits.

mod decompose;
mod error;
mod hermitian_values;
mod leading;
mod matrix;
mod product;
mod triangular;

pub use decompose::{
    Eigen, HermitianEigen, Qr, Svd, SymmetricEigen, cholesky, eigen, generalized_symmetric_eigen,
    hermitian_eigen, qr, solve, solve_least_squares, svd, symmetric_eigen, symmetric_eigenvalues,
};
pub use error::LinalgError;
pub use hermitian_values::hermitian_eigenvalues;
pub use leading::{Operator, leading_svd};
pub use matrix::{ComplexMatrix, Matrix};
pub use num_complex::Complex64;
pub use triangular::{cholesky_in_its_place, solve_lower, solve_lower_transposed};
