//! Stiffness of springs from measured modes: the search that chains and frames share.

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
mod spring_model;
mod sprung;
mod starts;
mod stiffness_from_modes;
mod uncertainty;

pub use options::StiffnessSearch;
pub(super) use range::range_of_root;
pub use roots::FrequencyRoots;
pub(super) use roots::roots_by_continuation;
pub(super) use spring_model::SpringModel;
pub(super) use sprung::Sprung;
pub(super) use stiffness_from_modes::stiffness_from_modes;
