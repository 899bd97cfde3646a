//! The times of the rows of a log, in all forms of loggers and spreadsheets.

use crate::records::{calendar_day, date_time};
use crate::start::start_of_text;

/// Format of the times in a log, the same for all rows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct TimeCells {
    /// The time of day is in a separate cell after the date.
    has_clock_apart: bool,
    /// Whether the month comes first in dates such as "11/25/2026".
    is_month_first: bool,
}

/// Dates such as "05/11/2026" in which no row shows whether the day or the month comes first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct UnclearDay(pub(super) String);

impl TimeCells {
    /// Detects the form of a file; `first` is its first row, `dates` the first cell of each row.
    pub(super) fn of<'a>(first: &[String], dates: impl Iterator<Item = &'a str>) -> Result<Self, UnclearDay> {
        let [date, clock] = [0, 1].map(|at| first.get(at).map_or("", String::as_str));
        let has_clock_apart = !date.contains(':') && clock.contains(':') && date_time(clock).is_some();
        let with = |is_month_first| TimeCells {
            has_clock_apart,
            is_month_first,
        };
        if !YearLastDate::of(date).is_some_and(|turned| turned.is_unclear) {
            return Ok(with(false));
        }
        let mut could_be = [true; 2]; // the first number a day, a month
        for turned in dates.filter_map(YearLastDate::of) {
            could_be[0] &= turned.second <= MONTHS;
            could_be[1] &= turned.first <= MONTHS;
            if could_be.contains(&false) {
                break;
            }
        }
        match could_be {
            [true, true] => Err(UnclearDay(date.to_owned())),
            [is_day_first, _] => Ok(with(!is_day_first)),
        }
    }

    /// Number of cells before the readings in a row.
    pub(super) fn cells(self) -> usize {
        1 + usize::from(self.has_clock_apart)
    }

    /// The time of a row, s from 1970 in the clock of the logger.
    pub(super) fn at(self, row: &[String]) -> Option<f64> {
        let first = row.first()?;
        if !self.has_clock_apart {
            return self.time(first);
        }
        self.time(&format!("{first} {}", row.get(1)?))
    }

    fn time(self, cell: &str) -> Option<f64> {
        plain_time(cell).or_else(|| self.other_time(cell))
    }

    /// A day with or without a time, with its year first or last; a time zone applies to all rows.
    fn other_time(self, cell: &str) -> Option<f64> {
        let cell = match YearLastDate::of(cell) {
            Some(turned) => turned.year_first(self.is_month_first),
            None => cell.to_owned(),
        };
        match cell.contains(':') {
            // a time of day alone gives no date
            true => date_time(&cell)
                .filter(|at| at.seconds >= DAY_S)
                .map(|at| at.seconds),
            false => calendar_day(&cell),
        }
    }
}

/// Whether a cell is a time in any format.
pub(super) fn says_when(cell: &str) -> bool {
    let with = |is_month_first| TimeCells {
        has_clock_apart: false,
        is_month_first,
    };
    [false, true]
        .iter()
        .any(|first| with(*first).time(cell).is_some())
}

const DAY_S: f64 = 86_400.0;
const MONTHS: u32 = 12;

/// A date with its year last: "25.11.2026 10:00", "11/25/2026".
struct YearLastDate<'a> {
    first: u32,
    second: u32,
    year: &'a str,
    rest: &'a str,
    /// Whether either the day or the month may come first; with dots it is the day.
    is_unclear: bool,
}

impl<'a> YearLastDate<'a> {
    fn of(cell: &'a str) -> Option<Self> {
        let sign = cell.chars().find(|sign| !sign.is_ascii_digit())?;
        if !matches!(sign, '/' | '.' | '-') {
            return None;
        }
        let mut parts = cell.splitn(3, sign);
        let [first, second, behind] = [parts.next()?, parts.next()?, parts.next()?];
        let number = |text: &str| text.trim().parse::<u32>().ok().filter(|_| text.trim().len() <= 2);
        let behind = behind.trim_start();
        let (year, rest) = behind.split_at_checked(4)?;
        let is_year = year.chars().all(|sign| sign.is_ascii_digit());
        let ends = !rest.starts_with(|sign: char| sign.is_ascii_digit());
        (is_year && ends).then_some(YearLastDate {
            first: number(first)?,
            second: number(second)?,
            year,
            rest,
            is_unclear: sign != '.',
        })
    }

