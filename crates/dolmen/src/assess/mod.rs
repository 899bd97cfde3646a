//! From results to answers: whole checks, sensitivities, probabilities.

mod check;
mod error;
mod frame;
mod probability;
mod sensitivity;

pub use check::ChainCheck;
pub use error::AssessError;
pub use frame::{FrameCheck, check_frame};
pub use probability::Probability;
pub use sensitivity::{CentroidEffect, Sensitivity};
