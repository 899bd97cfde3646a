//! Required stiffness of the joints of a chain under its weights, compared with published criteria.

use super::findings::why_unsafe;
use crate::document::{Block, Cell, Column, Document, Series, Table, table_series};
use dolmen::assess::ChainCheck;
use dolmen::stability::{ChainLimits, Verdict};
use dolmen_words::{Digits, Quantity, Sentence, Unit, Values, messages};

messages! {
    /// Limits of the joints.
    pub(crate) enum Limits in "chain.limits" {
        Caption(unit: Sentence) => {
            en: "Limits of the joints, {unit}, lowest joint first.",
            ko: "접합면별 한계, {unit}, 아래에서부터.",
        },
        CaptionMeaning => {
            en: "From weights and lengths alone; M is exact when every other joint is rigid.",
            ko: "무게와 길이만으로 정해지며, M은 다른 접합면이 모두 강체일 때 정확하다.",
        },
        Joint => { en: "Joint", ko: "접합면" },
        Number(number: usize) => { en: "{number}", ko: "{number}" },
        Critical => { en: "published k_cr", ko: "발표된 k_cr" },
        Buckling => { en: "published P·H", ko: "발표된 P·H" },
        BucklingRatio => { en: "P·H / k_cr", ko: "P·H / k_cr" },
        Exact => { en: "exact limit M", ko: "정확한 한계 M" },
        ExactRatio => { en: "M / k_cr", ko: "M / k_cr" },
        Gravity => { en: "gravity moment G", ko: "중력 모멘트 G" },
        Factors => { en: "Factors.", ko: "필요 배수." },
        FactorsMeaning => {
            en: "By how much a set of stiffnesses must be multiplied, all by the same, before the chain stands.",
            ko: "강성 전체에 같은 값을 곱하여 안정하게 되는 최소 배수이다.",
        },
        AllAtOnce => { en: "All joints at once", ko: "모든 접합면에 동시에 적용" },
        Needed => { en: "factor needed to stand", ko: "안정에 필요한 배수" },
        ExactSingle => { en: "exact single-joint limits M", ko: "단일 접합면의 정확한 한계 M" },
        NoneEnough => { en: "none is enough", ko: "어떤 배수로도 부족" },
        NotUsed { least: Quantity, most: Quantity } => {
            en: "This review does not use the published criterion k_cr; the joints of this pole have {least} to {most} times that stiffness.",
            ko: "이 검토는 발표된 기준 k_cr을 쓰지 않았으며, 이 당간의 접합부 강성은 그 {least}~{most}배이다.",
        },
        Eigenvalues { eigenvalues: Values, equal: Quantity } => {
            en: "The stiffness matrix with the published k_cr has the eigenvalues {eigenvalues}: each negative one is a shape in which the chain falls. If all joints are equal, each needs more than {equal}.",
            ko: "발표된 k_cr로 만든 강성행렬의 고유값은 {eigenvalues}이다. 음의 고유값마다 그 형상으로 안정을 잃는다. 모든 접합면이 같다면 각각 {equal}보다 커야 한다.",
        },
    }
}

/// Limits of the joints, why the published ones are unsafe, and factors.
pub(super) fn section(document: &mut Document<'_>, check: &ChainCheck) {
    let limits = &check.limits;
    document.put(Block::Table(table(limits)));
    if limits.published_critical_n_m_rad.len() > 1 {
        match not_used(check) {
            // the verdict on a pole of known stiffness does not use the criterion
            Some(said) => document.put(Block::Paragraph(vec![said.into(), why_unsafe(limits)])),
            None => document.put(Block::Warning(why_unsafe(limits))),
        }
        document.put(Block::Table(factors(limits)));
        let unit = Unit::of(&limits.published_eigenvalues_n_m_rad, "N·m/rad");
        let eigenvalue = |value: &f64| Quantity::new(*value, unit.clone(), Digits::Fixed(2));
        document.paragraph(Limits::Eigenvalues {
            eigenvalues: Values(
                limits
                    .published_eigenvalues_n_m_rad
                    .iter()
                    .map(eigenvalue)
                    .collect(),
            ),
            equal: Quantity::engineering(limits.equal_joints_n_m_rad, "N·m/rad", 4),
        });
    }
}

