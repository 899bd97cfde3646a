//! Findings on records whose shapes contradict a chain or frame.

use super::solutions::{other_quantities, stiffness_quantities};
use crate::document::{Finding, Tone};
use dolmen::structure::{ChannelChange, Choice};
use dolmen_words::{Digits, Quantity, Sentence, Unit, Values, messages};
use dolmen_work::surveyed::{StiffnessAnswer, StiffnessDoubt, SurveyAnswer};

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
        OnMachine { mode: Quantity, said: Sentence } => {
            en: "not chosen, for a machine runs at the frequency of the mode at {mode}, and moves its frequency and shape. {said} Measure while the machine rests.",
            ko: "판정하지 않는다. {mode} 모드의 진동수에서 기계가 가동하여 그 진동수와 모드형상이 달라진다. {said} 기계가 멈춘 동안 다시 계측한다.",
        },
        MoreModes { modes: usize, choices: Vec<Sentence> } => {
            en: "not chosen, for more modes move along this direction than the model has ({modes}), and which of them are its own decides k: {choices}. The others are torsion, or of something that the model lacks: measure again with a second sensor across the floor, or write the modes of this direction into the survey.",
            ko: "판정하지 않는다. 이 방향으로 움직이는 모드가 모델의 모드 수({modes}개)보다 많으며, 어느 것이 이 방향의 모드인가에 따라 강성 k가 달라진다: {choices}. 나머지는 비틀림 모드이거나 모델에 없는 것의 모드이다. 바닥 반대쪽에 센서를 하나 더 두어 다시 계측하거나 이 방향의 모드를 조사에 적는다.",
        },
        With { frequencies: Values, values: Values } => {
            en: "{values} with {frequencies}",
            ko: "{frequencies}이면 {values}",
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
pub(super) fn not_chosen(answer: &StiffnessAnswer, doubt: StiffnessDoubt) -> Doubted {
    let is_one = answer.solutions.choice == Choice::One;
    let one = answer.solutions.solutions.first().filter(|_| is_one);
    let values = one.map(|one| Values(stiffness_quantities(answer, one)));
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
        StiffnessDoubt::MoreModes => more_modes(answer),
        StiffnessDoubt::Machine { mode_hz } => Doubted::OnMachine {
            mode: Quantity::new(mode_hz, Unit::si("Hz"), Digits::Fixed(3)),
            said,
        },
    }
}

/// The stiffness with every choice of the modes.
fn more_modes(answer: &StiffnessAnswer) -> Doubted {
    let hertz = |all: &[f64]| {
        let each = all
            .iter()
            .map(|hz| Quantity::new(*hz, Unit::si("Hz"), Digits::Fixed(3)));
        Values(each.collect())
    };
    let own = answer.solutions.solutions.iter();
    let own = own
        .filter(|_| answer.solutions.choice != Choice::Impossible)
        .map(|one| (&answer.frequencies_hz, Values(stiffness_quantities(answer, one))));
    let others = answer.other_choices.iter();
    let others = others.map(|of| (&of.frequencies_hz, Values(other_quantities(answer, of))));
    Doubted::MoreModes {
        modes: answer.frequencies_hz.len(),
        choices: own
            .chain(others)
            .map(|(frequencies_hz, values)| {
                let frequencies = hertz(frequencies_hz);
                Doubted::With { frequencies, values }.into()
            })
            .collect(),
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
