//! Options of the identification of modes.

use super::modes::Method;
use super::spectrum::Fdd;
use super::subspace::Clustering;
use super::subspace::Criteria;
use crate::signal::ClippedChannel;

/// Treatment of a mode that looks like a machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Harmonics {
    /// The mode is kept, and a note names it.
    Flag,
    /// The mode is left out, and a note names it.
    Remove,
}

/// Options of [`identify`](super::identify()). The defaults are suitable for every record measured in this chapter.
#[derive(Clone, Debug, PartialEq)]
pub struct Identify {
    /// Method of identification; default `SsiCov`. `Bayoma` and `SsiData` have less scatter on simulated records. On measured records, `SsiData`
    /// gave a damping ratio 50 % too large for ten minutes, and `Bayoma` is worse at separating modes within one half-power band.
    pub method: Method,
    /// Reference channels of the subspace methods, by index; empty (default): all.
    pub references: Vec<usize>,
    /// Indices of the channels that measure the excitation: the ground next to or below the structure, or a shaker. Only for `Okid`, which needs at
    /// least one.
    pub inputs: Vec<usize>,
    /// Lowest frequency of interest, Hz; `None` (default): from the lowest peak of the spectrum.
    pub frequency_low_hz: Option<f64>,
    /// Highest frequency of interest, Hz; `None` (default): from the highest peak of the spectrum.
    pub frequency_high_hz: Option<f64>,
    /// Block rows; `None` (default): from the lowest frequency.
    pub block_rows: Option<usize>,
    /// Decimation of the correlations; `None` (default): from the highest frequency; `Some(1)`: no decimation.
    pub decimation: Option<usize>,
    /// Highest model order; `None` (default): six times the number of spectral peaks or of channels, whichever is larger, within 24 to 60.
    pub order_most: Option<usize>,
    /// Blocks of time for the standard deviations; default 30.
    pub time_blocks: usize,
    /// Number of modes that must be found; `None` (default): any number.
    pub modes_wanted: Option<usize>,
    /// Frequencies of modes picked by hand, Hz; empty (default): all modes. A frequency without a mode nearby is an error; it never gives another
    /// mode.
    pub pick_hz: Vec<f64>,
    /// Largest relative distance between a picked frequency and its mode; default 0.02.
    pub pick_within: f64,
    /// Frequencies of requested modes, Hz. A refused candidate there becomes a mode that carries the reason of its refusal; without a candidate, a
    /// note says what is nearby.
    pub accept_hz: Vec<f64>,
    /// Largest relative distance between such a frequency and the refused candidate; default 0.03, the largest distance between a peak and its
    /// mode.
    pub accept_within: f64,
    /// Channels that were clipped before the record was filtered or decimated; those that are clipped in the record itself are found.
    pub clipped: Vec<ClippedChannel>,
    /// Treatment of a mode whose amplitude is too steady for random forces; default `Flag`.
    pub harmonics: Harmonics,
    /// Options of the spectrum, which is computed first.
    pub fdd: Fdd,
    /// Criteria for a pole; the frequency range is reduced to the selected one.
    pub criteria: Criteria,
    /// Options of the clustering of poles to modes.
    pub clustering: Clustering,
}

impl Default for Identify {
    fn default() -> Self {
        Identify {
            method: Method::SsiCov,
            references: Vec::new(),
            inputs: Vec::new(),
            frequency_low_hz: None,
            frequency_high_hz: None,
            block_rows: None,
            decimation: None,
            order_most: None,
            time_blocks: 30,
            modes_wanted: None,
            pick_hz: Vec::new(),
            pick_within: 0.02,
            accept_hz: Vec::new(),
            accept_within: 0.03,
            clipped: Vec::new(),
            harmonics: Harmonics::Flag,
            fdd: Fdd::default(),
            criteria: Criteria::default(),
            clustering: Clustering::default(),
        }
    }
}
