//! Every published number and every exact law that this crate must reproduce; one file for one source.
#![allow(clippy::unwrap_used, reason = "helpers of tests: a panic is a failed test")]

mod building_dampers;
mod building_history;
mod building_modes;
mod building_spectra;
mod chain_friction;
mod chain_identification;
mod chain_laws;
mod chain_maps;
mod chain_motion;
mod choi_2021;
mod columns;
mod damper_designs;
mod dampers;
mod draws;
mod el_centro;
mod frame_edges;
mod frame_friction;
mod frame_laws;
mod ground_motions;
mod limit_analysis_microlp;
mod liquid_columns;
mod made_records;
mod park_min_2010;
mod pyoma2;
mod rocking_and_sliding;
mod rocking_block;
mod sliding_pile;
mod stack_contacts;
mod stack_ends;
mod stack_limits;
mod stack_motion;
mod stack_rigid;
mod stack_rocking;
mod tuned_mass;
