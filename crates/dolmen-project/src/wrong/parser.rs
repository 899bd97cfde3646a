//! The messages of the TOML reader, in Korean too.

use dolmen_words::message::Both;
use dolmen_words::{Template, messages};

messages! {
    /// Errors of the syntax, in the words of the TOML reader.
    #[allow(dead_code, reason = "they are looked up by their English")]
    pub(crate) enum OfParser in "project.error.parser" {
        DuplicateKey => { en: "duplicate key", ko: "키가 두 번 있다" },
        UnclosedArrayTable => { en: "unclosed array table", ko: "[[표]]의 괄호가 닫히지 않았다" },
        UnclosedTable => { en: "unclosed table", ko: "[표]의 괄호가 닫히지 않았다" },
        KeyWithNoValue => { en: "key with no value", ko: "키에 값이 없다" },
        MissingValueForKey => { en: "missing value for key", ko: "키의 값이 빠졌다" },
        MissingValue => { en: "missing value", ko: "값이 빠졌다" },
        ExtraEquals => { en: "extra `=`", ko: "`=`가 더 있다" },
        MissingInlineOpening => { en: "missing inline table opening", ko: "한 줄 표를 여는 괄호가 없다" },
        MissingArrayOpening => { en: "missing array opening", ko: "목록을 여는 괄호가 없다" },
        ExtraCommaArray => { en: "extra comma in array", ko: "목록에 쉼표가 더 있다" },
        EqualsInArray => { en: "unexpected `=` in array", ko: "목록 안에 `=`가 있다" },
        MissingCommaArray => { en: "missing comma between array elements", ko: "목록의 항목 사이에 쉼표가 없다" },
        UnclosedArray => { en: "unclosed array", ko: "목록의 괄호가 닫히지 않았다" },
        ExtraCommaTable => { en: "extra comma in inline table", ko: "한 줄 표에 쉼표가 더 있다" },
        ExtraAssignment => { en: "extra assignment between key-value pairs", ko: "키와 값의 쌍 사이에 `=`가 더 있다" },
        MissingKeyElement => { en: "missing key for inline table element", ko: "한 줄 표의 항목에 키가 없다" },
        MissingAssignment => { en: "missing assignment between key-value pairs", ko: "키와 값 사이에 `=`가 없다" },
        InvalidElement => { en: "invalid inline table element", ko: "한 줄 표의 항목이 아니다" },
        MissingCommaPairs => { en: "missing comma between key-value pairs", ko: "키와 값의 쌍 사이에 쉼표가 없다" },
        UnclosedInline => { en: "unclosed inline table", ko: "한 줄 표의 괄호가 닫히지 않았다" },
        UnexpectedKeyOrValue => { en: "unexpected key or value", ko: "값 뒤에 다른 내용이 있다" },
        ContentAfterComment => { en: "unexpected content between comment and newline", ko: "주석 뒤에 다른 내용이 있다" },
        UnexpectedContent => { en: "unexpected content", ko: "읽을 수 없는 내용이 있다" },
        InvalidPair => { en: "invalid key-value pair", ko: "키와 값의 쌍이 아니다" },
        MissingTableOpen => { en: "missing table open", ko: "[표]를 여는 괄호가 없다" },
        RecursionMet => { en: "cannot recurse further; max recursion depth met", ko: "괄호가 너무 여러 겹이다" },
        LiteralKey => { en: "keys cannot be multi-line literal strings", ko: "키를 여러 줄 문자열로 쓸 수 없다" },
        BasicKey => { en: "keys cannot be multi-line basic strings", ko: "키를 여러 줄 문자열로 쓸 수 없다" },
        RedundantSign => { en: "redundant numeric sign", ko: "수의 부호가 더 있다" },
        InvalidString => { en: "invalid string", ko: "문자열이 아니다" },
        InvalidBoolean => { en: "invalid boolean", ko: "true도 false도 아니다" },
        InvalidDate => { en: "invalid date-time", ko: "날짜나 시각이 아니다" },
        InvalidFloat => { en: "invalid float", ko: "소수가 아니다" },
        InvalidInteger => { en: "invalid integer number", ko: "정수가 아니다" },
        InvalidMantissa => { en: "invalid mantissa", ko: "수의 형식이 아니다" },
        LeadingZero => { en: "unexpected leading zero", ko: "수가 불필요한 0으로 시작한다" },
        UnexpectedSign => { en: "unexpected sign", ko: "부호를 쓸 수 없는 자리이다" },
        Underscore => { en: "`_` may only go between digits", ko: "`_`는 숫자 사이에만 쓸 수 있다" },
        MissingQuote => { en: "missing opening quote", ko: "여는 따옴표가 없다" },
        QuotedStrings => { en: "string values must be quoted", ko: "문자열은 따옴표로 묶는다" },
        CarriageReturn => { en: "carriage return must be followed by newline", ko: "줄바꿈 문자가 잘못되었다" },
        MissingEscaped => { en: "missing escaped value", ko: "`\\\\` 뒤에 올 문자가 없다" },
        TooFewDigits => { en: "too few unicode value digits", ko: "유니코드 번호의 자릿수가 모자란다" },
        InvalidValue => { en: "invalid value", ko: "쓸 수 없는 값이다" },
        EmptyKey => { en: "unquoted keys cannot be empty", ko: "키가 비어 있다" },
        InvalidKey => { en: "invalid unquoted key", ko: "따옴표 없이 쓸 수 없는 키이다" },
        InvalidComment => { en: "invalid comment character", ko: "주석에 쓸 수 없는 문자가 있다" },
        InvalidBasic => { en: "invalid basic string", ko: "문자열이 잘못되었다" },
        InvalidLiteral => { en: "invalid literal string", ko: "문자열이 잘못되었다" },
        InvalidMultiBasic => { en: "invalid multi-line basic string", ko: "여러 줄 문자열이 잘못되었다" },
        InvalidMultiLiteral => { en: "invalid multi-line literal string", ko: "여러 줄 문자열이 잘못되었다" },
        InvalidTable => { en: "invalid table", ko: "[표]가 잘못되었다" },
        IntegerOverflow => { en: "integer number overflowed", ko: "정수가 너무 크다" },
        FloatOverflow => { en: "floating-point number overflowed", ko: "수가 너무 크다" },
        InvalidBinary => { en: "invalid binary number", ko: "이진수가 아니다" },
        InvalidExponent => { en: "invalid exponent", ko: "수의 지수가 잘못되었다" },
        InvalidFraction => { en: "invalid fraction", ko: "소수점 뒤에 숫자가 없다" },
        InvalidHex => { en: "invalid hexadecimal number", ko: "십육진수가 아니다" },
        InvalidKeyOther => { en: "invalid key", ko: "키가 잘못되었다" },
    }
}

