//! Project files that are read, with their values, and files that are rejected, with the messages.
#![allow(clippy::unwrap_used, reason = "helpers of tests: a panic is a failed test")]

mod korean_errors;
mod project;
mod project_book;
mod project_building;
mod project_chain_motion;
mod project_columns;
mod project_cornices;
mod project_frame_loads;
mod project_friction;
mod project_keys;
mod project_loads;
mod project_modes;
mod project_names;
mod project_report;
mod project_shapes;
mod project_site;
mod project_stack;
mod project_surveys;
mod project_tables;
mod project_values;
mod stations;
mod three_setups;
