//! Mathematics that knows nothing of structures: roots, statistics, seeded random numbers, Fourier transforms.

mod assignment;
mod chi_squared;
mod complex_solve;
mod crossing;
mod elementary;
mod error;
mod fisher;
mod highest;
mod levenberg_marquardt;
mod lyapunov;
mod minimax;
mod normal;
mod quadrature;
mod random;
mod roots;
mod statistics;
mod student;

pub use assignment::assignment;
pub use chi_squared::{chi_squared_above, chi_squared_quantile};
pub(crate) use complex_solve::complex_solve;
pub(crate) use crossing::{COEFFICIENTS_MOST, first_descent, polynomial, polynomial_most};
pub use error::NumericError;
pub use fisher::fisher_quantile;
pub(crate) use highest::highest;
pub(crate) use levenberg_marquardt::{LeastSquaresFit, Residuals, levenberg_marquardt};
pub(crate) use lyapunov::lyapunov;
pub(crate) use minimax::{Minimax, Piece, Worst, all_by_differences, by_differences, minimax};
pub(crate) use normal::{ln_normal_density, normal_hazard};
pub use normal::{ln_normal_probability, normal_probability, normal_quantile};
pub(crate) use quadrature::{adaptive_nodes, nodes_15};
pub use random::Random;
pub use roots::{Bracketing, bracketed_root};
pub(crate) use statistics::middle;
pub use statistics::{Interval, clopper_pearson, mean, quantile, variance};
pub use student::{student_detectable, student_two_sided, student_two_sided_quantile};
