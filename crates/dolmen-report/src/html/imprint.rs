//! The imprint of a report, and projects that it could not include.

/// The program and the date.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Imprint {
    /// Name and version of the program: "dolmen 0.1.0".
    pub program: String,
    /// Date as printed: "2026-05-12"; `None` leaves it out, so that the same input gives the same page.
    pub date: Option<String>,
}

/// Year, month and day, if the date has the form 2026-05-12 and exists.
pub(crate) fn day(date: Option<&str>) -> Option<[u16; 3]> {
    dolmen_project::calendar_day(date?)
}

/// A project that the report could not include.
#[derive(Clone, Debug, PartialEq)]
pub struct NotReported {
    /// Its file or folder, as the user named it.
    pub file: String,
    /// Reason.
    pub why: String,
}