/// How much stiffer the joints of a standing chain are than the published criterion requires.
fn not_used(check: &ChainCheck) -> Option<Limits> {
    let stability = check.stability.as_ref()?;
    let stands = matches!(stability.verdict, Verdict::Stable | Verdict::Marginal);
    let pairs = stability
        .joints
        .iter()
        .zip(&check.limits.published_critical_n_m_rad);
    let mut ratios: Vec<f64> = pairs
        .map(|(joint, k_cr)| joint.stiffness_n_m_rad / k_cr)
        .collect();
    ratios.sort_by(f64::total_cmp);
    let (least, most) = (*ratios.first()?, *ratios.last()?);
    (stands && least > 0.0).then(|| Limits::NotUsed {
        least: Quantity::ratio(least, 3),
        most: Quantity::ratio(most, 3),
    })
}

/// The limits as numbers of the figure.
pub(super) fn series(limits: &ChainLimits) -> Vec<Series> {
    table_series(&table(limits))
}

fn table(limits: &ChainLimits) -> Table {
    let all = [
        &limits.published_critical_n_m_rad,
        &limits.published_buckling_n_m_rad,
        &limits.necessary_n_m_rad,
    ];
    let all: Vec<f64> = all.into_iter().flatten().copied().collect();
    let unit = Unit::of(&all, "N·m/rad");
    let stiffness = |k: f64| Quantity::new(k, unit.clone(), Digits::Fixed(2));
    let row = |i: usize| {
        let k_cr = limits.published_critical_n_m_rad[i];
        let ratio = limits.published_ratio.get(i);
        vec![
            Cell::words(Limits::Number(i + 1)),
            Cell::Bad(stiffness(k_cr)),
            Cell::number(stiffness(limits.published_buckling_n_m_rad[i])),
            Cell::Number(ratio.map(|ratio| Quantity::ratio(*ratio, 3))),
            Cell::number(stiffness(limits.necessary_n_m_rad[i])),
            Cell::number(Quantity::ratio(limits.necessary_n_m_rad[i] / k_cr, 3)),
            Cell::number(stiffness(limits.gravity_moment_n_m_rad[i])),
        ]
    };
    let numbers = |head: Limits| Column::numbers(head, Unit::ratio());
    Table {
        caption: vec![
            Limits::Caption(Sentence::of_symbol(&unit.symbol)).into(),
            Limits::CaptionMeaning.into(),
        ],
        columns: vec![
            Column::words(Limits::Joint),
            numbers(Limits::Critical),
            numbers(Limits::Buckling),
            numbers(Limits::BucklingRatio),
            numbers(Limits::Exact),
            numbers(Limits::ExactRatio),
            numbers(Limits::Gravity),
        ],
        rows: (0..limits.necessary_n_m_rad.len()).map(row).collect(),
    }
}

/// Factors on the published and the exact limits.
fn factors(limits: &ChainLimits) -> Table {
    let factor = |value: f64| Quantity::beside_one(value, 4);
    let published = match limits.published_critical_factor {
        Some(value) => Cell::Bad(factor(value)),
        None => Cell::BadWords(Limits::NoneEnough.into()),
    };
    let row = |words: Limits, cell: Cell| vec![Cell::words(words), cell];
    Table {
        caption: vec![Limits::Factors.into(), Limits::FactorsMeaning.into()],
        columns: vec![
            Column::words(Limits::AllAtOnce),
            Column::numbers(Limits::Needed, Unit::ratio()),
        ],
        rows: vec![
            row(Limits::Critical, published),
            row(Limits::ExactSingle, Cell::number(factor(limits.necessary_factor))),
            row(
                Limits::Buckling,
                Cell::number(factor(limits.published_buckling_factor)),
            ),
        ],
    }
}
