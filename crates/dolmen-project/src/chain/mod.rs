//! Chains: rigid links on rotational springs.

mod doubts;
mod file;
mod friction;
mod lean;
mod part;
mod read;
mod slips;
mod strength;

pub(crate) use doubts::doubt_chain;
pub(crate) use file::{CapRaw, JointRaw, LinkRaw};
pub(crate) use lean::lean_chain;
pub use part::{Cap, ChainLean, ChainPart, JointFrictionPart, JointPart, LinkPart};
pub(crate) use read::chain;
pub(crate) use slips::judge_chain;
