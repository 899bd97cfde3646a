//! Compares the first and last date beside the samples with the rate.

use super::RecordError;
use super::csv_start::Start;
use super::date_text::{At, DAY_S, date_time, serial};
use super::dialect::{holds_cells, unquoted};

/// Relative difference allowed between a given rate and that of dates, beyond their last digit. As for stamps in seconds.
const RATE_TOLERANCE: f64 = 1e-4;
/// Result of dates for a given rate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Dates {
    /// There are none.
    None,
    /// They agree with it.
    Agree,
    /// A column that looks like dates cannot be read.
    Unread(String),
}

/// Compares the given rate with the first and the last date of a column that is not a channel.
///
/// # Errors
/// [`RecordError::DatesDisagree`].
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
                (false, _) => {
                    date_time(text).or_else(|| date_time(&format!("{text} {}", cells.get(column + 1)?)))
                }
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
            return Ok(Dates::Agree); // seconds of the day, as large as days since 1900
        }
        let passed = match b.seconds - a.seconds {
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
        return Ok(Dates::Agree);
    }
    Ok(unread.map_or(Dates::None, Dates::Unread))
}
