//! Why a record cannot be read.

use super::not_a_table::NotATable;
use crate::limits::LimitError;
use crate::seismic::SeismicError;
use crate::sheet_error::SheetError;
use dolmen::signal::SignalError;
use dolmen_words::message::Both;

/// Why the bytes of a file are not a record. Each variant gives the place in the file and the remedy. Lines and columns are counted from 1.
#[derive(Clone, Debug, PartialEq)]
pub enum RecordError {
    /// No bytes, or nothing but empty lines and comments.
    Empty,
    /// Names but no samples.
    OnlyHeader {
        /// Line of the header.
        line: usize,
    },
    /// The first line holds names and numbers.
    UnclearHeader {
        /// The line.
        line: usize,
    },
    /// Not a table of numbers; the error quotes nothing of it.
    NotATable(NotATable),
    /// The workbook is refused.
    Workbook {
        /// Why.
        why: SheetError,
    },
    /// Text of two bytes a letter.
    Utf16,
    /// The unit is not one of [`Unit`](super::Unit).
    UnknownUnit {
        /// The text given.
        given: String,
    },
    /// A cell is no number.
    NotANumber {
        /// Line of the file.
        line: usize,
        /// Name of the column.
        column: String,
        /// What stands there.
        text: String,
    },
    /// A time stamp is a date or other text.
    TimeText {
        /// Line of the file.
        line: usize,
        /// Name of the time column.
        column: String,
        /// What stands there.
        text: String,
    },
    /// An empty cell.
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
        /// What stands there.
        text: String,
    },
    /// The options name a column that does not exist.
    UnknownColumn {
        /// The name asked for.
        given: String,
        /// The most similar name, if any is similar.
        nearest: Option<String>,
        /// The names there are.
        names: Vec<String>,
    },
    /// The options ask for a column by a number that does not exist.
    ColumnNumber {
        /// The number asked for.
        given: usize,
        /// Columns of the file.
        columns: usize,
    },
    /// A column is requested twice.
    PickedTwice {
        /// The column.
        column: String,
        /// What it is read as first.
        first: String,
        /// What it is read as then.
        second: String,
    },
    /// Two columns have the same name, and one of them is requested by it.
    AmbiguousColumn {
        /// The name asked for.
        given: String,
        /// Columns of that name.
        count: usize,
    },
    /// A line holds more or fewer cells than the first.
    Ragged {
        /// Line of the file.
        line: usize,
        /// Cells in it.
        found: usize,
        /// Cells in the lines before.
        expected: usize,
        /// Whether it is the last line, without a line end.
        last: bool,
    },
    /// Numbers have decimal commas between commas that separate the cells.
    DecimalCommas {
        /// Line of the file.
        line: usize,
        /// Cells in it.
        found: usize,
        /// Names of columns.
        expected: usize,
    },
    /// Only a time column.
    OnlyTime {
        /// Name of the time column.
        column: String,
    },
    /// Neither a rate nor a time column.
    NoRate {
        /// The names of the columns.
        names: Vec<String>,
    },
    /// NPY files do not contain a rate, and none is given.
    NoRateNpy,
    /// A channel that looks like time stamps.
    LooksLikeTime {
        /// The column.
        column: String,
        /// Its constant step.
        step: f64,
    },
    /// Dates contradict the rate given.
    DatesDisagree {
        /// The rate given, Hz.
        given: f64,
        /// Name of the column.
        column: String,
        /// Its first cell.
        first: String,
        /// Its last cell.
        last: String,
        /// Samples.
        samples: usize,
        /// The rate of the dates, Hz.
        dates_hz: f64,
    },
    /// Samples are missing between two dates.
    DatesGap {
        /// Name of the column.
        column: String,
        /// Line before the gap.
        line: usize,
        /// The date there.
        before: String,
        /// The next.
        after: String,
        /// Time between both, s.
        step_s: f64,
    },
    /// The name of the time column has an unknown unit.
    TimeUnit {
        /// Name of the column.
        column: String,
    },
    /// Time stamps too far apart for seconds.
    SlowStamps {
        /// Name of the column.
        column: String,
        /// Their first steps, in the unit of the column.
        step: f64,
        /// The rate if they are milliseconds, Hz.
        milliseconds_hz: f64,
    },
    /// Time stamps that are not evenly spaced.
    Uneven {
        /// Line of the file.
        line: usize,
        /// The time stamp there, s.
        stamp_s: f64,
        /// Step from the stamp before, s.
        step_s: f64,
        /// Step of the stamps before, s.
        expected_step_s: f64,
        /// Where that step would put this stamp, s.
        expected_s: f64,
    },
    /// The second time stamp is not after the first.
    StampsStand {
        /// Line of the file.
        line: usize,
        /// The stamp, s.
        stamp: f64,
        /// The one before, s.
        before: f64,
    },
    /// Different steps between coarse time stamps: rounding or a missing sample.
    CoarseStamps {
        /// Line of the file.
        line: usize,
        /// Step from the stamp before, s.
        step_s: f64,
        /// The step before that, s.
        step_before_s: f64,
        /// The last digit printed, s.
        resolution_s: f64,
    },
    /// The given rate contradicts the time stamps.
    RateDisagrees {
        /// The rate given, Hz.
        given: f64,
        /// That of the time stamps, Hz.
        stamps_hz: f64,
    },
    /// No NPY file.
    NotNpy,
    /// A later version of NPY.
    NpyVersion {
        /// Its version.
        major: u8,
    },
    /// The NPY file ends within its header.
    NpyHeaderTruncated {
        /// Bytes of the file.
        bytes: usize,
    },
    /// The header of the NPY file cannot be understood.
    NpyHeader {
        /// The header, at most 200 characters of it.
        text: String,
    },
    /// Values of another type.
    NpyType {
        /// The type, as NumPy writes it.
        given: String,
    },
    /// An array of no or more than two axes.
    NpyShape {
        /// The shape.
        shape: Vec<usize>,
    },
    /// The NPY file ends before its last value.
    NpyTruncated {
        /// The shape.
        shape: Vec<usize>,
        /// Whole values held.
        held: usize,
    },
    /// The NPY file goes on after its last value.
    NpyTrailing {
        /// The shape.
        shape: Vec<usize>,
        /// Bytes too many.
        extra: usize,
    },
    /// A column of an NPY file is asked for by name.
    NpyNamed {
        /// The name asked for.
        given: String,
        /// Channels of the file.
        columns: usize,
    },
    /// The name of a column says another unit than the one given.
    ColumnUnitDisagrees {
        /// The column.
        column: String,
        /// The unit in its name.
        found: &'static str,
        /// The unit given.
        given: &'static str,
        /// Factor from one unit to the other; `None` if they measure different quantities.
        scale: Option<f64>,
    },
    /// The names of two columns say different units.
    ColumnUnitsDiffer {
        /// The column.
        column: String,
        /// The unit in its name.
        found: &'static str,
        /// A column before it.
        other: String,
        /// The unit in the name of that.
        unit: &'static str,
        /// Factor from this unit to the other; `None` if they measure different quantities.
        scale: Option<f64>,
    },
    /// A binary file ends before its header says.
    CutShort {
        /// Its format.
        format: &'static str,
        /// Bytes it has.
        bytes: usize,
        /// Bytes that its header asks for.
        wanted: u64,
    },
    /// An invalid value in a binary file.
    Damaged {
        /// Its format.
        format: &'static str,
        /// Where, bytes from 0.
        at: u64,
        /// What is wrong.
        what: Both,
    },
    /// A variant of a format that is not supported.
    NotReadHere {
        /// Its format.
        format: &'static str,
        /// What it holds.
        what: Both,
        /// What to do.
        instead: Both,
    },
    /// The file is not of the format that the project names.
    NotOfFormat {
        /// The format named.
        format: &'static str,
        /// Description of its beginning: "a miniseed file", "text", "no text". Its text is not quoted, because it may be any file.
        begins: Both,
    },
    /// A line of a text file is not what the format has there.
    LineIsNot {
        /// Its format.
        format: &'static str,
        /// The line.
        line: usize,
        /// What stands there, at most 80 characters of it.
        text: String,
        /// What must stand there.
        wanted: Both,
    },
    /// A text file ends too early.
    EndsBefore {
        /// Its format.
        format: &'static str,
        /// The line that is missing.
        line: usize,
        /// What it must be.
        wanted: Both,
    },
    /// A header lacks something.
    HeaderLacks {
        /// Its format.
        format: &'static str,
        /// What is missing.
        what: Both,
    },
    /// Not as many samples as the header says.
    SampleCount {
        /// Its format.
        format: &'static str,
        /// As the header says.
        stated: u64,
        /// As there are.
        found: usize,
    },
    /// Blocks of a channel do not follow one another.
    Gap {
        /// The channel.
        channel: String,
        /// Where it should begin, s.
        expected_s: f64,
        /// Where it begins, s.
        found_s: f64,
    },
    /// A variable of a MAT file contradicts the others.
    Variable {
        /// The variable.
        name: String,
        /// What it does.
        what: Both,
    },
    /// A WAV file without a scale.
    NoFullScale,
    /// The given unit contradicts that of the numbers.
    NoScale {
        /// Format of the file.
        format: &'static str,
        /// The channel.
        channel: String,
        /// What the file says.
        found: String,
        /// The unit given.
        given: &'static str,
    },
    /// The given unit contradicts that of the file.
    UnitDisagrees {
        /// The channel.
        channel: String,
        /// The unit given.
        given: &'static str,
        /// The unit of the file.
        found: &'static str,
    },
    /// The given rate contradicts that of the file.
    FileRateDisagrees {
        /// The rate given, Hz.
        given: f64,
        /// That of the file, Hz.
        found: f64,
    },
    /// A file that does not tell its rate.
    NoRateHere {
        /// Its format.
        format: &'static str,
    },
    /// A start is given for a file with its own.
    TwoStarts {
        /// The file.
        file: String,
    },
    /// The file exceeds a limit of the reader.
    Limit(LimitError),
    /// A file of a seismic station is refused.
    Seismic(Box<SeismicError>),
    /// The samples make no record.
    Signal(SignalError),
}
