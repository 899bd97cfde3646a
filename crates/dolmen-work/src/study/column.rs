//! A column of a table.

/// The values of a column.
#[derive(Clone, Debug, PartialEq)]
pub enum ColumnValues {
    /// Numbers; `None` for an empty cell.
    Numbers(Vec<Option<f64>>),
    /// Whole numbers.
    Counts(Vec<i64>),
    /// Words; empty for an empty cell.
    Words(Vec<String>),
}

/// A named column of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Its name, the unit last.
    pub name: String,
    /// One value for each row.
    pub values: ColumnValues,
}
