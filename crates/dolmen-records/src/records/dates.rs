//! Dates beside samples: what rate do the first and the last of them say?

use super::RecordError;
use super::csv_start::Start;
use super::dialect::{holds_cells, unquoted};
use crate::start::time_of;

/// Share by which a rate given may differ from that of dates, beside their last digit. As for stamps in seconds.
const RATE_TOLERANCE: f64 = 1e-4;
/// Seconds in a day.
pub(super) const DAY_S: f64 = 86_400.0;
/// Days that a table counts from 30 December 1899: of the years 1954 to 2118.
pub(super) const SERIAL_DAYS: std::ops::Range<f64> = 20_000.0..80_000.0;

/// What dates say of a rate that was given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Dates {
    /// There are none.
    None,
    /// They agree.
    Agree,
    /// A column that looks like them cannot be read.
    Unread(String),
}

/// A time and what its last digit is worth, s.
#[derive(Clone, Copy, Debug, PartialEq)]
struct At {
    seconds: f64,
    resolution_s: f64,
}

/// Holds the rate given against the first and the last date of a column that is not read for samples.
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
        let named = ["date", "time", "zeit", "datum", "stamp", "날짜", "시각", "시간"]
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

/// Days since 30 December 1899, as tables keep dates.
fn serial(text: &str) -> Option<At> {
    let text = text.replace(',', ".");
    let days: f64 = text.parse().ok()?;
    let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    SERIAL_DAYS.contains(&days).then(|| At {
        seconds: DAY_S * days,
        resolution_s: DAY_S * 10f64.powi(-(decimals as i32)),
    })
}

/// "2024-06-05 10:00:00.010", "2024-06-05T10:00:00Z", "05.06.2024 10:00:00", "6/5/2024 10:00:00 AM", "10:00:00,5".
fn date_time(text: &str) -> Option<At> {
    let text = text.trim();
    let (date, time) = match text.split_once(['T', ' ']) {
        Some((date, time)) if !date.contains(':') => (Some(date.trim()), time.trim()),
        _ => (None, text), // a time of the day, "06:30:00 PM" too
    };
    let day = match date {
        Some(date) => time_of(calendar(date)?)?,
        None => 0.0,
    };
    let lower = time.to_lowercase();
    let (clock, half_day_h) = match (lower.strip_suffix("am"), lower.strip_suffix("pm")) {
        (Some(clock), _) => (clock.trim(), Some(0.0)),
        (_, Some(clock)) => (clock.trim(), Some(12.0)),
        _ => (lower.as_str(), None),
    };
    // a zone shifts all alike
    let clock = clock.split(['z', '+', '-']).next()?.trim().replace(',', ".");
    let parts: Vec<&str> = clock.split(':').collect();
    let ([hour, minute] | [hour, minute, _]) = parts[..] else {
        return None;
    };
    let second = parts.get(2).copied();
    let mut hour: f64 = hour.parse().ok()?;
    if let Some(half_day_h) = half_day_h {
        hour = hour % 12.0 + half_day_h;
    }
    let minute: f64 = minute.parse().ok()?;
    let of_minute: f64 = second.map_or(Ok(0.0), str::parse).ok()?;
    let resolution_s = match second.map(|s| s.split_once('.').map_or(0, |(_, decimals)| decimals.len())) {
        Some(decimals) => 10f64.powi(-(decimals as i32)),
        None => 60.0,
    };
    let allowed =
        (0.0..24.0).contains(&hour) && (0.0..60.0).contains(&minute) && (0.0..61.0).contains(&of_minute);
    allowed.then_some(At {
        seconds: day + 3600.0 * hour + 60.0 * minute + of_minute,
        resolution_s,
    })
}

/// Year, month, day and midnight of "2024-06-05", "2024/6/5", "05.06.2024", "6/5/2024".
fn calendar(date: &str) -> Option<[f64; 6]> {
    let parts: Vec<&str> = date.split(['-', '/', '.']).collect();
    let [a, b, c] = parts[..] else { return None };
    let number = |text: &str| text.parse::<u32>().ok().map(f64::from);
    let (year, month, day) = match (a.len(), c.len()) {
        (4, _) => (number(a)?, number(b)?, number(c)?),
        // months stand first between slashes, unless they cannot
        (_, 4) if date.contains('/') && number(a)? <= 12.0 => (number(c)?, number(a)?, number(b)?),
        (_, 4) => (number(c)?, number(b)?, number(a)?),
        _ => return None,
    };
    Some([year, month, day, 0.0, 0.0, 0.0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_times_of_dates() {
        // datetime.timestamp of Python 3.11, UTC: 1717581600 is 2024-06-05 10:00:00
        for (text, resolution_s) in [
            ("2024-06-05 10:00:00.000", 1e-3),
            ("2024-06-05T10:00:00Z", 1.0),
            ("05.06.2024 10:00:00", 1.0),
            ("6/5/2024 10:00:00 AM", 1.0),
            ("2024/06/05 10:00", 60.0),
            ("2024-06-05 10:00:00,0", 0.1),
        ] {
            let at = date_time(text).unwrap();
            assert_eq!(
                (at.seconds, at.resolution_s),
                (1_717_581_600.0, resolution_s),
                "{text}"
            );
        }
        assert_eq!(date_time("13/6/2024 10:00:00"), date_time("2024-06-13 10:00:00"));
        assert_eq!(date_time("06:30:00 PM").map(|at| at.seconds), Some(66_600.0));
        assert_eq!(serial("45448.5").map(|at| at.seconds), Some(45448.5 * DAY_S));
        for text in [
            "noon",
            "2024-06-05",
            "2024-13-05 10:00:00",
            "1.25",
            "25:00:00",
            "sensor 3",
        ] {
            assert_eq!(date_time(text), None, "{text}");
        }
    }
}
