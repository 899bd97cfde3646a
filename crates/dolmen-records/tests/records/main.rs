//! Tests which bytes give which values, and which input is refused with which words.
#![allow(clippy::unwrap_used, reason = "helpers of tests: a panic is a failed test")]

mod csv_records;
mod csv_stamps;
mod korean_logs;
mod motion_formats;
mod motion_networks;
mod motion_responses;
mod motions;
mod npy_records;
mod palisaden;
mod record_formats;
mod uff_modes;
mod workbook_records;
