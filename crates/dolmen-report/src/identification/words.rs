//! Parts of sentences on stiffness: the quantity, the number of solutions, the misfit.

use dolmen::structure::{Misfit, OfSpring, Proportion, Spring};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Parts of sentences on stiffness.
    pub(crate) enum Words in "identification.words" {
        Joint => { en: "joint", ko: "접합면" },
        Storey => { en: "storey", ko: "층" },
        JointStiffness => { en: "joint stiffness", ko: "접합부 강성" },
        StoreyStiffness => { en: "storey stiffness", ko: "층강성" },
        JointNumber(number: usize) => { en: "joint {number}", ko: "접합면 {number}" },
        StoreyNumber(number: usize) => { en: "storey {number}", ko: "{number}층" },
        Of { spring: Sentence, value: Quantity } => { en: "{spring}: {value}", ko: "{spring}: {value}" },
        Chain => { en: "chain", ko: "체인 모델" },
        Frame => { en: "frame", ko: "골조 모델" },
        WeightMoment => { en: "the weight moment above each joint", ko: "각 접합면 상부의 자중 모멘트" },
        MassMomentOverHeight => {
            en: "the mass moment above each storey over its height (a nearly straight first shape)",
            ko: "각 층 상부의 질량 모멘트를 층고로 나눈 값(거의 직선인 1차 모드형상)",
        },
        MassAbove => { en: "the mass above each storey", ko: "각 층 상부의 질량" },
        Relative(misfit: Quantity) => { en: "{misfit} (root mean square)", ko: "{misfit}(제곱평균제곱근)" },
        Deviations(misfit: Quantity) => {
            en: "{misfit} standard deviations (root mean square)",
            ko: "표준편차의 {misfit}배(제곱평균제곱근)",
        },
        OneFrequency => { en: "1 frequency gives", ko: "고유진동수 1개에서 얻는" },
        Frequencies(count: usize) => { en: "{count} frequencies give", ko: "고유진동수 {count}개에서 얻는" },
        OneFrequencyWithShapes => {
            en: "1 frequency with shape points gives",
            ko: "고유진동수 1개와 모드형상 측점에서 얻는",
        },
        FrequenciesWithShapes(count: usize) => {
            en: "{count} frequencies with shape points give",
            ko: "고유진동수 {count}개와 모드형상 측점에서 얻는",
        },
        OneDatum => { en: "1 independent datum", ko: "독립된 자료는 1개" },
        Data(count: usize) => { en: "{count} independent data", ko: "독립된 자료는 {count}개" },
        OneStart => { en: "1 start", ko: "시작점 1개" },
        Starts(count: usize) => { en: "{count} starts", ko: "시작점 {count}개" },
        OneMode => { en: "1 mode", ko: "모드 1개" },
        Modes(count: usize) => { en: "{count} modes", ko: "모드 {count}개" },
        OneMeasured => { en: "the 1 frequency", ko: "고유진동수 1개" },
        Measured(count: usize) => { en: "the {count} frequencies", ko: "고유진동수 {count}개" },
        OneMeasuredWithShapes => {
            en: "the 1 frequency and the measured shapes",
            ko: "고유진동수 1개와 계측 모드형상",
        },
        MeasuredWithShapes(count: usize) => {
            en: "the {count} frequencies and the measured shapes",
            ko: "고유진동수 {count}개와 계측 모드형상",
        },
    }
}

/// One message for one, another for several.
pub(super) fn counted(count: usize, one: Words, several: Words) -> Sentence {
    match count {
        1 => one,
        _ => several,
    }
    .into()
}

/// "joint", "storey".
pub(super) fn spring_word(spring: Spring) -> Sentence {
    match spring {
        Spring::Joint => Words::Joint,
        Spring::Storey => Words::Storey,
    }
    .into()
}

/// "joint stiffness".
pub(super) fn stiffness_word(spring: Spring) -> Sentence {
    match spring {
        Spring::Joint => Words::JointStiffness,
        Spring::Storey => Words::StoreyStiffness,
    }
    .into()
}

/// "chain", "frame".
pub(super) fn model_word(spring: Spring) -> Sentence {
    match spring {
        Spring::Joint => Words::Chain,
        Spring::Storey => Words::Frame,
    }
    .into()
}

/// "joint 3".
pub(super) fn numbered(spring: Spring, number: usize) -> Sentence {
    match spring {
        Spring::Joint => Words::JointNumber(number),
        Spring::Storey => Words::StoreyNumber(number),
    }
    .into()
}

/// "joint 3: 0.70" for each value.
pub(super) fn of_each(spring: Spring, values: &[OfSpring], unit: &Unit, digits: Digits) -> Vec<Sentence> {
    let one = |of: &OfSpring| {
        Words::Of {
            spring: numbered(spring, of.number),
            value: Quantity::new(of.value, unit.clone(), digits),
        }
        .into()
    };
    values.iter().map(one).collect()
}

/// The quantities that stiffness is proportional to.
pub(super) fn proportion_words(proportion: Proportion) -> Sentence {
    match proportion {
        Proportion::WeightMoment => Words::WeightMoment,
        Proportion::MassMomentOverHeight => Words::MassMomentOverHeight,
        Proportion::MassAbove => Words::MassAbove,
    }
    .into()
}

/// The misfit between a solution and the data.
pub(super) fn misfit_words(misfit: Misfit) -> Sentence {
    match misfit {
        Misfit::Relative(share) => Words::Relative(Quantity::new(share, Unit::percent(), Digits::Fixed(2))),
        Misfit::Deviations(count) => Words::Deviations(Quantity::new(count, Unit::ratio(), Digits::Fixed(1))),
    }
    .into()
}

/// "3 starts".
pub(super) fn starts_words(count: usize) -> Sentence {
    counted(count, Words::OneStart, Words::Starts(count))
}

/// "2 modes".
pub(super) fn modes_words(count: usize) -> Sentence {
    counted(count, Words::OneMode, Words::Modes(count))
}
