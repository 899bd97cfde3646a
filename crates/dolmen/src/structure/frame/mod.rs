//! Frame: rigid storeys with P-delta, such as a timber gate (Park & Min 2010).

mod from_frequencies;
mod from_modes;
mod from_shape;
mod lean;
mod matrices;
mod range;
mod storeys;

pub use from_frequencies::stiffness_from_frequencies;
pub use from_modes::{FrameStiffness, frame_stiffness};
pub use from_shape::stiffness_from_shape;
pub use range::stiffness_range;
pub use storeys::{Convention, Frame, Storey, Tie, storey_axial_forces_n};
