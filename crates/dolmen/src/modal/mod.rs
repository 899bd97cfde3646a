//! Modes from ambient vibration: frequency, damping ratio and shape, each with its standard deviation.

mod error;
mod modes;

pub use error::ModalError;
pub use modes::{Method, Mode, Modes};
