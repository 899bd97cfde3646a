//! What can calm a structure: tuned masses and liquid columns, their tuning and their place.

mod error;
mod single_mode;
mod tuning;

pub use error::DamperError;
pub use single_mode::{Aim, OptimalTuning, SingleMode, optimal_tuning};
pub use tuning::{Tuning, TuningRule, rule_tuning};
