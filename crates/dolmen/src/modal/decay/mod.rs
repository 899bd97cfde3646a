//! Modes of free decays after a blow or a release, and their dependence on amplitude.

mod blows;
mod copies;
mod decay_fit;
mod decay_left;
mod decrement;
mod era;
mod identify_decay;
mod like_decay;
mod mode_decay;
mod not_modes;

pub(super) use copies::leave_out_copies;
pub use decrement::{AtAmplitude, Decrement, decrement};
pub use era::{Era, FreeDecay, era};
pub(super) use identify_decay::{SHORT, of_decay, short_spectrum};
pub use like_decay::DecaysInRecord;
pub(super) use like_decay::decays_in;
pub use mode_decay::{Decay, ModeDecay, Overtone};
