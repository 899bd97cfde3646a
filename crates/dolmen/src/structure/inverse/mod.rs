//! Stiffness of the springs of any structure from its measured modes: the search that chains and frames share.

mod continuation;
mod modal_fit;
mod newton;
mod notes;
mod options;
mod prior;
mod profile;
mod range;
mod roots;
mod search;
mod sprung;
mod starts;
mod uncertainty;

pub use options::StiffnessSearch;
pub(super) use range::range_of_root;
pub use roots::FrequencyRoots;
pub(super) use roots::roots_by_continuation;
pub(super) use search::stiffness_from_modes;
pub(super) use sprung::{SpringModel, Sprung};
