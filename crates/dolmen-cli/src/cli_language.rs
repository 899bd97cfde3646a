//! Types and parsers that several verbs share.

use clap::ValueEnum;
use dolmen::signal::Component;
use dolmen_words::Language as Spoken;

/// Language of text and figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Language {
    /// English
    En,
    /// Korean
    Ko,
}

/// Environment variables for the user's language; the first that is set decides.
const LANGUAGE_NAMES: [&str; 4] = ["DOLMEN_LANGUAGE", "LC_ALL", "LC_MESSAGES", "LANG"];

/// The user's language: Korean if the first set variable begins with "ko", or if Windows says so.
pub(crate) fn user_language(variable: impl Fn(&str) -> Option<String>) -> Spoken {
    let set = |name| variable(name).filter(|value| !value.is_empty());
    let named = LANGUAGE_NAMES.into_iter().find_map(set).or_else(system_locale);
    match named.is_some_and(|name| name.to_lowercase().starts_with("ko")) {
        true => Spoken::Korean,
        false => Spoken::English,
    }
}

#[cfg(windows)]
fn system_locale() -> Option<String> {
    sys_locale::get_locale()
}

#[cfg(not(windows))]
fn system_locale() -> Option<String> {
    None
}

/// Parses a date.
pub(crate) fn day(text: &str) -> Result<String, String> {
    match dolmen_project::is_day(text) {
        true => Ok(text.to_owned()),
        false => Err("must be a day of the calendar, such as 2026-05-12".to_owned()),
    }
}

/// Parses a positive number.
pub(crate) fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value > 0.0 && value.is_finite() => Ok(value),
        _ => Err("must be a positive number".to_owned()),
    }
}

/// Parses a seismic zone: 1, 2, I, II, Ⅰ, Ⅱ.
pub(crate) fn zone(text: &str) -> Result<u8, String> {
    match text.trim() {
        "1" | "I" | "i" | "Ⅰ" => Ok(1),
        "2" | "II" | "ii" | "Ⅱ" => Ok(2),
        _ => Err("must be 1 (I) or 2 (II)".to_owned()),
    }
}

/// Parses two positive numbers, the smaller first: "0.1,3".
pub(crate) fn pair(text: &str) -> Result<[f64; 2], String> {
    let wrong = || "must be two positive numbers, the smaller first, as in 0.1,3".to_owned();
    let (least, most) = text.split_once(',').ok_or_else(wrong)?;
    let [least, most] = [least, most].map(|text| text.trim().parse::<f64>());
    match (least, most) {
        (Ok(least), Ok(most)) if 0.0 < least && least < most && most.is_finite() => Ok([least, most]),
        _ => Err(wrong()),
    }
}

/// Parses a component with its column: "x=EW".
pub(crate) fn column(text: &str) -> Result<(Component, String), String> {
    let split = text.split_once('=').and_then(|(before, column)| {
        let component = Component::ALL.into_iter().find(|of| of.name() == before.trim())?;
        Some((component, column.trim().to_owned()))
    });
    split.filter(|(_, column)| !column.is_empty()).ok_or_else(|| {
        "must be x=, y= or z= and the name or number of a column, as in x=EW,y=NS,z=UD".to_owned()
    })
}

/// Parses a file size in bytes: "12 GB", "512 MiB", "1000".
pub(crate) fn size(text: &str) -> Result<u64, String> {
    const UNITS: [(&str, u64); 8] = [
        ("", 1),
        ("B", 1),
        ("KB", 1_000),
        ("MB", 1_000_000),
        ("GB", 1_000_000_000),
        ("KIB", 1 << 10),
        ("MIB", 1 << 20),
        ("GIB", 1 << 30),
    ];
    let wrong = || "must be a size such as \"12 GB\" or \"500 MB\"".to_owned();
    let digits = text
        .trim()
        .find(|c: char| !c.is_ascii_digit())
        .unwrap_or(text.trim().len());
    let (number, unit) = text.trim().split_at(digits);
    let unit = unit.trim().to_uppercase();
    let (_, bytes) = UNITS.iter().find(|(name, _)| *name == unit).ok_or_else(wrong)?;
    let number: u64 = number.parse().map_err(|_| wrong())?;
    number
        .checked_mul(*bytes)
        .filter(|size| *size > 0)
        .ok_or_else(wrong)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_the_first_variable_that_is_set_decides_the_language() {
        for (set, language) in [
            (&[][..], Spoken::English),
            (&[("LANG", "ko_KR.UTF-8")], Spoken::Korean),
            (&[("LANG", "ko_KR.UTF-8"), ("LC_ALL", "C.UTF-8")], Spoken::English),
            (
                &[("DOLMEN_LANGUAGE", "ko"), ("LC_ALL", "C.UTF-8")],
                Spoken::Korean,
            ),
            (&[("LC_ALL", ""), ("LC_MESSAGES", "ko_KR")], Spoken::Korean),
        ] {
            let variable = |name: &str| {
                let mut all = set.iter();
                all.find(|(own, _)| *own == name)
                    .map(|(_, value)| (*value).to_owned())
            };
            assert_eq!(user_language(variable), language, "{set:?}");
        }
    }

    #[test]
    fn exact_sizes() {
        for (text, bytes) in [
            ("1000", 1000),
            ("12 GB", 12_000_000_000),
            ("3MiB", 3 << 20),
            ("7 kB", 7000),
        ] {
            assert_eq!(size(text), Ok(bytes), "{text}");
        }
        for wrong in ["", "GB", "-1", "1.5 GB", "0", "99999999999999 GB", "1 TB"] {
            assert!(size(wrong).is_err(), "{wrong}");
        }
    }
}
