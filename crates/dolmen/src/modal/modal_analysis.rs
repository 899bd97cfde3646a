//! The modes of a record, and the intermediate results of the analysis.

use super::decay::{Decay, DecaysInRecord};
use super::driven::Driven;
use super::notes::Note;
use super::options::Identify;
use super::settings::{Settings, passed_hz};
use super::spectrum::{FddResult, SingularSpectrum};
use super::subspace::Cluster;
use super::subspace::Stabilization;
use super::{LastingChange, Mode, Modes};
use crate::signal::Record;

/// The modes of a record, with all data to draw, evaluate and reproduce them.
#[derive(Clone, Debug)]
pub struct ModalAnalysis {
    /// The modes, by frequency. Their shapes contain only the channels of one clock.
    pub modes: Modes,
    /// Singular values of the spectral matrix over frequency.
    pub spectrum: SingularSpectrum,
    /// Modes from the peaks of the spectrum, for comparison of frequency and shape.
    pub fdd_modes: Modes,
    /// Every pole with its verdict.
    pub stabilization: Stabilization,
    /// Every cluster of poles with its verdict; those with `Fate::Mode` are the modes, in order.
    pub clusters: Vec<Cluster>,
    /// Singular values of the Hankel matrix, descending.
    pub hankel_singular_values: Vec<f64>,
    /// Settings that were chosen from the data.
    pub settings: Settings,
    /// For a free decay: quality of the exponential model, and dependence on amplitude.
    pub decay: Option<Decay>,
    /// For a record that is made up of free decays and is not analysed as one: these decays.
    pub free_decays: Option<DecaysInRecord>,
    /// Modes of which the frequencies in the two halves of the record differ beyond chance.
    pub between_halves: Vec<LastingChange>,
    /// For a record with measured inputs: the motion that the inputs explain, and the modes of structure and ground.
    pub driven: Option<Driven>,
    /// Notes on the modes.
    pub notes: Vec<Note>,
}

/// The analysis with the spectral peaks as modes.
pub(super) fn of_peaks(peaks: FddResult, record: &Record, options: &Identify) -> ModalAnalysis {
    let lines = peaks.spectrum.frequency_hz.len() - 1;
    let nyquist_hz = peaks.spectrum.frequency_hz.last().copied().unwrap_or(0.0);
    let first = |modes: &[Mode]| modes.first().map_or(0.0, |m| m.frequency_hz);
    let last = |modes: &[Mode]| modes.last().map_or(nyquist_hz, |m| m.frequency_hz);
    let modes = &peaks.modes.modes;
    let settings = Settings {
        lowest_hz: options.frequency_low_hz.unwrap_or(first(modes)),
        highest_hz: options.frequency_high_hz.unwrap_or(last(modes)),
        decimation: 1,
        sampling_rate_hz: 2.0 * nyquist_hz,
        lines,
        block_rows: 0,
        block_rows_least: 0,
        order_most: 0,
        time_blocks: 0,
        time_blocks_effective: 0,
        references: Vec::new(),
        references_keep: None,
        range_hz: [
            options.frequency_low_hz.unwrap_or(0.0),
            options
                .frequency_high_hz
                .unwrap_or(nyquist_hz)
                .min(passed_hz(record).unwrap_or(nyquist_hz)),
        ],
    };
    ModalAnalysis {
        modes: peaks.modes.clone(),
        spectrum: peaks.spectrum,
        fdd_modes: peaks.modes,
        stabilization: Stabilization {
            poles: Vec::new(),
            criteria: options.criteria.clone(),
        },
        clusters: Vec::new(),
        hankel_singular_values: Vec::new(),
        settings,
        decay: None,
        free_decays: None,
        between_halves: Vec::new(),
        driven: None,
        notes: Vec::new(),
    }
}
