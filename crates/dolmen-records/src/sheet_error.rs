//! Why a table cannot be used, and how large it may be.

/// Most bytes that a workbook may unpack to. Chosen here: 10,000 stones in twenty columns are 20 MB of XML.
pub(crate) const UNPACKED_BYTES_MOST: u64 = 128 << 20;
/// Most bytes that come out of one byte of a workbook. Chosen here: sheets of numbers pack to a tenth, of empty cells with a format to a thirtieth.
pub(crate) const UNPACKED_A_BYTE_MOST: u64 = 100;
/// Bytes that may come out of any workbook, however small.
pub(crate) const UNPACKED_BYTES_FREE: u64 = 16 << 20;
/// Most rows and columns that are looked at. Chosen here: no monument was ever measured stone by stone in more.
pub(crate) const ROWS_MOST: usize = 10_000;
pub(crate) const COLUMNS_MOST: usize = 256;

/// A table that cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SheetError {
    /// No table by its name.
    NotATable,
    /// It cannot be read.
    Unreadable {
        /// What the reader says.
        why: String,
    },
    /// It unpacks to more than it may.
    TooLarge {
        /// The limit, MiB.
        most_mib: u64,
    },
    /// More rows or columns than are read.
    TooMany {
        /// Rows.
        rows: usize,
        /// Columns.
        columns: usize,
        /// Rows that are read.
        rows_most: usize,
    },
    /// Few cells far from one another.
    Sparse {
        /// Rows up to the last.
        rows: usize,
        /// Columns up to the last.
        columns: usize,
        /// Cells that hold something.
        cells: usize,
    },
    /// A cell stands where no sheet has one.
    NoPlace {
        /// How its place begins.
        place: String,
    },
    /// There is no such sheet.
    NoSuchSheet {
        /// The name.
        name: String,
        /// Those there are.
        known: String,
    },
    /// Which sheet is meant is not said.
    SeveralSheets {
        /// Those there are.
        known: String,
    },
    /// Several sheets of a workbook of samples hold something.
    SeveralTables {
        /// They.
        known: String,
    },
    /// A table of text has sheets.
    NoSheets,
    /// Nothing stands in it.
    NoRows,
    /// A formula.
    Formula {
        /// The cell.
        place: String,
    },
    /// Cells that are merged.
    Merged {
        /// The cells: "B2:B4".
        place: String,
    },
    /// An error of the sheet.
    Other {
        /// The cell.
        place: String,
        /// What it holds.
        what: String,
    },
}

/// An error of whatever reads a table.
pub(crate) fn unreadable(why: impl std::fmt::Display) -> SheetError {
    SheetError::Unreadable { why: why.to_string() }
}
