//! The basis of a verdict as parts of the headline: what the model leaves out, made-up surveys, assumed inputs.

use crate::engineer::damage_words;
use dolmen_words::{Quantity, Sentence, Template, messages};
use dolmen_work::judgement::{AssumedInputs, Basis};

/// Made-up surveys and severe damages that a headline names before it counts the rest.
pub(crate) const NAMED_MOST: usize = 3;

messages! {
    /// The basis of a verdict.
    pub(crate) enum HeadlineBasis in "headline.basis" {
        SevereLeftOut { found: Vec<Sentence> } => {
            en: "not in it: severe damage found ({found})",
            ko: "점검된 심한 손상 미반영({found})",
        },
        Damage { part: String, what: Sentence } => { en: "“{part}”: {what}", ko: "‘{part}’ {what}" },
        More { count: usize } => { en: "{count} more", ko: "그 외 {count}건" },
        InspectionsLeftOut { surveys: Vec<String> } => {
            en: "not in it: the damage of inspection {surveys}",
            ko: "{surveys} 점검의 손상 미반영",
        },
        CapLeftOut => {
            en: "not in it: the cap stone (on the unsafe side)",
            ko: "옥개석 미반영(불안전측)",
        },
        WindLeftOut => {
            en: "not in it: the wind of the file, which no combination counts",
            ko: "하중조합에 없는 풍하중 미반영",
        },
        LoadsLeftOut => {
            en: "not in it: static loads of the file, which no combination counts",
            ko: "하중조합에 없는 정하중 미반영",
        },
        HeldBySupports { factor: Quantity } => {
            en: "held by its side supports alone (load factor {factor} without them)",
            ko: "측면 지지에만 의지함(지지 없이는 하중계수 {factor})",
        },
        MadeUp { surveys: Vec<String> } => {
            en: "made up, not measured: survey {surveys}",
            ko: "실측이 아닌 가상 조사: {surveys}",
        },
        MadeUpMany { count: usize, first: String, last: String } => {
            en: "made up, not measured: {count} surveys, {first} to {last}",
            ko: "실측이 아닌 가상 조사 {count}회({first}~{last})",
        },
        Assumed { assumed: usize, all: usize } => {
            en: "assumed inputs: {assumed} of {all}",
            ko: "가정한 입력: {all}개 중 {assumed}개",
        },
    }
}

/// The sentences as they are written.
pub(crate) const TEMPLATES: &[Template] = HeadlineBasis::TEMPLATES;

/// Known properties of the structure that the model leaves out.
pub(crate) fn left_out(basis: &Basis) -> Vec<Sentence> {
    let mut all = Vec::new();
    if !basis.severe_damage.is_empty() {
        let named = basis.severe_damage.iter().take(NAMED_MOST).map(|one| {
            let (part, what) = (one.part.clone(), damage_words(&one.what));
            Sentence::from(HeadlineBasis::Damage { part, what })
        });
        let more = basis.severe_damage.len().saturating_sub(NAMED_MOST);
        let more = (more > 0).then(|| HeadlineBasis::More { count: more }.into());
        let found = named.chain(more).collect();
        all.push(HeadlineBasis::SevereLeftOut { found }.into());
    }
    if !basis.inspections_left_out.is_empty() {
        let surveys = basis.inspections_left_out.clone();
        all.push(HeadlineBasis::InspectionsLeftOut { surveys }.into());
    }
    all.extend(basis.is_cap_left_out.then(|| HeadlineBasis::CapLeftOut.into()));
    all.extend(basis.is_wind_left_out.then(|| HeadlineBasis::WindLeftOut.into()));
    all.extend(
        basis
            .is_loads_left_out
            .then(|| HeadlineBasis::LoadsLeftOut.into()),
    );
    let held = basis
        .load_factor_without_supports
        .map(|factor| Quantity::beside_one(factor, 3));
    all.extend(held.map(|factor| HeadlineBasis::HeldBySupports { factor }.into()));
    all
}

/// Made-up surveys and assumed inputs.
pub(crate) fn resting(basis: &Basis) -> Vec<Sentence> {
    let mut all = Vec::new();
    match basis.made_up_surveys.as_slice() {
        [] => {}
        [first, .., last] if basis.made_up_surveys.len() > NAMED_MOST => {
            let (count, first, last) = (basis.made_up_surveys.len(), first.clone(), last.clone());
            all.push(HeadlineBasis::MadeUpMany { count, first, last }.into());
        }
        surveys => {
            let surveys = surveys.to_vec();
            all.push(HeadlineBasis::MadeUp { surveys }.into());
        }
    }
    let AssumedInputs { assumed, all: inputs } = basis.inputs;
    if assumed > 0 {
        all.push(HeadlineBasis::Assumed { assumed, all: inputs }.into());
    }
    all
}
