//! Damage of a stack: a bed that has lost a part or stiffness, broken dowels and clamps, a missing stone.

use super::chain::has_it;
use super::in_model::InModel;
use super::model_damage::ModelDamage;
use super::refused::refused;
use crate::reader::Reader;
use crate::stack::{LoosenedBedPart, LostBedPart, ShapePart, StackPart};
use crate::wrong::WrongDamage;
use dolmen::structure::stack::Body;

/// Carries a damage into a stack.
pub(super) fn damage_stack(reader: &mut Reader, (of, part): (&ModelDamage, usize), stack: &mut StackPart) {
    match of.effect {
        InModel::BedLost { side: None, .. } => {
            refused(reader, of, WrongDamage::NoSide, WrongDamage::GiveSide);
        }
        InModel::BedLost {
            share,
            side: Some(side),
        } => {
            let own = stack.blocks.iter().find(|block| block.name == of.part);
            if own.is_some_and(|block| matches!(block.shape, ShapePart::Mesh(_))) {
                return refused(reader, of, WrongDamage::OfMesh, WrongDamage::WriteItYourself);
            }
            stack.lost_beds.push(LostBedPart {
                block: of.part.clone(),
                share,
                outward: side.outward(),
                path: of.path.clone(),
            });
        }
        InModel::TiesBroken => break_ties(reader, (of, part), stack),
        InModel::Lost => lose(reader, of, stack),
        InModel::StiffnessLeft(factor) => loosen(reader, of, stack, factor),
        InModel::Mended => {}
    }
}

/// Scales normal and shear stiffness of the bed below a stone.
fn loosen(reader: &mut Reader, of: &ModelDamage, stack: &mut StackPart, factor: f64) {
    let identified = stack.bed_identified_from(&of.part);
    if let Some(survey) = identified.filter(|own| has_it(Some(own), &of.survey)) {
        let why = WrongDamage::AlreadyIn(survey.to_owned());
        return refused(reader, of, why, WrongDamage::LeaveStiffnessOut);
    }
    stack.loosened_beds.push(LoosenedBedPart {
        block: of.part.clone(),
        factor,
        path: of.path.clone(),
    });
}

/// Removes the dowels and clamps between a stone and the stones below it.
fn break_ties(reader: &mut Reader, (of, block): (&ModelDamage, usize), stack: &mut StackPart) {
    let before = stack.ties.len();
    let below = |lower: Body, upper: usize| {
        let stands_on = |body: &Body| stack.blocks.get(block).is_some_and(|own| own.on.contains(body));
        upper == block || (lower == Body::Block(block) && stands_on(&Body::Block(upper)))
    };
    let kept: Vec<_> = stack
        .ties
        .iter()
        .filter(|tie| !below(tie.lower, tie.upper))
        .cloned()
        .collect();
    stack.ties = kept;
    if stack.ties.len() == before {
        refused(reader, of, WrongDamage::NoTies, WrongDamage::LeaveModelOut);
    }
}

/// Removes a stone, with its joints and ties, unless another stone stands on it alone.
fn lose(reader: &mut Reader, of: &ModelDamage, stack: &mut StackPart) {
    let Some(gone) = stack.blocks.iter().position(|block| block.name == of.part) else {
        return refused(reader, of, WrongDamage::NoList, WrongDamage::ListBlocks);
    };
    let itself = Body::Block(gone);
    let alone = stack.blocks.iter().find(|block| block.on == [itself]);
    if let Some(upper) = alone {
        let why = WrongDamage::StoodOn(upper.name.clone());
        return refused(reader, of, why, WrongDamage::WriteItYourself);
    }
    if stack.blocks.len() == 1 || stack.static_loads.iter().any(|load| load.part == gone) {
        return refused(
            reader,
            of,
            WrongDamage::LoadedOrAlone,
            WrongDamage::WriteItYourself,
        );
    }
    stack.blocks.remove(gone);
    let moved = |index: usize| index - usize::from(index > gone);
    let body = |body: Body| match body {
        Body::Block(index) => Body::Block(moved(index)),
        Body::Ground => Body::Ground,
    };
    for block in &mut stack.blocks {
        block.on.retain(|on| *on != itself);
        block.on.iter_mut().for_each(|on| *on = body(*on));
    }
    stack.contacts.retain(|of| of.upper != gone && of.lower != itself);
    for of in &mut stack.contacts {
        (of.lower, of.upper) = (body(of.lower), moved(of.upper));
    }
    stack.ties.retain(|of| of.upper != gone && of.lower != itself);
    for of in &mut stack.ties {
        (of.lower, of.upper) = (body(of.lower), moved(of.upper));
    }
    stack.side_supports.retain(|of| of.block != gone);
    stack
        .side_supports
        .iter_mut()
        .for_each(|of| of.block = moved(of.block));
    stack.support_movement.retain(|of| of.block != gone);
    stack
        .support_movement
        .iter_mut()
        .for_each(|of| of.block = moved(of.block));
    stack
        .static_loads
        .iter_mut()
        .for_each(|of| of.part = moved(of.part));
}
