//! Errors of tables, and limits of their size.

/// Largest unpacked size of a workbook, bytes. Our choice: 10,000 stones in twenty columns are 20 MB of XML.
pub(crate) const UNPACKED_BYTES_MOST: u64 = 128 << 20;
/// Largest unpacked size relative to that of the workbook. Our choice: sheets of numbers pack to a tenth, formatted empty cells to a thirtieth.
pub(crate) const UNPACKED_A_BYTE_MOST: u64 = 100;
/// Bytes allowed for any workbook, however small.
pub(crate) const UNPACKED_BYTES_FREE: u64 = 16 << 20;
/// Largest number of rows and columns. Our choice: no monument was ever measured stone by stone in more.
pub(crate) const ROWS_MOST: usize = 10_000;
pub(crate) const COLUMNS_MOST: usize = 256;

/// A table that is not usable.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SheetError {
    /// The file name is not that of a table.
    NotATable,
    /// The table cannot be read.
    Unreadable {
        /// Message of the workbook reader.
        why: String,
    },
    /// Its unpacked size is too large.
    TooLarge {
        /// The limit, MiB.
        most_mib: u64,
    },
    /// The table has more rows or columns than allowed.
    TooMany {
        /// Number of rows.
        rows: usize,
        /// Number of columns.
        columns: usize,
        /// Largest number of rows.
        rows_most: usize,
    },
    /// The table has few cells, far from one another.
    Sparse {
        /// Rows up to the last.
        rows: usize,
        /// Columns up to the last.
        columns: usize,
        /// Number of cells with contents.
        cells: usize,
    },
    /// A cell in an impossible place.
    NoPlace {
        /// Beginning of its cell reference.
        place: String,
    },
    /// An element of its XML does not end where it should.
    Damaged,
    /// There is no such sheet.
    NoSuchSheet {
        /// The name.
        name: String,
        /// The existing names.
        known: String,
    },
    /// Several sheets; the user must choose one.
    SeveralSheets {
        /// The existing names.
        known: String,
    },
    /// Several sheets of a workbook of samples have values.
    SeveralTables {
        /// Names of these sheets.
        known: String,
    },
    /// The user chose a sheet, but the table is text.
    NoSheets,
    /// The table is empty.
    NoRows,
    /// A cell contains a formula.
    Formula {
        /// The cell.
        place: String,
    },
    /// Cells are merged.
    Merged {
        /// The cells: "B2:B4".
        place: String,
    },
    /// An error of the sheet.
    Other {
        /// The cell.
        place: String,
        /// Content of the cell.
        what: String,
    },
}

/// An error of a library that reads a table.
pub(crate) fn unreadable(why: impl std::fmt::Display) -> SheetError {
    SheetError::Unreadable { why: why.to_string() }
}
