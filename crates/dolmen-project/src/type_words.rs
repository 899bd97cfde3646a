//! The words for types and for enumerated values.

use super::wrong::WrongKey;
use dolmen_words::message::Both;
use toml::de::DeValue;

/// A type of the schema in words.
pub(super) fn type_words(of: &str) -> Option<Both> {
    Some(Both::from(match of {
        "number" => WrongKey::Number,
        "integer" => WrongKey::WholeNumber,
        "string" => WrongKey::Text,
        "boolean" => WrongKey::TrueOrFalse,
        "array" => WrongKey::List,
        "object" => WrongKey::Table,
        _ => return None,
    }))
}

/// The type of a value in words.
pub(super) fn type_word_of(value: &DeValue<'_>) -> Both {
    Both::from(match value {
        DeValue::String(_) => WrongKey::Text,
        DeValue::Integer(_) | DeValue::Float(_) => WrongKey::Number,
        DeValue::Boolean(_) => WrongKey::TrueOrFalse,
        DeValue::Datetime(_) => WrongKey::Date,
        DeValue::Array(_) => WrongKey::List,
        DeValue::Table(_) => WrongKey::Table,
    })
}

/// "a", "b" or "c", each in quotes.
pub(super) fn alternatives(words: &[&str]) -> Both {
    let quoted: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
    match quoted.split_last() {
        Some((last, [])) => Both::from(last.as_str()),
        Some((last, others)) => Both::from(WrongKey::Or {
            others: others.join(", "),
            last: last.to_string(),
        }),
        None => Both::from(""),
    }
}

/// Whether the values of a survey at a path are tables by direction.
pub(super) fn is_by_direction(path: &str) -> bool {
    path.starts_with("survey.") && (path.ends_with(".tilt") || path.ends_with(".frequencies"))
}

/// A description for use within a sentence: without capital and full stop.
pub(super) fn lower_first(sentence: &str) -> String {
    let mut characters = sentence.trim_end_matches('.').chars();
    let first = characters.next().into_iter().flat_map(char::to_lowercase);
    first.chain(characters).collect()
}
