//! The hazard behind the rates, and the share of the rates that comes from beyond it.

use super::words::{g, state};
use crate::document::{Block, Document};
use dolmen_project::HazardSource;
use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::study::{ALLOWED_DRIFT, StudyAnswer, YEARS};

/// Smallest share of a rate from beyond the points of the hazard that is reported. Our choice.
const BEYOND_SAID: f64 = 0.1;

messages! {
    /// Hazard.
    pub(crate) enum Hazard in "study.hazard" {
        PowerLaw { source: Sentence, exponent: Quantity, years: Quantity } => {
            en: "Rates a year and probabilities in {years} years: by {source}, a power law with k = {exponent}.",
            ko: "연간 초과율과 {years}년 확률: {source}, k = {exponent}인 멱함수.",
        },
        Points { source: Sentence, least: Quantity, most: Quantity, years: Quantity } => {
            en: "Rates a year and probabilities in {years} years: by {source}, {least} to {most}.",
            ko: "연간 초과율과 {years}년 확률: {source}, {least}–{most}.",
        },
        Kds17 => {
            en: "the return periods of KDS 17 10 00, 50 to 2400 years, soil included",
            ko: "KDS 17 10 00의 재현주기 50–2400년(지반 증폭 포함)",
        },
        File => {
            en: "the hazard of the file, its peaks taken as those at the surface (no soil factor is applied)",
            ko: "입력 파일의 재해도(지표면 값으로 보고 지반 증폭을 적용하지 않음)",
        },
        Extrapolated { shares: Vec<Sentence> } => {
            en: "Extrapolated: shaking beyond these peaks, where the slope of the ends goes on and nobody gave it, makes {shares}.",
            ko: "외삽: 재해도가 주어지지 않아 끝 기울기를 연장한 범위의 지반운동이 {shares}을(를) 차지한다.",
        },
        Share { share: Quantity, state: Sentence } => {
            en: "{share} of the rate of {state}",
            ko: "{state} 초과율의 {share}",
        },
    }
}

/// The basis of the rates; empty without a hazard.
pub(super) fn section(document: &mut Document<'_>, answer: &StudyAnswer) {
    let Some(hazard) = &answer.hazard else { return };
    let source = match hazard.source {
        HazardSource::Kds17 => Hazard::Kds17.into(),
        HazardSource::File => Hazard::File.into(),
    };
    let years = Quantity::ratio(YEARS, 2);
    let points = hazard.curve.points();
    let end = |point: Option<&[f64; 2]>| g(answer, point.map_or(0.0, |point| point[0]));
    document.note(match hazard.curve.exponent() {
        Some(exponent) => Hazard::PowerLaw {
            source,
            exponent: Quantity::ratio(exponent, 3),
            years,
        },
        None => Hazard::Points {
            source,
            least: end(points.first()),
            most: end(points.last()),
            years,
        },
    });
    document
        .blocks
        .extend(extrapolated(answer).map(|said| Block::Warning(said.into())));
}

/// Rates that depend on shaking without a given hazard.
pub(super) fn extrapolated(answer: &StudyAnswer) -> Option<Hazard> {
    let all = answer.fragilities().iter().flat_map(|one| &one.states);
    let share = |of: usize| {
        let risks = all
            .clone()
            .filter(|own| own.state == of)
            .filter_map(|own| own.risk);
        let shares = risks.map(|risk| risk.share_below_points + risk.share_above_points);
        let most = shares.fold(0.0, f64::max);
        let said = Hazard::Share {
            share: Quantity::percent(most, 2),
            state: state(answer, of),
        };
        (most > BEYOND_SAID).then(|| said.into())
    };
    let shares: Vec<Sentence> = (0..=ALLOWED_DRIFT).filter_map(share).collect();
    (!shares.is_empty()).then_some(Hazard::Extrapolated { shares })
}
