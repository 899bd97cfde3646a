//! The seismic demand at a site: findings, and the section of its numbers, its spectrum and the comparison.

mod comparison;
mod findings;
mod first;
mod local_mechanisms;
mod periods;
mod site;
mod unverified;
mod velocity;
mod words;

pub(crate) use findings::findings;
pub(crate) use site::{ground_word, type_word};

use crate::document::{Document, Figure, Series};
use crate::figures::{design_spectrum, spectrum_curves};
use crate::limits;
use dolmen_words::{Quantity, Sentence, Template, messages};
use dolmen_work::part_limit::Compared;
use dolmen_work::state::DemandAnswer;

messages! {
    /// The head and figure of the demand of a site.
    pub(crate) enum Demand in "demand" {
        Period => { en: "period", ko: "주기" },
        Acceleration(damping: Quantity) => {
            en: "spectral acceleration, damping ratio {damping}",
            ko: "응답 가속도, 감쇠비 {damping}",
        },
        Head => { en: "Earthquake demand at the site", ko: "부지의 설계지진" },
        Source(source: String) => { en: "{source}", ko: "{source}" },
        Spectrum => { en: "Design spectrum.", ko: "설계 응답스펙트럼." },
        SpectrumOfStack => {
            en: "Dots: the first periods, at the damping of the site; level line: the acceleration at which it begins to move, less the vertical acceleration.",
            ko: "점은 1차 주기(부지의 감쇠비), 수평선은 수직 가속도를 고려한 거동 시작 가속도이다.",
        },
        SpectrumOfOthers => {
            en: "Dots: the first periods, each at the damping of the table.",
            ko: "점은 1차 주기이다(표의 감쇠비).",
        },
        BearsUnknown => {
            en: "What acceleration this structure bears is not computed; S_a is for the engineer's own check.",
            ko: "이 구조물의 거동 시작 가속도는 계산하지 않았다. S_a는 기술자가 별도로 검토할 때 쓰는 값이다.",
        },
    }
}

/// Templates of the sentences on the demand of a site.
pub(crate) const TEMPLATES: [&[Template]; 10] = [
    findings::Found::TEMPLATES,
    first::First::TEMPLATES,
    words::Words::TEMPLATES,
    unverified::NotHeld::TEMPLATES,
    Demand::TEMPLATES,
    site::Numbers::TEMPLATES,
    comparison::Compared::TEMPLATES,
    local_mechanisms::Local::TEMPLATES,
    periods::Periods::TEMPLATES,
    velocity::ByVelocity::TEMPLATES,
];

/// The section of a site.
pub(crate) fn sections(answer: &DemandAnswer) -> Document<'_> {
    let mut document = Document::default();
    document.heading(Demand::Head);
    document.paragraph(Demand::Source(answer.site.spectrum.source.clone()));
    site::section(&mut document, &answer.site);
    if let Some(why) = &answer.refused {
        document.note(findings::Found::NotCompared(why.clone()));
    }
    match &answer.stack {
        Some(stack) => {
            comparison::section(&mut document, stack);
            if let Some(of) = &answer.by_velocity {
                velocity::section(&mut document, of);
            }
            local_mechanisms::section(&mut document, answer);
        }
        None => periods::section(&mut document, &answer.spectral),
    }
    for of in &answer.compared.not_compared {
        document.note(findings::not_compared(of));
    }
    limits::section(&mut document, &answer.compared.parts, answer.drift_limit.as_ref());
    let is_compared = answer.stack.is_some() || answer.compared != Compared::default();
    if !is_compared && answer.refused.is_none() {
        document.note(Demand::BearsUnknown);
    }
    if let Some(said) = unverified::unverified(&answer.site) {
        document.note(said);
    }
    let meaning = match answer.stack {
        Some(_) => Some(Demand::SpectrumOfStack),
        None => (!answer.spectral.is_empty()).then_some(Demand::SpectrumOfOthers),
    };
    let caption = std::iter::once(Demand::Spectrum).chain(meaning);
    let drawn = Figure::drawn(caption.map(Sentence::from).collect(), |language| {
        design_spectrum(answer, language)
    });
    document.charted(drawn.with_series(|| spectrum_series(answer)));
    document
}

/// Periods and accelerations of the curves.
fn spectrum_series(answer: &DemandAnswer) -> Vec<Series> {
    let curves = spectrum_curves(answer).into_iter().flat_map(|curve| {
        let damping = Quantity::percent(curve.damping_ratio, 3);
        let points = curve.points;
        [
            Series::numbers(Demand::Period, "s", points.iter().map(|point| point[0])),
            Series::numbers(
                Demand::Acceleration(damping),
                "g",
                points.iter().map(|point| point[1]),
            ),
        ]
    });
    curves.collect()
}
