//! The channels of a motion file, with the numbers as printed in the file.

use super::Orientation;
use crate::breaks::Break;
use crate::unit::Unit;
use dolmen::signal::Quantity;

/// File format of a ground motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionFormat {
    /// AT2 of the PEER databases.
    At2,
    /// COSMOS V1 or V2, format 1.20.
    Cosmos,
    /// V1 or V2 of the Californian program (CSMIP), the predecessor of COSMOS.
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

/// The content of one channel of any format, with the numbers as printed.
pub(crate) struct Raw {
    pub(crate) format: MotionFormat,
    pub(crate) name: String,
    pub(crate) title: String,
    pub(crate) samples: Vec<f64>,
    pub(crate) time_step_s: f64,
    /// Unit stated by the file.
    pub(crate) unit: Option<Unit>,
    pub(crate) orientation: Option<Orientation>,
    pub(crate) begins_s: Option<f64>,
    /// Gaps: where the samples continue after missing time.
    pub(crate) breaks: Vec<Break>,
    /// Whether the format defines the numbers with an arbitrary offset.
    pub(crate) subtract_mean: bool,
    /// Measured quantity, if the file states the quantity but no unit.
    pub(crate) quantity: Option<Quantity>,
    /// Largest absolute value stated by the header, in the unit of the file.
    pub(crate) stated_peak: Option<f64>,
    /// Whether the file states that the sensor is in a borehole.
    pub(crate) is_borehole: bool,
}

impl Raw {
    /// A channel of which only the format and the time step are known.
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
            is_borehole: false,
        }
    }
}
