//! The change between two surveys of a structure, judged by a history of many surveys.

use crate::modal::ObservedMode;
use crate::numeric::welch;

/// Relative difference up to which a frequency of a history belongs to a survey. Our choice: several records of a day count as their median.
const SAME_READING: f64 = 0.01;

/// Effect of weather on one mode between two surveys, and the scatter of the mode, both from a history of many surveys.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct HistoryEffect {
    /// Frequency in the earlier of the two surveys, Hz.
    pub from_hz: f64,
    /// Frequency in the later survey, Hz.
    pub to_hz: f64,
    /// Number of surveys in the history.
    pub surveys: usize,
    /// Relative change that the weather explains.
    pub explained: f64,
    /// Whether the weather is represented by a temperature coefficient.
    pub knows_temperature: bool,
    /// The temperature coefficient, relative per °C, and its standard deviation.
    pub per_c: Option<(f64, f64)>,
    /// Relative standard deviation of one survey, without the noise of its reading.
    pub disturbance_sd: f64,
    /// Relative standard deviation of the difference, without the noise of both readings.
    pub scatter_sd: f64,
    /// Degrees of freedom of `scatter_sd`.
    pub degrees_of_freedom: f64,
    /// Standard deviations of the two readings, Hz.
    pub reading_sds_hz: [f64; 2],
}

/// The mode of a history that belongs to a pair of modes.
pub(super) struct NearestOfPair {
    /// Its index.
    pub(super) index: usize,
    /// Larger of its two relative differences from the pair.
    pub(super) off: f64,
}

/// The mode of a history, given by its frequencies in both surveys, Hz, that is nearest to a pair of modes, if it belongs to the pair.
pub(super) fn nearest_of_pair(
    all: impl Iterator<Item = [f64; 2]>,
    from: &ObservedMode,
    to: &ObservedMode,
) -> Option<NearestOfPair> {
    let off = |[from_hz, to_hz]: [f64; 2]| {
        let both = [(from_hz, from), (to_hz, to)];
        let each = both.map(|(hz, mode)| (hz / mode.frequency_hz - 1.0).abs());
        each[0].max(each[1])
    };
    let each = all.enumerate().map(|(index, both_hz)| NearestOfPair {
        index,
        off: off(both_hz),
    });
    let nearest = each.min_by(|a, b| a.off.total_cmp(&b.off))?;
    (nearest.off <= SAME_READING).then_some(nearest)
}

impl HistoryEffect {
    /// The history nearest to a pair of modes, if it belongs to the pair.
    pub(super) fn of_pair<'a>(all: &'a [Self], from: &ObservedMode, to: &ObservedMode) -> Option<&'a Self> {
        let nearest = nearest_of_pair(all.iter().map(|of| [of.from_hz, of.to_hz]), from, to)?;
        all.get(nearest.index)
    }

    /// Variance of the difference, Hz², and its degrees of freedom. `more_hz2` is the variance due to a temperature coefficient from another
    /// source.
    pub(super) fn spread(&self, from: &ObservedMode, to: &ObservedMode, more_hz2: f64) -> (f64, f64) {
        let [before_hz, after_hz] = self.reading_sds_hz;
        welch(&[
            (after_hz.powi(2), to.degrees_of_freedom),
            (before_hz.powi(2), from.degrees_of_freedom),
            (
                (self.scatter_sd * from.frequency_hz).powi(2),
                self.degrees_of_freedom,
            ),
            (more_hz2, f64::INFINITY),
        ])
    }
}
