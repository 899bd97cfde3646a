//! The date in a survey's name.

/// The date at the beginning of a survey's name: "2019", "2019-04", "2019-04-02", "2019.04.02", "20190402"; missing parts are 0.
pub use dolmen_project::date_of as date;
use dolmen_records::time_text;

/// Days from 1970-01-01 to a date; a missing month or day is taken in the middle of the known period.
///
/// Source: Richards (2013) Explanatory supplement to the astronomical almanac, 15.11, in the form of H. Hinnant (2013).
pub(crate) fn day_of([year, month, day]: [u32; 3]) -> f64 {
    let (month, day) = match (month, day) {
        (0, _) => (7, 1),
        (month, 0) => (month, 15),
        known => known,
    };
    let (y, m) = match month {
        1 | 2 => (i64::from(year) - 1, i64::from(month) + 9),
        _ => (i64::from(year), i64::from(month) - 3),
    };
    let era = y.div_euclid(400);
    let of_era = y - era * 400;
    let of_year = (153 * m + 2) / 5 + i64::from(day) - 1;
    let of_cycle = of_era * 365 + of_era / 4 - of_era / 100 + of_year;
    (era * 146_097 + of_cycle - 719_468) as f64
}

/// The first and the last day of a date, such as the whole of a year.
pub(crate) fn days_of([year, month, day]: [u32; 3]) -> [f64; 2] {
    match (month, day) {
        (0, _) => [day_of([year, 1, 1]), day_of([year, 12, 31])],
        (12, 0) => [day_of([year, 12, 1]), day_of([year, 12, 31])],
        (month, 0) => [day_of([year, month, 1]), day_of([year, month + 1, 1]) - 1.0],
        known => {
            let day = day_of([year, known.0, known.1]);
            [day, day]
        }
    }
}

/// The date of a day from 1970-01-01: "2019-04-02".
pub fn date_text(day: f64) -> String {
    time_text(day.floor() * 86_400.0).chars().take(DATE).collect()
}

/// Number of characters in a full date: "2019-04-02".
const DATE: usize = 10;

/// The day of a survey whose name is only a date, with or without a time or a number after it: "2019-04-02", "2019-04-02T10:30", "2019-04-02
/// 10:30:15", "2019-04-02 (2)". A name with words after its date means something else.
pub fn day_of_a_record(name: &str) -> Option<&str> {
    date(name).filter(|[_, _, day]| *day > 0 && name.as_bytes().get(4) == Some(&b'-'))?;
    let (day, rest) = name.split_at_checked(DATE)?;
    let rest = rest.trim_start_matches(['T', ' ']);
    let is_when = |sign: char| sign.is_ascii_digit() || matches!(sign, ':' | '(' | ')' | ' ');
    rest.chars().all(is_when).then_some(day)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_names_that_say_only_when_are_of_a_day() {
        for name in [
            "2019-04-02",
            "2019-04-02T10:30",
            "2019-04-02 10:30:15",
            "2019-04-02 (2)",
        ] {
            assert_eq!(day_of_a_record(name), Some("2019-04-02"), "{name}");
        }
        for name in [
            "2019-04",
            "2019",
            "2019-04-02 before",
            "20190402 10:30",
            "2019-04-02-a",
            "2019-04-02조",
            "first",
            "",
        ] {
            assert_eq!(day_of_a_record(name), None, "{name}");
        }
    }

    #[test]
    fn exact_days_of_dates_that_are_known() {
        assert_eq!(day_of([1970, 1, 1]), 0.0);
        assert_eq!(day_of([2000, 3, 1]), 11_017.0);
        assert_eq!(day_of([2024, 2, 29]), 19_782.0);
        assert_eq!(day_of([2024, 0, 0]), day_of([2024, 7, 1]));
        assert_eq!(days_of([2024, 2, 0]).map(date_text), ["2024-02-01", "2024-02-29"]);
        assert_eq!(
            days_of([2024, 12, 0]).map(date_text),
            ["2024-12-01", "2024-12-31"]
        );
        assert_eq!(days_of([2024, 0, 0]).map(date_text), ["2024-01-01", "2024-12-31"]);
        assert_eq!(days_of([2024, 2, 29]).map(date_text), ["2024-02-29"; 2]);
    }
}
