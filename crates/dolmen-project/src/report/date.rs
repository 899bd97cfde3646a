//! Days of the calendar.

/// Whether a text is a day as "2026-05-12".
pub fn is_day(text: &str) -> bool {
    let parts: Vec<&str> = text.split('-').collect();
    let [year, month, day] = parts.as_slice() else {
        return false;
    };
    let widths = [year.len(), month.len(), day.len()] == [4, 2, 2];
    let digits = parts.iter().all(|part| part.bytes().all(|b| b.is_ascii_digit()));
    let number = |part: &str| part.parse::<u32>().unwrap_or(0);
    let (year, month, day) = (number(year), number(month), number(day));
    widths && digits && (1..=12).contains(&month) && (1..=days(year, month)).contains(&day)
}

fn days(year: u32, month: u32) -> u32 {
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
