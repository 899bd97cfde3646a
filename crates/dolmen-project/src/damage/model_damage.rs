//! A damage that a model has.

use super::in_model::InModel;
use crate::survey::DamageKind;

/// A damage that the model has.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelDamage {
    /// The survey whose inspection said so last.
    pub survey: String,
    /// The part.
    pub part: String,
    /// What the inspection calls it.
    pub what: DamageKind,
    /// What tells it from others of its kind at the part.
    pub name: Option<String>,
    /// What it does.
    pub effect: InModel,
    /// Where it stands in the file.
    pub path: String,
}
