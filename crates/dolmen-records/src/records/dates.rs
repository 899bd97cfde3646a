//! Compares the first and last date in a file with the sampling rate.

use super::csv_start::Start;
use super::date_text::{At, DAY_S, HOUR_S, after_in_hours, date_time, minute_of_hour, serial};
use super::dialect::{holds_cells, unquoted};
use super::{FirstDate, RateSource, RecordError};

/// Relative difference allowed between a given rate and that of dates, beyond their last digit. As for stamps in seconds.
const RATE_TOLERANCE: f64 = 1e-4;
/// Result of dates for a given rate.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Dates {
    /// There are none.
    None,
    /// The dates agree with the given rate; the first one, if it is more than a time of the hour.
    Agree(Option<At>),
    /// A column that looks like dates cannot be read.
    Unread(String),
}

impl Dates {
    pub(super) fn rate_source(&self) -> RateSource {
        match self {
            Dates::Agree(_) => RateSource::GivenAndDates,
            Dates::None | Dates::Unread(_) => RateSource::Given,
        }
    }

    pub(super) fn first(&self) -> Option<FirstDate> {
        match self {
            Dates::Agree(first) => first.map(FirstDate::of),
            Dates::None | Dates::Unread(_) => None,
        }
    }

    pub(super) fn unread(self) -> Option<String> {
        match self {
            Dates::Unread(column) => Some(column),
            Dates::None | Dates::Agree(_) => None,
        }
    }
}

/// Compares the given rate with the first and the last date of a column that is not a channel.
///
/// # Errors
/// [`RecordError::DatesDisagree`], [`RecordError::DatesGap`].
pub(super) fn held_against(
    bytes: &[u8],
    (start, free): (&Start, &[bool]),
    (given_hz, samples): (f64, usize),
) -> Result<Dates, RecordError> {
    let body = &bytes[start.samples_at..];
    let mut lines = body
        .split(|b| *b == b'\n')
        .map(|line| line.strip_suffix(b"\r").unwrap_or(line));
    let first = lines.clone().find(|line| holds_cells(line));
    let last = lines.rfind(|line| holds_cells(line));
    let (Some(first), Some(last)) = (first, last) else {
        return Ok(Dates::None);
    };
    let cells = |line| -> Vec<String> {
        let cells = start.delimiter.cells(line).into_iter();
        cells
            .map(|cell| String::from_utf8_lossy(unquoted(cell)).into_owned())
            .collect()
    };
    let (first, last) = (cells(first), cells(last));
    let mut unread = None;
    for column in (0..start.columns.len()).filter(|c| free[*c]) {
        let name = &start.columns[column];
        let lower = name.to_lowercase();
        let named = [
            "date", "time", "zeit", "datum", "stamp", "clock", "날짜", "시각", "시간", "일시",
        ]
        .iter()
        .any(|word| lower.contains(word));
        let at = |cells: &[String]| -> Option<At> {
            let text = cells.get(column)?;
            match (start.numeric[column], named) {
                (true, true) => serial(text),
                (true, false) => None,
                (false, _) => time(text, || cells.get(column + 1).cloned()),
            }
        };
        let (Some(a), Some(b)) = (at(&first), at(&last)) else {
            if named && !start.numeric[column] && unread.is_none() {
                unread = Some(name.clone());
            }
            continue;
        };
        let steps = (samples - 1) as f64;
        let number = |cells: &[String]| cells.get(column).and_then(|text| text.parse::<f64>().ok());
        if let (true, Some(a), Some(b)) = (start.numeric[column], number(&first), number(&last))
            && (given_hz * (b - a) - steps).abs() <= 1.0 + RATE_TOLERANCE * steps
        {
            return Ok(Dates::Agree(None)); // seconds of the day, as large as days since 1900
        }
        if !start.numeric[column] {
            refuse_gap(body, (start, column), given_hz)?;
        }
        let is_of_hour = minute_of_hour(&first[column]).is_some();
        let passed = match b.seconds - a.seconds {
            // the hour that fits best: gaps within it are refused above
            of_hour if is_of_hour => of_hour + HOUR_S * ((steps / given_hz - of_hour) / HOUR_S).round(),
            back if back < 0.0 && a.seconds < DAY_S => back + DAY_S, // times of the day across midnight
            passed => passed,
        };
        let allowed = 1.0 + given_hz * (a.resolution_s + b.resolution_s) + RATE_TOLERANCE * steps;
        if (given_hz * passed - steps).abs() > allowed {
            return Err(RecordError::DatesDisagree {
                given: given_hz,
                column: name.clone(),
                first: first[column].clone(),
                last: last[column].clone(),
                samples,
                dates_hz: steps / passed,
            });
        }
        return Ok(Dates::Agree(Some(a).filter(|_| !is_of_hour)));
    }
    Ok(unread.map_or(Dates::None, Dates::Unread))
}

/// The time in a cell, or in it and the next.
fn time(text: &str, next: impl FnOnce() -> Option<String>) -> Option<At> {
    minute_of_hour(text)
        .or_else(|| date_time(text))
        .or_else(|| date_time(&format!("{text} {}", next()?)))
}

/// A step of this many sampling intervals is a gap, as for stamps in seconds.
const GAP_STEPS: f64 = 1.5;

/// Refuses the largest step between two times of a column if samples are missing: a rate that agrees only with the first and the last time
/// would shift all frequencies.
fn refuse_gap(body: &[u8], (start, column): (&Start, usize), given_hz: f64) -> Result<(), RecordError> {
    let mut before: Option<(usize, String, At)> = None;
    let mut steps_s = Vec::new();
    let mut widest: Option<(f64, f64, RecordError)> = None;
    for (number, line) in body.split(|b| *b == b'\n').enumerate() {
        let mut cells = start.delimiter.cells(line).into_iter().skip(column);
        let mut next = || {
            let cell = cells.next()?;
            Some(String::from_utf8_lossy(unquoted(cell.trim_ascii_end())).into_owned())
        };
        let Some(text) = next() else { continue };
        let Some(mut at) = time(&text, next) else { continue };
        if let Some((line, text_before, earlier)) = &before {
            if minute_of_hour(&text).is_some() {
                at.seconds = after_in_hours(earlier.seconds, at.seconds);
            }
            let step_s = at.seconds - earlier.seconds;
            steps_s.push(step_s);
            if widest.as_ref().is_none_or(|(other, _, _)| step_s > *other) {
                let gap = RecordError::DatesGap {
                    column: start.columns[column].clone(),
                    line: start.samples_line + line,
                    before: text_before.clone(),
                    after: text.clone(),
                    step_s,
                };
                widest = Some((step_s, at.resolution_s + earlier.resolution_s, gap));
            }
        }
        before = Some((number, text, at));
    }
    let Some((step_s, resolution_s, gap)) = widest else {
        return Ok(());
    };
    // the rate may be wrong as well: the usual step is that of the dates, or of the rate if dates are too coarse
    let middle = steps_s.len() / 2;
    let (_, usual_s, _) = steps_s.select_nth_unstable_by(middle, f64::total_cmp);
    match step_s > GAP_STEPS * usual_s.max(1.0 / given_hz) + resolution_s {
        true => Err(gap),
        false => Ok(()),
    }
}
