//! The basis of a verdict as parts of the headline: what the model leaves out, made-up surveys, assumed inputs.

use crate::building::millimetres;
use crate::engineer::{damage_words, severity_words};
use dolmen_words::{Digits, Quantity, Sentence, Template, messages};
use dolmen_work::judgement::{AssumedInputs, Basis, GrownDamage, Growth};

/// Made-up surveys and severe damages that a headline names before it counts the rest.
pub(crate) const NAMED_MOST: usize = 3;
/// Significant digits of the size of a damage.
const SIZE_DIGITS: usize = 4;

messages! {
    /// The basis of a verdict.
    pub(crate) enum HeadlineBasis in "headline.basis" {
        SevereLeftOut { found: Vec<Sentence> } => {
            en: "not in it: severe damage found ({found})",
            ko: "점검된 심한 손상 미반영({found})",
        },
        GrownLeftOut { found: Vec<Sentence> } => {
            en: "not in it: damage recorded as larger since ({found})",
            ko: "이후 점검에서 커진 손상 미반영({found})",
        },
        Grown { part: String, what: Sentence, before: Quantity, after: Quantity, survey: String } => {
            en: "“{part}”: {what} {before} → {after}, {survey}",
            ko: "‘{part}’ {what} {before} → {after}, {survey}",
        },
        GrownWorse { part: String, what: Sentence, before: Sentence, after: Sentence, survey: String } => {
            en: "“{part}”: {what} {before} → {after}, {survey}",
            ko: "‘{part}’ {what} {before} → {after}, {survey}",
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
        Unchecked { surveys: Vec<String> } => {
            en: "stiffness unchecked, it fits by construction (survey {surveys})",
            ko: "미검증 강성({surveys} 조사, 미지수만큼의 고유진동수에 맞춘 값)",
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
        let each = basis.severe_damage.iter().map(|one| {
            let (part, what) = (one.part.clone(), damage_words(&one.what));
            HeadlineBasis::Damage { part, what }.into()
        });
        let found = some_named(each.collect());
        all.push(HeadlineBasis::SevereLeftOut { found }.into());
    }
    if !basis.grown_damage.is_empty() {
        let found = some_named(basis.grown_damage.iter().map(grown).collect());
        all.push(HeadlineBasis::GrownLeftOut { found }.into());
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

/// The first few, and the number of the others.
fn some_named(mut named: Vec<Sentence>) -> Vec<Sentence> {
    let more = named.len().saturating_sub(NAMED_MOST);
    named.truncate(NAMED_MOST);
    named.extend((more > 0).then(|| HeadlineBasis::More { count: more }.into()));
    named
}

fn grown(of: &GrownDamage) -> Sentence {
    let (part, what, survey) = (of.part.clone(), damage_words(&of.what), of.survey.clone());
    match of.growth {
        Growth::Size { before_m, after_m } => {
            let size = |value_m: f64| Quantity::new(value_m, millimetres(), Digits::Trimmed(SIZE_DIGITS));
            let (before, after) = (size(before_m), size(after_m));
            HeadlineBasis::Grown {
                part,
                what,
                before,
                after,
                survey,
            }
        }
        Growth::Severity { before, after } => {
            let [before, after] = [before, after].map(|one| severity_words(Some(one)));
            HeadlineBasis::GrownWorse {
                part,
                what,
                before,
                after,
                survey,
            }
        }
    }
    .into()
}

/// Made-up surveys, stiffness that nothing checks, and assumed inputs.
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
    if !basis.unchecked_stiffness_from.is_empty() {
        let surveys = basis.unchecked_stiffness_from.clone();
        all.push(HeadlineBasis::Unchecked { surveys }.into());
    }
    let AssumedInputs { assumed, all: inputs } = basis.inputs;
    if assumed > 0 {
        all.push(HeadlineBasis::Assumed { assumed, all: inputs }.into());
    }
    all
}
