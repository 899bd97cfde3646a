//! Probable slips of every kind of structure.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Probable slips of every kind of structure.
    pub(crate) enum Slip in "project.error.slips" {
        NotYetCome { path: String, today: String } => {
            en: "{path} is of a day that has not come yet: it is {today} at the latest",
            ko: "{path}은(는) 아직 오지 않은 날짜이다. 오늘은 늦어도 {today}이다",
        },
        IsTheYearRight => {
            en: "the latest survey is what the model and the verdict rest on: is the year right?",
            ko: "모델과 판정은 가장 최근 조사에 근거한다. 연도가 맞는가?",
        },
        DeviationLarge { path: String, sd: String, written: String, percent: String } => {
            en: "{path} = {written} has a standard deviation of {sd}, {percent} % of it, and would contradict no model",
            ko: "{path} = {written}의 표준편차 {sd}은(는) 값의 {percent} %이므로 어떤 모델과도 일치하게 된다",
        },
        FrequenciesAreKnown => {
            en: "frequencies are measured to 0.1 to 5 %: is it in per cent, or a decimal place off?",
            ko: "고유진동수의 측정 오차는 0.1~5 %이다. % 단위로 썼거나 소수점 위치가 잘못되었는가?",
        },
        GravityIsNotThat(written: String) => {
            en: "gravity = {written} is not that of the Earth, 9.78 to 9.83 m/s2",
            ko: "gravity = {written}은(는) 지구의 중력가속도(9.78~9.83 m/s2)가 아니다",
        },
        GalMS2And => {
            en: "981 gal, 9.81 m/s2 and 1 g are the same",
            ko: "981 gal, 9.81 m/s2, 1 g은 같은 값이다",
        },
        ButStructuresSwayAt { path: String, written: String, least: String, most: String } => {
            en: "{path} = {written}, but structures sway at {least} to {most} Hz",
            ko: "{path} = {written}인데, 구조물의 진동수는 {least}~{most} Hz이다",
        },
        LengthsAllOff { count: usize, unit: String } => {
            en: "units.length is \"{unit}\", and {count} lengths of the file are then not those of a structure",
            ko: "units.length가 \"{unit}\"인데, 그러면 파일의 길이 {count}개가 구조물의 크기가 아니다",
        },
        MeantUnitOfLength(meant: String) => {
            en: "did you mean units = {{ length = \"{meant}\" }}? A length that is right as it is takes its own unit: \"1.2 m\"",
            ko: "units = {{ length = \"{meant}\" }}를 쓰려던 것인가? 지금 단위가 맞는 길이는 \"1.2 m\"처럼 단위를 따로 붙인다",
        },
        DidYouMeanKhz => { en: "did you mean kHz?", ko: "kHz 단위인가?" },
        DidYouMeanMhz => { en: "did you mean mHz or 1/min?", ko: "mHz 또는 1/min 단위인가?" },
        ButStructuresHaveTo { path: String, written: String } => {
            en: "{path} = {written}, but structures have 0.005 to 0.1",
            ko: "{path} = {written}인데, 구조물의 감쇠비는 0.005~0.1이다",
        },
        DidYouMeanEither { name: String, other: String } => {
            en: "did you mean {name} or {other}?",
            ko: "단위가 {name} 또는 {other}인가?",
        },
        DidYouMean(name: String) => { en: "did you mean {name}?", ko: "단위가 {name}인가?" },
        ItIsAboutWhat(ratio: String) => {
            en: "it is about {ratio} × what is usual: check its unit",
            ko: "보통 값의 약 {ratio}배이다. 단위를 확인한다",
        },
        Above { ratio: String, part: Both } => {
            en: "{ratio} × the {part} above",
            ko: "위 {part}의 {ratio}배이다",
        },
        Below { ratio: String, part: Both } => {
            en: "{ratio} × the {part} below",
            ko: "아래 {part}의 {ratio}배이다",
        },
        OfAbove { ratio: String, part: Both } => {
            en: "{ratio} of the {part} above",
            ko: "위 {part}의 {ratio}이다",
        },
        OfBelow { ratio: String, part: Both } => {
            en: "{ratio} of the {part} below",
            ko: "아래 {part}의 {ratio}이다",
        },
        Beside { path: String, written: String, beside: Both } => {
            en: "{path} = {written}, {beside}",
            ko: "{path} = {written}인데, {beside}",
        },
        Link => { en: "link", ko: "부재" },
        Stone => { en: "stone", ko: "석재" },
    }
}
