//! From results to answers: whole checks, sensitivities, probabilities.

mod chain;
pub mod demand;
mod error;
mod frame;
mod probability;
mod sensitivity;
mod stack;

pub use chain::{CENTROID_CHANGE, ChainCheck, centroid_effect, check_chain};
pub use error::AssessError;
pub use frame::{FrameCheck, FrameNote, check_frame};
pub use probability::{Distribution, Probability, probability, sampled};
pub use sensitivity::{CentroidEffect, Sensitivity, elasticity};
pub use stack::{StackCheck, StackCheckOptions, StackNote, check_stack};
