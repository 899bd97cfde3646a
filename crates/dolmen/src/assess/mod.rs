//! From results to answers: whole checks, sensitivities, probabilities.

mod check;
mod probability;
mod sensitivity;

pub use check::{ChainCheck, FrameCheck};
pub use probability::Probability;
pub use sensitivity::{CentroidEffect, Sensitivity};
