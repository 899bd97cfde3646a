//! Options for reading a record.

use super::{Decimal, Delimiter, RecordFormat};
use crate::unit::Unit;
use dolmen::signal::Channel;

/// What the user states about a file. Everything else is detected from the file, or the file is refused.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RecordOptions {
    /// Format of the file. `None`: detected from its content; GCF files and short texts are hard to identify.
    pub format: Option<RecordFormat>,
    /// Sampling rate, Hz. `None`: from the time column. If both are given, they must agree to 1e-4.
    pub sampling_rate_hz: Option<f64>,
    /// Unit of the samples. Default: unknown; the numbers are not converted.
    pub unit: Unit,
    /// Factor from the numbers to the unit: the value of one count of the recorder, or of full scale in a WAV file. `None`: 1, if the file shows
    /// that its numbers are in the unit.
    pub scale: Option<f64>,
    /// Columns to read, in this order, each with its sensor. Empty: all columns except the time column, named as in the header, or ch1, ch2, …
    /// if there is no header.
    pub picks: Vec<Pick>,
    /// Delimiter of a CSV file. `None`: detected.
    pub delimiter: Option<Delimiter>,
    /// Decimal sign of a CSV file. `None`: detected; a comma only if it is not the delimiter.
    pub decimal: Option<Decimal>,
    /// Whether a CSV file begins with a line of column names.
    pub header: Header,
    /// Number of lines to skip before the header of a CSV file; default 0. Empty lines and lines that begin with `#` are always skipped, but
    /// count here.
    pub skip_lines: usize,
    /// The column of a CSV file with time stamps, s.
    pub time: TimeColumn,
    /// Treatment of gaps between time stamps or blocks. Default: the longest span without a gap is used.
    pub lost_samples: LostSamples,
}

/// Whether the first line of a CSV file contains column names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Header {
    /// Detected: column names, if any cell is not a number.
    #[default]
    Detect,
    /// The first line contains column names.
    Present,
    /// The first line contains samples.
    Absent,
}

/// The time column of a CSV file, in seconds.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum TimeColumn {
    /// Detected by its name: t, time, zeit, sec or seconds, in any case, with or without a following "s" or "sec", as in "Time (s)" or "time_s".
    /// Without such a name there is no time column.
    #[default]
    Detect,
    /// There is no time column: all columns are channels.
    Absent,
    /// The given column.
    At(Column),
}

/// A column of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Column {
    /// The name in the header.
    Named(String),
    /// The number of the column, from 1.
    Number(usize),
}

/// One column to read, and its sensor.
#[derive(Clone, Debug, PartialEq)]
pub struct Pick {
    /// The column.
    pub column: Column,
    /// The sensor. [`RecordOptions::unit`] sets its quantity.
    pub channel: Channel,
    /// As [`RecordOptions::scale`], for this channel.
    pub scale: Option<f64>,
}

/// Treatment of a record with lost samples.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum LostSamples {
    /// Fills runs of at most eight samples, if at most one in a hundred is lost, by linear prediction; then as `longest`.
    #[default]
    Fill,
    /// Uses the longest span that is whole in all channels, and reports the parts cut off.
    Longest,
    /// Refuses it.
    Refuse,
    /// Uses all of it: runs of at most eight samples are filled, and longer ones are set to the mean of their channel, for callers that
    /// know where they are.
    #[serde(skip)]
    Bridged,
    /// None is lost, as the user says: the given sampling rate counts, and time stamps are compared with it in the mean alone.
    #[serde(skip)]
    NoneLost,
}
