//! Frame: rigid storeys with P-delta, as a timber gate (Park & Min 2010).

mod matrices;
mod storeys;

pub use storeys::{Convention, Frame, Storey, Tie, storey_axial_forces_n};
