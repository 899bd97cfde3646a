//! Errors of the syntax of a file, or its version.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Errors of the syntax of a file, or its version.
    pub(crate) enum WrongToml in "project.error.toml" {
        ThisIsNotToml(first: Both) => { en: "this is not TOML: {first}", ko: "TOML 문법 오류: {first}" },
        NumberBeginsWithDigit => {
            en: "a number begins with a digit: write 0.02, not .02",
            ko: "수는 숫자로 시작한다. .02가 아니라 0.02로 쓴다",
        },
        CommaMissing(next: String) => {
            en: "a comma is missing before {next}",
            ko: "{next} 앞에 쉼표가 없다",
        },
        WriteComma(next: String) => {
            en: "entries are separated by commas: write , before {next}",
            ko: "항목은 쉼표로 나눈다. {next} 앞에 ,를 쓴다",
        },
        ListNotClosed(key: String) => {
            en: "the list {key} that begins here is not closed",
            ko: "여기서 시작하는 목록 {key}이(가) 닫히지 않았다",
        },
        TableNotClosed(key: String) => {
            en: "the table of {key} that begins here is not closed",
            ko: "여기서 시작하는 {key}의 표가 닫히지 않았다",
        },
        CloseBefore { sign: String, line: String } => {
            en: "write {sign} before line {line}",
            ko: "{line}행 앞에 {sign}를 쓴다",
        },
        CloseAtEnd(sign: String) => { en: "write {sign} at the end", ko: "끝에 {sign}를 쓴다" },
        WideSigns(written: String) => {
            en: "{written} is written in signs of full width, which are no part of TOML outside of quotes",
            ko: "{written}은(는) 전각 문자이다. 따옴표 밖에는 전각 문자를 쓸 수 없다",
        },
        WritePlain(plain: String) => { en: "write {plain}", ko: "반각 {plain}(으)로 쓴다" },
        WideBlank => {
            en: "a blank of full width, or one that does not break, stands here",
            ko: "전각 공백이나 줄바꿈 없는 공백이 있다",
        },
        WritePlainBlank => { en: "write a plain blank instead", ko: "보통 공백으로 바꾼다" },
        BackslashBeginsSign(path: String) => {
            en: "in \"…\" a \\ begins a special sign: write the path with /, \"{path}\"",
            ko: "\"…\" 안에서 \\는 특수 문자의 시작이다. 경로는 /로 쓴다: \"{path}\"",
        },
        KeyIs { given: String, key: String } => {
            en: "keys are English words: is \"{given}\" {key}?",
            ko: "키는 영어로 쓴다. \"{given}\"은(는) {key}인가?",
        },
        QuoteKey(quoted: String) => {
            en: "a name with other signs stands in quotes: {quoted}",
            ko: "한글이나 빈칸이 있는 이름은 따옴표로 묶는다: {quoted}",
        },
        CurlyQuotesAreNo => {
            en: "curly quotes are no quotes of TOML: write plain ones, \"…\"",
            ko: "둥근 따옴표는 TOML의 따옴표가 아니다. 곧은 따옴표 \"…\"를 쓴다",
        },
        NumberHoldsComma(number: String) => {
            en: "the number {number} holds a comma",
            ko: "수 {number}에 쉼표가 있다",
        },
        CommaOfThousandsOrDecimals { thousands: String, decimal: String } => {
            en: "a number has no comma: write {thousands} if it separates thousands, {decimal} if it is a decimal sign",
            ko: "수에는 쉼표를 쓰지 않는다. 천 단위 구분이면 {thousands}, 소수점이면 {decimal}(으)로 쓴다",
        },
        ThousandsWrite(number: String) => {
            en: "a number has no thousands separator: write {number}",
            ko: "수에는 천 단위 구분 기호를 쓰지 않는다. {number}(으)로 쓴다",
        },
        DecimalCommaWrite(number: String) => {
            en: "a decimal comma? Write {number}",
            ko: "소수점으로 쉼표를 쓴 것인가? {number}(으)로 쓴다",
        },
        IsGivenTwiceIn(line: String) => {
            en: "\"{line}\" is given twice in the same table: keep one",
            ko: "같은 표에 \"{line}\"이(가) 두 번 있다. 하나만 남긴다",
        },
        SchemaIsNotKnown(given: String) => {
            en: "schema = {given} is not known",
            ko: "schema = {given}은(는) 알 수 없는 형식 버전이다",
        },
        MustBe(version: String) => { en: "must be {version}", ko: "{version}이어야 한다" },
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
