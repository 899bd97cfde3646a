//! Mathematics that knows nothing of structures: roots, statistics, seeded random numbers, Fourier transforms.

mod elementary;
mod error;
mod random;
mod roots;
mod statistics;

pub use error::NumericError;
pub use random::Random;
pub use roots::{Bracketing, bracketed_root};
pub use statistics::{Interval, clopper_pearson, mean, quantile, variance};
