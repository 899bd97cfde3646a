//! The files that make the schema, in the words of SQLite; the first has number 1.

/// One schema for every database.
pub(crate) const FILES: [&str; 5] = [
    include_str!("sql/0001_surveys.sql"),
    include_str!("sql/0002_arrivals.sql"),
    include_str!("sql/0003_accepted_modes.sql"),
    include_str!("sql/0004_earthquakes.sql"),
    include_str!("sql/0005_inspections.sql"),
];

/// The file whose tables hold what inspections found: stores of earlier ones have it in the texts of their projects alone.
pub(crate) const OF_INSPECTIONS: usize = 5;
