//! Dates and times of day as printed in tables.

use super::dialect::unquoted;
use crate::number::Number;
use crate::start::time_of;

/// Seconds in a day.
pub(super) const DAY_S: f64 = 86_400.0;
/// Range of days since 30 December 1899 that are dates: the years 1954 to 2118.
pub(super) const SERIAL_DAYS: std::ops::Range<f64> = 20_000.0..80_000.0;

/// A time and the value of its last digit, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct At {
    pub(crate) seconds: f64,
    pub(crate) resolution_s: f64,
}

impl At {
    /// The same as a printed number of seconds that ends at `end`.
    pub(super) fn printed(self, end: usize) -> Number {
        Number {
            value: self.seconds,
            end,
            decimals: -(self.resolution_s.log10().round() as i32),
        }
    }
}

/// Days since 30 December 1899, as spreadsheets store dates.
pub(super) fn serial(text: &str) -> Option<At> {
    let text = text.replace(',', ".");
    let days: f64 = text.parse().ok()?;
    let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    SERIAL_DAYS.contains(&days).then(|| At {
        seconds: DAY_S * days,
        resolution_s: DAY_S * 10f64.powi(-(decimals as i32)),
    })
}

/// Words for the halves of a day and their first hours, in loggers and spreadsheets; longer ones precede their own parts.
const HALF_DAYS: [(&str, f64); 6] = [
    ("오전", 0.0),
    ("오후", 12.0),
    ("a.m.", 0.0),
    ("p.m.", 12.0),
    ("am", 0.0),
    ("pm", 12.0),
];

