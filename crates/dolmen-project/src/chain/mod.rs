//! Chains: rigid links on rotational springs.

mod axes;
mod axis;
mod doubts;
mod file;
mod friction;
mod lean;
mod part;
mod read;
mod side_supports;
mod slips;
mod stone;
mod strength;
mod support_part;

pub use axis::ChainAxis;
pub(crate) use doubts::doubt_chain;
pub(crate) use file::{CapRaw, JointRaw, LinkRaw, StoneRaw};
pub(crate) use lean::lean_chain;
pub use lean::tilt_of_axes;
pub use part::{Cap, ChainLean, ChainPart, JointFrictionPart, JointPart, LinkPart, StonePart};
pub(crate) use read::chain;
pub(crate) use slips::judge_chain;
pub use support_part::ChainSupportPart;
