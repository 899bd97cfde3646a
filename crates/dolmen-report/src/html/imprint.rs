//! What a report tells of itself, and of what it could not tell.

/// Who made the page, and when.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Imprint {
    /// Name and version of the program: "dolmen 0.1.0".
    pub program: String,
    /// When, as it is to be printed: "2026-05-12"; `None` leaves it out, so that the same input gives the same page.
    pub date: Option<String>,
}

/// Year, month and day, if the date is written as 2026-05-12 and is one of the calendar.
pub(crate) fn day(date: Option<&str>) -> Option<[u16; 3]> {
    let parts: Vec<&str> = date?.split('-').collect();
    let numbers: Option<Vec<u16>> = parts.iter().map(|part| part.parse().ok()).collect();
    let lengths: Vec<usize> = parts.iter().map(|part| part.len()).collect();
    match numbers.as_deref() {
        Some([year, month, day]) if lengths == [4, 2, 2] => {
            let is_there = (1..=days(*year, *month)).contains(day);
            is_there.then_some([*year, *month, *day])
        }
        _ => None,
    }
}

fn days(year: u16, month: u16) -> u16 {
    let leap = year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
    match month {
        1 | 3 | 5 | 7 | 8 | 10 | 12 => 31,
        4 | 6 | 9 | 11 => 30,
        2 if leap => 29,
        2 => 28,
        _ => 0,
    }
}

/// A project that could not be reported on.
#[derive(Clone, Debug, PartialEq)]
pub struct NotReported {
    /// Its file or folder, as it was named.
    pub file: String,
    /// Why.
    pub why: String,
}
