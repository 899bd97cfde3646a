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
    dolmen_project::calendar_day(date?)
}

/// A project that could not be reported on.
#[derive(Clone, Debug, PartialEq)]
pub struct NotReported {
    /// Its file or folder, as the user named it.
    pub file: String,
    /// Why.
    pub why: String,
}
