//! What bytes become which values, and which are refused with which words.
#![allow(clippy::unwrap_used, reason = "helpers of tests: a panic is a failed test")]

mod portfolios;
mod simulations;
