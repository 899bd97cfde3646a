//! Tests which bytes give which values, and which input is refused with which words.
#![allow(clippy::unwrap_used, reason = "helpers of tests: a panic is a failed test")]

mod compared_variants;
mod portfolios;
mod simulations;
