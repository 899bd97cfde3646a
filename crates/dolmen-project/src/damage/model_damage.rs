//! Damage in the model.

use super::in_model::InModel;
use crate::survey::{DamageKind, Inspection};

/// Damage in the model.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelDamage {
    /// The survey whose inspection stated it last.
    pub survey: String,
    /// The part.
    pub part: String,
    /// Its kind in the inspection.
    pub what: DamageKind,
    /// Its name among others of its kind at the part.
    pub name: Option<String>,
    /// Its effect.
    pub effect: InModel,
    /// Its path in the file.
    pub path: String,
}

impl ModelDamage {
    /// Whether an entry of an inspection is of this damage.
    pub fn is_of(&self, one: &Inspection) -> bool {
        self.part == one.part && self.what == one.what && self.name == one.name
    }
}
