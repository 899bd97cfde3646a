//! Errors of a unit, and the words for what numbers measure.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Errors of a unit, and the words for what numbers measure.
    pub(crate) enum WrongUnit in "project.error.units" {
        MOrMm => { en: "m or mm", ko: "m 또는 mm" },
        TOrKg => { en: "t or kg", ko: "t 또는 kg" },
        GOrMS2 => { en: "g or m/s2", ko: "g 또는 m/s2" },
        OrNone => { en: "%, or none", ko: "%(또는 단위 없음)" },
        KgM3OrT => { en: "kg/m3 or t/m3", ko: "kg/m3 또는 t/m3" },
        KpaOrMpa => { en: "kPa or MPa", ko: "kPa 또는 MPa" },
        MmMOrDeg => { en: "mm/m or deg, or \"1/200\"", ko: "mm/m, deg 또는 \"1/200\"" },
        PlainNumberOrAngle => { en: "a plain number or an angle", ko: "무차원수(또는 각도)" },
        Length => { en: "a length", ko: "길이" },
        Area => { en: "an area", ko: "면적" },
        Mass => { en: "a mass", ko: "질량" },
        Frequency => { en: "a frequency", ko: "진동수" },
        Force => { en: "a force", ko: "힘" },
        MomentOrRotationalStiffness => { en: "a moment (or rotational stiffness)", ko: "모멘트(회전강성)" },
        ForcePerLengthLateral => { en: "a force per length (lateral stiffness)", ko: "단위길이당 힘(횡강성)" },
        RotationalDamping => { en: "a rotational damping", ko: "회전 감쇠" },
        ForcePerVelocityDashpot => { en: "a force per velocity (dashpot)", ko: "속도당 힘(감쇠)" },
        MomentOfInertia => { en: "a moment of inertia", ko: "관성모멘트" },
        Velocity => { en: "a velocity", ko: "속도" },
        Time => { en: "a time", ko: "시간" },
        Density => { en: "a density", ko: "밀도" },
        Stress => { en: "a stress", ko: "응력" },
        StressPerLengthStiffness => {
            en: "a stress per length (stiffness of a joint per area)",
            ko: "단위길이당 응력(접합면의 단위면적당 강성)",
        },
        ThereIsNoUnit => { en: "there is no unit", ko: "단위가 없다" },
        WhatStandsBelowIs => { en: "what stands below the / is not clear", ko: "/ 아래의 단위를 알 수 없다" },
        DidYouMean(nearest: String) => { en: "did you mean \"{nearest}\"?", ko: "\"{nearest}\"인가?" },
        TonOrTf => {
            en: "is it \"t\", a mass of 1000 kg, or \"tf\", its weight of 9.81 kN?",
            ko: "질량 1000 kg이면 \"t\", 그 무게 9.81 kN이면 \"tf\"로 쓴다",
        },
        WriteProductsBeforeOne => {
            en: "write products before one / at the end: \"kN*m/rad\"",
            ko: "곱을 먼저 쓰고 /는 끝에 한 번만 쓴다: \"kN*m/rad\"",
        },
        UnitsAreProductsAnd(symbols: String) => {
            en: "units are products and one quotient of {symbols}",
            ko: "단위는 다음 기호의 곱과 한 번의 나눗셈으로 쓴다: {symbols}",
        },
        WriteItAsE => {
            en: "write it as \"1e-4 rad\" or \"0.5 deg\"",
            ko: "\"1e-4 rad\" 또는 \"0.5 deg\"와 같이 쓴다",
        },
        ItBeginsWithNo => { en: "it begins with no number", ko: "수로 시작하지 않는다" },
        ItHasNoUnit => { en: "it has no unit", ko: "단위가 없다" },
        ItsUnitIsNot => { en: "its unit is not one of an angle", ko: "각도의 단위가 아니다" },
        ItIsNoNumber => { en: "it is no number", ko: "수가 아니다" },
        IsNotKnownUnit(symbol: String) => {
            en: "\"{symbol}\" is not a known unit",
            ko: "\"{symbol}\"은(는) 알 수 없는 단위이다",
        },
        PowerIsNot { symbol: String, most: String } => {
            en: "the power of \"{symbol}\" is not one of 1 to {most}",
            ko: "\"{symbol}\"의 지수가 1~{most}이(가) 아니다",
        },
        Refused { said: Both, help: Both } => { en: "{said}; {help}", ko: "{said}. {help}" },
        IsNoAngle { text: String, why: Both } => {
            en: "\"{text}\" is no angle: {why}",
            ko: "\"{text}\"은(는) 각도가 아니다: {why}",
        },
        At { of: String, said: Both } => { en: "{of}: {said}", ko: "{of}: {said}" },
        AtIn { of: String, text: String, said: Both } => {
            en: "{of}: in \"{text}\" {said}",
            ko: "{of}: \"{text}\"에서 {said}",
        },
    }
}
