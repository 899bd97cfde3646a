//! Results of a record with measured inputs besides the modes.

use super::responses::FrequencyResponses;

/// Results of a record with measured inputs besides the modes.
#[derive(Clone, Debug, PartialEq)]
pub struct Driven {
    /// Names of the input channels.
    pub inputs: Vec<String>,
    /// Samples that the observer looks back, at the rate of the settings.
    pub lags: usize,
    /// Noise taken for granted in every channel, over its standard deviation.
    pub noise: f64,
    /// How each channel follows the inputs, line by line; `None` where the record is too short to tell.
    pub responses: Option<FrequencyResponses>,
    /// Each mode, by frequency.
    pub modes: Vec<DrivenMode>,
}

/// One mode of a structure on a base that is measured.
#[derive(Clone, Debug, PartialEq)]
pub struct DrivenMode {
    /// Its frequency with that base held, Hz.
    pub frequency_hz: f64,
    /// Share of the motion at that frequency that follows the inputs, 0 to 1: multiple coherence of the channel that moves most. `None` where the
    /// record has too few segments to tell.
    pub explained: Option<f64>,
    /// Frequency, Hz, and standard deviation of the mode with a similar shape from the record without inputs: structure and ground together.
    /// `None` if there is no similar mode.
    pub with_base_hz: Option<(f64, Option<f64>)>,
}
