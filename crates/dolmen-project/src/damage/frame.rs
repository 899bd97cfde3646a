//! Damage of a frame: a storey whose joints have lost stiffness.

use super::chain::{has_it, scale};
use super::in_model::InModel;
use super::model_damage::ModelDamage;
use super::refused::refused;
use crate::frame::FramePart;
use crate::reader::Reader;
use crate::wrong::WrongDamage;

/// Puts a damage into a frame: the remaining share of every stiffness of a storey in each direction: sticking, slipping, of its tenons, and of the beds
/// of columns that stand free.
pub(super) fn damage_frame(reader: &mut Reader, (of, part): (&ModelDamage, usize), frame: &mut FramePart) {
    let InModel::StiffnessLeft(factor) = of.effect else {
        return refused(reader, of, WrongDamage::OfFrame, WrongDamage::WriteItYourself);
    };
    let mut is_on_columns_alone = false;
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
        let alone = own.value == 0.0;
        scale(own, factor);
        let slipping = direction
            .friction
            .as_mut()
            .and_then(|own| own.slipping_stiffness.as_mut());
        let tenons = direction.tenons.as_mut().map(|own| &mut own.stiffness);
        for each in [slipping, tenons].into_iter().flatten() {
            if let Some(own) = each.get_mut(part) {
                scale(own, factor);
            }
        }
        is_on_columns_alone |= alone;
    }
    let columns = frame.storeys.get_mut(part).and_then(|own| own.columns.as_mut());
    match columns.and_then(|own| own.bed_stiffness.as_mut()) {
        Some(bed) => scale(bed, factor),
        None if is_on_columns_alone => {
            refused(reader, of, WrongDamage::RigidBeds, WrongDamage::WriteItYourself)
        }
        None => {}
    }
}
