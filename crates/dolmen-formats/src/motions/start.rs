//! When the first sample of a channel was taken.

/// Seconds in a day.
const DAY_S: f64 = 86_400.0;

/// Days from 1 January 1970 to a day of the Gregorian calendar; `None` unless it is one.
///
/// # Source
/// Hinnant (2021) *chrono-Compatible Low-Level Date Algorithms*, days_from_civil.
pub(super) fn days(year: i64, month: i64, day: i64) -> Option<i64> {
    if !(1..=9999).contains(&year) || !(1..=12).contains(&month) || !(1..=31).contains(&day) {
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
pub(super) fn seconds(day: i64, hour: i64, minute: i64, second: f64) -> f64 {
    day as f64 * DAY_S + (hour * 3600 + minute * 60) as f64 + second
}

/// From "2018/01/24 19:51:37" or "20190728_160919.870": year, month, day, hour, minute and second are its digits in order.
pub(super) fn of_text(text: &str) -> Option<f64> {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_seconds_since_1970() {
        // datetime.timestamp of Python 3.11, UTC
        assert_eq!(of_text("2018/01/24 19:51:37"), Some(1_516_823_497.0));
        assert_eq!(of_text("20190728_160919.870"), Some(1_564_330_159.870));
        assert_eq!(of_text("1996/02/29 00:00:00"), Some(825_552_000.0));
        assert_eq!(of_text("2018/13/24 19:51:37"), None);
        assert_eq!(of_text("yesterday"), None);
    }
}
