//! Which runs of a study something is true of, in words.

use crate::wrong::OfRuns;
use dolmen_project::{ModelDamage, StudyPart};
use dolmen_words::message::Both;

/// Inspected damage in the model of the runs.
#[derive(Clone, Debug, PartialEq)]
pub struct DamageInRuns {
    /// The damage.
    pub damage: ModelDamage,
    /// The runs that have it: "variant damaged"; `None` for all.
    pub only_in: Option<Both>,
}

/// The combinations for which something holds, by their variant or by the value of one input if these decide it; `None` for all of them.
/// Refused combinations, which have no runs, are `None` in `holds`.
fn some_runs(study: &StudyPart, holds: &[Option<bool>]) -> Option<Both> {
    if holds.iter().flatten().all(|holds| *holds) {
        return None;
    }
    if let Some(variants) = decided_by(study, holds, &|combination| {
        study.combination(combination).0.map(str::to_owned)
    }) {
        return Some(OfRuns::OfVariants { variants }.into());
    }
    let by_input = study.vary.iter().enumerate().find_map(|(at, axis)| {
        let values = decided_by(study, holds, &|combination| {
            let (_, values) = study.combination(combination);
            Some(values.get(at)?.text.trim_matches('"').to_owned())
        })?;
        let input = axis.path.clone();
        Some(OfRuns::OfValues { input, values })
    });
    let some = holds.iter().flatten().filter(|holds| **holds).count();
    let all = holds.iter().flatten().count();
    Some(by_input.unwrap_or(OfRuns::OfCombinations { some, all }).into())
}

/// The values for which something holds, if it holds for all combinations with these and for no other.
fn decided_by(
    study: &StudyPart,
    holds: &[Option<bool>],
    value_of: &dyn Fn(usize) -> Option<String>,
) -> Option<Vec<String>> {
    let all: Option<Vec<String>> = (0..study.combinations()).map(value_of).collect();
    let all = all?;
    let mut held: Vec<String> = Vec::new();
    for (value, _) in all.iter().zip(holds).filter(|(_, holds)| **holds == Some(true)) {
        if !held.contains(value) {
            held.push(value.clone());
        }
    }
    let is_decided = all
        .iter()
        .zip(holds)
        .all(|(value, holds)| holds.is_none_or(|holds| held.contains(value) == holds));
    is_decided.then_some(held)
}

/// Sentences on the runs of each combination: each once, with the combinations of which it is true unless these are all.
pub(super) fn said_of_runs(study: &StudyPart, each: &[Option<&[Both]>]) -> Vec<Both> {
    let of = |(said, only_in): (&Both, Option<Both>)| match only_in {
        Some(some) => OfRuns::OnlyIn {
            some,
            said: said.clone(),
        }
        .into(),
        None => said.clone(),
    };
    once_each(study, each).into_iter().map(of).collect()
}

/// The damage in the model of each combination.
pub(super) fn damage_in_runs(study: &StudyPart, each: &[Option<&[ModelDamage]>]) -> Vec<DamageInRuns> {
    let of = |(damage, only_in): (&ModelDamage, Option<Both>)| DamageInRuns {
        damage: damage.clone(),
        only_in,
    };
    once_each(study, each).into_iter().map(of).collect()
}

fn once_each<'a, T: PartialEq>(study: &StudyPart, each: &[Option<&'a [T]>]) -> Vec<(&'a T, Option<Both>)> {
    let mut once: Vec<&T> = Vec::new();
    for one in each.iter().copied().flatten().flatten() {
        if !once.contains(&one) {
            once.push(one);
        }
    }
    let with_runs = once.into_iter().map(|one| {
        let holds: Vec<Option<bool>> = each.iter().map(|own| Some(own.as_ref()?.contains(one))).collect();
        (one, some_runs(study, &holds))
    });
    with_runs.collect()
}
