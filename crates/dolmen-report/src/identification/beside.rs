//! Findings on the stiffness from a survey, compared with that of the file.

use super::place::place;
use crate::document::{Finding, Tone};
use dolmen_words::{Digits, Quantity, Sentence, Unit, Values, messages};
use dolmen_work::beside_file::BesideFile;
use dolmen_work::surveyed::SurveyAnswer;

messages! {
    /// Stiffness found, compared with that of the file.
    pub(crate) enum Beside in "identification.beside" {
        Differs { survey: String, place: Sentence, ratios: Values } => {
            en: "Survey {survey}, {place}: the stiffness found is {ratios} times that of the file, the lowest first.",
            ko: "{survey} 조사, {place}: 추정한 강성은 파일 값의 {ratios}배이다(아래부터).",
        },
        DiffersBy { survey: String, place: Sentence, ratios: Values, deviations: Quantity } => {
            en: "Survey {survey}, {place}: the stiffness found is {ratios} times that of the file, the lowest first, up to {deviations} standard deviations apart.",
            ko: "{survey} 조사, {place}: 추정한 강성은 파일 값의 {ratios}배이며(아래부터), 차이는 최대 표준편차의 {deviations}배이다.",
        },
        PlanDiffers { survey: String, ratios: Values } => {
            en: "Survey {survey}, in plan: the k_x, k_y and k_θ found are {ratios} times those of the file.",
            ko: "{survey} 조사, 평면: 추정한 k_x, k_y, k_θ는 파일 값의 {ratios}배이다.",
        },
        PlanDiffersBy { survey: String, ratios: Values, deviations: Quantity } => {
            en: "Survey {survey}, in plan: the k_x, k_y and k_θ found are {ratios} times those of the file, up to {deviations} standard deviations apart.",
            ko: "{survey} 조사, 평면: 추정한 k_x, k_y, k_θ는 파일 값의 {ratios}배이며, 차이는 최대 표준편차의 {deviations}배이다.",
        },
        Exchanged { survey: String, first: String, second: String } => {
            en: "PROBABLY A SLIP: survey {survey} finds in direction {first} the stiffness that the file has in {second}, and in {second} that of {first}. Are the directions of the sensors exchanged, or those of the file?",
            ko: "입력 오류 의심: {survey} 조사에서 {first} 방향으로 추정한 강성은 파일의 {second} 방향 값과 같고, {second} 방향은 {first} 방향 값과 같다. 센서의 방향이나 파일의 방향이 서로 바뀐 것이 아닌가?",
        },
    }
}

/// Differences between a survey and the file.
pub(super) fn findings(survey: &SurveyAnswer) -> Vec<Finding> {
    let name = || survey.name.clone();
    let exchanged = survey.exchanged_directions.as_ref().map(|[first, second]| {
        let (first, second) = (first.clone(), second.clone());
        let said = Beside::Exchanged {
            survey: name(),
            first,
            second,
        };
        Finding::key(Tone::Warn, said).with_code("sensor-slip")
    });
    let of_directions = survey.stiffness.iter().filter_map(|answer| {
        let beside = answer.beside_file.as_ref().filter(|of| of.differs)?;
        let (survey, place, ratios) = (name(), place(answer), ratios(beside));
        let said = match most(beside) {
            Some(deviations) => Beside::DiffersBy {
                survey,
                place,
                ratios,
                deviations,
            },
            None => Beside::Differs {
                survey,
                place,
                ratios,
            },
        };
        Some(Finding::key(tone(beside), said))
    });
    let plan = survey.plan.as_ref().and_then(|plan| plan.beside_file.as_ref());
    let in_plan = plan.filter(|of| of.differs).map(|beside| {
        let (survey, ratios) = (name(), ratios(beside));
        let said = match most(beside) {
            Some(deviations) => Beside::PlanDiffersBy {
                survey,
                ratios,
                deviations,
            },
            None => Beside::PlanDiffers { survey, ratios },
        };
        Finding::key(tone(beside), said)
    });
    exchanged
        .into_iter()
        .chain(of_directions)
        .chain(in_plan)
        .collect()
}

/// A difference from an assumed value is no alarm.
fn tone(beside: &BesideFile) -> Tone {
    match beside.is_assumed {
        true => Tone::Plain,
        false => Tone::Warn,
    }
}

fn ratios(beside: &BesideFile) -> Values {
    let of = |ratio: &f64| Quantity::new(*ratio, Unit::ratio(), Digits::Significant(3));
    Values(beside.ratios.iter().map(of).collect())
}

fn most(beside: &BesideFile) -> Option<Quantity> {
    let all = beside.deviations.as_ref()?;
    let most = all.iter().fold(0.0_f64, |most, of| most.max(*of));
    Some(Quantity::ratio(most, 2))
}
