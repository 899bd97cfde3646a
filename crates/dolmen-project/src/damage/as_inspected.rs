//! Selects the inspections whose damage a model includes.

use super::chain::damage_chain;
use super::frame::damage_frame;
use super::in_model::InModel;
use super::model_damage::ModelDamage;
use super::refused::refused;
use super::stack::damage_stack;
use crate::content::{EarlierModel, Structure};
use crate::error::Fault;
use crate::file_number::At;
use crate::reader::Reader;
use crate::survey::{DamageKind, Survey, date_of};
use crate::wrong::WrongDamage;
use std::collections::BTreeMap;

/// The damage of inspections in a model, and the models of the days before.
#[derive(Default)]
pub(crate) struct Damaged {
    /// The damage in the model.
    pub(crate) damage: Vec<ModelDamage>,
    /// The model before each inspection that changed it, by date.
    pub(crate) earlier: Vec<EarlierModel>,
}

/// Applies the effects of damage to the model, from the inspections up to the one that `as_inspected` chooses. Returns the damage in the
/// model.
///
/// A damage applies from its inspection until a later one gives the same damage another effect, or as mended. A later inspection without it
/// does not remove it: it may not have been looked for. Two damages of one kind on one part need names, because the later would replace
/// the earlier.
pub(crate) fn damaged(
    reader: &mut Reader,
    chosen: Option<&At<String>>,
    surveys: &[Survey],
    structure: Option<&mut Structure>,
) -> Damaged {
    let Some(last) = chosen_day(reader, chosen, surveys) else {
        return Damaged::default();
    };
    let mut dated: Vec<([u32; 3], &Survey)> = surveys
        .iter()
        .filter_map(|survey| Some((date_of(&survey.name)?, survey)))
        .filter(|(day, _)| last.is_none_or(|last| *day <= last))
        .collect();
    dated.sort_by_key(|(day, _)| *day);
    undated(reader, surveys);
    let mut now: Known<'_> = BTreeMap::new();
    let mut before: Vec<([u32; 3], Vec<ModelDamage>)> = Vec::new();
    for (day, survey) in dated {
        let known = standing(&now);
        find(reader, survey, &mut now);
        if known != standing(&now) {
            before.push((day, known));
        }
    }
    let damage = standing(&now);
    let mut earlier = Vec::new();
    if let Some(structure) = structure {
        let given = structure.clone();
        let faults = reader.faults.len();
        apply(reader, &damage, structure);
        // what is refused here is refused once
        if reader.faults.len() == faults {
            earlier.extend(before.into_iter().map(|(until, damage)| {
                let mut structure = given.clone();
                apply(reader, &damage, &mut structure);
                EarlierModel {
                    until,
                    structure,
                    damage,
                }
            }));
        }
    }
    Damaged { damage, earlier }
}

/// Damage by part, kind and name.
type Known<'s> = BTreeMap<(&'s str, &'s DamageKind, Option<&'s str>), ModelDamage>;

/// The damage that is not mended; a missing stone last, because its removal changes the places of later stones.
fn standing(known: &Known<'_>) -> Vec<ModelDamage> {
    let each = known.values().filter(|of| of.effect != InModel::Mended);
    let mut all: Vec<ModelDamage> = each.cloned().collect();
    all.sort_by_key(|of| of.effect == InModel::Lost);
    all
}

/// Adds what the inspections of a survey found.
fn find<'s>(reader: &mut Reader, survey: &'s Survey, now: &mut Known<'s>) {
    for (number, item) in (1..).zip(&survey.inspections) {
        let Some(effect) = item.model else { continue };
        let of = ModelDamage {
            survey: survey.name.clone(),
            part: item.part.clone(),
            what: item.what.clone(),
            name: item.name.clone(),
            effect,
            path: format!("survey.{}.inspections[{number}].model", survey.name),
        };
        let key = (item.part.as_str(), &item.what, item.name.as_deref());
        if let Some(earlier) = now.get(&key)
            && (earlier.survey == of.survey || !effect.may_follow(earlier.effect))
        {
            let why = WrongDamage::Twice(earlier.survey.clone());
            refused(reader, &of, why, WrongDamage::NameEach);
        }
        now.insert(key, of);
    }
}

/// Puts damage into a structure.
fn apply(reader: &mut Reader, damage: &[ModelDamage], structure: &mut Structure) {
    let names = structure.part_names();
    for of in damage {
        let Some(part) = names.iter().position(|name| *name == of.part) else {
            let help = WrongDamage::LeaveModelOut;
            refused(reader, of, WrongDamage::NoModel, help);
            continue;
        };
        match structure {
            Structure::Chain(chain) => damage_chain(reader, (of, part), chain),
            Structure::Frame(frame) => damage_frame(reader, (of, part), frame),
            Structure::Stack(stack) => damage_stack(reader, (of, part), stack),
            Structure::Building(_) => {
                refused(reader, of, WrongDamage::OfBuilding, WrongDamage::WriteItYourself);
            }
            Structure::Survey => refused(reader, of, WrongDamage::NoModel, WrongDamage::LeaveModelOut),
        }
    }
}

/// The day up to which inspections count, `Some(None)` for all; `None` for no inspection.
fn chosen_day(
    reader: &mut Reader,
    chosen: Option<&At<String>>,
    surveys: &[Survey],
) -> Option<Option<[u32; 3]>> {
    let Some(given) = chosen else {
        return Some(None);
    };
    match given.value.as_str() {
        "none" => None,
        "latest" => Some(None),
        name => {
            let inspected = || surveys.iter().filter(|survey| !survey.inspections.is_empty());
            let found = inspected().find(|survey| survey.name == name);
            let day = found.and_then(|survey| date_of(&survey.name));
            if day.is_none() {
                let names = inspected().filter(|survey| date_of(&survey.name).is_some());
                let names = names.map(|survey| format!("\"{}\"", survey.name));
                let allowed = ["\"latest\"".to_owned(), "\"none\"".to_owned()].into_iter();
                let message = WrongDamage::AsInspectedButNo(name.to_owned());
                let fault = Fault::new(given.span.clone(), "as_inspected", message);
                reader.fault(fault.allowed(WrongDamage::MustBeOneOf(
                    allowed.chain(names).collect::<Vec<_>>().join(", "),
                )));
            }
            day.map(Some)
        }
    }
}

/// Rejects effects on the model from inspections without a date, because their order is unknown.
fn undated(reader: &mut Reader, surveys: &[Survey]) {
    for survey in surveys.iter().filter(|survey| date_of(&survey.name).is_none()) {
        for (number, item) in (1..).zip(&survey.inspections) {
            if let Some(effect) = item.model {
                let of = ModelDamage {
                    survey: survey.name.clone(),
                    part: item.part.clone(),
                    what: item.what.clone(),
                    name: item.name.clone(),
                    effect,
                    path: format!("survey.{}.inspections[{number}].model", survey.name),
                };
                refused(reader, &of, WrongDamage::NoDate, WrongDamage::NameSurveyByDate);
            }
        }
    }
}
