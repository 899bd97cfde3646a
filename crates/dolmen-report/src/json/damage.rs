//! Damage of inspections in a model, as JSON.

use crate::as_json;
use dolmen_project::{InModel, ModelDamage};
use serde_json::Value;

/// The effect of a damage on the model.
pub(super) fn damage(of: &ModelDamage) -> Value {
    let (bed_lost, side, stiffness_left) = match of.effect {
        InModel::BedLost { share, side } => (Some(share), side.map(|side| side.word()), None),
        InModel::StiffnessLeft(left) => (None, None, Some(left)),
        InModel::TiesBroken | InModel::Lost | InModel::Mended => (None, None, None),
    };
    as_json!({
        "survey": of.survey,
        "part": of.part,
        "bed_lost": bed_lost,
        "side": side,
        "stiffness_left": stiffness_left,
        "ties_broken": of.effect == InModel::TiesBroken,
        "lost": of.effect == InModel::Lost,
    })
}
