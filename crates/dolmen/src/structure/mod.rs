//! Structures as checked values: mass, damping and stiffness matrices; natural modes; stiffness from modes.

mod chain;
mod directional;
mod error;
mod frame;
mod identification;
mod natural;

pub use chain::{Chain, ChainStiffness, Inertia, Link, SideSupport, SingleMass, chain_stiffness};
pub use directional::{DirectionalModes, LeftOut, directional_modes};
pub use error::StructureError;
pub use frame::{Convention, Frame, Storey, Tie, storey_axial_forces_n};
pub use identification::{
    Choice, MeasuredMode, ShapePoint, StiffnessRange, StiffnessSolution, StiffnessSolutions, Visibility,
};
pub use natural::NaturalMode;
