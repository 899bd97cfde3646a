//! The command as a user meets it, the listings of the docs, and the layout of the source.
#![allow(clippy::unwrap_used, reason = "helpers of tests: a panic is a failed test")]

mod accepted_modes;
mod aftershocks;
mod answers;
mod assemblies;
mod both_directions;
mod brief;
mod building_studies;
mod buildings;
mod by_velocity;
mod chain_axes;
mod chain_counts;
mod chain_side_posts;
mod chains;
mod chains_on_soil;
mod changed_parts;
mod changes;
mod columns;
mod damaged_models;
mod decisions;
mod demands;
mod docs;
mod documents;
mod doubted_records;
mod driven_records;
mod earthquake_records;
mod english;
mod exchanged_records;
mod figure_files;
mod first_day;
mod followed;
mod followed_alarms;
mod followed_earthquakes;
mod frame_loads;
mod frames;
mod habits;
mod handovers;
mod identified_stiffness;
mod import_circles;
mod imports;
mod inspected_years;
mod inventories;
mod judgements;
mod keys;
mod korean;
mod korean_errors;
mod korean_inputs;
mod layout;
mod leaning_frames;
mod limits;
mod links;
mod logs;
mod long_functions;
mod looked_safe;
mod loose_tenons;
mod made_up_surveys;
mod measured_beside;
mod mistaken_inputs;
mod modes_lost;
mod motion_suites;
mod mutants;
mod names;
mod not_known;
mod nrml;
mod one_stones;
mod plan_stiffness;
mod prints;
mod safety;
mod said_plainly;
mod scanned;
mod score_forms;
mod sentences;
#[cfg(all(unix, feature = "postgres"))]
mod server_faults;
#[cfg(all(unix, feature = "postgres"))]
mod server_processes;
#[cfg(all(unix, feature = "postgres"))]
mod server_stores;
#[cfg(all(unix, feature = "postgres"))]
mod servers;
#[cfg(unix)]
mod signals;
mod simulations;
mod sliding_model;
mod stack_loads;
mod stack_strength;
mod stacks;
#[cfg(target_os = "linux")]
mod still_misleading;
mod store_disks;
mod store_processes;
mod store_strangers;
mod stores;
mod studies;
mod studies_fallen;
mod supply;
mod surfaces;
mod surveyed_lean;
mod towers;
mod training;
mod tunings;
mod untrusted;
mod verbs;
mod walls;
mod watched_seasons;
mod watched_slips;
mod what_counts;
mod wind_histories;
mod wind_on_buildings;
mod workbooks;
#[cfg(target_os = "linux")]
mod writers_disks;
#[cfg(target_os = "linux")]
mod writers_killed;
mod written_back;
