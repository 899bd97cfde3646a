//! Vibration records: what was measured, where, and what has been done to it since.

mod error;
mod record;

pub use error::SignalError;
pub use record::{Channel, Processing, Quantity, Record};
