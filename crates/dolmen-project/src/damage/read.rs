//! Reads the effect of a damage on the model.

use super::file::{InModelRaw, SideRaw};
use super::in_model::{InModel, Side};
use crate::error::Fault;
use crate::file_number::At;
use crate::reader::Reader;
use crate::wrong::WrongDamage;

/// Bounds of shares: less counts as nothing, more as the whole. Our choice.
const LOST: [f64; 2] = [0.01, 0.95];
const LEFT: [f64; 2] = [0.01, 1.0];

/// The effect, by exactly one key.
pub(crate) fn in_model(reader: &mut Reader, raw: Option<&At<InModelRaw>>, path: &str) -> Option<InModel> {
    let raw = raw?;
    reader.mark(path, &raw.span);
    let of = &raw.value;
    let is = |key: &Option<At<bool>>| key.as_ref().is_some_and(|given| given.value);
    let given = [
        of.bed_lost.is_some(),
        of.stiffness_left.is_some(),
        is(&of.ties_broken),
        is(&of.lost),
        is(&of.mended),
    ];
    let count = given.into_iter().filter(|given| *given).count();
    if count != 1 {
        let message = WrongDamage::NotOne {
            path: path.to_owned(),
            count,
        };
        reader.fault(Fault::new(raw.span.clone(), path, message).allowed(WrongDamage::MustBeOne));
        return None;
    }
    if let Some(side) = of.side.as_ref().filter(|_| of.bed_lost.is_none()) {
        let path = format!("{path}.side");
        let message = WrongDamage::SideOfNothing(path.clone());
        reader.fault(Fault::new(side.span.clone(), &path, message).help(WrongDamage::LeaveSideOut));
        return None;
    }
    if of.bed_lost.is_some() {
        let [least, most] = LOST;
        let share = reader.within(of.bed_lost.as_ref(), &format!("{path}.bed_lost"), least, most)?;
        let side = of.side.as_ref().map(|side| match side.value {
            SideRaw::XPlus => Side::XPlus,
            SideRaw::XMinus => Side::XMinus,
            SideRaw::YPlus => Side::YPlus,
            SideRaw::YMinus => Side::YMinus,
        });
        return Some(InModel::BedLost { share, side });
    }
    if of.stiffness_left.is_some() {
        let [least, most] = LEFT;
        let path = format!("{path}.stiffness_left");
        let left = reader.within(of.stiffness_left.as_ref(), &path, least, most)?;
        return Some(InModel::StiffnessLeft(left));
    }
    Some(match (is(&of.ties_broken), is(&of.lost)) {
        (true, _) => InModel::TiesBroken,
        (_, true) => InModel::Lost,
        _ => InModel::Mended,
    })
}
