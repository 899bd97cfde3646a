//! Modes that stand in a valley of the spectrum, between two peaks: few block rows put one pole there in place of two modes.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | S | `Spectrum` | spectral matrix of the two channels in which the mode is largest, by Welch's method |
//! | σ(f) | `largest` | its largest eigenvalue |
//! | w | `half_width_hz` | ζ f |

use crate::modal::Mode;
use crate::signal::Record;
use dolmen_linalg::Complex64;
use realfft::RealFftPlanner;
use std::f64::consts::TAU;

/// Level over that of the lower of the two peaks below which a mode is none. Our choice: 0.25 to 0.59 for 24 of 25 modes that stand for two
/// (a sensor of two axes, modes 9 % apart), above 0.64 for 480 true modes of buildings, masts, chimneys and pagodas.
const VALLEY: f64 = 0.55;
/// Half-power widths on each side in which peaks are looked for.
const REACH: f64 = 3.0;
/// Resolution over the half-power width, for Hann's window.
const RESOLUTION: f64 = 1.0 / 1.5;
const HANN: f64 = 1.5;
/// Fewest segments, half overlapping, and the most that are needed.
const SEGMENTS_LEAST: usize = 6;
const SEGMENTS_MOST: usize = 64;
/// Fewest samples of a segment.
const LENGTH_LEAST: usize = 16;

/// Share of the highest order at which the poles of a mode still stand; those of two modes in one end where higher orders split them.
const ENDS: f64 = 0.85;

/// A mode in a valley.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct InValley {
    pub(crate) frequency_hz: f64,
    pub(crate) damping_ratio: f64,
    /// Whether its poles end where higher orders split them.
    pub(crate) ends: bool,
}

impl InValley {
    /// Whether modes on both sides stand for it.
    pub(crate) fn is_split_in(&self, modes: &[Mode]) -> bool {
        let reach_hz = REACH * self.damping_ratio * self.frequency_hz;
        let is_within = |off_hz: f64| off_hz > 0.0 && off_hz < reach_hz;
        modes
            .iter()
            .any(|mode| is_within(self.frequency_hz - mode.frequency_hz))
            && modes
                .iter()
                .any(|mode| is_within(mode.frequency_hz - self.frequency_hz))
    }
}

/// The modes in valleys, of those found up to a highest order.
pub(crate) fn in_valleys(record: &Record, modes: &[Mode], order_most: usize) -> Vec<InValley> {
    let of = |mode: &Mode| {
        let damping_ratio = mode.damping_ratio.filter(|ratio| *ratio > 0.0)?;
        let last = mode.orders.last().copied().unwrap_or(order_most);
        let is_low = level(record, mode, damping_ratio)? < VALLEY;
        is_low.then_some(InValley {
            frequency_hz: mode.frequency_hz,
            damping_ratio,
            ends: last as f64 <= ENDS * order_most as f64,
        })
    };
    modes.iter().filter_map(of).collect()
}

/// σ at the mode over the lower of the two largest values on either side; `None` if the record is too short to resolve them.
fn level(record: &Record, mode: &Mode, damping_ratio: f64) -> Option<f64> {
    let (n, rate_hz) = (record.length(), record.sampling_rate_hz());
    let half_width_hz = damping_ratio * mode.frequency_hz;
    let wished_hz = (RESOLUTION * half_width_hz).max(8.0 * rate_hz / n as f64);
    let length = ((HANN * rate_hz / wished_hz) as usize).next_power_of_two();
    let length = length.min(n / SEGMENTS_LEAST / 2 * 2);
    if length < LENGTH_LEAST {
        return None;
    }
    let line_hz = rate_hz / length as f64;
    let reach_hz = REACH * half_width_hz.max(line_hz);
    let line = |hz: f64| (hz / line_hz).max(1.0);
    let first = line(mode.frequency_hz - reach_hz).ceil() as usize;
    let last = (line(mode.frequency_hz + reach_hz) as usize).min(length / 2 - 1);
    let here = line(mode.frequency_hz).round() as usize;
    if first >= here || here >= last {
        return None;
    }
    let largest = largest(record, channels(mode), length, first..=last);
    let at = here - first;
    let most = |part: &[f64]| part.iter().copied().fold(0.0, f64::max);
    Some(largest[at] / most(&largest[..at]).min(most(&largest[at + 1..])))
}

/// The two channels in which a mode is largest; one channel twice if there is no other.
fn channels(mode: &Mode) -> [usize; 2] {
    let mut order: Vec<usize> = (0..mode.shape.len()).collect();
    order.sort_by(|a, b| mode.shape[*b].norm().total_cmp(&mode.shape[*a].norm()));
    let first = order.first().copied().unwrap_or(0);
    [first, order.get(1).copied().unwrap_or(first)]
}

