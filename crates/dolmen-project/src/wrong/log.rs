//! Errors of a log of a project.

use dolmen_words::messages;

messages! {
    /// Errors of a log of a project.
    pub(crate) enum WrongLog in "project.error.log" {
        IsMissing { path: String } => { en: "{path} is missing", ko: "{path}이(가) 없다" },
        NeedsFile => {
            en: "needs the file of the logger, relative to the project file: \"tilt.dat\"",
            ko: "프로젝트 파일 기준의 기록 파일 경로가 필요하다: \"tilt.dat\"",
        },
        NeedsKind => {
            en: "needs \"tilt\", \"crack\" or \"temperature\"",
            ko: "\"tilt\", \"crack\", \"temperature\" 중 하나가 필요하다",
        },
        NeedsDirection => {
            en: "needs the direction in which it leans where the reading grows: \"x\"",
            ko: "읽은 값이 커질 때 기울어지는 방향이 필요하다: \"x\"",
        },
        NeedsUnitOfTilt => {
            en: "needs the unit of the readings: \"deg\", \"mrad\", \"mm/m\"",
            ko: "읽은 값의 단위가 필요하다: \"deg\", \"mrad\", \"mm/m\"",
        },
        NeedsUnitOfWidth => {
            en: "needs the unit of the readings: \"mm\"",
            ko: "읽은 값의 단위가 필요하다: \"mm\"",
        },
        NotCelsius { path: String, written: String } => {
            en: "{path} = \"{written}\" is not read",
            ko: "{path} = \"{written}\"은(는) 읽을 수 없다",
        },
        MustBeCelsius => {
            en: "must be \"°C\": convert the log, or leave the key out where it is in °C",
            ko: "\"°C\"이어야 한다. 기록을 환산하거나, °C로 기록되어 있으면 이 키를 삭제한다",
        },
        SaysNothing { path: String } => {
            en: "{path} says nothing of a log of this kind",
            ko: "{path}은(는) 이 종류의 기록에 쓰지 않는다",
        },
        LeaveItOut => { en: "leave it out", ko: "삭제한다" },
        SecondTemperature { path: String, first: String } => {
            en: "{path} is a second log of temperature, beside {first}",
            ko: "{path}은(는) {first}에 이은 두 번째 온도 기록이다",
        },
        OneTemperature => {
            en: "keep one: it explains the other logs and is the temperature of the surveys",
            ko: "하나만 남긴다. 온도 기록은 다른 기록을 설명하고 조사의 기온으로 쓰인다",
        },
        SameColumn { path: String, first: String } => {
            en: "{path} reads the same column of the same file as {first}",
            ko: "{path}이(가) {first}와(과) 같은 파일의 같은 열을 읽는다",
        },
        OwnColumn => {
            en: "each log needs a column of its own: look at the column of both",
            ko: "기록마다 다른 열을 지정해야 한다. 두 기록의 column을 확인한다",
        },
        OutOfBounds { path: String } => {
            en: "{path} is beyond what can be meant",
            ko: "{path}이(가) 있을 수 있는 범위를 벗어났다",
        },
        TiltWithin => {
            en: "must be within ±0.25, a limit from 0.00001 on: \"1/150\", \"0.4 deg\", \"7 mm/m\"",
            ko: "±0.25 이내, 한계는 0.00001 이상이어야 한다: \"1/150\", \"0.4 deg\", \"7 mm/m\"",
        },
        WidthWithin => {
            en: "must be within ±1 m, a limit from 0.01 mm on: \"2 mm\"",
            ko: "±1 m 이내, 한계는 0.01 mm 이상이어야 한다: \"2 mm\"",
        },
    }
}
