//! The time of the first sample of a channel.

/// Seconds in a day.
const DAY_S: f64 = 86_400.0;

/// Days from 1 January 1970 to a day of the Gregorian calendar; `None` for an invalid date.
///
/// # Source
/// Hinnant (2021) *chrono-Compatible Low-Level Date Algorithms*, days_from_civil.
pub(crate) fn days(year: i64, month: i64, day: i64) -> Option<i64> {
    let is_leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    let days_of_month = match month {
        2 => 28 + i64::from(is_leap),
        4 | 6 | 9 | 11 => 30,
        _ => 31,
    };
    if !(1..=9999).contains(&year) || !(1..=12).contains(&month) || !(1..=days_of_month).contains(&day) {
        return None;
    }
    let y = if month <= 2 { year - 1 } else { year };
    let era = y.div_euclid(400);
    let year_of_era = y - era * 400;
    let month_from_march = (month + 9) % 12;
    let day_of_year = (153 * month_from_march + 2) / 5 + day - 1;
    let day_of_era = year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year;
    Some(era * 146_097 + day_of_era - 719_468)
}

/// Seconds from 1 January 1970 to a time of the day.
pub(crate) fn seconds(day: i64, hour: i64, minute: i64, second: f64) -> f64 {
    day as f64 * DAY_S + (hour * 3600 + minute * 60) as f64 + second
}

/// Seconds from 1 January 1970 to year, month, day, hour, minute, second; `None` for an invalid time.
pub(crate) fn time_of([year, month, day, hour, minute, second]: [f64; 6]) -> Option<f64> {
    let whole = |x: f64| (x.fract() == 0.0 && x.abs() < 1e4).then_some(x as i64);
    let day = days(whole(year)?, whole(month)?, whole(day)?)?;
    let (hour, minute) = (whole(hour)?, whole(minute)?);
    let allowed = (0..24).contains(&hour) && (0..60).contains(&minute) && (0.0..61.0).contains(&second);
    allowed.then(|| seconds(day, hour, minute, second))
}

/// Seconds from 1 January 1970 of "2018/01/24 19:51:37" or "20190728_160919.870": year, month, day, hour, minute and second are its digits in order.
pub fn start_of_text(text: &str) -> Option<f64> {
    let text = text.trim();
    let fraction = text
        .find('.')
        .map_or(Some(0.0), |at| text[at..].parse::<f64>().ok())?;
    let whole = text.split('.').next()?;
    let digits: String = whole.chars().filter(char::is_ascii_digit).collect();
    if digits.len() != 14 {
        return None;
    }
    let part = |from: usize, to: usize| digits[from..to].parse::<i64>().ok();
    let day = days(part(0, 4)?, part(4, 6)?, part(6, 8)?)?;
    let (hour, minute, second) = (part(8, 10)?, part(10, 12)?, part(12, 14)?);
    (hour < 24 && minute < 60 && second <= 60).then(|| seconds(day, hour, minute, second as f64 + fraction))
}

/// Times beyond these are not dates, s: the year 9999.
const DATES_WITHIN_S: f64 = 253_402_300_800.0;

/// "2018-01-24 19:51:37.250" from seconds since 1 January 1970; "1e300 s from 1970" if it is not a date.
///
/// # Source
/// Hinnant (2021) *chrono-Compatible Low-Level Date Algorithms*, civil_from_days.
pub fn time_text(seconds: f64) -> String {
    if seconds.is_nan() || seconds.abs() > DATES_WITHIN_S {
        return format!("{seconds:e} s from 1970");
    }
    let milliseconds = (seconds * 1e3).round();
    let day = (milliseconds / (DAY_S * 1e3)).floor();
    let of_day = milliseconds - day * DAY_S * 1e3;
    let shifted = day as i64 + 719_468;
    let era = shifted.div_euclid(146_097);
    let day_of_era = shifted - era * 146_097;
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month_from_march = (5 * day_of_year + 2) / 153;
    let date = day_of_year - (153 * month_from_march + 2) / 5 + 1;
    let month = if month_from_march < 10 {
        month_from_march + 3
    } else {
        month_from_march - 9
    };
    let year = year_of_era + era * 400 + i64::from(month <= 2);
    let (minutes, second) = ((of_day / 6e4).floor(), of_day % 6e4 / 1e3);
    let (hour, minute) = ((minutes / 60.0).floor(), minutes % 60.0);
    format!("{year:04}-{month:02}-{date:02} {hour:02}:{minute:02}:{second:06.3}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_seconds_since_1970() {
        // datetime.timestamp of Python 3.11, UTC
        assert_eq!(start_of_text("2018/01/24 19:51:37"), Some(1_516_823_497.0));
        assert_eq!(start_of_text("20190728_160919.870"), Some(1_564_330_159.870));
        assert_eq!(start_of_text("1996/02/29 00:00:00"), Some(825_552_000.0));
        for text in [
            "2018-01-24 19:51:37.000",
            "1996-02-29 00:00:00.125",
            "2000-12-31 23:59:59.999",
        ] {
            assert_eq!(start_of_text(text).map(time_text).as_deref(), Some(text));
        }
        assert_eq!(
            time_of([2018.0, 1.0, 24.0, 19.0, 51.0, 37.5]),
            Some(1_516_823_497.5)
        );
        assert_eq!(time_of([2018.0, 1.5, 24.0, 19.0, 51.0, 37.5]), None);
        assert_eq!(start_of_text("2018/13/24 19:51:37"), None);
        for (day, is_one) in [
            ("2018/02/29", false),
            ("2020/02/29", true),
            ("1900/02/29", false),
            ("2018/04/31", false),
        ] {
            assert_eq!(
                start_of_text(&format!("{day} 00:00:00")).is_some(),
                is_one,
                "{day}"
            );
        }
        assert_eq!(start_of_text("yesterday"), None);
        for (seconds, text) in [
            (1e300, "1e300 s from 1970"),
            (f64::NAN, "NaN s from 1970"),
            (253_402_300_799.0, "9999-12-31 23:59:59.000"),
        ] {
            assert_eq!(time_text(seconds), text);
        }
    }
}
