//! What the reader of a record is told about its file.

use super::{Decimal, Delimiter, LostSamples, Unit};
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

/// Format of a record file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum RecordFormat {
    /// Text columns.
    Csv,
    /// NumPy array of two dimensions.
    Npy,
    /// Universal file, datasets 58 and 58b.
    Uff,
    /// Sound file; scale is what full scale is worth.
    Wav,
    /// MATLAB, version 5 ("-v7") or 7.3.
    Mat,
    /// Text of the SESAME project.
    Saf,
    /// Of Güralp recorders.
    Gcf,
    /// Of LabVIEW.
    Tdms,
    /// miniSEED 2.
    MiniSeed,
    /// SAC, binary.
    Sac,
    /// K-NET or KiK-net ASCII.
    #[serde(rename = "k-net")]
    KNet,
    /// ESM ASCII.
    Esm,
    /// COSMOS, or CSMIP before it.
    Cosmos,
}

impl RecordFormat {
    /// All of them, as [`name`](Self::name) has them.
    pub const ALL: [RecordFormat; 13] = [
        RecordFormat::Csv,
        RecordFormat::Npy,
        RecordFormat::Uff,
        RecordFormat::Wav,
        RecordFormat::Mat,
        RecordFormat::Saf,
        RecordFormat::Gcf,
        RecordFormat::Tdms,
        RecordFormat::MiniSeed,
        RecordFormat::Sac,
        RecordFormat::KNet,
        RecordFormat::Esm,
        RecordFormat::Cosmos,
    ];

    /// "csv", "npy", "uff", "wav", "mat", "saf", "gcf", "tdms", "miniseed", "sac", "k-net", "esm", "cosmos".
    pub fn name(self) -> &'static str {
        match self {
            RecordFormat::Csv => "csv",
            RecordFormat::Npy => "npy",
            RecordFormat::Uff => "uff",
            RecordFormat::Wav => "wav",
            RecordFormat::Mat => "mat",
            RecordFormat::Saf => "saf",
            RecordFormat::Gcf => "gcf",
            RecordFormat::Tdms => "tdms",
            RecordFormat::MiniSeed => "miniseed",
            RecordFormat::Sac => "sac",
            RecordFormat::KNet => "k-net",
            RecordFormat::Esm => "esm",
            RecordFormat::Cosmos => "cosmos",
        }
    }

    /// Whether its times are universal, by the definition of the format; K-NET's are turned into it.
    pub fn clock_is_utc(self) -> bool {
        matches!(
            self,
            RecordFormat::MiniSeed
                | RecordFormat::Sac
                | RecordFormat::KNet
                | RecordFormat::Esm
                | RecordFormat::Gcf
                | RecordFormat::Tdms
        )
    }

    /// The format that an ending of a file name means, if it means one.
    pub fn of_ending(ending: &str) -> Option<Self> {
        Some(match ending.to_ascii_lowercase().as_str() {
            "csv" | "txt" | "tsv" | "dat" | "asc" => RecordFormat::Csv,
            "npy" => RecordFormat::Npy,
            "uff" | "unv" | "uf" | "u58" => RecordFormat::Uff,
            "wav" => RecordFormat::Wav,
            "mat" => RecordFormat::Mat,
            "saf" => RecordFormat::Saf,
            "gcf" => RecordFormat::Gcf,
            "tdms" => RecordFormat::Tdms,
            "mseed" | "miniseed" | "msd" => RecordFormat::MiniSeed,
            "sac" => RecordFormat::Sac,
            "knet" | "kik" | "ns" | "ew" | "ud" => RecordFormat::KNet,
            _ => return None,
        })
    }
}
