//! The files of the schema, in SQLite's dialect; the first has number 1.

/// One schema for every database.
pub(crate) const FILES: [&str; 5] = [
    include_str!("sql/0001_surveys.sql"),
    include_str!("sql/0002_arrivals.sql"),
    include_str!("sql/0003_accepted_modes.sql"),
    include_str!("sql/0004_earthquakes.sql"),
    include_str!("sql/0005_inspections.sql"),
];

/// The file that adds the tables of inspections. Stores of earlier versions have inspections only in the texts of their projects.
pub(crate) const OF_INSPECTIONS: usize = 5;
