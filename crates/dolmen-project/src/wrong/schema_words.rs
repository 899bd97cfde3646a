//! The meaning of keys and the allowed values: the words of the schema, in Korean too.

use dolmen_words::message::Both;
use dolmen_words::messages;
use serde_json::{Map, Value};
use std::sync::LazyLock;

/// Korean text of each key's English description in the schema: the file that [`korean`] searches.
const KOREAN: &str = include_str!("../schema_ko.json");

messages! {
    /// What a value must be, where its type alone does not say it.
    #[allow(dead_code, reason = "they are looked up by their English")]
    pub(crate) enum Needed in "project.needed" {
        DirectionOrVector => {
            en: "\"x\", \"-x\", \"y\", \"-y\", \"z\", \"-z\" or three numbers",
            ko: "\"x\", \"-x\", \"y\", \"-y\", \"z\", \"-z\" 또는 세 수",
        },
        KoreanSoil => {
            en: "\"S1\" (rock) to \"S5\" (deep and soft)",
            ko: "\"S1\"(암반)~\"S5\"(깊고 연약한 지반)",
        },
        NumbersOrRange => {
            en: "a list of numbers, or {{ from = …, to = …, steps = … }}",
            ko: "수의 목록 또는 {{ from = …, to = …, steps = … }}",
        },
        ListOrUnknown => {
            en: "a list, lowest first, \"unknown\", \"identified\" or {{ source = \"identified\", survey = … }}",
            ko: "아래에서부터 쓴 목록, \"unknown\", \"identified\" 또는 {{ source = \"identified\", survey = … }}",
        },
        NumberOrText => {
            en: "a number, or text with its unit (\"38.95 kN\")",
            ko: "수 또는 단위를 붙인 문자열(\"38.95 kN\")",
        },
        NumberTextOrTable => {
            en: "a number, text with its unit (\"38.95 kN\"), or a table {{ value = …, cov = …, source = … }}",
            ko: "수, 단위를 붙인 문자열(\"38.95 kN\") 또는 표 {{ value = …, cov = …, source = … }}",
        },
        TableOfPaths => {
            en: "a table of paths: {{ \"joint.friction\" = … }}",
            ko: "경로의 표 {{ \"joint.friction\" = … }}",
        },
        WindOrSheltered => {
            en: "a table {{ speed = …, means = \"gust\", force_coefficient = … }}, or \"sheltered\"",
            ko: "표 {{ speed = …, means = \"gust\", force_coefficient = … }} 또는 \"sheltered\"",
        },
        ColumnNameOrNumber => { en: "the column's name, or its number from 1", ko: "열의 이름 또는 1부터 센 번호" },
        BlockNames => {
            en: "the name of a block, a list of names, or \"ground\"",
            ko: "부재의 이름, 이름의 목록 또는 \"ground\"",
        },
    }
}

/// The description of a key in Korean.
pub(crate) fn korean(english: &str) -> Option<&'static str> {
    static ALL: LazyLock<Map<String, Value>> =
        LazyLock::new(|| serde_json::from_str(KOREAN).unwrap_or_default());
    ALL.get(english).and_then(Value::as_str)
}

/// Words of the schema in both languages; English alone where there is no Korean.
pub(crate) fn of_schema(english: &str) -> Both {
    let plain = |template: &str| template.replace("{{", "{").replace("}}", "}");
    let needed = || {
        let mut known = Needed::TEMPLATES.iter();
        known.find(|known| plain(known.english) == english)
    };
    let found = korean(english).map(str::to_owned);
    Both {
        english: english.to_owned(),
        korean: found
            .or_else(|| Some(plain(needed()?.korean)))
            .unwrap_or_else(|| english.to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::schema::descriptions;

    #[test]
    fn holds_every_description_is_there_in_korean_and_no_other() {
        let korean: Map<String, Value> = serde_json::from_str(KOREAN).unwrap();
        let seen = descriptions();
        let missing: Vec<&String> = seen.iter().filter(|text| !korean.contains_key(*text)).collect();
        assert!(missing.is_empty(), "schema_ko.json lacks: {missing:#?}");
        let stale: Vec<&String> = korean.keys().filter(|text| !seen.contains(*text)).collect();
        assert!(stale.is_empty(), "no key has these any more: {stale:#?}");
        let hangul = |said: &str| said.chars().any(|c| ('가'..='힣').contains(&c));
        for (text, said) in &korean {
            assert!(said.as_str().is_some_and(hangul), "{text}");
        }
    }
}
