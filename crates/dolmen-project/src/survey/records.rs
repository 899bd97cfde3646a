//! Where the vibration records of a survey are, and how to read and use them.

use dolmen::modal::{Harmonics, Method};
use dolmen::signal::Starts;
use dolmen_records::records::LostSamples;
pub use dolmen_records::records::RecordFormat;

/// A column, by name or number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Column {
    /// Number, from 1.
    Number(usize),
    /// Name in the header.
    Name(String),
}

/// One channel of a record file.
#[derive(Clone, Debug, PartialEq)]
pub struct ChannelSource {
    /// Its column.
    pub column: Column,
    /// Its name; that of the column if not given.
    pub name: Option<String>,
    /// Place of the sensor, m: x right, y away, z up.
    pub position_m: Option<[f64; 3]>,
    /// Unit vector of the positive direction.
    pub direction: Option<[f64; 3]>,
    /// Factor from its numbers to the unit; `None`: that of the record.
    pub scale: Option<f64>,
    /// Read, but leave it out (a dead or loose sensor).
    pub leave_out: bool,
}

/// A stretch of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// From, s after the first sample.
    pub from_s: f64,
    /// To, s after the first sample.
    pub to_s: f64,
}

/// Zero-phase band-pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BandPass {
    /// Lower corner, Hz.
    pub low_hz: f64,
    /// Upper corner, Hz.
    pub high_hz: f64,
    /// Order of one pass.
    pub order: usize,
}

/// Zero-phase low-pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LowPass {
    /// Corner, Hz.
    pub corner_hz: f64,
    /// Order of one pass.
    pub order: usize,
}

/// Conditioning of a record before use, in this order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Conditioning {
    /// Keep only this time.
    pub cut: Option<Cut>,
    /// Remove a polynomial of this degree: 0 mean, 1 line.
    pub detrend_degree: Option<usize>,
    /// Band-pass.
    pub band_pass: Option<BandPass>,
    /// Low-pass.
    pub low_pass: Option<LowPass>,
    /// Keep each such sample after an anti-alias filter.
    pub decimate_factor: Option<usize>,
}

/// Settings of the file for the identification of modes; `None` leaves the choice to the method.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ModalChoice {
    /// Lowest frequency of interest, Hz.
    pub frequency_low_hz: Option<f64>,
    /// Highest frequency of interest, Hz.
    pub frequency_high_hz: Option<f64>,
    /// Least damping ratio of a mode.
    pub damping_least: Option<f64>,
    /// Largest damping ratio of a mode.
    pub damping_most: Option<f64>,
    /// Largest model order.
    pub order_most: Option<usize>,
    /// Block rows of the Hankel matrix.
    pub block_rows: Option<usize>,
    /// How many modes to report, lowest first.
    pub modes_wanted: Option<usize>,
    /// The method.
    pub method: Option<Method>,
    /// Reference channels, by name; empty: all.
    pub references: Vec<String>,
    /// Names of the channels that drive the others.
    pub inputs: Vec<String>,
    /// Frequencies at which modes are picked by hand, Hz; empty: all modes.
    pub pick_hz: Vec<f64>,
    /// Frequencies of modes that the user insists on, Hz.
    pub accept_hz: Vec<f64>,
    /// How to treat modes that look like machines.
    pub harmonics: Option<Harmonics>,
    /// Whether the record counts as ambient vibration without a search for an earthquake in it.
    pub without_earthquake: bool,
    /// The channel whose spectrogram is drawn, by name; `None`: the one that moves most in the range.
    pub spectrogram: Option<String>,
}

/// A record file of a survey.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordSource {
    /// Path relative to the project file.
    pub file: String,
    /// Files of a record that is stored in several files, instead of `file`, which then lists them; conditioning and modal are those of
    /// the whole record.
    pub stations: Vec<RecordSource>,
    /// What is known of the times at which stations begin.
    pub starts: Starts,
    /// First sample of a station whose file does not state it, s in a common clock.
    pub begins_s: Option<f64>,
    /// Format by the project file or the file's extension; `None`: detected from the content.
    pub format: Option<RecordFormat>,
    /// Samples a second, Hz; `None` if the time column gives it.
    pub sampling_rate_hz: Option<f64>,
    /// Unit of the samples as written: "m/s2", "g", "mm/s".
    pub unit: Option<String>,
    /// Factor from the numbers to the unit.
    pub scale: Option<f64>,
    /// Separator of columns.
    pub delimiter: Option<char>,
    /// The column of time stamps.
    pub time_column: Option<Column>,
    /// How to treat a record that lost samples.
    pub lost_samples: LostSamples,
    /// The channels; empty takes every column but the time.
    pub channels: Vec<ChannelSource>,
    /// Conditioning before use.
    pub conditioning: Conditioning,
    /// How modes are identified.
    pub modal: ModalChoice,
}
