//! Errors of reading a record.

use super::not_a_table::NotATable;
use crate::limits::LimitError;
use crate::seismic::SeismicError;
use crate::sheet_error::SheetError;
use dolmen::signal::SignalError;
use dolmen_words::message::Both;

/// Why the bytes of a file are not a record. Each variant gives the place in the file and what to do. Lines and columns are counted from 1.
#[derive(Clone, Debug, PartialEq)]
pub enum RecordError {
    /// The file has no bytes, or only empty lines and comments.
    Empty,
    /// The file has column names but no samples.
    OnlyHeader {
        /// Line of the header.
        line: usize,
    },
    /// The first line mixes names and numbers.
    UnclearHeader {
        /// The line.
        line: usize,
    },
    /// The file is not a table of numbers. The error quotes none of its content.
    NotATable(NotATable),
    /// The workbook cannot be read.
    Workbook {
        /// The reason.
        why: SheetError,
    },
    /// Text in UTF-16, with two bytes per character.
    Utf16,
    /// The unit is not one of [`Unit`](super::Unit).
    UnknownUnit {
        /// The text given.
        given: String,
    },
    /// A cell is not a number.
    NotANumber {
        /// Line of the file.
        line: usize,
        /// Name of the column.
        column: String,
        /// Content of the cell.
        text: String,
    },
    /// A time stamp is a date or other text.
    TimeText {
        /// Line of the file.
        line: usize,
        /// Name of the time column.
        column: String,
        /// Content of the cell.
        text: String,
    },
    /// The line of the column names occurs again.
    HeaderAgain {
        /// Line of the file.
        line: usize,
    },
    /// A cell is empty.
    EmptyCell {
        /// Line of the file.
        line: usize,
        /// Name of the column.
        column: String,
    },
    /// A cell holds NaN or infinity.
    NotFinite {
        /// Line of the file.
        line: usize,
        /// Name of the column.
        column: String,
        /// Content of the cell.
        text: String,
    },
    /// The options name a column that does not exist.
    UnknownColumn {
        /// The requested name.
        given: String,
        /// The most similar name, if any is similar.
        nearest: Option<String>,
        /// The existing names.
        names: Vec<String>,
    },
    /// The options give a column number that does not exist.
    ColumnNumber {
        /// The requested number.
        given: usize,
        /// Number of columns in the file.
        columns: usize,
    },
    /// A column is requested twice.
    PickedTwice {
        /// The column.
        column: String,
        /// The first use of the column.
        first: String,
        /// The second use of the column.
        second: String,
    },
    /// Several columns have the same name, and the options request that name.
    AmbiguousColumn {
        /// The requested name.
        given: String,
        /// Number of columns with that name.
        count: usize,
    },
    /// A line has more or fewer cells than the lines before.
    Ragged {
        /// Line of the file.
        line: usize,
        /// Number of cells in the line.
        found: usize,
        /// Number of cells in the lines before.
        expected: usize,
        /// Whether this is the last line of the file and has no line end.
        last: bool,
    },
    /// Numbers have decimal commas, and commas also separate the cells.
    DecimalCommas {
        /// Line of the file.
        line: usize,
        /// Number of cells in the line.
        found: usize,
        /// Number of column names.
        expected: usize,
    },
    /// The only column is the time column.
    OnlyTime {
        /// Name of the time column.
        column: String,
    },
    /// The file has no time column, and the options give no rate.
    NoRate {
        /// The names of the columns.
        names: Vec<String>,
    },
    /// NPY files do not contain a rate, and the options give none.
    NoRateNpy,
    /// A channel looks like time stamps.
    LooksLikeTime {
        /// The column.
        column: String,
        /// Constant step between its samples.
        step: f64,
    },
    /// The dates contradict the given rate.
    DatesDisagree {
        /// The given rate, Hz.
        given: f64,
        /// Name of the column.
        column: String,
        /// First cell of the column.
        first: String,
        /// Last cell of the column.
        last: String,
        /// Number of samples.
        samples: usize,
        /// The rate that follows from the dates, Hz.
        dates_hz: f64,
    },
    /// Samples are missing between two dates.
    DatesGap {
        /// Name of the column.
        column: String,
        /// Line before the gap.
        line: usize,
        /// Date before the gap.
        before: String,
        /// Date after the gap.
        after: String,
        /// Time between both dates, s.
        step_s: f64,
    },
    /// The name of the time column has an unknown unit.
    TimeUnit {
        /// Name of the column.
        column: String,
    },
    /// The steps between time stamps are too long for seconds.
    SlowStamps {
        /// Name of the column.
        column: String,
        /// First step, in the unit of the column.
        step: f64,
        /// The rate if the unit is milliseconds, Hz.
        milliseconds_hz: f64,
    },
    /// The time stamps are not equally spaced.
    Uneven {
        /// Line of the file.
        line: usize,
        /// Time stamp in this line, s.
        stamp_s: f64,
        /// Step from the previous time stamp, s.
        step_s: f64,
        /// Step between the earlier time stamps, s.
        expected_step_s: f64,
        /// Expected time stamp, s.
        expected_s: f64,
    },
    /// The time stamps scatter about even steps, but no sample is missing.
    Jitter {
        /// Line of the file.
        line: usize,
        /// Time stamp in this line, s.
        stamp_s: f64,
        /// Step from the previous time stamp, s.
        step_s: f64,
        /// Even step: that of the given rate, else the mean of all steps, s.
        even_step_s: f64,
    },
    /// The second time stamp is not after the first.
    StampsStand {
        /// Line of the file.
        line: usize,
        /// The time stamp, s.
        stamp: f64,
        /// The time stamp before it, s.
        before: f64,
    },
    /// Coarse time stamps have different steps: by rounding, or because a sample is missing.
    CoarseStamps {
        /// Line of the file.
        line: usize,
        /// Step from the previous time stamp, s.
        step_s: f64,
        /// The step before it, s.
        step_before_s: f64,
        /// Value of the last printed digit, s.
        resolution_s: f64,
    },
    /// The given rate contradicts the time stamps.
    RateDisagrees {
        /// The given rate, Hz.
        given: f64,
        /// The rate of the time stamps, Hz.
        stamps_hz: f64,
    },
    /// The file is not an NPY file.
    NotNpy,
    /// The version of the NPY format is too new.
    NpyVersion {
        /// Major version.
        major: u8,
    },
    /// The NPY file ends inside its header.
    NpyHeaderTruncated {
        /// Number of bytes in the file.
        bytes: usize,
    },
    /// The header of the NPY file is not valid.
    NpyHeader {
        /// The first 200 characters of the header.
        text: String,
    },
    /// The NPY file has an unsupported type of number.
    NpyType {
        /// The type in the notation of NumPy.
        given: String,
    },
    /// The NPY array has no axis, or more than two.
    NpyShape {
        /// The shape.
        shape: Vec<usize>,
    },
    /// The NPY file ends before its last value.
    NpyTruncated {
        /// The shape.
        shape: Vec<usize>,
        /// Number of complete values in the file.
        held: usize,
    },
    /// The NPY file continues after its last value.
    NpyTrailing {
        /// The shape.
        shape: Vec<usize>,
        /// Number of bytes after the last value.
        extra: usize,
    },
    /// The options request a column of an NPY file by name.
    NpyNamed {
        /// The requested name.
        given: String,
        /// Number of channels in the file.
        columns: usize,
    },
    /// The unit in a column name differs from the given unit.
    ColumnUnitDisagrees {
        /// The column.
        column: String,
        /// The unit in its name.
        found: &'static str,
        /// The given unit.
        given: &'static str,
        /// Factor between the units; `None` if they measure different quantities.
        scale: Option<f64>,
    },
    /// The names of two columns have different units.
    ColumnUnitsDiffer {
        /// The column.
        column: String,
        /// The unit in its name.
        found: &'static str,
        /// An earlier column.
        other: String,
        /// The unit in its name.
        unit: &'static str,
        /// Factor between the units; `None` if they measure different quantities.
        scale: Option<f64>,
    },
    /// A binary file is shorter than its header states.
    CutShort {
        /// Format of the file.
        format: &'static str,
        /// Number of bytes in the file.
        bytes: usize,
        /// Number of bytes that the header requires.
        wanted: u64,
    },
    /// A binary file contains an invalid value.
    Damaged {
        /// Format of the file.
        format: &'static str,
        /// Position of the value, in bytes from 0.
        at: u64,
        /// The fault.
        what: Both,
    },
    /// The file uses a variant of its format that is not supported.
    NotReadHere {
        /// Format of the file.
        format: &'static str,
        /// The unsupported content.
        what: Both,
        /// What to do.
        instead: Both,
    },
    /// The file does not have the format that the project states.
    NotOfFormat {
        /// The stated format.
        format: &'static str,
        /// Description of the beginning of the file: "a miniseed file", "text", "no text". The text is not quoted, because it may come from
        /// any file.
        begins: Both,
    },
    /// A line of a text file differs from what the format requires.
    LineIsNot {
        /// Format of the file.
        format: &'static str,
        /// Line of the file.
        line: usize,
        /// The first 80 characters of the line.
        text: String,
        /// The required content.
        wanted: Both,
    },
    /// A text file ends too early.
    EndsBefore {
        /// Format of the file.
        format: &'static str,
        /// The missing line.
        line: usize,
        /// The required content.
        wanted: Both,
    },
    /// The header lacks a value.
    HeaderLacks {
        /// Format of the file.
        format: &'static str,
        /// What is missing.
        what: Both,
    },
    /// The number of samples differs from that in the header.
    SampleCount {
        /// Format of the file.
        format: &'static str,
        /// Number of samples in the header.
        stated: u64,
        /// Number of samples in the file.
        found: usize,
    },
    /// The blocks of a channel are not continuous in time.
    Gap {
        /// The channel.
        channel: String,
        /// Expected start of the block, s.
        expected_s: f64,
        /// Actual start of the block, s.
        found_s: f64,
    },
    /// A variable of a MAT file contradicts the others.
    Variable {
        /// The variable.
        name: String,
        /// The contradiction.
        what: Both,
    },
    /// A WAV file has no scale.
    NoFullScale,
    /// The given unit contradicts the unit of the numbers in the file.
    NoScale {
        /// Format of the file.
        format: &'static str,
        /// The channel.
        channel: String,
        /// Unit of the numbers in the file.
        found: String,
        /// The given unit.
        given: &'static str,
    },
    /// The given unit contradicts the unit in the file.
    UnitDisagrees {
        /// The channel.
        channel: String,
        /// The given unit.
        given: &'static str,
        /// The unit of the file.
        found: &'static str,
    },
    /// The given rate contradicts that of the file.
    FileRateDisagrees {
        /// The given rate, Hz.
        given: f64,
        /// The rate in the file, Hz.
        found: f64,
    },
    /// The file does not contain its rate, and the options give none.
    NoRateHere {
        /// Format of the file.
        format: &'static str,
    },
    /// The options give a start time, but the file contains one.
    TwoStarts {
        /// The file.
        file: String,
    },
    /// The file exceeds a limit of the reader.
    Limit(LimitError),
    /// The file of a seismic station cannot be read.
    Seismic(Box<SeismicError>),
    /// The samples do not form a valid record.
    Signal(SignalError),
}
