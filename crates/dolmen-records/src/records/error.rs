//! Why a record cannot be read.

use super::not_a_table::NotATable;
use crate::limits::LimitError;
use crate::quoted::{listed, shown};
use crate::seismic::SeismicError;
use dolmen::signal::SignalError;

/// Why the bytes of a file are no record. Each variant says where in the file and what to do. Lines and columns are counted from 1.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RecordError {
    /// No bytes, or nothing but empty lines and comments.
    #[error("the file is empty: it holds no line but blank ones and comments; is it the right file?")]
    Empty,
    /// Names but no samples.
    #[error("the file holds a header (line {line}) but no samples: is it the right file?")]
    OnlyHeader {
        /// Line of the header.
        line: usize,
    },
    /// The first line holds names and numbers.
    #[error(
        "line {line} holds both names and numbers: if it names the columns, say that the header is present; if it holds \
         samples, correct it"
    )]
    UnclearHeader {
        /// The line.
        line: usize,
    },
    /// No table of numbers: nothing of it is quoted.
    #[error(transparent)]
    NotATable(#[from] NotATable),
    /// Text of two bytes a letter.
    #[error("the file is UTF-16 text: save it as UTF-8 (\"CSV UTF-8\" in spreadsheets)")]
    Utf16,
    /// The unit is not one of [`Unit`](super::Unit).
    #[error(
        "the unit \"{given}\" is not known: write m/s2, cm/s2 (gal), mm/s2, g, mg, m/s, cm/s, mm/s, um/s, m, cm, mm, or \
         \"unknown\" to keep the numbers as they are",
        given = shown(given)
    )]
    UnknownUnit {
        /// The text given.
        given: String,
    },
    /// A cell is no number.
    #[error(
        "line {line}, column \"{column}\": \"{text}\" is not a number; correct it, leave the column out, or cut the file",
        column = shown(column), text = shown(text)
    )]
    NotANumber {
        /// Line of the file.
        line: usize,
        /// Name of the column.
        column: String,
        /// What stands there.
        text: String,
    },
    /// A time stamp is a date or other text.
    #[error(
        "line {line}, column \"{column}\": the time stamp \"{text}\" is not a number of seconds: give sampling_rate and name \
         the columns to read, then the first and the last date are held against that rate",
        column = shown(column), text = shown(text)
    )]
    TimeText {
        /// Line of the file.
        line: usize,
        /// Name of the time column.
        column: String,
        /// What stands there.
        text: String,
    },
    /// A cell holds nothing.
    #[error(
        "line {line}, column \"{column}\" is empty: a sample is missing; cut the file before or after it, or leave the \
         column out",
        column = shown(column)
    )]
    EmptyCell {
        /// Line of the file.
        line: usize,
        /// Name of the column.
        column: String,
    },
    /// A cell holds NaN or infinity.
    #[error(
        "line {line}, column \"{column}\" holds {text}: a sample is missing; cut the file before or after it, or leave \
         the column out",
        column = shown(column), text = shown(text)
    )]
    NotFinite {
        /// Line of the file.
        line: usize,
        /// Name of the column.
        column: String,
        /// What stands there.
        text: String,
    },
    /// A column is named that is not there.
    #[error(
        "there is no column \"{given}\"{}; the file has {names}",
        nearest.as_ref().map_or(String::new(), |n| format!(" (did you mean \"{}\"?)", shown(n))),
        given = shown(given), names = listed(names)
    )]
    UnknownColumn {
        /// The name asked for.
        given: String,
        /// The most similar name, if any is similar.
        nearest: Option<String>,
        /// The names there are.
        names: Vec<String>,
    },
    /// A column is asked for by a number that is not there.
    #[error("there is no column {given}: the file has columns 1 to {columns}")]
    ColumnNumber {
        /// The number asked for.
        given: usize,
        /// Columns of the file.
        columns: usize,
    },
    /// A column is asked for twice.
    #[error(
        "column \"{column}\" is read twice, as \"{first}\" and as \"{second}\": give each channel its own column",
        column = shown(column), first = shown(first), second = shown(second)
    )]
    PickedTwice {
        /// The column.
        column: String,
        /// What it is read as first.
        first: String,
        /// What it is read as then.
        second: String,
    },
    /// Two columns have one name, and one of them is asked for by it.
    #[error(
        "{count} columns are named \"{given}\": ask for the one you mean by its number",
        given = shown(given)
    )]
    AmbiguousColumn {
        /// The name asked for.
        given: String,
        /// Columns of that name.
        count: usize,
    },
    /// A line holds more or fewer cells than the first.
    #[error(
        "line {line} holds {found} cells, but the lines before it {expected}: correct it, or cut the file there{}",
        if *last { "; it is the last line: the file was cut short" } else { "" }
    )]
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
    /// Only a time column.
    #[error(
        "the file holds only the time column \"{column}\": there is nothing to read",
        column = shown(column)
    )]
    OnlyTime {
        /// Name of the time column.
        column: String,
    },
    /// Neither a rate nor a time column.
    #[error(
        "the sampling rate is not known: no column is named time or t (the columns are {names}); give sampling_rate, or name \
         the time column",
        names = listed(names)
    )]
    NoRate {
        /// The names of the columns.
        names: Vec<String>,
    },
    /// An NPY file has no place for a rate.
    #[error("the sampling rate is not known: an NPY file cannot hold it; give sampling_rate")]
    NoRateNpy,
    /// A channel that looks like time stamps.
    #[error(
        "column \"{column}\" rises by {step} from each line to the next, as time stamps or a line count do, not as a \
         sensor: name it as the time column, or name the columns to read",
        column = shown(column)
    )]
    LooksLikeTime {
        /// The column.
        column: String,
        /// Its constant step.
        step: f64,
    },
    /// Dates contradict the rate given.
    #[error(
        "sampling_rate is {given}, but column \"{column}\" goes from {first} to {last} in {samples} samples, which is {dates_hz:.3} Hz: correct \
         the rate, or cut the file where samples are missing",
        column = shown(column), first = shown(first), last = shown(last)
    )]
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
    /// The name of the time column holds a unit that is not known.
    #[error(
        "column \"{column}\" looks like time stamps in a unit that is not s, ms or us: name it as the time column if it \
         is in seconds, or say that there is none and give sampling_rate",
        column = shown(column)
    )]
    TimeUnit {
        /// Name of the column.
        column: String,
    },
    /// Time stamps too far apart for seconds.
    #[error(
        "the time stamps of column \"{column}\" lie {step} apart: as seconds that is no rate of a vibration; if they are milliseconds, give \
         sampling_rate = \"{milliseconds_hz:.4} Hz\" or name the column \"time [ms]\"; if they are seconds, \"time [s]\"",
        column = shown(column)
    )]
    SlowStamps {
        /// Name of the column.
        column: String,
        /// Their first steps, in the unit of the column.
        step: f64,
        /// The rate if they are milliseconds, Hz.
        milliseconds_hz: f64,
    },
    /// Time stamps that are not evenly spaced.
    #[error(
        "line {line}: the time stamp {stamp_s} s is {step_s:.6} s after the one before, but even steps of \
         {expected_step_s:.6} s would put it at {expected_s:.6} s: samples are missing or the clock jumped; cut the file \
         there, or resample it before"
    )]
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
    #[error(
        "line {line}: the time stamp {stamp} is not after the one before, {before}: print more digits, or give sampling_rate and say which columns \
         to read"
    )]
    StampsStand {
        /// Line of the file.
        line: usize,
        /// The stamp, s.
        stamp: f64,
        /// The one before, s.
        before: f64,
    },
    /// Steps that differ, between time stamps so coarse that this may be rounding or a missing sample.
    #[error(
        "line {line}: the time stamp is {step_s:.6} s after the one before, that one {step_before_s:.6} s after its own; \
         printed to {resolution_s} s, this may be rounding or a missing sample: give sampling_rate if none is missing, \
         or print more digits"
    )]
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
    /// The rate given is not that of the time stamps.
    #[error(
        "sampling_rate is {given}, but the time stamps say {stamps_hz:.6}: correct it, or leave it out to take that of \
         the stamps"
    )]
    RateDisagrees {
        /// The rate given, Hz.
        given: f64,
        /// That of the time stamps, Hz.
        stamps_hz: f64,
    },
    /// No NPY file.
    #[error("this is no NPY file: it does not begin with \\x93NUMPY")]
    NotNpy,
    /// A later version of NPY.
    #[error(
        "the NPY file is of version {major}, but versions 1 to 3 can be read: save it again with numpy.save"
    )]
    NpyVersion {
        /// Its version.
        major: u8,
    },
    /// The NPY file ends within its header.
    #[error("the NPY file ends within its header, after {bytes} bytes: copy it again")]
    NpyHeaderTruncated {
        /// Bytes of the file.
        bytes: usize,
    },
    /// The header of the NPY file cannot be understood.
    #[error(
        "the header of the NPY file cannot be understood: \"{text}\"; save it again with numpy.save",
        text = shown(text)
    )]
    NpyHeader {
        /// The header, at most 200 characters of it.
        text: String,
    },
    /// Values of another type.
    #[error(
        "the NPY file holds values of type \"{given}\", but f4, f8, i2, i4 and i8 can be read: save array.astype(\"f8\")",
        given = shown(given)
    )]
    NpyType {
        /// The type, as NumPy writes it.
        given: String,
    },
    /// An array of no or more than two axes.
    #[error(
        "the array of the NPY file has shape [{shape}], but must have 1 axis (samples) or 2 (samples and channels): save \
         one setup a file",
        shape = listed(&shape.iter().map(usize::to_string).collect::<Vec<_>>())
    )]
    NpyShape {
        /// The shape.
        shape: Vec<usize>,
    },
    /// The NPY file ends before its last value.
    #[error("the NPY file ends too early: its shape is {shape:?}, but it holds {held} values; copy it again")]
    NpyTruncated {
        /// The shape.
        shape: Vec<usize>,
        /// Whole values held.
        held: usize,
    },
    /// The NPY file goes on after its last value.
    #[error(
        "the NPY file goes on for {extra} bytes after the last value of its shape {shape:?}: it is damaged or holds \
         several arrays; save one array a file"
    )]
    NpyTrailing {
        /// The shape.
        shape: Vec<usize>,
        /// Bytes too many.
        extra: usize,
    },
    /// A column of an NPY file is asked for by name.
    #[error(
        "column \"{given}\" is asked for by name, but an NPY file has no names: ask for it by its number, 1 to {columns}",
        given = shown(given)
    )]
    NpyNamed {
        /// The name asked for.
        given: String,
        /// Channels of the file.
        columns: usize,
    },
    /// A binary file ends before its header says.
    #[error("the {format} file has {bytes} bytes, but {wanted} are needed: it was cut short; copy it again")]
    CutShort {
        /// Its format.
        format: &'static str,
        /// Bytes it has.
        bytes: usize,
        /// Bytes that its header asks for.
        wanted: u64,
    },
    /// A binary file holds something that cannot be.
    #[error("the {format} file is damaged at byte {at}: {what}; copy it again")]
    Damaged {
        /// Its format.
        format: &'static str,
        /// Where, bytes from 0.
        at: u64,
        /// What is wrong.
        what: String,
    },
    /// A variant of a format that is not read.
    #[error("the {format} file holds {what}, which is not read: {instead}")]
    NotReadHere {
        /// Its format.
        format: &'static str,
        /// What it holds.
        what: String,
        /// What to do.
        instead: &'static str,
    },
    /// The file is not of the format that the project names.
    #[error(
        "the file is not of the format {format}: it begins like {begins}; correct format, or leave it out"
    )]
    NotOfFormat {
        /// The format named.
        format: &'static str,
        /// What it begins like: "a miniseed file", "text", "no text". Its text is not quoted, since it may be any file.
        begins: String,
    },
    /// A line of a text file is not what the format has there.
    #[error(
        "line {line}: \"{text}\" is not {wanted}: the {format} file was cut or edited; copy it again",
        text = shown(text)
    )]
    LineIsNot {
        /// Its format.
        format: &'static str,
        /// The line.
        line: usize,
        /// What stands there, at most 80 characters of it.
        text: String,
        /// What must stand there.
        wanted: &'static str,
    },
    /// A text file ends too early.
    #[error(
        "the {format} file ends before line {line}, which must be {wanted}: it was cut short; copy it again"
    )]
    EndsBefore {
        /// Its format.
        format: &'static str,
        /// The line that is missing.
        line: usize,
        /// What it must be.
        wanted: &'static str,
    },
    /// A header does not say something.
    #[error("the header of the {format} file does not give {what}: it was cut or edited; copy it again")]
    HeaderLacks {
        /// Its format.
        format: &'static str,
        /// What is missing.
        what: &'static str,
    },
    /// Not as many samples as the header says.
    #[error(
        "the header of the {format} file says {stated} samples, but {found} follow: it was cut or edited; copy it again"
    )]
    SampleCount {
        /// Its format.
        format: &'static str,
        /// As the header says.
        stated: u64,
        /// As there are.
        found: usize,
    },
    /// Blocks of a channel do not follow one another.
    #[error(
        "channel {channel}: a block begins {found_s} s after the first, but the samples before it end at {expected_s} s: there is \
         a gap or an overlap; cut the file there",
        channel = shown(channel)
    )]
    Gap {
        /// The channel.
        channel: String,
        /// Where it should begin, s.
        expected_s: f64,
        /// Where it begins, s.
        found_s: f64,
    },
    /// A variable of a MAT file contradicts the others.
    #[error(
        "the variable {name} of the MAT file {what}: correct it, or leave it out",
        name = shown(name)
    )]
    Variable {
        /// The variable.
        name: String,
        /// What it does.
        what: String,
    },
    /// A WAV file without a scale.
    #[error(
        "the numbers of a WAV file are parts of full scale: give scale = what full scale is in the unit (scale = 1 without a unit \
         keeps them as parts)"
    )]
    NoFullScale,
    /// A unit is given for numbers that are in another.
    #[error(
        "channel \"{channel}\": unit is \"{given}\", but the {format} file says that its numbers are in \"{found}\": give scale = \
         what one of them is worth in {given} (1 if they are in {given} already), or leave unit out",
        channel = shown(channel), found = shown(found)
    )]
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
    /// The unit given is not that of the file.
    #[error(
        "channel \"{channel}\": unit is \"{given}\", but the file says \"{found}\": correct it, or leave it out",
        channel = shown(channel)
    )]
    UnitDisagrees {
        /// The channel.
        channel: String,
        /// The unit given.
        given: &'static str,
        /// The unit of the file.
        found: &'static str,
    },
    /// The rate given is not that of the file.
    #[error("sampling_rate is {given}, but the file says {found}: correct it, or leave it out")]
    FileRateDisagrees {
        /// The rate given, Hz.
        given: f64,
        /// That of the file, Hz.
        found: f64,
    },
    /// A file that does not tell its rate.
    #[error("the sampling rate is not known: the {format} file does not say it; give sampling_rate")]
    NoRateHere {
        /// Its format.
        format: &'static str,
    },
    /// A start is given for a file that says its own.
    #[error(
        "begins is given for {file}, but the file says itself when it begins: leave begins out, or correct the clock in the file",
        file = shown(file)
    )]
    TwoStarts {
        /// The file.
        file: String,
    },
    /// The file asks too much of the reader.
    #[error(transparent)]
    Limit(#[from] LimitError),
    /// A file of a seismic station is refused.
    #[error(transparent)]
    Seismic(Box<SeismicError>),
    /// The samples make no record.
    #[error(transparent)]
    Signal(#[from] SignalError),
}
