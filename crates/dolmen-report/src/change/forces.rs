//! Doubts about a change: what moved the structure differed between the surveys.

use super::quantities::hertz;
use crate::document::{Finding, Tone};
use dolmen::assess::SurveyChange;
use dolmen_words::{Values, messages};
use dolmen_work::answer::CompareAnswer;
use dolmen_work::unlike_forces::{UnlikeForces, within_bands};

messages! {
    /// Forces that shift modes.
    pub(crate) enum Forces in "change.forces" {
        InSpells { survey: String, at: Values } => {
            en: "NOT SURE, since the record of survey {survey} holds steps or a machine that ran for a while ({at}): such forces move the modes near them, so that a change shown here may be of the forces and not of the structure. Measure again without them.",
            ko: "확실하지 않다. {survey} 조사의 기록에 발걸음이나 한동안 운전한 기계의 진동이 있다({at}). 이런 힘은 가까운 모드의 진동수를 바꾸므로 여기에 나타난 변화는 구조물이 아니라 힘에 의한 것일 수 있다. 이런 진동 없이 다시 측정한다.",
        },
        FreeDecays { survey: String } => {
            en: "NOT SURE, since the record of survey {survey} is made up of free decays after blows: it shows the structure in larger swings, and the deviations of an ambient method do not hold in it. Compare records with like forces.",
            ko: "확실하지 않다. {survey} 조사의 기록은 타격 뒤의 자유감쇠로 이루어져 있다. 더 큰 진폭의 구조물을 나타내며 상시진동 방법의 표준편차도 맞지 않는다. 같은 조건에서 측정한 기록끼리 비교한다.",
        },
        BetweenHalves { survey: String } => {
            en: "NOT SURE, since the frequencies differ between the two halves of the record of survey {survey}: its modes are of no one state, and a change shown here may be one within that record. Compare a part of it (conditioning.cut).",
            ko: "확실하지 않다. {survey} 조사 기록의 앞 절반과 뒤 절반에서 고유진동수가 다르다. 그 모드는 어느 한 상태의 것이 아니며 여기에 나타난 변화는 그 기록 안의 변화일 수 있다. 기록의 일부를 비교한다(conditioning.cut).",
        },
        WithinBands { at: Values } => {
            en: "At {at} the change is less than half the bandwidth of the mode, and most modes did not change: steps or a machine near a mode, in one of the records alone, move it as much, and a record need not show them. Compare a further survey before you believe it.",
            ko: "{at} 모드의 변화는 대역폭의 절반보다 작고 다른 모드는 대부분 변하지 않았다. 한 기록에만 있는 발걸음이나 가까운 진동수의 기계도 모드를 그만큼 움직이며, 기록에 드러나지 않을 수도 있다. 변화로 판단하기 전에 다른 조사와도 비교한다.",
        },
    }
}

/// Doubts about the changes found; none without a change.
pub(super) fn doubts(answer: &CompareAnswer, change: &SurveyChange) -> Vec<Finding> {
    if change.changed().count() == 0 {
        return Vec::new();
    }
    let values = |at_hz: &[f64]| Values(at_hz.iter().copied().map(hertz).collect());
    let said = answer.unlike_forces.iter().map(|(survey, of)| {
        let survey = survey.clone();
        let said = match of {
            UnlikeForces::InSpells(at_hz) => Forces::InSpells {
                survey,
                at: values(at_hz),
            },
            UnlikeForces::FreeDecays(_) => Forces::FreeDecays { survey },
            UnlikeForces::BetweenHalves => Forces::BetweenHalves { survey },
        };
        Finding::key(Tone::Warn, said)
    });
    let mut all: Vec<Finding> = said.collect();
    // modes that the file gives were identified elsewhere
    let is_recorded = |name: &String| {
        let mut surveys = answer.project.surveys.iter();
        surveys.any(|survey| survey.name == *name && (survey.records.is_some() || !survey.setups.is_empty()))
    };
    let are_recorded = [&answer.from, &answer.to].into_iter().all(is_recorded);
    let within = within_bands(change).into_iter().filter(|_| are_recorded);
    let within: Vec<f64> = within.map(|mode| mode.from.frequency_hz).collect();
    if all.is_empty() && !within.is_empty() {
        let at = values(&within);
        all.push(Finding::key(Tone::Unknown, Forces::WithinBands { at }));
    }
    all
}
