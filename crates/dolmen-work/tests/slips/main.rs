//! Tests that Dolmen notices mistakes: those of `data/slips.csv`, each made in a shipped example; and that it accepts plausible structures.

#![allow(clippy::unwrap_used, reason = "helpers of tests: a panic is a failed test")]
#![allow(clippy::panic, reason = "helpers of tests: a panic is a failed test")]
#![allow(clippy::disallowed_methods, reason = "the examples are read from their files")]

mod caught;
mod edit;
mod folder;
mod plausible;
