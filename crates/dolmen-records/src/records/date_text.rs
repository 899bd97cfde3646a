//! Dates and times of the day as tables print them.

use crate::start::time_of;

/// Seconds in a day.
pub(super) const DAY_S: f64 = 86_400.0;
/// Days that a table counts from 30 December 1899: of the years 1954 to 2118.
pub(super) const SERIAL_DAYS: std::ops::Range<f64> = 20_000.0..80_000.0;

/// A time and what its last digit is worth, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct At {
    pub(super) seconds: f64,
    pub(super) resolution_s: f64,
}

/// Days since 30 December 1899, as tables keep dates.
pub(super) fn serial(text: &str) -> Option<At> {
    let text = text.replace(',', ".");
    let days: f64 = text.parse().ok()?;
    let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    SERIAL_DAYS.contains(&days).then(|| At {
        seconds: DAY_S * days,
        resolution_s: DAY_S * 10f64.powi(-(decimals as i32)),
    })
}

/// "2024-06-05 10:00:00.010", "2024-06-05T10:00:00Z", "05.06.2024 10:00:00", "6/5/2024 10:00:00 AM", "10:00:00,5".
pub(super) fn date_time(text: &str) -> Option<At> {
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

/// Whether a cell is a date, a time of the day, or both.
pub(super) fn is_date(text: &str) -> bool {
    date_time(text).is_some() || calendar(text.trim()).and_then(time_of).is_some()
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
