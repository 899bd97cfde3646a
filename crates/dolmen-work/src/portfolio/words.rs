//! What stands in the cells of a ranking, in English and Korean.

use super::answer::{Basis, PortfolioAnswer, PortfolioEntry};
use super::state_words::state_words;
use crate::study::YEARS;
use dolmen::assess::{Factor, Known, KnownCapacity, Unlike};
use dolmen_words::Language;
use dolmen_words::number::significant;

/// Places by which falls alone must differ to be spoken of: a third of all. Chosen here.
const PART_APART: f64 = 1.0 / 3.0;

/// What a factor is called, with its unit.
pub fn factor_words(factor: Factor, language: Language) -> &'static str {
    match factor {
        Factor::Storeys => language.pick("storeys", "층수"),
        Factor::BodyHeight => language.pick("body height, m", "탑신 높이 (m)"),
        Factor::SlendernessAngle => language.pick("tan α", "세장각 tan α"),
        Factor::BodySlenderness => language.pick("body slenderness λ", "탑신 세장비 λ"),
        Factor::Taper => language.pick("taper φ, deg", "체감도 φ (°)"),
        Factor::BodyBaseHeightRatio => language.pick("body/base height", "탑신/기단 높이비"),
    }
}

/// Probability that something of a rate comes true in [`YEARS`].
pub fn probability_in_years(annual_rate: f64) -> f64 {
    -(-annual_rate * YEARS).exp_m1()
}

/// How a capacity is known, as a word of tables.
pub fn known_word(known: Known) -> &'static str {
    match known {
        Known::Found => "found",
        Known::AtLeast => "at_least",
        Known::AtMost => "at_most",
    }
}

/// What a capacity rests on.
pub fn basis_words(entry: &PortfolioEntry, language: Language) -> String {
    match &entry.basis {
        Basis::Study { name, scans } => language.pick(
            format!("study {name}, {scans} scans"),
            format!("해석 {name}, {scans}조"),
        ),
        Basis::Score { outside, unlike, .. } if outside.is_empty() && unlike.is_empty() => {
            language.pick("score", "점수").to_owned()
        }
        Basis::Score { outside, unlike, .. } => {
            let names = outside
                .iter()
                .map(|factor| factor_words(*factor, language).to_owned());
            let names = names.chain(unlike.iter().map(Unlike::to_string));
            let names = names.collect::<Vec<String>>().join("; ");
            language.pick(
                format!("score, EXTRAPOLATED: {names}"),
                format!("점수(학습 범위 밖: {names})"),
            )
        }
    }
}

/// θ in g, with the sign of a bound.
pub fn capacity_words(capacity: &KnownCapacity, gravity_m_s2: f64) -> String {
    let g = significant(capacity.fragility.theta() / gravity_m_s2, 2);
    match capacity.known {
        Known::Found => g,
        Known::AtLeast => format!("> {g}"),
        Known::AtMost => format!("< {g}"),
    }
}

/// The factor that lowers the capacity most, and by how much.
pub fn reason_words(entry: &PortfolioEntry, language: Language) -> String {
    match entry.worst_factor() {
        Some((factor, share)) => {
            let percent = 100.0 * share.exp_m1();
            format!("{}: {percent:+.0} %", factor_words(factor, language))
        }
        None => "–".to_owned(),
    }
}

