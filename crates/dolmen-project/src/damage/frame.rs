//! Damage of a frame: a storey whose joints have lost stiffness.

use super::chain::{has_it, scale};
use super::in_model::InModel;
use super::model_damage::ModelDamage;
use super::refused::refused;
use crate::frame::FramePart;
use crate::reader::Reader;
use crate::wrong::WrongDamage;

/// Puts a damage into a frame: the remaining share of the lateral stiffness of a storey, in each direction.
pub(super) fn damage_frame(reader: &mut Reader, (of, part): (&ModelDamage, usize), frame: &mut FramePart) {
    let InModel::StiffnessLeft(factor) = of.effect else {
        return refused(reader, of, WrongDamage::OfFrame, WrongDamage::WriteItYourself);
    };
    for at in 0..frame.directions.len() {
        let direction = &mut frame.directions[at];
        if direction.sought.is_some() {
            return refused(reader, of, WrongDamage::Sought, WrongDamage::LeaveStiffnessOut);
        }
        let own = direction.stiffness.as_mut().and_then(|all| all.get_mut(part));
        let Some(own) = own else {
            return refused(reader, of, WrongDamage::NoStiffness, WrongDamage::GiveStiffness);
        };
        if let Some(survey) = own
            .survey
            .clone()
            .filter(|survey| has_it(Some(survey), &of.survey))
        {
            let why = WrongDamage::AlreadyIn(survey);
            return refused(reader, of, why, WrongDamage::LeaveStiffnessOut);
        }
        scale(own, factor);
    }
}
