//! Answers about a building with torsion: findings, and the sections of its check.

mod dampers;
mod findings;
mod modes;
mod spectrum;
mod storeys;
mod wind;
mod wind_findings;
mod words;

pub(crate) use dampers::rest;
pub(crate) use findings::{findings, variant_findings};
pub(crate) use wind::InWind;
pub(crate) use wind_findings::slender;
pub(crate) use words::{
    axis_words, beside, direction_words, fixed, floor_words, kilonewtons, millimetres, name, number, of_both,
    scaled, significant, stroke_words, tonnes,
};

use crate::document::Document;
use dolmen_project::{BuiltDamper, LoadsPart};
use dolmen_words::{Template, messages};
use dolmen_work::building::BuildingAnswer;

messages! {
    /// The heading of the stability of a building.
    pub(crate) enum Stability in "building.stability" {
        Head => { en: "Stability", ko: "안정성" },
    }
}

/// Templates of the sentences on buildings.
pub(crate) const TEMPLATES: [&[Template]; 9] = [
    words::Words::TEMPLATES,
    findings::Found::TEMPLATES,
    Stability::TEMPLATES,
    storeys::Storeys::TEMPLATES,
    modes::Modes::TEMPLATES,
    dampers::Dampers::TEMPLATES,
    spectrum::Spectrum::TEMPLATES,
    wind::InWind::TEMPLATES,
    wind_findings::Blown::TEMPLATES,
];

/// The sections of a building.
pub(crate) fn sections<'a>(answer: &'a BuildingAnswer, loads: &'a LoadsPart) -> Document<'a> {
    let mut document = Document::default();
    document.heading(Stability::Head);
    storeys::section(&mut document, answer);
    if let Some(standing) = &answer.stands {
        modes::section(&mut document, standing);
        dampers::section(&mut document, &standing.dampers);
        spectrum::section(&mut document, answer, standing);
        wind::section(&mut document, answer, standing, loads);
    }
    document
}

/// The dampers alone.
pub(crate) fn damper_table(dampers: &[BuiltDamper]) -> Document<'static> {
    let mut document = Document::default();
    dampers::section(&mut document, dampers);
    document
}
