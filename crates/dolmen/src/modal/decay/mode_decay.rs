//! Results of a free decay besides its modes.

use crate::modal::AtAmplitude;

/// Results of a free decay besides its modes.
#[derive(Clone, Debug, PartialEq)]
pub struct Decay {
    /// Channels of the record.
    pub channels: usize,
    /// Share of the motion that the poles explain.
    pub explained: f64,
    /// Peaks of the residual, Hz, if it is not white, including peaks at the listed modes.
    pub left_peaks_hz: Vec<f64>,
    /// Each mode, by frequency.
    pub modes: Vec<ModeDecay>,
    /// Frequencies at which the motion does not decay over the record, Hz: hum or machines. They are not among the modes.
    pub machines_hz: Vec<f64>,
}

/// A multiple of the frequency of a mode that is not linear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overtone {
    /// Frequency of that mode, Hz.
    pub of_hz: f64,
    /// The multiple: 3 or 5.
    pub times: usize,
}

/// The decay of one mode.
#[derive(Clone, Debug, PartialEq)]
pub struct ModeDecay {
    /// Frequency of the mode, Hz.
    pub frequency_hz: f64,
    /// Frequencies of the poles that represent the mode, Hz. Several poles with the same shape and overlapping bands mean that the decay is not
    /// exponential: frequency and damping depend on the amplitude. The mode then has the frequency of the strongest pole and the median damping of
    /// its cycles, if there are any, without a standard deviation. With one channel all shapes are equal, so the poles may be several modes.
    pub poles_hz: Vec<f64>,
    /// Standard deviations over those for white noise of the same power: far above 1 if forces still act on the structure.
    pub over_white: f64,
    /// Whether damping depends on the amplitude, significantly and by more than a fifth: friction, or a joint that slips. The single damping ratio
    /// is then a mean without a standard deviation.
    pub damping_follows: bool,
    /// Frequency and damping at each amplitude, largest first, at the channel with the largest motion of the mode. Empty if another mode is too
    /// near, if there are too few cycles, or if the cycles of several poles grow with time (beats).
    pub swings: Vec<AtAmplitude>,
    /// The stronger mode whose overtone this may be: its frequency depends on the amplitude, and the shapes are alike.
    pub overtone: Option<Overtone>,
}