/// "2024-06-05 10:00:00.010", "2024-06-05T10:00:00Z", "05.06.2024 10:00:00", "6/5/2024 10:00:00 AM", "10:00:00,5",
/// "2024-06-05 오전 10:00:00", "2024. 6. 5. PM 10:00", "2024년 6월 5일 오후 10:00".
pub(crate) fn date_time(text: &str) -> Option<At> {
    let (text, half_day_h) = without_half_day(text);
    let (date, clock) = date_and_clock(&text)?;
    let day = match date {
        "" => 0.0,
        date => time_of(calendar(date)?)?,
    };
    // a time zone shifts all alike
    let clock = clock.split(['z', '+', '-']).next()?.trim().replace(',', ".");
    let parts: Vec<&str> = clock.split(':').collect();
    let ([hour, minute] | [hour, minute, _]) = parts[..] else {
        return None;
    };
    let second = parts.get(2).copied();
    if second.is_none() && minute.contains('.') {
        return None; // minutes and seconds
    }
    let hour = hour_of_day(hour.parse().ok()?, half_day_h)?;
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

/// Seconds in an hour.
pub(super) const HOUR_S: f64 = 3600.0;

/// Minutes and seconds without the hour, "59:30.0", as spreadsheets show times in the format "mm:ss.0"; s from the beginning of the hour.
pub(super) fn minute_of_hour(text: &str) -> Option<At> {
    let (minute, second) = text.trim().split_once(':')?;
    let second = second.replace(',', ".");
    // without decimals it may be hours and minutes
    let (_, decimals) = second.split_once('.')?;
    let minutes: f64 = minute.parse::<u32>().ok()?.into();
    let seconds: f64 = second.parse().ok()?;
    ((0.0..60.0).contains(&minutes) && (0.0..60.0).contains(&seconds)).then(|| At {
        seconds: 60.0 * minutes + seconds,
        resolution_s: 10f64.powi(-(decimals.len() as i32)),
    })
}

/// A time of the hour after another: an hour later if a full hour passed between.
pub(super) fn after_in_hours(before_s: f64, of_hour_s: f64) -> f64 {
    match before_s - of_hour_s > 0.5 * HOUR_S {
        true => of_hour_s + HOUR_S * ((before_s - of_hour_s) / HOUR_S).round(),
        false => of_hour_s,
    }
}

/// A text in lower case without its word for the half of the day, and the first hour of that half.
fn without_half_day(text: &str) -> (String, Option<f64>) {
    let lower = text.trim().to_lowercase();
    let found = HALF_DAYS
        .iter()
        .find_map(|(word, begins_h)| Some((lower.find(word)?, word.len(), *begins_h)));
    match found {
        Some((at, length, begins_h)) => (
            format!("{} {}", &lower[..at], &lower[at + length..])
                .trim()
                .to_owned(),
            Some(begins_h),
        ),
        None => (lower, None),
    }
}

/// The part before the hour, and the time of day.
fn date_and_clock(text: &str) -> Option<(&str, &str)> {
    let colon = text.find(':')?;
    let is_before = |c: char| !c.is_ascii_digit();
    let hour = text[..colon]
        .char_indices()
        .rev()
        .find(|(_, c)| is_before(*c))
        .map_or(0, |(at, c)| at + c.len_utf8());
    let (date, clock) = text.split_at(hour);
    Some((date.trim_end_matches(['t', ' ']).trim(), clock))
}

/// The hour from midnight: 12 is the first of each half; some programs write 13 to 23 in the afternoon.
fn hour_of_day(hour: f64, half_day_h: Option<f64>) -> Option<f64> {
    match half_day_h {
        None => Some(hour),
        Some(begins_h) if hour <= 12.0 => Some(hour % 12.0 + begins_h),
        Some(begins_h) => (begins_h > 0.0).then_some(hour),
    }
}

/// Whether a cell is a date, a time of the day, or both.
pub(super) fn is_date(text: &str) -> bool {
    date_time(text).is_some() || calendar_day(text).is_some()
}

/// Whether a cell of a table is a date or a time.
pub(super) fn is_date_cell(cell: &[u8]) -> bool {
    std::str::from_utf8(unquoted(cell)).is_ok_and(is_date)
}

/// Midnight at the beginning of a day, s from 1970.
pub(crate) fn calendar_day(text: &str) -> Option<f64> {
    calendar(text).and_then(time_of)
}

/// Year, month, day and midnight of "2024-06-05", "2024/6/5", "2024. 6. 5.", "2024년 6월 5일", "05.06.2024", "6/5/2024".
fn calendar(date: &str) -> Option<[f64; 6]> {
    let date = date.trim().trim_end_matches(['.', '일']);
    let parts: Vec<&str> = date.split(['-', '/', '.', '년', '월']).map(str::trim).collect();
    let [a, b, c] = parts[..] else { return None };
    let number = |text: &str| text.parse::<u32>().ok().map(f64::from);
    let (year, month, day) = match (a.len(), c.len()) {
        (4, _) => (number(a)?, number(b)?, number(c)?),
        // in dates with slashes the month comes first, unless that is impossible
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
            ("2024-06-05 오전 10:00:00.000", 1e-3),
            ("2024-06-05 AM 10:00:00", 1.0),
            ("2024-06-05 10:00:00.0 오전", 0.1),
            ("2024. 6. 5. 오전 10:00", 60.0),
            ("2024년 6월 5일 오전 10:00:00", 1.0),
            ("6/5/2024 10:00:00 a.m.", 1.0),
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
        for (text, hour) in [
            ("오전 12:30:00", 0.5),
            ("오후 12:30:00", 12.5),
            ("PM 1:30:00", 13.5),
            ("오후 13:30:00", 13.5),
            ("11:30:00 p.m.", 23.5),
        ] {
            assert_eq!(
                date_time(text).map(|at| at.seconds),
                Some(3600.0 * hour),
                "{text}"
            );
        }
        let at = minute_of_hour("59:30.05").unwrap();
        assert_eq!((at.seconds, at.resolution_s), (3570.05, 0.01));
        for text in ["59:30", "60:00.0", "10:60.0", "9:59:30.0", "-1:30.0", "1.5"] {
            assert_eq!(minute_of_hour(text), None, "{text}");
        }
        assert_eq!(date_time("09:30.5"), None);
        assert_eq!(
            (after_in_hours(3599.9, 0.1), after_in_hours(7199.9, 0.1)),
            (3600.1, 7200.1)
        );
        assert_eq!(after_in_hours(100.0, 99.0), 99.0);
        assert_eq!(serial("45448.5").map(|at| at.seconds), Some(45448.5 * DAY_S));
        for text in [
            "noon",
            "2024-06-05",
            "2024-13-05 10:00:00",
            "1.25",
            "25:00:00",
            "오전 13:00:00",
            "오후 25:00:00",
            "am 3: 5",
            "sensor 3",
        ] {
            assert_eq!(date_time(text), None, "{text}");
        }
    }
}
