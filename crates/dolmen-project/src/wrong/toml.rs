//! What is wrong with the syntax of a file, or its version.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// What is wrong with the syntax of a file, or its version.
    pub(crate) enum WrongToml in "project.error.toml" {
        ThisIsNotToml { first: Both } => { en: "this is not TOML: {first}", ko: "TOML 문법 오류: {first}" },
        NumberBeginsWithDigit => {
            en: "a number begins with a digit: write 0.02, not .02",
            ko: "수는 숫자로 시작한다. .02가 아니라 0.02로 쓴다",
        },
        CurlyQuotesAreNo => {
            en: "curly quotes are no quotes of TOML: write plain ones, \"…\"",
            ko: "둥근 따옴표는 TOML의 따옴표가 아니다. 곧은 따옴표 \"…\"를 쓴다",
        },
        NumberHoldsComma { number: String } => {
            en: "the number {number} holds a comma",
            ko: "수 {number}에 쉼표가 있다",
        },
        CommaOfThousandsOrDecimals { thousands: String, decimal: String } => {
            en: "a number has no comma: write {thousands} if it separates thousands, {decimal} if it is a decimal sign",
            ko: "수에는 쉼표를 쓰지 않는다. 천 단위 구분이면 {thousands}, 소수점이면 {decimal}(으)로 쓴다",
        },
        ThousandsWrite { number: String } => {
            en: "a number has no thousands separator: write {number}",
            ko: "수에는 천 단위 구분 기호를 쓰지 않는다. {number}(으)로 쓴다",
        },
        DecimalCommaWrite { number: String } => {
            en: "a decimal comma? Write {number}",
            ko: "소수점으로 쉼표를 쓴 것인가? {number}(으)로 쓴다",
        },
        IsGivenTwiceIn { line: String } => {
            en: "\"{line}\" is given twice in the same table: keep one",
            ko: "같은 표에 \"{line}\"이(가) 두 번 있다. 하나만 남긴다",
        },
        SchemaIsNotKnown { given: String } => {
            en: "schema = {given} is not known",
            ko: "schema = {given}은(는) 알 수 없는 형식 버전이다",
        },
        MustBe { version: String } => { en: "must be {version}", ko: "{version}이어야 한다" },
        FileIsOfNewer { dolmen: String, version: String, number: String } => {
            en: "the file is of a newer format: this is Dolmen {dolmen}, which reads schema {version}; get a Dolmen that reads schema {number}",
            ko: "더 새로운 형식의 파일이다. 이 Dolmen {dolmen}은(는) schema {version}까지 읽으므로 schema {number}을(를) 읽는 Dolmen을 설치한다",
        },
        DolmenReadsSchemaWrite { dolmen: String, version: String } => {
            en: "Dolmen {dolmen} reads schema {version}: write schema = {version}",
            ko: "Dolmen {dolmen}은(는) schema {version}을(를) 읽는다. schema = {version}(으)로 쓴다",
        },
    }
}
