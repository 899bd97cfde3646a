//! Made records as unkind as the field's: what the identification of modes is measured against beside the kind ones of `synthetic.rs`.

mod energy;
mod plan;
mod record;
mod structures;

pub use plan::{UnkindPlan, UnkindTone};
pub use record::{UnkindMode, UnkindRecord};
