//! Modes from a measured input: the response of a structure to the motion of its ground.

mod driven_modes;
mod followed_inputs;
mod ground_ratios;
mod identify_driven;
mod lowest_response;
mod made;
mod markov_parameters;
mod observer;
mod realization;
mod refused_inputs;
mod responses;

pub use driven_modes::{Driven, DrivenMode};
pub use ground_ratios::OffGround;
pub(super) use identify_driven::of_driven;
pub use made::{MadeOnGround, MadeOneMass};
pub use responses::{FrequencyResponse, FrequencyResponses, frequency_responses};
