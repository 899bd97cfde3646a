//! Damage of a chain: a bed that has lost a part, a joint that has lost stiffness.

use super::in_model::{InModel, Side};
use super::model_damage::ModelDamage;
use super::refused::refused;
use crate::chain::{ChainPart, JointPart};
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
/// bed of width b that lost s b at one side:  pivot b/2 − s b → width (1 − 2 s) b;   k → (1 − s)³ k
/// ```
/// The beds of the chain are symmetric, so the nearer pivot is used for both sides. The stiffness of a bed of equal springs is proportional to the
/// third power of its width.
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
    let Some(bed) = chain.links.get_mut(part).and_then(|link| link.bed_width.as_mut()) else {
        return refused(reader, of, WrongDamage::NoBed, WrongDamage::GiveBed);
    };
    let (edge, stiffness) = (1.0 - 2.0 * share, (1.0 - share).powi(3));
    let joint = chain.joints.as_mut().and_then(|joints| joints.get_mut(part));
    match (is_across, joint) {
        (false, joint) => {
            let whole = bed.clone();
            scale(bed, edge);
            if let Some(joint) = joint {
                // the width across is unchanged
                if joint.bed_depth.is_none() && has_two_axes {
                    joint.bed_depth = Some(whole);
                }
                weaken(joint, stiffness, &of.survey, later);
            }
        }
        (true, Some(joint)) => {
            let mut depth = joint.bed_depth.clone().unwrap_or_else(|| bed.clone());
            scale(&mut depth, edge);
            joint.bed_depth = Some(depth);
            weaken(joint, stiffness, &of.survey, later);
        }
        (true, None) => refused(reader, of, WrongDamage::NoStiffness, WrongDamage::GiveStiffness),
    }
}

/// Reduces the stiffness by the loss of the bed, unless a later survey identified it.
fn weaken(joint: &mut JointPart, factor: f64, inspection: &str, later: Option<bool>) {
    if later == Some(true) || has_it(joint.stiffness.survey.as_deref(), inspection) {
        return;
    }
    scale(&mut joint.stiffness, factor);
    if let Some(across) = &mut joint.stiffness_across {
        scale(across, factor);
    }
}