/// Why rates do not order the structures although some have a hazard: those without it, by name; `None` if all have one, or none.
pub fn without_hazard(answer: &PortfolioAnswer, language: Language) -> Option<String> {
    const NAMED: usize = 5;
    let entries = &answer.entries;
    let lacking: Vec<&str> = entries
        .iter()
        .filter(|entry| entry.hazard.is_none())
        .map(|entry| entry.name.as_str())
        .collect();
    let (lack, all) = (lacking.len(), entries.len());
    if lack == 0 || lack == all {
        return None;
    }
    let mut names = lacking[..lack.min(NAMED)].join(", ");
    if lack > NAMED {
        names += language.pick(", …", " 등");
    }
    Some(language.pick(
        format!(
            "{lack} of {all} have no hazard of their site ({names}): all are ordered by what they bear, not by how often it comes. Give zone_factor_g \
             and soil for each, or site.hazard in its project"
        ),
        format!(
            "{all}기 가운데 {lack}기({names})는 부지의 지진재해도가 없어, 발생률이 아니라 저항능력만으로 순서를 매겼다. 모든 구조물에 zone_factor_g와 soil을, \
             또는 과제 파일에 site.hazard를 주어야 한다."
        ),
    ))
}

/// How many have a place, of how many.
pub fn count_words(answer: &PortfolioAnswer, language: Language) -> String {
    let (count, without) = (answer.ranked.places.len(), answer.left_out.len());
    match without {
        0 => language.pick(format!("{count} structures"), format!("구조물 {count}기")),
        _ => language.pick(
            format!("{count} of {} structures", count + without),
            format!("구조물 {}기 중 {count}기", count + without),
        ),
    }
}

/// Structures whose hazard the table gave although their project has its own; `None` if there is none.
pub fn hazards_replaced(answer: &PortfolioAnswer, language: Language) -> Option<String> {
    let replaced = answer.entries.iter().filter(|entry| entry.hazard_replaced);
    let names: Vec<&str> = replaced.map(|entry| entry.name.as_str()).collect();
    let names = names.join(", ");
    (!names.is_empty()).then(|| {
        language.pick(
            format!("the zone and soil of the table (KDS 17 10 00) stand in place of the project's own [site] for {names}"),
            format!("{names}: 과제 파일의 [site] 대신 표의 지진구역과 지반(KDS 17 10 00)을 적용하였다."),
        )
    })
}

/// Structures that by falls alone stand far further ahead than by the state, each in a sentence, the first to fall first.
pub fn falls_first(answer: &PortfolioAnswer, language: Language) -> Vec<String> {
    let apart = (PART_APART * answer.entries.len() as f64).max(1.0);
    let state = state_words(answer.state, language);
    let mut found: Vec<(usize, String)> = Vec::new();
    for (place, entry, _) in answer.rows() {
        let Some(falls) = answer.by_falls.get(place.candidate).copied().flatten() else {
            continue;
        };
        if place.rank as f64 - falls as f64 >= apart {
            let (name, rank) = (&entry.name, place.rank);
            let sentence = language.pick(
                format!("{name}: place {rank} by {state}, but {falls} by falls alone: little is damaged before it falls"),
                format!("{name}: {state} 기준 {rank}위이나 낙하·전도만 보면 {falls}위: 큰 손상 없이 먼저 떨어진다"),
            );
            found.push((falls, sentence));
        }
    }
    found.sort_by_key(|one| one.0);
    found.into_iter().map(|one| one.1).collect()
}

/// Structures that falls alone would put far further back than the state does, each in a sentence.
pub fn misjudged(answer: &PortfolioAnswer, language: Language) -> Vec<String> {
    let apart = (PART_APART * answer.entries.len() as f64).max(1.0);
    let mut found = Vec::new();
    if answer.state == 3 {
        return found;
    }
    let state = state_words(answer.state, language);
    for (place, entry, _) in answer.rows() {
        let Some(falls) = answer.by_falls.get(place.candidate).copied().flatten() else {
            continue;
        };
        if falls as f64 - place.rank as f64 >= apart {
            let (name, rank) = (&entry.name, place.rank);
            found.push(language.pick(
                format!(
                    "{name}: place {rank} by {state}, but {falls} by falls alone: it is damaged long before anything falls"
                ),
                format!(
                    "{name}: {state} 기준 {rank}위이나 낙하·전도만 보면 {falls}위: 떨어지기 훨씬 전에 손상된다"
                ),
            ));
        }
    }
    found
}
