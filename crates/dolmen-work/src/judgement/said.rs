//! What the judgement says beside its fixed words.

use dolmen_words::message::Both;
use dolmen_words::{Language, Sentence, Template, messages};

messages! {
    /// Whether the model is the structure.
    pub enum EvidenceSaid in "judgement.evidence" {
        // possibly only the lowest frequency of each direction was compared
        Agrees => { en: "agrees (lowest frequencies)", ko: "계측과 일치(최저 고유진동수)" },
        Contradicted => { en: "contradicted", ko: "계측과 불일치" },
        TooRough(survey: String) => {
            en: "not decided: survey {survey} measured too roughly to tell",
            ko: "판별 불가({survey} 조사의 계측 오차가 커서 판단할 수 없음)",
        },
        InDoubt(why: Both) => { en: "in doubt: {why}", ko: "확인 필요({why})" },
        Unread(survey: String) => {
            en: "not compared with the records of survey {survey}, whose modes were not sought",
            ko: "비교 불가({survey} 조사의 진동 기록에서 모드를 아직 구하지 않음)",
        },
        NotCompared(survey: String) => {
            en: "not compared with survey {survey}: the model has no frequency, its stiffness is not given",
            ko: "비교 불가({survey} 조사의 고유진동수는 있으나 모델의 강성이 주어지지 않음)",
        },
        MarkedAssumed(survey: String) => {
            en: "the frequencies of survey {survey} are marked as assumed, not measured",
            ko: "{survey} 조사의 고유진동수가 계측값이 아니라 가정값으로 표시되어 있다",
        },
        MarkedAssumedApart { survey: String, direction: String, given: String, computed: String } => {
            en: "the frequencies of survey {survey} are marked as assumed, not measured; {direction}: {given} Hz there, {computed} Hz modelled",
            ko: "{survey} 조사의 고유진동수가 계측값이 아니라 가정값으로 표시되어 있다; {direction} 방향 {given} Hz, 모델 {computed} Hz",
        },
        Calibrated(survey: String) => {
            en: "not measured (calibrated to {survey})",
            ko: "계측 없음({survey} 조사로 추정한 강성)",
        },
        NotMeasured => { en: "not measured", ko: "계측 없음" },
    }
}

messages! {
    /// Why a model is in doubt whose lowest frequencies agree.
    pub enum DoubtSaid in "judgement.doubt" {
        OfSurvey { said: Both, survey: String } => { en: "{said} (survey {survey})", ko: "{survey} 조사: {said}" },
        Unpaired { number: usize, direction: String, computed: String } => {
            en: "no measured mode is paired with mode {number} of the model in direction {direction}, {computed} Hz",
            ko: "모델의 {direction} 방향 {number}차 모드 {computed} Hz와 짝지은 계측 모드 없음",
        },
        OfTorsion(number: usize) => { en: "mode {number} of torsion", ko: "비틀림 {number}차 모드" },
        Along { number: usize, direction: String } => {
            en: "mode {number} in direction {direction}",
            ko: "{direction} 방향 {number}차 모드",
        },
        OfModel(number: usize) => { en: "mode {number} of the model", ko: "모델의 {number}차 모드" },
        Apart { mode: Both, measured: String, computed: String, change: String } => {
            en: "{mode} {measured} Hz measured, {computed} Hz modelled, {change}",
            ko: "{mode} 실측 {measured} Hz, 모델 {computed} Hz, {change}",
        },
        ApartAndMore { apart: Both, more: usize } => {
            en: "{apart} and {more} more off",
            ko: "{apart} 외 {more}개 모드",
        },
        Unexplained => {
            en: "no stiffness explains the measured modes",
            ko: "계측 모드를 설명하는 강성이 없음",
        },
        UnexplainedAlong(direction: String) => {
            en: "no stiffness explains the measured modes in direction {direction}",
            ko: "{direction} 방향 계측 모드를 설명하는 강성이 없음",
        },
        StiffnessAlong { direction: String, ratio: String } => {
            en: "the stiffness found in direction {direction} is {ratio} times that of the file where it differs most",
            ko: "{direction} 방향에서 추정한 강성이 가장 크게 다른 곳에서 파일 값의 {ratio}배",
        },
        StiffnessInPlan { ratio: String } => {
            en: "the stiffness found in plan is {ratio} times that of the file where it differs most",
            ko: "평면에서 추정한 강성이 가장 크게 다른 곳에서 파일 값의 {ratio}배",
        },
        StiffnessOff { found: Both, deviations: String } => {
            en: "{found}, {deviations} standard deviations apart",
            ko: "{found}(표준편차의 {deviations}배 차이)",
        },
        BestOff { unexplained: Both, deviations: String } => {
            en: "{unexplained}, the best is {deviations} standard deviations off",
            ko: "{unexplained}(가장 가까운 값도 표준편차의 {deviations}배 차이)",
        },
    }
}

messages! {
    /// The word of the wind, with what acts.
    pub enum MovedSaid in "judgement.moved" {
        InWind { word: Both } => { en: "{word} in wind", ko: "풍응답 {word}" },
        UnderLoads { word: Both } => { en: "{word} under its static loads", ko: "정하중 변위 {word}" },
        UnderBoth { word: Both } => {
            en: "{word} under wind and static loads",
            ko: "풍하중·정하중 변위 {word}",
        },
        UnderAll { word: Both } => {
            en: "{word} under its combinations with the earthquake",
            ko: "지진을 포함한 하중조합의 변위 {word}",
        },
    }
}

messages! {
    /// The word of the weight, with the value of a contradicted model.
    pub enum WeightSaid in "judgement.weight" {
        IfRight { word: Both, load_factor: String } => {
            en: "{word} ({load_factor} if this model were right)",
            ko: "{word}(이 모델이 옳다면 {load_factor})",
        },
    }
}

/// All sentences of the judgement.
pub const SAID: [&[Template]; 4] = [
    EvidenceSaid::TEMPLATES,
    DoubtSaid::TEMPLATES,
    MovedSaid::TEMPLATES,
    WeightSaid::TEMPLATES,
];

/// A message as text.
pub(super) fn text(message: impl Into<Sentence>, language: Language) -> String {
    message.into().text(language)
}
