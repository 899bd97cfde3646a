//! Options of the reader of a record.

use super::{Decimal, Delimiter, RecordFormat};
use crate::unit::Unit;
use dolmen::signal::Channel;

/// Properties of the file. Defaults are detected from the file, or the file is refused.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RecordOptions {
    /// Format of the file. `None`: detected from its content; GCF files and short texts are hard to identify.
    pub format: Option<RecordFormat>,
    /// Samples a second, Hz. `None`: from the time column. If both are there, they must agree to 1e-4.
    pub sampling_rate_hz: Option<f64>,
    /// Unit of the samples. Default: unknown; numbers stay as they are.
    pub unit: Unit,
    /// Factor from the numbers to the unit: the value of a count of the recorder, or of full scale in a WAV file. `None`: 1, if the file shows
    /// that its numbers are in the unit.
    pub scale: Option<f64>,
    /// Columns to read, in this order, each with its sensor. Empty: every column but the time column, named as in the
    /// header, or ch1, ch2, … where there is none.
    pub picks: Vec<Pick>,
    /// Delimiter of a CSV file. `None`: detected.
    pub delimiter: Option<Delimiter>,
    /// Decimal sign of a CSV file. `None`: detected; a comma only where it is not the delimiter.
    pub decimal: Option<Decimal>,
    /// Whether a CSV file begins with names.
    pub header: Header,
    /// Number of lines to skip before the header of a CSV file; 0. Empty lines and lines that begin with `#` are always skipped, and are counted
    /// here.
    pub skip_lines: usize,
    /// The column of a CSV file that holds time stamps, s.
    pub time: TimeColumn,
    /// Treatment of gaps between time stamps or blocks. Default: the longest whole span is used.
    pub lost_samples: LostSamples,
}

/// Whether the first line of a CSV file names its columns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Header {
    /// It does if any of its cells is not a number.
    #[default]
    Detect,
    /// It does.
    Present,
    /// It holds samples.
    Absent,
}

/// The time column of a CSV file, in seconds.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum TimeColumn {
    /// In the column named t, time, zeit, sec or seconds, whatever its case and whether "s" or "sec" follows as in
    /// "Time (s)" or "time_s"; nowhere if there is none.
    #[default]
    Detect,
    /// None: all columns are channels.
    Absent,
    /// This one.
    At(Column),
}

/// A column of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Column {
    /// By its name in the header.
    Named(String),
    /// By its place, counted from 1.
    Number(usize),
}

/// One column to read, and its sensor.
#[derive(Clone, Debug, PartialEq)]
pub struct Pick {
    /// The column.
    pub column: Column,
    /// Its sensor. The quantity is set by [`RecordOptions::unit`].
    pub channel: Channel,
    /// As [`RecordOptions::scale`], for this channel.
    pub scale: Option<f64>,
}

/// Treatment of a record with lost samples.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum LostSamples {
    /// Fills runs of at most eight samples, if they are at most one in a hundred, by linear prediction; then as `longest`.
    #[default]
    Fill,
    /// Uses the longest span that is whole in all channels, and reports the parts cut off.
    Longest,
    /// Refuses it.
    Refuse,
    /// Uses all of it: runs of at most eight samples are filled, and longer ones hold the mean of their channel, for callers that know where
    /// they are.
    #[serde(skip)]
    Bridged,
}
