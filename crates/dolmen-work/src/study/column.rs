//! A column of a table.

/// The values of a column.
#[derive(Clone, Debug, PartialEq)]
pub enum ColumnValues {
    /// Numbers; none where there is none.
    Numbers(Vec<Option<f64>>),
    /// Whole numbers.
    Counts(Vec<i64>),
    /// Words; empty where there are none.
    Words(Vec<String>),
}

/// A named column of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Its name, the unit last.
    pub name: String,
    /// One value a row.
    pub values: ColumnValues,
}
