//! Effect of a lower centre of mass, by the published criterion and by the exact one.

use super::findings::RISE_LEAST;
use crate::document::{Block, Cell, Column, Document, Figure, Series, Table};
use crate::figures::centroid_effect;
use dolmen::assess::{CentroidEffect, ChainCheck};
use dolmen::stability::ChainLimits;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

/// Largest number of links whose effects are drawn; the table has all.
const EFFECTS_DRAWN: usize = 4;

messages! {
    /// Lower centres of mass.
    pub(crate) enum Centroids in "chain.centroids" {
        Head => { en: "What lowering a centre of mass does", ko: "무게중심을 낮춘 효과" },
        Drawn { link: usize, change: Quantity } => {
            en: "Link {link} lowered by {change}.",
            ko: "부재 {link}의 무게중심을 {change} 낮춘 경우.",
        },
        Caption { changes: Vec<Quantity>, unit: Sentence } => {
            en: "Published k_cr with one centre of mass changed by {changes}, {unit}.",
            ko: "무게중심 하나를 {changes} 바꾼 경우의 발표된 k_cr, {unit}.",
        },
        CaptionMeaning => {
            en: "↑ marks those that rise although lowering can only help; the exact need of equal joints and λ show it.",
            ko: "낮추면 항상 유리한데도 커지는 값을 ↑로 표시하였다. 모든 접합면의 강성이 같을 때의 정확한 한계와 λ는 모두 개선된다.",
        },
        Lowered => { en: "Link lowered", ko: "낮춘 부재" },
        Critical { joint: usize } => { en: "k_cr {joint}", ko: "k_cr {joint}" },
        Joint => { en: "joint", ko: "접합면" },
        PublishedChange => { en: "change of the published k_cr", ko: "발표된 k_cr의 변화" },
        ExactChange => { en: "change of the exact limit M", ko: "정확한 한계 M의 변화" },
        Equal => { en: "equal joints", ko: "동일 강성 시 필요값" },
        LoadFactor => { en: "λ", ko: "λ" },
        None => { en: "none", ko: "없음" },
        Link { link: usize, change: Quantity } => { en: "link {link} ({change})", ko: "부재 {link} ({change})" },
    }
}

/// Figures of the strongest effects and a table of all.
pub(super) fn section<'a>(document: &mut Document<'a>, check: &'a ChainCheck) {
    if check.centroids.is_empty() {
        return;
    }
    document.heading(Centroids::Head);
    let figure = |effect: &'a CentroidEffect| {
        let caption = Centroids::Drawn {
            link: effect.link,
            change: Quantity::percent(-effect.change, 2),
        };
        let drawn = Figure::drawn(vec![caption.into()], |language| {
            centroid_effect(&check.limits, effect, language)
        });
        drawn.with_series(|| effect_series(&check.limits, effect))
    };
    let drawn = drawn_effects(check).into_iter().map(figure);
    document.put(Block::Figures(drawn.collect()));
    document.put(Block::Table(table(check)));
}

/// Changes of the limits of each joint.
fn effect_series(limits: &ChainLimits, effect: &CentroidEffect) -> Vec<Series> {
    let change = |new: &[f64], old: &[f64]| -> Vec<f64> {
        let pairs = new.iter().zip(old);
        pairs.map(|(new, old)| 100.0 * (new / old - 1.0)).collect()
    };
    let published = change(
        &effect.published_critical_n_m_rad,
        &limits.published_critical_n_m_rad,
    );
    let exact = change(&effect.necessary_n_m_rad, &limits.necessary_n_m_rad);
    let joints = (1..=exact.len()).map(|joint| joint as f64);
    vec![
        Series::numbers(Centroids::Joint, "", joints),
        Series::numbers(Centroids::PublishedChange, "%", published),
        Series::numbers(Centroids::ExactChange, "%", exact),
    ]
}

fn table(check: &ChainCheck) -> Table {
    let limits = &check.limits;
    let before = &limits.published_critical_n_m_rad;
    let unit = Unit::of(before, "N·m/rad");
    let with_load = check.centroids.iter().any(|effect| effect.load_factor.is_some());
    let row = |name: Centroids, k_cr: &[f64], equal: f64, load: Option<f64>| {
        let stiffness = |k: f64| Quantity::new(k, unit.clone(), Digits::Fixed(2));
        let mut row = vec![Cell::words(name)];
        row.extend(
            k_cr.iter()
                .zip(before)
                .map(|(new, old)| match new / old - 1.0 > RISE_LEAST {
                    true => Cell::Rises(stiffness(*new)),
                    false => Cell::number(stiffness(*new)),
                }),
        );
        row.push(Cell::number(stiffness(equal)));
        if with_load {
            row.push(Cell::Number(load.map(|load| Quantity::beside_one(load, 4))));
        }
        row
    };
    let own = check.stability.as_ref().map(|stability| stability.load_factor);
    let mut rows = vec![row(Centroids::None, before, limits.equal_joints_n_m_rad, own)];
    let mut changes: Vec<Quantity> = Vec::new();
    for effect in &check.centroids {
        let change = Quantity::percent(effect.change, 2);
        let name = Centroids::Link {
            link: effect.link,
            change: change.clone(),
        };
        rows.push(row(
            name,
            &effect.published_critical_n_m_rad,
            effect.equal_joints_n_m_rad,
            effect.load_factor,
        ));
        if !changes.iter().any(|known| known.text() == change.text()) {
            changes.push(change);
        }
    }
    let mut columns = vec![Column::words(Centroids::Lowered)];
    let joints = limits.necessary_n_m_rad.len();
    columns.extend((1..=joints).map(|joint| Column::numbers(Centroids::Critical { joint }, Unit::ratio())));
    columns.push(Column::numbers(Centroids::Equal, unit.clone()));
    if with_load {
        columns.push(Column::numbers(Centroids::LoadFactor, Unit::ratio()));
    }
    let caption = Centroids::Caption {
        changes,
        unit: Sentence::of_symbol(&unit.symbol),
    };
    Table {
        caption: vec![caption.into(), Centroids::CaptionMeaning.into()],
        columns,
        rows,
    }
}

/// The links whose published limits rise most, in order.
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
    effects.sort_by_key(|effect| effect.link);
    effects
}
