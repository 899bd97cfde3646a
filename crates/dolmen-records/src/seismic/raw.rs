//! The channels of a file as it prints them.

use super::Orientation;
use crate::breaks::Break;
use crate::unit::Unit;
use dolmen::signal::Quantity;

/// Format of a motion file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionFormat {
    /// Of the PEER databases.
    At2,
    /// COSMOS V1 or V2, format 1.20.
    Cosmos,
    /// V1 or V2 of the Californian program before it.
    Csmip,
    /// K-NET or KiK-net ASCII.
    KNet,
    /// ESM ASCII.
    Esm,
    /// SAC, binary.
    Sac,
    /// SAC, alphanumeric.
    SacText,
    /// miniSEED 2.
    MiniSeed,
    /// Text in columns.
    Text,
}

impl MotionFormat {
    /// "at2", "cosmos", "csmip", "k-net", "esm", "sac", "sac (text)", "miniseed", "csv".
    pub fn name(self) -> &'static str {
        match self {
            MotionFormat::At2 => "at2",
            MotionFormat::Cosmos => "cosmos",
            MotionFormat::Csmip => "csmip",
            MotionFormat::KNet => "k-net",
            MotionFormat::Esm => "esm",
            MotionFormat::Sac => "sac",
            MotionFormat::SacText => "sac (text)",
            MotionFormat::MiniSeed => "miniseed",
            MotionFormat::Text => "csv",
        }
    }
}

/// What each format yields: numbers as printed.
pub(crate) struct Raw {
    pub(crate) format: MotionFormat,
    pub(crate) name: String,
    pub(crate) title: String,
    pub(crate) samples: Vec<f64>,
    pub(crate) time_step_s: f64,
    /// As the file says.
    pub(crate) unit: Option<Unit>,
    pub(crate) orientation: Option<Orientation>,
    pub(crate) begins_s: Option<f64>,
    /// Where the samples go on after a gap.
    pub(crate) breaks: Vec<Break>,
    /// Whether the numbers have an offset by the definition of the format.
    pub(crate) subtract_mean: bool,
    /// What is measured, if the file says it without a unit.
    pub(crate) quantity: Option<Quantity>,
    /// Largest absolute value by the header, in the unit of the file.
    pub(crate) stated_peak: Option<f64>,
}

impl Raw {
    /// Nothing known but this.
    pub(crate) fn new(format: MotionFormat, time_step_s: f64) -> Self {
        Raw {
            format,
            name: String::new(),
            title: String::new(),
            samples: Vec::new(),
            time_step_s,
            unit: None,
            orientation: None,
            begins_s: None,
            breaks: Vec::new(),
            subtract_mean: false,
            quantity: None,
            stated_peak: None,
        }
    }
}
