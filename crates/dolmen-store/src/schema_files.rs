//! The files that make the schema, in the words of SQLite; the first has number 1.

/// One schema for every database.
pub(crate) const FILES: [&str; 4] = [
    include_str!("sql/0001_surveys.sql"),
    include_str!("sql/0002_arrivals.sql"),
    include_str!("sql/0003_accepted_modes.sql"),
    include_str!("sql/0004_earthquakes.sql"),
];
