//! Mathematics that knows nothing of structures: roots, statistics, seeded random numbers, Fourier transforms.

mod elementary;
mod error;
mod random;

pub use error::NumericError;
pub use random::Random;
