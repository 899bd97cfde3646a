//! Errors of the search for joint factors.

use super::super::error::BlocksError;
use super::result::UnusedMode;
use dolmen_linalg::LinalgError;

/// Why measured modes give no factor on the springs of a stack.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum JointFactorsError {
    /// No mode is given.
    #[error("no measured mode along x, along y or of torsion is given: give at least one frequency")]
    NoModes,
    /// An invalid value of a measured mode.
    #[error("{quantity} of the mode at {frequency_hz} Hz is {given}, but must be {allowed}")]
    Mode {
        /// The quantity.
        quantity: &'static str,
        /// Its value.
        given: f64,
        /// Frequency of the mode, Hz.
        frequency_hz: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// An option out of its range.
    #[error("{option} is {given}, but must be {allowed}")]
    Option {
        /// Its name.
        option: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// No measured mode can be paired with certainty.
    #[error(
        "no measured mode can be assigned to a mode of the stack: measure the mode shapes, or state which measured mode is the lowest in each direction"
    )]
    NonePaired {
        /// The modes and the reasons.
        unused: Vec<UnusedMode>,
    },
    /// The stack does not come to rest, or is refused.
    #[error(transparent)]
    Blocks(#[from] BlocksError),
    /// A decomposition failed.
    #[error(transparent)]
    Linalg(#[from] LinalgError),
}
