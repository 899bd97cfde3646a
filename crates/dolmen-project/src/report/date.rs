//! Days of the calendar.

/// Year, month and day of a text such as "2026-05-12"; `None` if it is no day of the calendar.
pub fn calendar_day(text: &str) -> Option<[u16; 3]> {
    let parts: Vec<&str> = text.split('-').collect();
    let digits = |part: &&str| part.bytes().all(|b| b.is_ascii_digit());
    let numbers: Option<Vec<u16>> = parts.iter().map(|part| part.parse().ok()).collect();
    match (numbers?.as_slice(), parts.iter().all(digits)) {
        ([year, month, day], true) if parts.iter().map(|part| part.len()).eq([4, 2, 2]) => {
            let is_there = (1..=12).contains(month) && (1..=days(*year, *month)).contains(day);
            is_there.then_some([*year, *month, *day])
        }
        _ => None,
    }
}

/// Whether a text is a day of the calendar.
pub fn is_day(text: &str) -> bool {
    calendar_day(text).is_some()
}

fn days(year: u16, month: u16) -> u16 {
    let leap = year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
    match month {
        4 | 6 | 9 | 11 => 30,
        2 if leap => 29,
        2 => 28,
        _ => 31,
    }
}

#[cfg(test)]
mod tests {
    use super::is_day;

    #[test]
    fn exact_days_of_the_calendar() {
        for day in ["2026-11-23", "2024-02-29", "2000-02-29", "1999-12-31"] {
            assert!(is_day(day), "{day}");
        }
        for day in [
            "2023-02-29",
            "1900-02-29",
            "2026-04-31",
            "2026-13-01",
            "2026-00-10",
            "2026-1-1",
            "2026. 4. 2.",
            "+026-01-01",
            "",
        ] {
            assert!(!is_day(day), "{day}");
        }
    }
}