messages! {
    /// What the reader of TOML expects.
    #[allow(dead_code, reason = "they are looked up by their English")]
    pub(crate) enum Expected in "project.error.expected" {
        Key => { en: "key", ko: "키" },
        Value => { en: "value", ko: "값" },
        Newline => { en: "newline", ko: "줄바꿈" },
        Digits => { en: "digits", ko: "숫자" },
        Letters => { en: "letters", ko: "영문자" },
        Numbers => { en: "numbers", ko: "숫자" },
        Characters => { en: "characters", ko: "문자" },
        Basic => { en: "basic string", ko: "\"문자열\"" },
        Literal => { en: "literal string", ko: "'문자열'" },
        Hexadecimal => { en: "unicode hexadecimal value", ko: "유니코드 번호(십육진수)" },
        Multi => { en: "multi-line basic string", ko: "여러 줄 문자열" },
    }
}

messages! {
    /// What is wrong, with what should stand there.
    pub(crate) enum AtItsPlace in "project.error.at-its-place" {
        Wants { said: Both, wanted: Vec<Both> } => {
            en: "{said}, expected {wanted}",
            ko: "{said}. {wanted}이(가) 올 자리이다",
        },
    }
}

/// A message of the TOML reader, in both languages; English only where there is no Korean.
pub(crate) fn of_parser(english: &str) -> Both {
    let (said, wanted) = english.split_once(", expected ").unwrap_or((english, ""));
    let said = in_both(said, OfParser::TEMPLATES);
    let korean = match wanted {
        "" | "nothing" => said.korean,
        wanted => {
            let wanted = wanted
                .split(", ")
                .map(|one| in_both(one, Expected::TEMPLATES))
                .collect();
            Both::from(AtItsPlace::Wants { said, wanted }).korean
        }
    };
    Both {
        english: english.to_owned(),
        korean,
    }
}

fn in_both(english: &str, known: &[Template]) -> Both {
    let found = known.iter().find(|known| known.english == english);
    Both {
        english: english.to_owned(),
        korean: found.map_or(english, |known| known.korean).to_owned(),
    }
}
