//! How well the data determine a stiffness, and the contribution of masses to its intervals.

use dolmen::structure::Visibility;
use dolmen_project::{Project, Quantity as Input, Structure};
use dolmen_words::number::subscript;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::surveyed::SurveyAnswer;

/// Fraction determined by the data below which a stiffness is not determined.
const SEEN_LEAST: f64 = 0.5;

messages! {
    /// Quantities that the data determine.
    pub(crate) enum Seen in "identification.seen" {
        Shares { shares: Vec<Sentence>, free: usize } => {
            en: "Share of each that the data see (at 1 all of it, at 0 nothing): {shares}; directions that stay free: {free}.",
            ko: "자료로 정해지는 정도(1 완전, 0 전혀 없음): {shares}; 정해지지 않는 강성 조합 {free}개.",
        },
        Share { spring: Sentence, share: Quantity } => { en: "{spring}: {share}", ko: "{spring}: {share}" },
        Little { springs: Vec<Sentence>, least: Quantity } => {
            en: "The data alone do not settle {springs} (share below {least}).",
            ko: "{springs}은(는) 자료만으로 정해지지 않는다(정해지는 정도 {least} 미만).",
        },
        Masses => {
            en: "The deviations of the stiffness are of the frequencies alone; the file gives weights and dimensions no scatter (cov), so they count as exact. 1 % more mass is 1 % more of every k.",
            ko: "강성의 표준편차는 진동수에서만 비롯한 것이다. 파일에 무게와 치수의 변동계수(cov)가 없어 정확한 값으로 보았다. 질량이 1 % 크면 모든 k가 1 % 크다.",
        },
        MassesScatter { most: Quantity } => {
            en: "The deviations of the stiffness are of the frequencies and of the scatter that the file gives weights and dimensions (up to {most}), each on its own; 1 % more mass is 1 % more of every k.",
            ko: "강성의 표준편차는 진동수의 오차와 파일에 준 무게·치수의 변동계수(최대 {most})를 서로 독립으로 보아 합한 값이다. 질량이 1 % 크면 모든 k가 1 % 크다.",
        },
    }
}

fn symbol(at: usize) -> Sentence {
    Sentence::of_symbol(&format!("k{}", subscript(at + 1)))
}

/// How well the data determine each stiffness.
pub(super) fn seen(visibility: &Visibility) -> Vec<Sentence> {
    let each = || visibility.seen.iter().enumerate();
    let share = |(at, share): (usize, &f64)| {
        Seen::Share {
            spring: symbol(at),
            share: Quantity::new(*share, Unit::ratio(), Digits::Fixed(2)),
        }
        .into()
    };
    let mut said = vec![
        Seen::Shares {
            shares: each().map(share).collect(),
            free: visibility.free_directions,
        }
        .into(),
    ];
    let unseen = each().filter(|(_, share)| **share < SEEN_LEAST);
    let springs: Vec<Sentence> = unseen.map(|(at, _)| symbol(at)).collect();
    if !springs.is_empty() {
        let least = Quantity::new(SEEN_LEAST, Unit::ratio(), Digits::Fixed(1));
        said.push(Seen::Little { springs, least }.into());
    }
    said
}

/// Contribution of the masses to deviations of stiffness, if a survey has any.
pub(super) fn masses(survey: &SurveyAnswer, project: &Project) -> Option<Sentence> {
    let mut solutions = survey
        .stiffness
        .iter()
        .flat_map(|found| &found.solutions.solutions);
    if !solutions.any(|solution| solution.stiffness_sd.is_some()) {
        return None;
    }
    let masses: Vec<&Input> = match &project.structure {
        Structure::Chain(part) => part.links.iter().map(|link| link.heaviness.quantity()).collect(),
        Structure::Frame(part) => part
            .storeys
            .iter()
            .map(|storey| storey.heaviness.quantity())
            .collect(),
        Structure::Stack(_) | Structure::Building(_) | Structure::Survey => Vec::new(),
    };
    let most = masses.iter().filter_map(|mass| mass.cov).fold(0.0, f64::max);
    let percent = |share: f64| Quantity::new(share, Unit::percent(), Digits::Fixed(0));
    let said = match most > 0.0 {
        true => Seen::MassesScatter { most: percent(most) },
        false => Seen::Masses,
    };
    Some(said.into())
}
