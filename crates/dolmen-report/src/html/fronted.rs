//! Sentences before and after the sections of a report, and of what was given.

use dolmen_words::message::Both;
use dolmen_words::{Digits, Language, Quantity, Sentence, Template, Unit, messages};

messages! {
    /// The front of a report, its sources and its end.
    pub(crate) enum Fronted in "report.front" {
        Reports => { en: "Reports", ko: "보고서 모음" },
        Findings => { en: "Findings", ko: "검토 결과 요약" },
        Sources => { en: "Evidence and sources", ko: "근거와 출처" },
        NotReported => { en: "Not reported on", ko: "보고서에서 제외됨" },
        StoneFalls(motion: Both) => { en: "a stone falls under {motion}", ko: "{motion} 작용 시 낙하" },
        Falls(motion: Both) => { en: "it falls under {motion}", ko: "{motion} 작용 시 전도" },
        LeansTooFar(motion: Both) => { en: "it leans too far under {motion}", ko: "{motion} 작용 시 과대 변위" },
        BeyondRoom => { en: "beyond its room", ko: "여유 공간 초과" },
        NoGravityLoad => { en: "No gravity load is given.", ko: "축력이 주어지지 않았다." },
        NoStiffness => { en: "Stiffness is not given.", ko: "강성이 주어지지 않았다." },
        Shaken(reasons: Both) => {
            en: "The verdict on its own weight is without shaking. With shaking: {reasons}.",
            ko: "자중에 대한 판정은 지진이 없을 때의 것이다. 지진을 고려한 판정: {reasons}.",
        },
        Contradicted { survey: String, measured: Quantity, computed: Quantity } => {
            en: "A survey contradicts this model: {survey} measured {measured}, the model has {computed}.",
            ko: "조사 결과가 이 모델과 일치하지 않는다. {survey} 조사의 실측 {measured}, 모델 {computed}.",
        },
        RestsOnAssumed { assumed: usize, all: usize } => {
            en: "This rests on assumed inputs, {assumed} of {all}; see the findings.",
            ko: "입력 {all}개 중 가정값 {assumed}개에 의존한다(결과 요약 참조).",
        },
        Thresholds(limit: Quantity) => {
            en: "stable: λ ≥ {limit} · marginal: 1 < λ < {limit} · unstable: λ ≤ 1 · unknown: not enough is given. λ is the factor on gravity at which the structure falls.",
            ko: "안정: λ ≥ {limit} · 여유 부족: 1 < λ < {limit} · 불안정: λ ≤ 1 · 판정 불가: 입력 부족. λ는 구조물이 안정을 잃는 중력의 배수(하중배율)이다.",
        },
        NoModel => {
            en: "There is no model: this is what the surveys show.",
            ko: "구조 모델이 없으며 조사 결과만으로 판단하였다.",
        },
        YearsScale => {
            en: "red: an alarm that no inspection or repair followed, or a limit of the file exceeded · amber: frequencies changed beyond chance",
            ko: "빨강: 점검·보수가 뒤따르지 않은 경보 또는 파일에서 정한 한계의 초과 · 주황: 우연으로 볼 수 없는 진동수 변화",
        },
        ComputedBy(program: Both) => { en: "Computed by {program}", ko: "계산 프로그램: {program}" },
        SamplesFrom { samples: usize, seed: u64 } => {
            en: "Samples of the inputs: {samples}, from seed {seed}",
            ko: "입력의 표본: {samples}개, 난수 초깃값 {seed}",
        },
        InputFrom(source: Both) => { en: "Input: {source}", ko: "입력 자료: {source}" },
        SiteCode(code: Both) => { en: "Earthquake demand: {code}", ko: "지진 요구: {code}" },
        ChainPaper(work: Both) => {
            en: "{work} The published criterion: eqs 38–43, Tables 1–3.",
            ko: "{work} 발표된 기준: 식 38–43, 표 1–3.",
        },
        FramePaper(work: Both) => {
            en: "{work} The printed stiffness: eq. 7.",
            ko: "{work} 논문의 강성: 식 7.",
        },
        StackPaper(work: Both) => {
            en: "{work} Rocking and sliding of joints: sec. 3, Figs 10 and 12; joint stiffness: Fig. 17.",
            ko: "{work} 접합면의 로킹과 미끄러짐: 3절, 그림 10, 12; 접합면 강성: 그림 17.",
        },
        BuildingPaper(work: Both) => {
            en: "{work} Mode centre: eq. 12.",
            ko: "{work} 모드 중심: 식 12.",
        },
        Closing => {
            en: "The same input gives the same numbers. This page supports the judgement of an engineer; it does not replace it.",
            ko: "입력이 같으면 결과도 같다. 이 보고서는 기술자의 판단을 돕기 위한 것이며 이를 대신하지 않는다.",
        },
    }
}

messages! {
    /// What was given.
    pub(crate) enum InputsGiven in "report.given" {
        Head => { en: "Appendix: What was given", ko: "부록: 입력 자료" },
        NoDimensions => {
            en: "No dimensions were given: only what was measured is reported.",
            ko: "치수가 주어지지 않아 계측 결과만 보고한다.",
        },
        Tinted { gravity: Quantity } => {
            en: "Inputs. Values marked as assumed are tinted; g = {gravity}.",
            ko: "입력값. 가정한 값은 바탕색으로 표시하였다; g = {gravity}.",
        },
        OfVariant { variant: Both } => {
            en: "Inputs that the variant “{variant}” changes; values marked as assumed are tinted.",
            ko: "대안 ‘{variant}’에서 달라지는 입력값. 가정한 값은 바탕색으로 표시하였다.",
        },
        Warnings => { en: "Warnings on reading the file", ko: "입력 파일에 대한 경고" },
        Survey { name: String } => { en: "Survey {name}", ko: "{name} 조사" },
        Records => { en: "Vibration records", ko: "진동 기록" },
        Source { source: Both } => { en: "Source: {source}", ko: "출처: {source}" },
        Temperature { temperature: Quantity } => { en: "Air temperature {temperature}", ko: "기온 {temperature}" },
        NoTemperature => { en: "Air temperature: unknown", ko: "기온: 미상" },
        Datum { datum: Both } => { en: "Datum: {datum}", ko: "기준점: {datum}" },
        Tilt { tilt: Both } => { en: "Tilt: {tilt}", ko: "기울기: {tilt}" },
    }
}

/// All sentences of the front and the end of a report.
pub(crate) const TEMPLATES: [&[Template]; 2] = [Fronted::TEMPLATES, InputsGiven::TEMPLATES];

/// A message as text.
pub(crate) fn text(message: impl Into<Sentence>, language: Language) -> String {
    message.into().text(language)
}

/// A frequency as the front prints it.
pub(super) fn hertz(frequency_hz: f64) -> Quantity {
    Quantity::new(frequency_hz, Unit::si("Hz"), Digits::Fixed(3))
}
