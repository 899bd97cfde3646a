//! Columns of a table of parts that no part uses: what the model would miss, other numbers, and notes.

use super::tabled_heads::{COUNTS, ELSEWHERE, MISSED, NOTES};
use super::units::parse_unit;
use dolmen_records::SheetValue;

/// What a column holds that no part uses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Unread {
    /// A quantity that changes the answer.
    Missed,
    /// Numbers of unknown meaning.
    Numbers,
    /// Words, numbers of rows, and what has no bearing on the answer.
    Note,
}

/// The kind of a column, by its head and its cells.
pub(super) fn unread(head: &str, cells: &[&SheetValue]) -> Unread {
    let name = head.split_once(['(', '[']).map_or(head, |(name, _)| name);
    let name = name.trim().to_lowercase().replace(['_', '-'], " ");
    if ELSEWHERE.contains(&name.as_str()) {
        return Unread::Missed;
    }
    let filled: Vec<&SheetValue> = cells
        .iter()
        .copied()
        .filter(|cell| **cell != SheetValue::Empty)
        .collect();
    let numbers: Vec<f64> = filled.iter().filter_map(|cell| number(cell)).collect();
    let all = |value: f64| numbers.iter().all(|number| *number == value);
    if all(0.0) {
        return Unread::Note;
    }
    if names(&name, &COUNTS) {
        return match all(1.0) {
            true => Unread::Note,
            false => Unread::Missed,
        };
    }
    if names(&name, &MISSED) && !name.ends_with("번호") {
        return Unread::Missed;
    }
    match names(&name, &NOTES) || numbers.len() < filled.len() || is_running(&numbers) {
        true => Unread::Note,
        false => Unread::Numbers,
    }
}

/// Whether a head has one of the words: Korean ones anywhere or, of one syllable, alone; others where a word begins.
fn names(head: &str, words: &[&str]) -> bool {
    words.iter().any(|word| match word.is_ascii() {
        true => format!(" {head} ").contains(&format!(" {word}")),
        false if word.chars().count() == 1 => head == *word,
        false => head.contains(word),
    })
}

/// A cell's number: "12", "1/30", "12 kN". The denominator may have a unit; it is not used.
fn number(cell: &SheetValue) -> Option<f64> {
    let text = match cell {
        SheetValue::Number(number) => return Some(*number),
        SheetValue::Text(text) => text.trim(),
        SheetValue::Empty => return None,
    };
    let end = text
        .find(|sign: char| !(sign.is_ascii_digit() || "+-.,".contains(sign)))
        .unwrap_or(text.len());
    let (number, rest) = text.split_at(end);
    let number: f64 = number.replace(',', ".").parse().ok()?;
    let rest = rest.trim();
    let is_fraction = rest
        .strip_prefix('/')
        .is_some_and(|below| below.trim().parse::<f64>().is_ok());
    (rest.is_empty() || is_fraction || parse_unit(rest).is_ok()).then_some(number)
}

/// Whether numbers count the rows: 1, 2, 3 or 3, 2, 1.
fn is_running(numbers: &[f64]) -> bool {
    let step = |pair: &[f64]| pair[1] - pair[0];
    numbers.len() > 1
        && numbers
            .windows(2)
            .all(|pair| step(pair).abs() == 1.0 && step(pair) == step(numbers))
}

#[cfg(test)]
mod tests {
    use super::{Unread, unread};
    use dolmen_records::SheetValue;

    #[test]
    fn holds_what_the_model_would_miss_is_told_from_notes() {
        let of = |head: &str, cells: &str| {
            let cells: Vec<SheetValue> = cells
                .split(' ')
                .map(|cell| match cell.parse() {
                    Ok(number) => SheetValue::Number(number),
                    Err(_) if cell == "-" => SheetValue::Empty,
                    Err(_) => SheetValue::Text(cell.to_owned()),
                })
                .collect();
            unread(head, &cells.iter().collect::<Vec<_>>())
        };
        for (head, cells) in [
            ("경사", "- 1/30"),
            ("경사(°)", "0 2"),
            ("편심(mm)", "0 120"),
            ("X 편차(mm)", "0 -30"),
            ("수량(개)", "1 2"),
            ("Qty.", "2 2"),
            ("Number of stones", "1 4"),
            ("접합부 강성(kN·m/rad)", "5 5"),
            ("압축강도(MPa)", "80 -"),
            ("rotation", "3deg -"),
            ("eccentricity_x", "0.1 0"),
            ("기울기", "없음 없음"),
        ] {
            assert_eq!(of(head, cells), Unread::Missed, "{head}");
        }
        for (head, cells) in [("무게(kN)", "12 9"), ("mass (kg)", "900kg -"), ("A", "1 3")] {
            assert_eq!(of(head, cells), Unread::Numbers, "{head}");
        }
        for (head, cells) in [
            ("비고", "2021 -"),
            ("번호", "7 5"),
            ("A", "3 2 1"),
            ("id", "100 105"),
            ("사진", "12 19"),
            ("재질", "화강암 화강암"),
            ("위치", "1층 2층"),
            ("수량", "1 1"),
            ("편심(mm)", "0 0"),
            ("country", "3 4"),
            ("No.", "1 5"),
            ("위치번호", "12 31"),
            ("층", "1 3"),
        ] {
            assert_eq!(of(head, cells), Unread::Note, "{head}");
        }
    }
}
