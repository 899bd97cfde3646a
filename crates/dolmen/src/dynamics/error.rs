//! Why a structure cannot be moved in time.

use crate::structure::StructureError;
use dolmen_linalg::LinalgError;

/// Why a simulation cannot start or cannot go on. How one that ran ended is a status in its result.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DynamicsError {
    /// A value out of its range.
    #[error("{argument} is {given}, but must be {allowed}")]
    Argument {
        /// Its name.
        argument: &'static str,
        /// The value given.
        given: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A value of one storey out of its range.
    #[error("storey {storey}: {argument} is {given}, but must be {allowed}")]
    Storey {
        /// The storey, 1 the lowest.
        storey: usize,
        /// The name of the value.
        argument: &'static str,
        /// The value given.
        given: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A list of the wrong length.
    #[error("{argument} has {given} entries, but the frame has {needed} storeys: give one for each")]
    Count {
        /// The name of the list.
        argument: &'static str,
        /// Its length.
        given: usize,
        /// The number of storeys.
        needed: usize,
    },
    /// No stick and slip of the storeys agrees with Coulomb's law at an event.
    #[error(
        "at {at_s} s no state of sticking and slipping was found in {tried} tries: the friction of some storey is far below the others', or the numbers of the frame lie too far apart"
    )]
    NoState {
        /// When, s.
        at_s: f64,
        /// States tried.
        tried: usize,
    },
    /// Events follow each other without end.
    #[error(
        "{events} changes between sticking and slipping within 1e-9 s of {at_s} s: look at the friction forces, of which one may be next to nothing"
    )]
    TooManyEvents {
        /// When, s.
        at_s: f64,
        /// Changes counted.
        events: usize,
    },
    /// The frame cannot be.
    #[error(transparent)]
    Structure(#[from] StructureError),
    /// A decomposition failed.
    #[error(transparent)]
    Linalg(#[from] LinalgError),
}
