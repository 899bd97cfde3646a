//! Days of the calendar.

use dolmen_records::start_of_text;

/// Year, month and day of a text such as "2026-05-12"; `None` for a day that is not in the calendar.
pub fn calendar_day(text: &str) -> Option<[u16; 3]> {
    let parts: Vec<&str> = text.split('-').collect();
    let digits = |part: &&str| part.bytes().all(|b| b.is_ascii_digit());
    let numbers: Option<Vec<u16>> = parts.iter().map(|part| part.parse().ok()).collect();
    match (numbers?.as_slice(), parts.iter().all(digits)) {
        ([year, month, day], true) if parts.iter().map(|part| part.len()).eq([4, 2, 2]) => {
            let is_there = start_of_text(&format!("{text} 00:00:00")).is_some();
            is_there.then_some([*year, *month, *day])
        }
        _ => None,
    }
}

/// Whether a text is a day of the calendar.
pub fn is_day(text: &str) -> bool {
    calendar_day(text).is_some()
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
