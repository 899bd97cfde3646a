//! Results of a free decay besides its modes.

use crate::modal::AtAmplitude;

/// Results of a free decay besides its modes.
#[derive(Clone, Debug, PartialEq)]
pub struct Decay {
    /// Channels of the record.
    pub channels: usize,
    /// Share of the motion that the poles explain.
    pub explained: f64,
    /// Peaks of the residual, Hz, if it is not white; they include those of the listed modes.
    pub left_peaks_hz: Vec<f64>,
    /// Each mode, by frequency.
    pub modes: Vec<ModeDecay>,
}

/// The decay of one mode.
#[derive(Clone, Debug, PartialEq)]
pub struct ModeDecay {
    /// Its frequency, Hz.
    pub frequency_hz: f64,
    /// Frequencies of the poles that represent the mode, Hz. If there are several, with the same shape and overlapping bands, the decay is not an
    /// exponential: frequency and damping depend on the amplitude. The mode then has the frequency of the strongest pole and the median damping of
    /// its swings, if there are any, without a standard deviation. With one channel all shapes are equal, so there may be several modes.
    pub poles_hz: Vec<f64>,
    /// Its deviations over those for white noise of the same power: far above 1 if the structure is still shaken.
    pub over_white: f64,
    /// Whether its damping depends on the amplitude, beyond chance and by more than a fifth: friction, or a joint that slips. Its one
    /// damping ratio is then a mean without a deviation.
    pub damping_follows: bool,
    /// Frequency and damping at each amplitude, largest first, at the channel with most of the mode. Empty where another mode is too
    /// near, where there are too few swings, and where swings of several poles grow with time (beats).
    pub swings: Vec<AtAmplitude>,
}
