//! The project as given beside its variants, before and after a repair.

use super::finding::{Finding, Tone};
use super::samples::lambda_text;
use super::table::{Cell, figure, table};
use super::words::verdict_word;
use crate::figures::{VariantDot, variants_compared};
use dolmen::stability::Verdict;
use dolmen_words::Language;
use dolmen_words::number::{beside_one, significant};
use dolmen_work::answer::ProjectReport;
use dolmen_work::state::{Check, State, VariantAnswer};
use maud::{Markup, html};

/// Differences of λ below this share are called none.
const SAME_SHARE: f64 = 1e-6;

/// One row: a variant, or one direction of it.
struct Row {
    name: String,
    load_factor: Option<f64>,
    verdict: Verdict,
    margins: Vec<Option<f64>>,
    frequency_hz: Option<f64>,
}

pub(super) fn findings(answer: &ProjectReport, language: Language) -> Vec<Finding> {
    let Some(state) = answer.state() else {
        return Vec::new();
    };
    let basis = rows(state, "");
    let mut all = Vec::new();
    for variant in answer.variants() {
        let title = title(variant, language);
        for (after, before) in rows(&variant.state, "").iter().zip(&basis) {
            let (Some(new), Some(old)) = (after.load_factor, before.load_factor) else {
                continue;
            };
            let (from, to) = (beside_one(old, 4), beside_one(new, 4));
            let word = verdict_word(after.verdict, language);
            let tone = if new < old { Tone::Warn } else { Tone::Plain };
            let place = if after.name.is_empty() {
                String::new()
            } else {
                format!(" ({})", after.name)
            };
            let text = if (new / old - 1.0).abs() < SAME_SHARE {
                language.pick(
                    format!("Variant “{title}”{place} leaves the load factor at {from}: {word}."),
                    format!("대안 ‘{title}’{place}에서 하중배율은 {from}로 같다: {word}."),
                )
            } else {
                language.pick(
                    format!("Variant “{title}”{place} changes the load factor from {from} to {to}: {word}."),
                    format!("대안 ‘{title}’{place}에서 하중배율이 {from}에서 {to}로 바뀐다: {word}."),
                )
            };
            all.push(Finding::new(tone, text));
        }
    }
    all
}

/// The section that compares variants.
pub(super) fn section(answer: &ProjectReport, language: Language) -> Markup {
    let Some(state) = answer.state().filter(|_| !answer.variants().is_empty()) else {
        return html! {};
    };
    let mut all = rows(state, language.pick("as given", "현재"));
    for variant in answer.variants() {
        all.extend(rows(&variant.state, title(variant, language)));
    }
    let dots: Vec<VariantDot> = all
        .iter()
        .map(|row| VariantDot {
            name: row.name.clone(),
            load_factor: row.load_factor,
            margins: row.margins.clone(),
        })
        .collect();
    let head = [
        language.pick("Variant", "대안").to_string(),
        language.pick("verdict", "판정").to_string(),
        "λ".to_string(),
        language.pick("least margin", "최소 여유도").to_string(),
        language
            .pick("lowest frequency (Hz)", "최저 고유진동수 (Hz)")
            .to_string(),
    ];
    let unknown = language.pick("unknown", "미상");
    let cells: Vec<Vec<Cell>> = all
        .iter()
        .map(|row| {
            let margin = match least_margin(row) {
                None => unknown.to_string(),
                Some(None) => language.pick("falls", "전도").to_string(),
                Some(Some(margin)) => beside_one(margin, 4),
            };
            vec![
                row.name.clone().into(),
                verdict_word(row.verdict, language).into(),
                lambda_text(row.load_factor, language).into(),
                margin.into(),
                row.frequency_hz
                    .map_or(unknown.into(), |f| significant(f, 4))
                    .into(),
            ]
        })
        .collect();
    html! {
        h2 { (language.pick("Variants compared", "대안 비교")) }
        (figure(
            &variants_compared(&dots, language),
            language.pick(
                "Load factor and margins of each variant. Left of 1 it falls.",
                "대안별 하중배율과 여유도. 1의 왼쪽은 전도이다.",
            ),
        ))
        (table(language.pick("Variants. The same check on each.", "대안별 결과. 모두 같은 방법으로 검토하였다."), 2, &head, &cells))
    }
}

/// `None` if no margin is known, `Some(None)` if some part falls whatever its stiffness is.
fn least_margin(row: &Row) -> Option<Option<f64>> {
    if row.margins.is_empty() {
        return None;
    }
    if row.margins.iter().any(Option::is_none) {
        return Some(None);
    }
    Some(row.margins.iter().flatten().copied().min_by(f64::total_cmp))
}

fn rows(state: &State, name: &str) -> Vec<Row> {
    let positive = |modes: &[dolmen::structure::NaturalMode]| {
        modes
            .first()
            .filter(|m| m.omega_squared > 0.0)
            .map(|m| m.frequency_hz)
    };
    match &state.check {
        Check::Chain(check) => {
            let stability = check.stability.as_ref();
            vec![Row {
                name: name.to_string(),
                load_factor: stability.map(|s| s.load_factor),
                verdict: stability.map_or(Verdict::Unknown, |s| s.verdict),
                margins: stability
                    .iter()
                    .flat_map(|s| s.joints.iter().map(|j| j.margin))
                    .collect(),
                frequency_hz: positive(&check.modes),
            }]
        }
        Check::Frame(directions) => directions
            .iter()
            .map(|direction| {
                let stability = direction.check.stability.as_ref();
                let apart = if name.is_empty() { "" } else { " · " };
                Row {
                    name: format!("{name}{apart}{}", direction.direction),
                    load_factor: stability.map(|s| s.load_factor),
                    verdict: stability.map_or(Verdict::Unknown, |s| s.verdict),
                    margins: stability
                        .iter()
                        .flat_map(|s| s.storeys.iter().map(|x| x.margin))
                        .collect(),
                    frequency_hz: positive(&direction.check.modes),
                }
            })
            .collect(),
        Check::Building(answer) => {
            let factor = answer.load_factor();
            let modes = answer.stands.as_ref().map(|standing| &standing.modes.modes);
            vec![Row {
                name: name.to_string(),
                load_factor: Some(factor),
                verdict: Verdict::of_load_factor(factor),
                margins: answer.falls.iter().map(|fall| Some(fall.load_factor)).collect(),
                frequency_hz: modes
                    .and_then(|modes| modes.first())
                    .map(|mode| mode.frequency_hz),
            }]
        }
        Check::Stack(_) => Vec::new(),
    }
}

pub(super) fn title(variant: &VariantAnswer, language: Language) -> &str {
    match &variant.title {
        Some(names) => language.pick(names.english(), names.korean()),
        None => &variant.name,
    }
}
