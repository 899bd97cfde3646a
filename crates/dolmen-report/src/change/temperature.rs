//! Known temperatures of two surveys, and their effect.

use super::quantities::temperature;
use crate::document::{Block, Document};
use dolmen::assess::{SurveyChange, TemperatureKnowledge};
use dolmen_project::Project;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Temperatures of two surveys.
    pub(crate) enum Weather in "change.temperature" {
        NotMeasured => {
            en: "The temperature of at least one of the two surveys is not known: a change of frequency may be the weather's.",
            ko: "두 조사 중 하나 이상의 기온을 알 수 없으므로 고유진동수의 변화는 기온에 의한 것일 수 있다.",
        },
        Same => { en: "Both surveys at the same temperature.", ko: "두 조사의 기온이 같다." },
        SameMeasured { temperature: Quantity } => {
            en: "Both surveys at {temperature}.",
            ko: "두 조사의 기온은 {temperature}(으)로 같다.",
        },
        Unexplained { difference: Sentence } => {
            en: "{difference}, and what that does to this structure is not known: a change of frequency may be the weather's.",
            ko: "{difference} 기온의 영향을 알 수 없으므로 고유진동수의 변화는 기온에 의한 것일 수 있다.",
        },
        Corrected { difference: Sentence } => {
            en: "{difference}; what that explains is taken out.",
            ko: "{difference} 그 영향은 제거하였다.",
        },
        Warmer { step: Quantity } => {
            en: "The later survey was {step} warmer than the earlier one",
            ko: "이후 조사의 기온이 이전 조사보다 {step} 높다.",
        },
        Colder { step: Quantity } => {
            en: "The later survey was {step} colder than the earlier one",
            ko: "이후 조사의 기온이 이전 조사보다 {step} 낮다.",
        },
        WarmerMeasured { before: Quantity, after: Quantity, step: Quantity } => {
            en: "The surveys were made at {before} and {after}, the later one {step} warmer",
            ko: "두 조사의 기온은 {before}와(과) {after}이며, 이후 조사가 {step} 높다.",
        },
        ColderMeasured { before: Quantity, after: Quantity, step: Quantity } => {
            en: "The surveys were made at {before} and {after}, the later one {step} colder",
            ko: "두 조사의 기온은 {before}와(과) {after}이며, 이후 조사가 {step} 낮다.",
        },
        Fitted { mode: usize, per_c: Quantity, surveys: usize, coldest: Quantity, warmest: Quantity } => {
            en: "Effect of temperature on mode {mode}: {per_c} per °C (± standard deviation), fitted to {surveys} surveys at {coldest} to {warmest}; the structure is taken as unchanged through them.",
            ko: "모드 {mode}의 기온 영향: 1 °C당 {per_c}(± 표준편차). {coldest}에서 {warmest}까지의 조사 {surveys}회로 추정하였으며, 그동안 구조물은 변하지 않은 것으로 보았다.",
        },
    }
}

/// The knowledge, by the difference of the temperatures.
pub(super) fn known(change: &SurveyChange) -> Sentence {
    match &change.temperature {
        TemperatureKnowledge::NotMeasured => Weather::NotMeasured.into(),
        TemperatureKnowledge::Same => Weather::Same.into(),
        TemperatureKnowledge::Unexplained { step_c } | TemperatureKnowledge::Corrected { step_c } => {
            let step = temperature(step_c.abs());
            let difference = match *step_c < 0.0 {
                true => Weather::Colder { step },
                false => Weather::Warmer { step },
            };
            differing(change, difference)
        }
    }
}

/// The same with the temperatures themselves.
pub(super) fn measured(project: &Project, change: &SurveyChange) -> Sentence {
    let of = |name: &str| {
        let survey = project.surveys.iter().find(|survey| survey.name == name);
        survey.and_then(|survey| survey.temperature_c)
    };
    let (Some(before_c), Some(after_c)) = (of(&change.from), of(&change.to)) else {
        return known(change);
    };
    let (before, after) = (temperature(before_c), temperature(after_c));
    let step = temperature((after_c - before_c).abs());
    match change.temperature {
        TemperatureKnowledge::NotMeasured => known(change),
        TemperatureKnowledge::Same => Weather::SameMeasured { temperature: before }.into(),
        TemperatureKnowledge::Unexplained { .. } | TemperatureKnowledge::Corrected { .. } => differing(
            change,
            match after_c < before_c {
                true => Weather::ColderMeasured { before, after, step },
                false => Weather::WarmerMeasured { before, after, step },
            },
        ),
    }
}

fn differing(change: &SurveyChange, difference: Weather) -> Sentence {
    let difference = difference.into();
    match change.temperature.leaves_doubt() {
        true => Weather::Unexplained { difference }.into(),
        false => Weather::Corrected { difference }.into(),
    }
}

/// The temperature lines, if fitted.
pub(super) fn fitted(document: &mut Document<'_>, change: &SurveyChange) {
    let modes = change.modes.iter().enumerate();
    let lines = modes.filter_map(|(i, mode)| {
        let line = mode.fitted.as_ref()?;
        let per_c = Quantity {
            sd_si: Some(line.sd_per_c),
            ..Quantity::new(line.per_c, Unit::percent(), Digits::Significant(3))
        };
        let said = Weather::Fitted {
            mode: i + 1,
            per_c,
            surveys: line.surveys,
            coldest: temperature(line.range_c[0]),
            warmest: temperature(line.range_c[1]),
        };
        Some(said.into())
    });
    let lines: Vec<Sentence> = lines.collect();
    if !lines.is_empty() {
        document.put(Block::List(lines));
    }
}
