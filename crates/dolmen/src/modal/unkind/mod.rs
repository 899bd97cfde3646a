//! Simulated records with the disturbances of field measurements, as a harder test of the identification than those of `synthetic.rs`.

mod energy;
mod plan;
mod record;
mod structures;

pub use plan::{UnkindPlan, UnkindTone};
pub use record::{UnkindMode, UnkindRecord};
