//! Answers about a chain of links: findings, and the sections of its check.

mod across;
mod centroids;
mod findings;
mod limits;
mod margins;
mod modes;
mod one_stone;
mod side_supports;
mod simulation;
mod simulation_ending;
mod simulation_run;
mod simulation_tables;
mod soil;

pub(crate) use findings::findings;
pub use simulation::chain_simulation_text;
pub(crate) use simulation::simulation_sections;
pub(crate) use simulation_ending::simulation_findings;
pub(crate) use soil::identified;

use crate::document::{Document, Figure};
use crate::figures::{chain_elevation, chain_series, stiffness_limits};
use dolmen::assess::ChainCheck;
use dolmen::stability::{ChainStability, Verdict};
use dolmen::structure::Chain;
use dolmen_project::{ChainAxis, ChainPart, Quantity as Input};
use dolmen_words::{Quantity, Template, messages};

messages! {
    /// The head and figures of the stability of a chain.
    pub(crate) enum Stability in "chain.stability" {
        Head => { en: "Stability", ko: "안정성" },
        Elevation => { en: "The chain in elevation.", ko: "체인 모델의 입면." },
        ElevationAcross => {
            en: "The chain in elevation, across: direction y.",
            ko: "체인 모델의 입면, 직각 방향(y).",
        },
        ElevationSigns { limit: Quantity, same: Quantity } => {
            en: "At each joint its margin, the other joints as they are: ● at least {limit}, ◆ between 1 and {same}, ✕ not above 1, ○ unknown.",
            ko: "각 접합면의 기호는 다른 접합면을 그대로 둔 여유도이다: ● {limit} 이상, ◆ 1과 {same} 사이, ✕ 1 이하, ○ 미상.",
        },
        Limits => { en: "Stiffness limits of each joint.", ko: "접합면별 강성 한계." },
        LimitsTinted => {
            en: "In the tinted part a joint is too soft whatever the others are; the published k_cr lies in it.",
            ko: "바탕색 범위에서는 다른 접합면이 어떠하든 강성이 부족하며, 발표된 k_cr은 이 범위 안에 있다.",
        },
        LimitsTogether => {
            en: "Beyond it the joints count together, so that being to its right is not yet enough.",
            ko: "그 오른쪽에서는 접합면의 강성이 함께 작용하므로 이 범위를 벗어난 것만으로는 충분하지 않다.",
        },
    }
}

/// Templates of the sentences on chains.
pub(crate) const TEMPLATES: [&[Template]; 14] = [
    across::Across::TEMPLATES,
    findings::Found::TEMPLATES,
    Stability::TEMPLATES,
    limits::Limits::TEMPLATES,
    margins::Margins::TEMPLATES,
    modes::Modes::TEMPLATES,
    one_stone::OneStone::TEMPLATES,
    side_supports::Supports::TEMPLATES,
    soil::OnSoil::TEMPLATES,
    centroids::Centroids::TEMPLATES,
    simulation::Shown::TEMPLATES,
    simulation_ending::Ending::TEMPLATES,
    simulation_tables::Tables::TEMPLATES,
    simulation_run::Run::TEMPLATES,
];

/// Results that depend on its stiffness only, for a version with the limits of another.
pub(crate) fn stiffness_sections<'a>(part: &ChainPart, check: &'a ChainCheck) -> Document<'a> {
    let mut document = Document::default();
    if let Some(stability) = &check.stability {
        margins::section(&mut document, stability);
    }
    modes::section(&mut document, part.build(&mut Input::nominal).ok(), check);
    across::section(&mut document, check);
    one_stone::section(&mut document, check);
    document
}

/// The sections of a chain.
pub(crate) fn sections<'a>(part: &ChainPart, check: &'a ChainCheck) -> Document<'a> {
    let names: Vec<Option<String>> = part.links.iter().map(|link| link.name.clone()).collect();
    let chain = part.build(&mut Input::nominal).ok();
    let mut document = Document::default();
    document.heading(Stability::Head);
    if let Some(chain) = chain.clone() {
        let stability = check.stability.as_ref();
        elevation(
            &mut document,
            (Stability::Elevation, chain),
            names.clone(),
            stability,
        );
    }
    let across = part.build_towards(ChainAxis::Across, &mut Input::nominal);
    if let (Some(of), Ok(chain)) = (&check.across, across) {
        let stability = of.stability.as_ref();
        elevation(
            &mut document,
            (Stability::ElevationAcross, chain),
            names,
            stability,
        );
    }
    let caption = vec![
        Stability::Limits.into(),
        Stability::LimitsTinted.into(),
        Stability::LimitsTogether.into(),
    ];
    let limits = Figure::drawn(caption, |language| {
        stiffness_limits(&check.limits, check.stability.as_ref(), language)
    });
    document.charted(limits.with_series(|| {
        let mut series = limits::series(&check.limits);
        series.extend(check.stability.iter().flat_map(margins::series));
        series
    }));
    limits::section(&mut document, check);
    if let Some(stability) = &check.stability {
        margins::section(&mut document, stability);
    }
    modes::section(&mut document, chain, check);
    across::section(&mut document, check);
    one_stone::section(&mut document, check);
    document
}

/// The published criterion for lower centres of mass; no result depends on it.
pub(crate) fn appendix(check: &ChainCheck) -> Document<'_> {
    let mut document = Document::default();
    centroids::section(&mut document, check);
    document
}

/// Height of each joint above the ground, m, lowest first.
pub(crate) fn joint_heights_m(part: &ChainPart) -> Vec<f64> {
    let chain = part.build(&mut Input::nominal);
    chain.map_or_else(|_| Vec::new(), |chain| chain.joint_heights_m())
}

fn elevation<'a>(
    document: &mut Document<'a>,
    (caption, chain): (Stability, Chain),
    names: Vec<Option<String>>,
    stability: Option<&'a ChainStability>,
) {
    let limit = Quantity::ratio(Verdict::MARGINAL_BELOW, 2);
    let signs = Stability::ElevationSigns {
        limit: limit.clone(),
        same: limit,
    };
    let (of, named) = (chain.clone(), names.clone());
    let drawn = Figure::drawn(vec![caption.into(), signs.into()], move |language| {
        chain_elevation(&chain, &names, stability, language)
    });
    document.charted(drawn.with_series(move || chain_series(&of, &named)));
}
