//! Errors of the report.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Errors of the report.
    pub(crate) enum WrongReport in "project.error.report" {
        NeedsTextOrEn => {
            en: "needs text, or {{ en = \"…\", ko = \"…\" }}",
            ko: "문자열 또는 {{ en = \"…\", ko = \"…\" }}이 필요하다",
        },
        WriteItOrTake => {
            en: "write it, or take the key out: what is not given is left out of the report",
            ko: "값을 쓰거나 키를 삭제한다. 주어지지 않은 항목은 보고서에서 빠진다",
        },
        IsNotDay { path: String, given: String } => {
            en: "{path} = \"{given}\" is not a day",
            ko: "{path} = \"{given}\"은(는) 날짜가 아니다",
        },
        MustBeDayOf => { en: "must be a day of the calendar: year, month, day", ko: "연, 월, 일로 된 날짜이어야 한다" },
        WriteItAs => { en: "write it as \"2026-11-23\"", ko: "\"2026-11-23\"과 같이 쓴다" },
        IsNoPartOf { path: String, name: String } => {
            en: "{path} = \"{name}\" is no part of this structure",
            ko: "{path} = \"{name}\"은(는) 이 구조물의 부재가 아니다",
        },
        NamePartAsFile => {
            en: "name a part as the file does; one without a name by its number from below, \"3\"",
            ko: "파일에 있는 부재 이름을 쓴다. 이름이 없는 부재는 아래에서부터 센 번호(\"3\")로 쓴다",
        },
        MustBeOneOf(parts: Both) => { en: "must be one of {parts}", ko: "다음 중 하나이어야 한다: {parts}" },
        PartsOfStructure => { en: "the parts of the structure", ko: "구조물의 부재" },
        AndMore { some: String, count: String } => {
            en: "{some} and {count} more",
            ko: "{some} 외 {count}개",
        },
        HasOneOfLatitude(path: String) => {
            en: "{path} has one of latitude and longitude",
            ko: "{path}에 latitude와 longitude 중 하나만 있다",
        },
        NeedsBothOrNeither => { en: "needs both or neither", ko: "둘 다 있거나 둘 다 없어야 한다" },
        GiveBothInDegrees => {
            en: "give both in degrees, north and east positive",
            ko: "둘 다 도(°)로 입력한다. 북위와 동경이 양수이다",
        },
        IsEmpty(file_path: String) => { en: "{file_path} is empty", ko: "{file_path}이(가) 비어 있다" },
        NeedsNameOfJpeg => { en: "needs the name of a JPEG or PNG file", ko: "JPEG 또는 PNG 파일 이름이 필요하다" },
        HasReadingOfOther(path: String) => {
            en: "{path} has a reading of the other method",
            ko: "{path}에 다른 방법의 측정값이 있다",
        },
        MustBe(own: Both) => { en: "must be {own}", ko: "{own}이어야 한다" },
        ListEachTestBy => { en: "list each test by itself", ko: "시험마다 따로 쓴다" },
        HasNoResult(path: String) => { en: "{path} has no result", ko: "{path}에 결과가 없다" },
        NeedsStrengthOrBoth(own: Both) => {
            en: "needs {own}, strength or both",
            ko: "{own}, strength 중 하나 이상이 필요하다",
        },
        IsNoGradeOf { value_path: String, english: String } => {
            en: "{value_path} = \"{english}\" is no grade of the periodic inspection",
            ko: "{value_path} = \"{english}\"은(는) 정기점검의 등급이 아니다",
        },
        MustBeBC => { en: "must be A, B, C, D, E or F", ko: "A, B, C, D, E 또는 F이어야 한다" },
        ForAnotherScaleWrite => {
            en: "for another scale write its name: scale = \"…\"",
            ko: "다른 등급 체계이면 그 이름을 쓴다: scale = \"…\"",
        },
    }
}