/// σ of these lines.
fn largest(
    record: &Record,
    of: [usize; 2],
    length: usize,
    lines: std::ops::RangeInclusive<usize>,
) -> Vec<f64> {
    let samples = of.map(|channel| record.samples(channel));
    let mean = samples.map(|all| all.iter().sum::<f64>() / all.len() as f64);
    let window: Vec<f64> = (0..length)
        .map(|i| 0.5 - 0.5 * (TAU * i as f64 / length as f64).cos())
        .collect();
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(length);
    let mut input = transform.make_input_vec();
    let mut output = [transform.make_output_vec(), transform.make_output_vec()];
    let mut scratch = transform.make_scratch_vec();
    let possible = (record.length() - length) / (length / 2) + 1;
    let segments = possible.min(SEGMENTS_MOST);
    let mut sums = vec![(0.0, 0.0, Complex64::default()); lines.clone().count()];
    for segment in 0..segments {
        // spread over the record
        let from = segment * possible / segments * (length / 2);
        for channel in 0..2 {
            for ((x, y), weight) in input.iter_mut().zip(&samples[channel][from..]).zip(&window) {
                *x = (y - mean[channel]) * weight;
            }
            // the buffers have the required lengths
            let _ = transform.process_with_scratch(&mut input, &mut output[channel], &mut scratch);
        }
        for (sum, line) in sums.iter_mut().zip(lines.clone()) {
            let (a, b) = (output[0][line], output[1][line]);
            sum.0 += a.norm_sqr();
            sum.1 += b.norm_sqr();
            sum.2 += a * b.conj();
        }
    }
    let eigenvalue = |(a, b, across): &(f64, f64, Complex64)| {
        let half = 0.5 * (a - b);
        0.5 * (a + b) + half.hypot(across.norm())
    };
    sums.iter().map(eigenvalue).collect()
}

#[cfg(test)]
mod tests {
    use super::super::super::{Identify, MadeMode, MadeRecord, identify};
    use super::*;

    /// A building of fifteen modes with its two lowest 9 % apart, seen by one sensor of two axes.
    fn record(seed: u64) -> Record {
        let modes = [
            (1.429, [1.0, 0.3]),
            (1.569, [-0.4, 1.0]),
            (2.215, [0.7, 0.6]),
            (3.91, [1.0, -0.2]),
            (4.29, [0.3, 1.0]),
            (6.06, [0.8, -0.6]),
            (6.12, [0.5, 0.9]),
            (6.716, [-0.9, 0.4]),
            (7.86, [1.0, 0.2]),
            (8.63, [-0.3, 1.0]),
            (9.48, [0.9, 0.5]),
            (10.24, [0.4, -0.8]),
            (12.19, [0.7, 0.7]),
        ];
        let mode = |(frequency_hz, shape): (f64, [f64; 2])| MadeMode {
            frequency_hz,
            damping_ratio: 0.015,
            shape: shape.to_vec(),
        };
        let made = MadeRecord {
            modes: modes.into_iter().map(mode).collect(),
            sampling_rate_hz: 50.0,
            noise_ratio: 0.02,
            seed,
            ..MadeRecord::default()
        };
        made.make().unwrap()
    }

    fn of(record: &Record, block_rows: Option<usize>) -> Vec<Mode> {
        let options = Identify {
            block_rows,
            ..Identify::default()
        };
        identify(record, &options).unwrap().modes.modes
    }

    #[test]
    fn holds_no_mode_stands_between_the_peaks_of_two() {
        let is_between = |mode: &Mode| mode.frequency_hz > 1.46 && mode.frequency_hz < 1.54;
        let is_near = |mode: &Mode, hz: f64| (mode.frequency_hz / hz - 1.0).abs() < 0.02;
        let mut both = 0;
        for seed in 0..4 {
            let record = record(seed);
            let found = of(&record, None);
            assert!(!found.iter().any(is_between), "{seed} {found:?}");
            let lowest = [1.429, 1.569].map(|hz| found.iter().any(|mode| is_near(mode, hz)));
            both += usize::from(lowest == [true, true]);
            // too few block rows that the user insists on: no mode rather than a wrong one
            assert!(!of(&record, Some(48)).iter().any(is_between), "{seed}");
        }
        assert!(both >= 3, "{both}");
    }

    #[test]
    fn holds_true_modes_stand_on_peaks() {
        let record = record(9);
        let true_modes = of(&record, Some(160));
        let levels = true_modes
            .iter()
            .filter_map(|mode| level(&record, mode, mode.damping_ratio?));
        assert!(levels.fold(f64::INFINITY, f64::min) > VALLEY);
    }
}
