//! What the caller tells the reader of a record about its file.

use super::{Decimal, Delimiter, RecordFormat};
use crate::unit::Unit;
use dolmen::signal::Channel;

/// What is known of the file. Everything left at its default is found out from the file, or refused.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RecordOptions {
    /// Format of the file. `None`: found out from its content; GCF files and short texts have little to tell them by.
    pub format: Option<RecordFormat>,
    /// Samples a second, Hz. `None`: from the time column. If both are there, they must agree to 1e-4.
    pub sampling_rate_hz: Option<f64>,
    /// Unit of the samples. Default: unknown, numbers kept as they are.
    pub unit: Unit,
    /// What the numbers are multiplied by to be in the unit: what a count of the recorder is worth, or full scale of a WAV file.
    /// `None`: 1, where the file tells that its numbers are in the unit.
    pub scale: Option<f64>,
    /// Columns to read, in this order, each with its sensor. Empty: every column but the time column, named as in the
    /// header, or ch1, ch2, … where there is none.
    pub picks: Vec<Pick>,
    /// Delimiter of a CSV file. `None`: found out.
    pub delimiter: Option<Delimiter>,
    /// Decimal sign of a CSV file. `None`: found out; a comma only where the delimiter is none.
    pub decimal: Option<Decimal>,
    /// Whether a CSV file begins with names.
    pub header: Header,
    /// Lines to pass over before the header of a CSV file; 0. Empty lines and lines that begin with `#` are passed over
    /// anyway, and are counted here.
    pub skip_lines: usize,
    /// The column of a CSV file that holds time stamps, s.
    pub time: TimeColumn,
    /// What becomes of a record whose time stamps or blocks leave a gap. Default: its longest whole span is used.
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

/// Where the time stamps of a CSV file stand. They are seconds.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum TimeColumn {
    /// In the column named t, time, zeit, sec or seconds, whatever its case and whether "s" or "sec" follows as in
    /// "Time (s)" or "time_s"; nowhere if there is none.
    #[default]
    Detect,
    /// Nowhere: all columns are channels.
    Absent,
    /// In this one.
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

/// One column to read, and the sensor that wrote it.
#[derive(Clone, Debug, PartialEq)]
pub struct Pick {
    /// The column.
    pub column: Column,
    /// Its sensor. The quantity is set by [`RecordOptions::unit`].
    pub channel: Channel,
    /// As [`RecordOptions::scale`], for this channel.
    pub scale: Option<f64>,
}

/// What becomes of a record that lost samples.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum LostSamples {
    /// Runs of eight samples at most, one in a hundred at most, are filled in by linear prediction; then as `longest`.
    #[default]
    Fill,
    /// Its longest span that is whole in all channels is used, and what was cut is said.
    Longest,
    /// It is refused.
    Refuse,
    /// All of it is used: runs of eight samples at most are filled in, and longer ones hold the mean of their channel, for who knows where they are.
    #[serde(skip)]
    Bridged,
}
