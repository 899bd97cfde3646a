//! Heads of the columns of a portfolio, in English and Korean.

use dolmen_records::{SheetValue, is_misspelt};
use dolmen_words::Language;
use dolmen_words::message::Both;

/// Every column; all except `name` are optional.
const COLUMNS: [&str; 11] = [
    "name",
    "storeys",
    "body_height_m",
    "slenderness_angle",
    "body_slenderness",
    "taper_deg",
    "body_base_height_ratio",
    "project",
    "study",
    "zone_factor_g",
    "soil",
];

/// Korean heads of columns, without blanks.
const KOREAN: [(&str, &str); 23] = [
    ("이름", "name"),
    ("명칭", "name"),
    ("석탑", "name"),
    ("구조물", "name"),
    ("문화재명", "name"),
    ("국가유산명", "name"),
    ("층수", "storeys"),
    ("몸체높이", "body_height_m"),
    ("탑신높이", "body_height_m"),
    ("탑신부높이", "body_height_m"),
    ("세장각", "slenderness_angle"),
    ("세장비각", "slenderness_angle"),
    ("몸돌세장비", "body_slenderness"),
    ("체감각", "taper_deg"),
    ("탑신/기단높이비", "body_base_height_ratio"),
    ("탑신기단높이비", "body_base_height_ratio"),
    ("프로젝트", "project"),
    ("해석", "study"),
    ("지역계수", "zone_factor_g"),
    ("지진구역", "zone_factor_g"),
    ("지반", "soil"),
    ("지반종류", "soil"),
    ("지반분류", "soil"),
];

/// Korean names of the columns, for errors.
const LABELS: [&str; COLUMNS.len()] = [
    "이름",
    "층수",
    "탑신 높이",
    "세장각",
    "몸돌 세장비",
    "체감각",
    "탑신/기단 높이비",
    "프로젝트",
    "해석",
    "지역계수",
    "지반",
];

/// Name of a column in an error. If its head differs from the key: the head, in English with the key.
/// Otherwise: the key, in Korean with the Korean name.
pub(super) fn said(column: &str, written: Option<&str>) -> Both {
    let labels = COLUMNS.iter().zip(LABELS).find(|(key, _)| **key == column);
    let label = labels.map_or(column, |(_, label)| label);
    match written.map(str::trim) {
        Some(head) if !head.eq_ignore_ascii_case(column) => Both {
            english: format!("{head} ({column})"),
            korean: head.to_owned(),
        },
        _ => Both {
            english: column.to_owned(),
            korean: format!("{label}({column})"),
        },
    }
}

/// All columns, for errors.
pub(crate) fn columns_said() -> Vec<Both> {
    COLUMNS.iter().map(|column| said(column, None)).collect()
}

/// The column that a head stands for.
pub(super) enum Head {
    Of(&'static str),
    /// A column that a ranking does not use.
    LeftOut,
    /// Probably a column, but misspelt or in another unit.
    Doubtful,
}

/// The column that a head of a table stands for.
pub(super) fn head(head: &str) -> Head {
    let (name, unit) = head.split_once(['(', '[']).unwrap_or((head, ""));
    let plain: String = name.chars().filter(|sign| !sign.is_whitespace()).collect();
    let korean = KOREAN.iter().find(|(korean, _)| *korean == plain);
    let known = korean.map(|(_, column)| *column);
    let known = known.or_else(|| COLUMNS.into_iter().find(|column| *column == plain.to_lowercase()));
    let has_own_unit = matches!(
        unit.trim_end_matches([')', ']']).trim(),
        "" | "m" | "도" | "°" | "deg" | "g"
    );
    match known {
        Some(column) if has_own_unit => Head::Of(column),
        Some(_) => Head::Doubtful,
        None => {
            let mut all = COLUMNS.iter().chain(KOREAN.iter().map(|(korean, _)| korean));
            match all.any(|column| is_misspelt(name, column)) {
                true => Head::Doubtful,
                false => Head::LeftOut,
            }
        }
    }
}

/// A cell as it was written.
pub(super) fn text(value: &SheetValue) -> String {
    match value {
        SheetValue::Empty => String::new(),
        SheetValue::Number(number) => number.to_string(),
        SheetValue::Text(text) => text.clone(),
    }
}

/// Joins names.
pub(super) fn joined(each: &[Both], between: &str, language: Language) -> String {
    let each: Vec<&str> = each.iter().map(|of| of.text(language)).collect();
    each.join(between)
}
