//! Does it stand: critical stiffness, load factor, margins, verdicts.

mod chain;
mod error;
mod frame;
mod verdict;

pub use chain::{ChainLimits, ChainStability, JointStability};
pub use error::StabilityError;
pub use frame::{FrameStability, StoreyStability, frame_stability};
pub use verdict::Verdict;
