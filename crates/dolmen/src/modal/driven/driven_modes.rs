//! Results of a record with measured inputs besides the modes.

use super::ground_ratios::OffGround;
use super::responses::FrequencyResponses;

/// Results of a record with measured inputs besides the modes.
#[derive(Clone, Debug, PartialEq)]
pub struct Driven {
    /// Names of the input channels.
    pub inputs: Vec<String>,
    /// Number of past samples in the observer, at the rate of the settings.
    pub lags: usize,
    /// Noise assumed in every channel, over its standard deviation.
    pub noise: f64,
    /// Response of each channel to the inputs, line by line; `None` if the record is too short.
    pub responses: Option<FrequencyResponses>,
    /// Channels that do not move as a measured ground far below the lowest mode: a reversed sensor or a wrong unit.
    pub off_ground: Vec<OffGround>,
    /// Each mode, by frequency.
    pub modes: Vec<DrivenMode>,
}

/// One mode of a structure on a measured base.
#[derive(Clone, Debug, PartialEq)]
pub struct DrivenMode {
    /// Frequency with a fixed base, Hz.
    pub frequency_hz: f64,
    /// Share of the motion at that frequency due to the inputs, 0 to 1: multiple coherence of the channel with the largest motion. `None` if
    /// the record has too few segments.
    pub explained: Option<f64>,
    /// Frequency, Hz, and standard deviation of the mode of structure and ground together (from the record without inputs) with a similar
    /// shape. `None` if there is none.
    pub with_base_hz: Option<(f64, Option<f64>)>,
}
