//! Rows of a table that are sums of the rows above them, not parts of the structure.

use dolmen_records::{SheetCell, SheetValue};

/// Names of rows that hold a sum, mean, extreme or scatter of others, in lower case and without blanks.
const NAMES: [&str; 33] = [
    "합계",
    "계",
    "소계",
    "총계",
    "총합",
    "총합계",
    "누계",
    "합",
    "전체",
    "평균",
    "total",
    "totals",
    "subtotal",
    "grandtotal",
    "sum",
    "average",
    "mean",
    "최대",
    "최소",
    "최댓값",
    "최솟값",
    "최대값",
    "최소값",
    "중앙값",
    "표준편차",
    "편차",
    "max",
    "min",
    "maximum",
    "minimum",
    "median",
    "sd",
    "std",
];
/// Relative difference up to which a rounded number counts as the sum.
const NEAR: f64 = 1e-3;
/// Fewest rows above a total without a name: the sum of fewer may be chance.
const ROWS_LEAST: usize = 2;
/// Fewest numbers of such a total if its row has a name.
const SUMS_LEAST: usize = 2;

/// A row that is not a part, with the cell that proves it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Total<'a> {
    /// By its name.
    Named(&'a SheetCell),
    /// Each of its numbers is the sum of those above.
    Sums(&'a SheetCell),
}

/// The first row named as a total; else the last row, if each of its numbers is a sum. `name_at` is the column of the names.
pub(super) fn total(body: &[Vec<SheetCell>], name_at: Option<usize>) -> Option<Total<'_>> {
    let name = |row: &'_ Vec<SheetCell>| name_at.filter(|at| *at < row.len());
    let named = body.iter().find_map(|row| {
        let cell = &row[name(row)?];
        let SheetValue::Text(text) = &cell.value else {
            return None;
        };
        let plain: String = text
            .to_lowercase()
            .chars()
            .filter(|sign| sign.is_alphabetic())
            .collect();
        NAMES.contains(&plain.as_str()).then_some(Total::Named(cell))
    });
    named.or_else(|| sums(body, name_at))
}

fn sums(body: &[Vec<SheetCell>], name_at: Option<usize>) -> Option<Total<'_>> {
    let (last, above) = body.split_last()?;
    if above.len() < ROWS_LEAST {
        return None;
    }
    let has_no_name = |at: usize| last.get(at).is_none_or(|cell| cell.value == SheetValue::Empty);
    let is_nameless = name_at.is_some_and(has_no_name);
    let numbers = last
        .iter()
        .enumerate()
        .filter_map(|(at, cell)| Some((at, number(cell)?)));
    let numbers: Vec<(usize, f64)> = numbers
        .filter(|(at, value)| Some(*at) != name_at && *value != 0.0)
        .collect();
    let are_sums = numbers.iter().all(|(at, value)| {
        let sum: f64 = above.iter().filter_map(|row| row.get(*at).and_then(number)).sum();
        (value - sum).abs() <= NEAR * sum.abs()
    });
    let enough = if is_nameless { 1 } else { SUMS_LEAST };
    (are_sums && numbers.len() >= enough).then(|| Total::Sums(&last[numbers[0].0]))
}

fn number(cell: &SheetCell) -> Option<f64> {
    match &cell.value {
        SheetValue::Number(number) => Some(*number),
        SheetValue::Text(text) => text.trim().parse().ok(),
        SheetValue::Empty => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(all: &[(&str, &[f64])]) -> Vec<Vec<SheetCell>> {
        let cell = |value: SheetValue| SheetCell {
            place: "A1".to_owned(),
            value,
        };
        let row = |(name, numbers): &(&str, &[f64])| {
            let name = match name.is_empty() {
                true => SheetValue::Empty,
                false => SheetValue::Text((*name).to_owned()),
            };
            let numbers = numbers.iter().map(|number| cell(SheetValue::Number(*number)));
            [cell(name)].into_iter().chain(numbers).collect()
        };
        all.iter().map(row).collect()
    }

    #[test]
    fn holds_what_is_a_total_and_what_a_part() {
        let parts: [(&str, &[f64]); 3] = [("a", &[30.2, 3.1]), ("b", &[14.0, 2.4]), ("c", &[8.1, 1.9])];
        let with = |last: (&'static str, &'static [f64])| {
            let all: Vec<_> = parts.into_iter().chain([last]).collect();
            total(&rows(&all), Some(0)).is_some()
        };
        for name in [
            "합계",
            "합 계",
            "계",
            "Total:",
            "소계(하부)".split('(').next().unwrap(),
        ] {
            assert!(with((name, &[1.0, 1.0])), "{name}");
        }
        assert!(with(("d", &[52.3, 7.4])) && with(("", &[52.3])));
        assert!(!with(("d", &[52.3, 7.3])) && !with(("d", &[52.3])) && !with(("계단석", &[1.0, 1.0])));
        // a stone as heavy as the one below it is not a sum
        assert!(total(&rows(&parts[..1].repeat(2)), Some(0)).is_none());
    }
}
