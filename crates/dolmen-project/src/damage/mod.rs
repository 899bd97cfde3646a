//! Damage from inspections in the model: which damage counts, and its effect on a chain, a frame, a stack.

mod as_inspected;
mod chain;
mod file;
mod frame;
mod in_model;
mod model_damage;
mod read;
mod refused;
mod stack;

pub(crate) use as_inspected::{Damaged, damaged};
pub(crate) use file::InModelRaw;
pub use in_model::{InModel, Side};
pub use model_damage::ModelDamage;
pub(crate) use read::in_model;
