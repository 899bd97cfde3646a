//! Chains: rigid links on rotational springs.

mod doubts;
mod file;
mod friction;
mod part;
mod read;
mod slips;
mod strength;

pub(crate) use doubts::doubt_chain;
pub(crate) use file::{CapRaw, JointRaw, LinkRaw};
pub use part::{Cap, ChainPart, JointFrictionPart, JointPart, LinkPart};
pub(crate) use read::chain;
pub(crate) use slips::judge_chain;
