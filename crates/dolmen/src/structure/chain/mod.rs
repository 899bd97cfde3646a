//! Chain: n rigid links on rotational springs, such as a flagpole of stacked stones.

mod added_mass;
mod from_modes;
mod links;
mod matrices;
mod motion;
mod side_support;
mod single_mass;

pub use added_mass::AddedMass;
pub use from_modes::{ChainStiffness, chain_stiffness};
pub use links::{Chain, Inertia, Link};
pub use side_support::SideSupport;
pub use single_mass::SingleMass;
