//! Damage of a chain: a bed that has lost a part, a joint that has lost stiffness.

use super::in_model::{InModel, Side};
use super::model_damage::ModelDamage;
use super::refused::refused;
use crate::chain::{ChainPart, JointPart, LinkPart};
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::survey::date_of;
use crate::wrong::WrongDamage;

/// At a loss of half of its width the weight is no longer above the remaining bed.
const HALF: f64 = 0.5;

/// A quantity times a factor, with its text.
pub(super) fn scale(of: &mut Quantity, factor: f64) {
    of.value *= factor;
    of.written = format!("{} × {factor:.4}", of.written);
}

/// Whether a stiffness comes from a survey after the inspection: it then includes the damage.
pub(super) fn has_it(identified_from: Option<&str>, inspection: &str) -> bool {
    let survey = identified_from.and_then(date_of);
    survey.is_some() && survey >= date_of(inspection)
}

/// Carries a damage into a chain.
///
/// ```text
/// bed of width b that lost s b at one side:  pivot b/2 − s b → width (1 − 2 s) b;   k → (1 − s)³ k,   across it k → (1 − s) k
/// ```
/// The beds of the chain are symmetric, so the nearer pivot is used for both sides. The stiffness of a bed of equal springs is proportional to the
/// third power of its width in the direction of motion, and to its width across.
pub(super) fn damage_chain(reader: &mut Reader, (of, part): (&ModelDamage, usize), chain: &mut ChainPart) {
    match of.effect {
        InModel::StiffnessLeft(factor) => loosen(reader, (of, part), chain, factor),
        InModel::BedLost { share, side } => narrow(reader, (of, part), chain, (share, side)),
        InModel::TiesBroken | InModel::Lost | InModel::Mended => {
            refused(reader, of, WrongDamage::OfChain, WrongDamage::WriteItYourself);
        }
    }
}

fn loosen(reader: &mut Reader, (of, part): (&ModelDamage, usize), chain: &mut ChainPart, factor: f64) {
    if chain.sought.is_some() {
        return refused(reader, of, WrongDamage::Sought, WrongDamage::LeaveStiffnessOut);
    }
    let joint = chain.joints.as_mut().and_then(|joints| joints.get_mut(part));
    let Some(joint) = joint else {
        return refused(reader, of, WrongDamage::NoStiffness, WrongDamage::GiveStiffness);
    };
    if let Some(survey) = joint
        .stiffness
        .survey
        .clone()
        .filter(|own| has_it(Some(own), &of.survey))
    {
        let why = WrongDamage::AlreadyIn(survey);
        return refused(reader, of, why, WrongDamage::LeaveStiffnessOut);
    }
    scale(&mut joint.stiffness, factor);
    if let Some(across) = &mut joint.stiffness_across {
        scale(across, factor);
    }
}

fn narrow(
    reader: &mut Reader,
    (of, part): (&ModelDamage, usize),
    chain: &mut ChainPart,
    (share, side): (f64, Option<Side>),
) {
    if share >= HALF {
        return refused(
            reader,
            of,
            WrongDamage::BesideItsBed,
            WrongDamage::WriteItYourself,
        );
    }
    let is_across = side.is_some_and(Side::is_across);
    let has_two_axes = chain.has_two_axes();
    if is_across && !has_two_axes {
        return refused(reader, of, WrongDamage::OneDirection, WrongDamage::SideAlong);
    }
    let sought = chain.sought.clone();
    let later = sought
        .as_ref()
        .map(|sought| has_it(sought.survey.as_deref(), &of.survey));
    if later == Some(false) {
        return refused(reader, of, WrongDamage::Sought, WrongDamage::WriteStiffness);
    }
    let ratio = chain
        .bed(part, &mut Quantity::nominal)
        .map(|bed| bed.stiffness_ratio_across().min(1.0));
    let Some(link) = chain.links.get_mut(part).filter(|link| link.bed_width.is_some()) else {
        return refused(reader, of, WrongDamage::NoBed, WrongDamage::GiveBed);
    };
    // without a side it may be either: each axis then loses as on its own side
    let loses = [!is_across, is_across || (side.is_none() && has_two_axes)];
    let left = 1.0 - share;
    let stiffness = loses.map(|loses| if loses { left.powi(3) } else { left });
    let depth = depth_of_bed(link);
    if let Some(bed) = link.bed_width.as_mut().filter(|_| loses[0]) {
        scale(bed, 1.0 - 2.0 * share);
    }
    let joint = chain.joints.as_mut().and_then(|joints| joints.get_mut(part));
    let Some(joint) = joint else {
        if is_across {
            refused(reader, of, WrongDamage::NoStiffness, WrongDamage::GiveStiffness);
        }
        return;
    };
    if has_two_axes {
        // the sides and stiffnesses across that the file leaves to those along: they are reduced by other factors
        joint.bed_depth = joint.bed_depth.take().or(depth);
        if let Some(depth) = joint.bed_depth.as_mut().filter(|_| loses[1]) {
            scale(depth, 1.0 - 2.0 * share);
        }
        let whole = joint.stiffness.clone();
        joint.stiffness_across.get_or_insert_with(|| {
            let mut across = Quantity {
                path: format!("{}_across", whole.path),
                ..whole
            };
            if let Some(ratio) = ratio.filter(|ratio| *ratio != 1.0) {
                scale(&mut across, ratio);
            }
            across
        });
    }
    weaken(joint, stiffness, &of.survey, later);
}

/// The width of a bed across, as the sides of its link give it where the file does not.
fn depth_of_bed(link: &LinkPart) -> Option<Quantity> {
    let width = link.bed_width.clone()?;
    let mut depth = Quantity {
        path: format!("{}_across", width.path),
        ..width
    };
    match (&link.depth, &link.breadth) {
        (Some(across), Some(along)) if across.value != along.value => {
            scale(&mut depth, across.value / along.value);
        }
        (Some(across), None) if across.value < depth.value => depth = across.clone(),
        _ => {}
    }
    Some(depth)
}

/// Reduces the stiffness along and across by the loss of the bed, unless a later survey identified it.
fn weaken(joint: &mut JointPart, [along, across]: [f64; 2], inspection: &str, later: Option<bool>) {
    if later == Some(true) || has_it(joint.stiffness.survey.as_deref(), inspection) {
        return;
    }
    scale(&mut joint.stiffness, along);
    if let Some(own) = &mut joint.stiffness_across {
        scale(own, across);
    }
}
