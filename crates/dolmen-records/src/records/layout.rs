//! How the files of records were laid out.

use super::{Decimal, Delimiter, FileUnit, RateSource, RecordFormat};

/// How a file was laid out.
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

/// How a CSV file was laid out.
#[derive(Clone, Debug, PartialEq)]
pub struct CsvLayout {
    /// Between cells.
    pub delimiter: Delimiter,
    /// Before decimals.
    pub decimal: Decimal,
    /// Line of the header, counted from 1, if there is one.
    pub header_line: Option<usize>,
    /// All columns of the file, in order: as named by the header, or ch1, ch2, …
    pub columns: Vec<String>,
    /// The column of time stamps, if there is one.
    pub time_column: Option<String>,
    /// Where the sampling rate comes from.
    pub rate_source: RateSource,
    /// A column that looks like stamps or dates and cannot be read, so that nothing confirms the rate given.
    pub unread_stamps: Option<String>,
    /// First and last line of text above the names of the columns that was passed over.
    pub passed_over: Option<[usize; 2]>,
    /// Whether the text is in CP949 (EUC-KR), as Korean programs save it, and was read as that.
    pub is_cp949: bool,
    /// Whether the names of some columns are neither UTF-8 nor CP949, so that they are called by their number.
    pub names_unread: bool,
    /// Seconds in one unit of the stamps, where the column does not say it and it was found out from their steps.
    pub time_unit_s: Option<f64>,
    /// Whether the last line ends with a line end. If not, the file may have been cut short, and its last number with it.
    pub last_line_ended: bool,
}

/// Which axis of the array is time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Samples × channels (also taken if both axes are equally long, and for one axis).
    First,
    /// Channels × samples.
    Second,
}

/// How an NPY file was laid out.
#[derive(Clone, Debug, PartialEq)]
pub struct NpyLayout {
    /// Type of the values, as NumPy writes it: "<f8".
    pub value_type: String,
    /// Shape of the array.
    pub shape: Vec<usize>,
    /// The axis taken as time: the longer one.
    pub time_axis: Axis,
}

/// How a file of channels was laid out.
#[derive(Clone, Debug, PartialEq)]
pub struct ChannelsLayout {
    /// Its format.
    pub format: RecordFormat,
    /// All its channels, in order.
    pub channels: Vec<FoundChannel>,
    /// What else the file says or holds, sentences.
    pub notes: Vec<String>,
}

/// One channel of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundChannel {
    /// As the file names it.
    pub name: String,
    /// Its samples.
    pub samples: usize,
    /// Samples a second, Hz; `None` if the file does not say it.
    pub sampling_rate_hz: Option<f64>,
    /// What the file says of the unit.
    pub unit: FileUnit,
    /// The first sample, s from 1 January 1970 in the clock of the file, if it says it.
    pub begins_s: Option<f64>,
}
