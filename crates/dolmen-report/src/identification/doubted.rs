//! Findings on records whose shapes contradict a chain or frame.

use crate::document::{Finding, Tone};
use dolmen::structure::ChannelChange;
use dolmen_words::{Digits, Quantity, Sentence, Unit, Values, messages};
use dolmen_work::surveyed::{StiffnessDoubt, SurveyAnswer};

messages! {
    /// Doubts about the shapes of a record.
    pub(crate) enum Doubted in "identification.doubted" {
        OneChange { survey: String, unexplained: Quantity, change: Sentence, changed: Quantity } => {
            en: "PROBABLY A SLIP (survey {survey}): {unexplained} of the mode shapes is not of the model, whatever its stiffness, and {changed} with {change}. Check the sign, place and unit of each sensor.",
            ko: "입력 오류 의심({survey} 조사): 강성을 어떻게 정하여도 모드형상의 {unexplained}이(가) 모델과 맞지 않으며, {change} {changed}이다. 각 센서의 부호, 위치, 단위를 확인해야 한다.",
        },
        Changes { survey: String, unexplained: Quantity, changes: Vec<Sentence>, changed: Quantity } => {
            en: "PROBABLY A SLIP (survey {survey}): {unexplained} of the mode shapes is not of the model, whatever its stiffness, and about {changed} with one of these changes, which the shapes do not tell apart: {changes}. Check the sign, place and unit of each sensor.",
            ko: "입력 오류 의심({survey} 조사): 강성을 어떻게 정하여도 모드형상의 {unexplained}이(가) 모델과 맞지 않으며, 다음 중 하나를 바꾸면 약 {changed}이다(모드형상으로는 서로 구별되지 않는다): {changes}. 각 센서의 부호, 위치, 단위를 확인해야 한다.",
        },
        Contradict { survey: String, unexplained: Quantity } => {
            en: "Survey {survey}: {unexplained} of the mode shapes of its record is not of the model, whatever its stiffness, and no one change of the sensors explains it. Check the directions of the sensors against the axes of the model, which modes are which, and the masses.",
            ko: "{survey} 조사: 강성을 어떻게 정하여도 기록의 모드형상 중 {unexplained}이(가) 모델과 맞지 않으며, 센서 하나를 바꾸어서는 설명되지 않는다. 센서의 방향과 모델의 축, 모드의 구분, 질량을 확인해야 한다.",
        },
        Turned(channel: String) => { en: "the sign of {channel} changed", ko: "{channel}의 부호를 바꾸면" },
        Exchanged { first: String, second: String } => {
            en: "{first} and {second} exchanged",
            ko: "{first}와(과) {second}을(를) 맞바꾸면",
        },
        Scaled { channel: String, factor: Quantity } => {
            en: "{channel} times about {factor}",
            ko: "{channel}에 약 {factor}을(를) 곱하면",
        },
        NotChosen(said: Sentence) => {
            en: "not chosen, for the sensors of the record are doubted. {said}",
            ko: "판정하지 않는다. 기록의 센서가 의심스럽다. {said}",
        },
        NotChosenShapes { unexplained: Quantity, said: Sentence } => {
            en: "not chosen, for {unexplained} of the shapes of these modes is not of the model. {said}",
            ko: "판정하지 않는다. 이 모드들의 형상 중 {unexplained}이(가) 모델과 맞지 않는다. {said}",
        },
        Would(values: Values) => {
            en: "Taken as they are, they would give k, the lowest first: {values}.",
            ko: "그대로 쓰면 강성 k는 아래부터 {values}이다.",
        },
        Nothing => { en: "Correct them and identify again.", ko: "바로잡은 뒤 다시 추정해야 한다." },
    }
}

/// Evidence of the shapes of a record against the model.
pub(super) fn finding(survey: &SurveyAnswer) -> Option<Finding> {
    let doubt = survey.shape_doubt.as_ref()?;
    let name = survey.name.clone();
    let (unexplained, changed) = (share(doubt.unexplained), share(doubt.changed));
    let said = match doubt.changes.as_slice() {
        [] => Doubted::Contradict {
            survey: name,
            unexplained,
        },
        [one] => Doubted::OneChange {
            survey: name,
            unexplained,
            change: change(one),
            changed,
        },
        several => Doubted::Changes {
            survey: name,
            unexplained,
            changes: several.iter().map(change).collect(),
            changed,
        },
    };
    Some(Finding::key(Tone::Warn, said).with_code("sensor-slip"))
}

/// Why a solution is not chosen; `said` is its text.
pub(super) fn not_chosen(doubt: StiffnessDoubt, values: Option<Values>) -> Doubted {
    let said: Sentence = match values {
        Some(values) => Doubted::Would(values).into(),
        None => Doubted::Nothing.into(),
    };
    match doubt {
        StiffnessDoubt::Sensors => Doubted::NotChosen(said),
        StiffnessDoubt::Shapes { unexplained } => Doubted::NotChosenShapes {
            unexplained: share(unexplained),
            said,
        },
    }
}

fn change(of: &ChannelChange) -> Sentence {
    match of {
        ChannelChange::Turned { channel } => Doubted::Turned(channel.clone()),
        ChannelChange::Exchanged {
            channels: [first, second],
        } => Doubted::Exchanged {
            first: first.clone(),
            second: second.clone(),
        },
        ChannelChange::Scaled { channel, factor } => Doubted::Scaled {
            channel: channel.clone(),
            factor: Quantity::new(*factor, Unit::ratio(), Digits::Trimmed(6)),
        },
    }
    .into()
}

fn share(of: f64) -> Quantity {
    Quantity::percent(of.max(0.0), 2)
}