    fn year_first(&self, is_month_first: bool) -> String {
        let (day, month) = match is_month_first {
            true => (self.second, self.first),
            false => (self.first, self.second),
        };
        format!("{}-{month:02}-{day:02}{}", self.year, self.rest)
    }
}

/// "2026-11-25 10:00:00", "2026/11/25T10:00", "2026-11-25": year, month, day first; s from 1970.
fn plain_time(cell: &str) -> Option<f64> {
    let (whole, part) = match cell.split_once('.') {
        Some((whole, part)) if whole.len() > "2026-11-25".len() => (whole, part),
        _ => (cell, ""),
    };
    let whole = whole.trim_end_matches('Z');
    let is_time = |sign: char| sign.is_ascii_digit() || matches!(sign, '-' | '/' | ':' | ' ' | 'T' | '.');
    if !whole.chars().all(is_time) || !whole.starts_with(|sign: char| sign.is_ascii_digit()) {
        return None;
    }
    let digits = whole.chars().filter(char::is_ascii_digit).count();
    let missing = match digits {
        8 => "000000",
        12 => "00",
        14 => "",
        _ => return None,
    };
    let day = whole.get(.."2026-11-25".len())?;
    if !day
        .chars()
        .enumerate()
        .all(|(at, sign)| matches!(at, 4 | 7) != sign.is_ascii_digit())
    {
        return None;
    }
    let seconds = start_of_text(&format!("{}{missing}", whole.replace('.', "-")))?;
    let part: f64 = if part.is_empty() {
        0.0
    } else {
        format!("0.{}", part.trim_end_matches('Z')).parse().ok()?
    };
    Some(seconds + part)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEN_S: f64 = 1_795_600_800.0; // 2026-11-25 10:00 by `date -u`

    fn cells(row: &str) -> Vec<String> {
        row.split(',').map(str::to_owned).collect()
    }

    fn read(rows: &[&str]) -> Result<Vec<Option<f64>>, UnclearDay> {
        let rows: Vec<Vec<String>> = rows.iter().map(|row| cells(row)).collect();
        let times = TimeCells::of(&rows[0], rows.iter().map(|row| row[0].as_str()))?;
        Ok(rows.iter().map(|row| times.at(row)).collect())
    }

    #[test]
    fn exact_one_moment_in_the_forms_of_loggers_and_spreadsheets() {
        for cell in [
            "2026-11-25 10:00:00",
            "2026/11/25T10:00",
            "2026-11-25 오전 10:00",
            "2026. 11. 25. 오전 10:00",
            "2026. 11. 25. 10:00",
            "2026년 11월 25일 10:00:00",
            "2026-11-25T10:00:00+09:00",
            "25.11.2026 10:00",
            "25.11.2026 10:00:00.0",
            "25/11/2026 10:00",
            "11/25/2026 10:00:00 AM",
            "25-11-2026 10:00",
            "2026-11-25,10:00",
            "25.11.2026,10:00:00",
            "11/25/2026,오전 10:00",
        ] {
            assert_eq!(read(&[cell]), Ok(vec![Some(TEN_S)]), "{cell}");
        }
        for cell in [
            "2026-11-25",
            "2026.11.25",
            "2026. 11. 25.",
            "25.11.2026",
            "25/11/2026",
        ] {
            assert_eq!(read(&[cell]), Ok(vec![Some(TEN_S - 36_000.0)]), "{cell}");
        }
        for cell in [
            "10:00",
            "25.11.26 10:00",
            "tomorrow",
            "1.25",
            "2026-13-25 10:00",
            "31.02.2026",
        ] {
            assert_eq!(read(&[cell]), Ok(vec![None]), "{cell}");
            assert!(!says_when(cell), "{cell}");
        }
    }

    #[test]
    fn exact_a_later_row_tells_the_day_from_the_month_and_without_one_it_is_unclear() {
        let day = 86_400.0;
        assert_eq!(
            read(&["10/11/2026", "13/11/2026"]),
            Ok(vec![
                Some(TEN_S - 36_000.0 - 15.0 * day),
                Some(TEN_S - 36_000.0 - 12.0 * day)
            ])
        );
        assert_eq!(
            read(&["11/10/2026", "11/13/2026"]),
            Ok(vec![
                Some(TEN_S - 36_000.0 - 15.0 * day),
                Some(TEN_S - 36_000.0 - 12.0 * day)
            ])
        );
        assert_eq!(
            read(&["10/11/2026", "11/11/2026"]),
            Err(UnclearDay("10/11/2026".into()))
        );
    }
}
