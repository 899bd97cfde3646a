//! What lowering a centre of mass does, by the published criterion and in truth.

use super::chain_findings::RISE_LEAST;
use super::table::{Cell, figure, table};
use super::words::listed;
use crate::figures::centroid_effect;
use dolmen::assess::{CentroidEffect, ChainCheck};
use dolmen_words::Language;
use dolmen_words::number::{self, beside_one, prefix};
use maud::{Markup, html};

/// Effects of a lower centre of mass are drawn for at most so many links; the table has them all.
const EFFECTS_DRAWN: usize = 4;

pub(super) fn section(check: &ChainCheck, language: Language) -> Markup {
    if check.centroids.is_empty() {
        return html! {};
    }
    let all: Vec<f64> = check.limits.published_critical_n_m_rad.clone();
    let unit = prefix(&all, "N·m/rad");
    let joints = check.limits.necessary_n_m_rad.len();
    let mut head = vec![language.pick("Link lowered", "낮춘 부재").to_string()];
    head.extend((1..=joints).map(|i| format!("k_cr {i}")));
    let with_load = check.centroids.iter().any(|e| e.load_factor.is_some());
    head.push(format!(
        "{} ({})",
        language.pick("equal joints", "동일 강성"),
        unit.unit
    ));
    if with_load {
        head.push("λ".into());
    }
    let row = |name: String, k_cr: &[f64], equal: f64, load: Option<f64>| {
        let mut row: Vec<Cell> = vec![name.into()];
        for (new, old) in k_cr.iter().zip(&check.limits.published_critical_n_m_rad) {
            let text = number::fixed(new * unit.factor, 2);
            row.push(if new / old - 1.0 > RISE_LEAST {
                Cell::bad(format!("{text} ↑"))
            } else {
                text.into()
            });
        }
        row.push(number::fixed(equal * unit.factor, 2).into());
        if with_load {
            row.push(load.map_or("–".into(), |l| beside_one(l, 5)).into());
        }
        row
    };
    let none = language.pick("none", "없음").to_string();
    let basis = check.stability.as_ref().map(|s| s.load_factor);
    let limits = &check.limits;
    let mut rows = vec![row(
        none,
        &limits.published_critical_n_m_rad,
        limits.equal_joints_n_m_rad,
        basis,
    )];
    let mut changes: Vec<String> = Vec::new();
    for effect in &check.centroids {
        let change = number::percent(effect.change, 2);
        rows.push(row(
            format!("{} {} ({change})", language.pick("link", "부재"), effect.link),
            &effect.published_critical_n_m_rad,
            effect.equal_joints_n_m_rad,
            effect.load_factor,
        ));
        if !changes.contains(&change) {
            changes.push(change);
        }
    }
    let changes = listed(&changes, language);
    let drawn = drawn_effects(check);
    let caption = language.pick(
        format!(
            "Published k_cr with one centre of mass changed by {changes}, {}. ↑ marks those that rise although lowering can only \
             help; the exact need of equal joints and λ show it.",
            unit.unit
        ),
        format!(
            "무게 중심 하나를 {changes} 바꾼 경우의 발표된 k_cr, {}. 낮추면 항상 유리한데도 커지는 값을 ↑로 표시하였다. 동일 \
             강성의 정확한 한계와 λ는 모두 개선된다.",
            unit.unit
        ),
    );
    html! {
        h2 { (language.pick("What lowering a centre of mass does", "무게 중심을 낮춘 효과")) }
        div.pair { @for effect in drawn {
            (figure(
                &centroid_effect(&check.limits, effect, language),
                &language.pick(
                    format!("Link {} lowered by {}.", effect.link, number::percent(-effect.change, 2)),
                    format!("부재 {}의 무게 중심을 {} 낮춘 경우.", effect.link, number::percent(-effect.change, 2)),
                ),
            ))
        } }
        (table(&caption, 1, &head, &rows))
    }
}

/// Those whose published limits rise most, in the order of the links.
fn drawn_effects(check: &ChainCheck) -> Vec<&CentroidEffect> {
    let rise = |effect: &CentroidEffect| {
        let pairs = effect
            .published_critical_n_m_rad
            .iter()
            .zip(&check.limits.published_critical_n_m_rad);
        pairs
            .map(|(new, old)| new / old - 1.0)
            .fold(f64::NEG_INFINITY, f64::max)
    };
    let mut effects: Vec<&CentroidEffect> = check.centroids.iter().collect();
    effects.sort_by(|a, b| rise(b).total_cmp(&rise(a)));
    effects.truncate(EFFECTS_DRAWN);
    effects.sort_by_key(|e| e.link);
    effects
}
