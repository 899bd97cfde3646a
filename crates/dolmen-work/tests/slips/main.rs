//! What Dolmen notices: the slips of `data/slips.csv`, each made in a shipped example, and plausible structures that it must let pass.

#![allow(clippy::unwrap_used, reason = "helpers of tests: a panic is a failed test")]
#![allow(clippy::panic, reason = "helpers of tests: a panic is a failed test")]
#![allow(clippy::disallowed_methods, reason = "the examples are read from their files")]

mod caught;
mod edit;
mod folder;
mod plausible;
