//! All external numbers that this crate must reproduce: published and computed values, with the correct value if
//! the published one is wrong.

mod aftershocks;
mod arches;
mod building_motion;
mod buildings;
mod case;
mod cases;
mod choi_2021;
mod chopra_2017;
mod columns;
mod crushing;
mod dampers;
mod driven_modes;
mod dry_friction;
mod earthquakes;
mod error;
mod fragility;
mod free_columns;
mod free_decay;
mod free_walls;
mod gusts;
mod hwang_min_hong;
mod joined;
mod kim_koo_hong_2018;
mod local_mechanisms;
mod owen_prieur_2017;
mod park_min_2010;
mod pushed_frames;
mod pyoma2;
mod restitution;
mod rigid_blocks;
mod second_methods;
mod setups;
mod sliced_scans;
mod stacks;
mod survey_change;
mod tenons;
mod watch;
mod wind;

pub use buildings::{twenty_storeys, twenty_storeys_mass, twisting_floor};
pub use case::Case;
pub use cases::cases;
pub use choi_2021::naju_flagpole;
pub use error::ValidationError;
pub use park_min_2010::{heunginjimun_gate, heunginjimun_gate_as_printed};
pub use stacks::{p10, p20};
