//! Formats of record files.

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
    /// Sound file; the scale is the value of full scale.
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
    /// Workbook of one sheet with columns as those of text.
    Xlsx,
}

impl RecordFormat {
    /// All formats.
    pub const ALL: [RecordFormat; 14] = [
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
        RecordFormat::Xlsx,
    ];

    /// "csv", "npy", "uff", "wav", "mat", "saf", "gcf", "tdms", "miniseed", "sac", "k-net", "esm", "cosmos", "xlsx".
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
            RecordFormat::Xlsx => "xlsx",
        }
    }

    /// Whether its times are UTC by the definition of the format; those of K-NET are converted.
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

    /// The format for the ending of a file name, if any.
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
            "xlsx" | "xlsm" => RecordFormat::Xlsx,
            "knet" | "kik" | "ns" | "ew" | "ud" => RecordFormat::KNet,
            _ => return None,
        })
    }
}
