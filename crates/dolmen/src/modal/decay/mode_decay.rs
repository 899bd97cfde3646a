//! What a free decay shows beside its modes.

use crate::modal::AtAmplitude;

/// What a free decay shows beside its modes.
#[derive(Clone, Debug, PartialEq)]
pub struct Decay {
    /// Channels of the record.
    pub channels: usize,
    /// Share of the motion that the poles explain.
    pub explained: f64,
    /// Peaks of what is left, Hz, where it is not white; those of the modes shown are among them.
    pub left_peaks_hz: Vec<f64>,
    /// Each mode, by frequency.
    pub modes: Vec<ModeDecay>,
}

/// How one mode dies away.
#[derive(Clone, Debug, PartialEq)]
pub struct ModeDecay {
    /// Its frequency, Hz.
    pub frequency_hz: f64,
    /// Frequencies of the poles that stand for it, Hz. More than one, of one shape and with bands that meet: it is no exponential, its
    /// frequency and damping follow the size of its swings; the mode has the frequency of the strongest pole and the median damping of its swings where there are any, without a deviation. With one
    /// channel every shape is alike: they may as well be several modes.
    pub poles_hz: Vec<f64>,
    /// Its deviations over those in white noise of the same power: far above 1 where the structure is still shaken.
    pub over_white: f64,
    /// Whether its damping follows the size of its swings, beyond chance and by more than a fifth: friction, or a joint that works. Its one damping
    /// ratio is then a mean without a deviation.
    pub damping_follows: bool,
    /// Frequency and damping by the size of its swings, largest first, at the channel that shows most of it; empty where another mode
    /// is too near, where there are too few swings, and where swings of several poles grow on the way: they beat.
    pub swings: Vec<AtAmplitude>,
}
