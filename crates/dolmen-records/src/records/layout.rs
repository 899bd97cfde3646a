//! Layouts of record files.

use super::date_text::At;
use super::{Decimal, Delimiter, FileUnit, RateSource, RecordFormat};
use dolmen_words::message::Both;

/// Layout of a file.
#[derive(Clone, Debug, PartialEq)]
pub enum Layout {
    /// Text in columns.
    Csv(CsvLayout),
    /// A NumPy array.
    Npy(NpyLayout),
    /// Channels, each with a header.
    Channels(ChannelsLayout),
    /// Several files.
    Stations(Vec<Layout>),
}

/// The date of the first sample of a file, by its column of dates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FirstDate {
    /// s from 1 January 1970, or from midnight for a time without a date.
    pub at_s: f64,
    /// Value of its last digit, s.
    pub resolution_s: f64,
}

impl FirstDate {
    pub(super) fn of(at: At) -> Self {
        FirstDate {
            at_s: at.seconds,
            resolution_s: at.resolution_s,
        }
    }
}

/// Layout of a CSV file.
#[derive(Clone, Debug, PartialEq)]
pub struct CsvLayout {
    /// Separator of cells.
    pub delimiter: Delimiter,
    /// Decimal sign.
    pub decimal: Decimal,
    /// Line of the header, counted from 1, if there is one.
    pub header_line: Option<usize>,
    /// All columns of the file, in order: as named by the header, or ch1, ch2, …
    pub columns: Vec<String>,
    /// The column of time stamps, if there is one.
    pub time_column: Option<String>,
    /// Source of the sampling rate.
    pub rate_source: RateSource,
    /// A column that looks like stamps or dates but cannot be read, so that nothing confirms the given rate.
    pub unread_stamps: Option<String>,
    /// The date of its first sample, if a column of dates confirmed the given rate.
    pub first_date: Option<FirstDate>,
    /// First and last line of text above the column names that was ignored.
    pub passed_over: Option<[usize; 2]>,
    /// Whether the text was in CP949 (EUC-KR), as Korean programs save it.
    pub is_cp949: bool,
    /// Whether some column names are neither UTF-8 nor CP949, so that numbers replace them.
    pub names_unread: bool,
    /// Seconds in one unit of the stamps, if it was found from their steps and not from the column name.
    pub time_unit_s: Option<f64>,
    /// Whether the last line ends with a line end. If not, the file may have been cut short, and its last number with it.
    pub last_line_ended: bool,
}

/// The time axis of the array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Samples × channels (also taken if both axes are equally long, and for one axis).
    First,
    /// Channels × samples.
    Second,
}

/// Layout of an NPY file.
#[derive(Clone, Debug, PartialEq)]
pub struct NpyLayout {
    /// Type of the values, as NumPy writes it: "<f8".
    pub value_type: String,
    /// Shape of the array.
    pub shape: Vec<usize>,
    /// The axis used as time: the longer one.
    pub time_axis: Axis,
}

/// Layout of a file of channels.
#[derive(Clone, Debug, PartialEq)]
pub struct ChannelsLayout {
    /// Its format.
    pub format: RecordFormat,
    /// All its channels, in order.
    pub channels: Vec<FoundChannel>,
    /// Further contents of the file, as sentences.
    pub notes: Vec<Both>,
}

/// One channel of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundChannel {
    /// Name in the file.
    pub name: String,
    /// Number of samples.
    pub samples: usize,
    /// Samples per second, Hz; `None` if the file does not state it.
    pub sampling_rate_hz: Option<f64>,
    /// The unit in the file.
    pub unit: FileUnit,
    /// Time of the first sample, s from 1 January 1970 in the clock of the file, if the file states it.
    pub begins_s: Option<f64>,
}
