//! The spectrogram of a channel: its power spectral density over frequency and time.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | L | `segment_length` | samples of a segment |
//! | h | `hop` | samples from one segment to the next: half of L |

use super::{Record, SignalError, Welch, cross_spectra};

/// Options of the segments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Spectrogram {
    /// Samples of a segment, from 8 to the length of the record. Longer segments give finer lines but a coarser time.
    pub segment_length: usize,
    /// Largest number of columns; with more segments, each column averages several of them. Default 100 (our choice, for a figure).
    pub columns_most: usize,
}

impl Default for Spectrogram {
    fn default() -> Self {
        Spectrogram {
            segment_length: 1024,
            columns_most: 100,
        }
    }
}

/// One-sided power spectral densities of one channel; each column is a span of time.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeFrequency {
    /// Frequency of each line, Hz: 0 to the Nyquist frequency.
    pub frequency_hz: Vec<f64>,
    /// Spacing of the lines, Hz.
    pub resolution_hz: f64,
    /// Samples of a segment.
    pub segment_length: usize,
    /// Time from one segment to the next, s.
    pub hop_s: f64,
    /// Middle of the first segment, s from the first sample.
    pub first_s: f64,
    /// The columns, in order.
    pub columns: Vec<SpectrumAt>,
}

/// A column of a spectrogram.
#[derive(Clone, Debug, PartialEq)]
pub struct SpectrumAt {
    /// Middle of the column, s from the first sample.
    pub time_s: f64,
    /// Number of averaged segments.
    pub segments: usize,
    /// Power spectral density of each line, unit²/Hz.
    pub density: Vec<f64>,
}

/// The spectrogram of a channel. Each column is Welch's average of its own segments. So the mean of the columns, weighted by their numbers of
/// segments, is [`cross_spectra`] of the whole channel.
///
/// ```text
/// S(f, t) = 2 / (f_s Σ w²) · mean over the segments of the column of |X(f)|²        (lines × columns)
/// ```
///
/// # Errors
/// [`SignalError::SegmentLength`]; [`SignalError::Argument`] if `columns_most` is 0.
///
/// # Limits
/// Frequency is accurate to half the resolution, time to half a segment: their product is 1/4 at best.
pub fn spectrogram(
    record: &Record,
    channel: usize,
    options: &Spectrogram,
) -> Result<TimeFrequency, SignalError> {
    let welch = Welch {
        segment_length: options.segment_length,
    };
    if options.columns_most == 0 {
        return Err(SignalError::Argument {
            argument: "columns_most",
            given: 0.0,
            allowed: "1 or more",
        });
    }
    let (length, rate) = (options.segment_length, record.sampling_rate_hz());
    let hop = length - length / 2;
    let segments = record
        .length()
        .checked_sub(length)
        .map_or(0, |rest| rest / hop.max(1) + 1);
    let each = segments.div_ceil(options.columns_most).max(1);
    let mut found = TimeFrequency {
        frequency_hz: Vec::new(),
        resolution_hz: 0.0,
        segment_length: length,
        hop_s: hop as f64 / rate,
        first_s: 0.5 * length as f64 / rate,
        columns: Vec::new(),
    };
    let alone = |from: usize, to: usize| {
        let samples = record.samples(channel);
        let part = samples.get(from..to.min(samples.len())).unwrap_or_default();
        Record::from_contiguous(vec![record.channels()[channel].clone()], part.to_vec(), rate)
    };
    // at least one segment, so that a segment longer than the record is refused
    for first in (0..segments.max(1)).step_by(each) {
        let last = (first + each).min(segments.max(1)) - 1;
        let part = alone(first * hop, last * hop + length)?;
        let spectra = cross_spectra(&part, &welch)?;
        found.columns.push(SpectrumAt {
            time_s: found.first_s + 0.5 * (first + last) as f64 * found.hop_s,
            segments: spectra.segments,
            density: spectra.power(0),
        });
        found.resolution_hz = spectra.resolution_hz;
        found.frequency_hz = spectra.frequency_hz;
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;
    use crate::signal::Channel;
    use std::f64::consts::TAU;

    fn record(samples: Vec<f64>) -> Record {
        Record::new(vec![Channel::named("x")], vec![samples], 100.0).unwrap()
    }

    /// Frequency of the largest density of a column, Hz.
    fn peak_hz(found: &TimeFrequency, column: &SpectrumAt) -> f64 {
        let lines = found.frequency_hz.iter().zip(&column.density);
        let most = lines.max_by(|a, b| a.1.total_cmp(b.1)).unwrap();
        *most.0
    }

    #[test]
    fn exact_a_stepped_tone_stands_in_its_line_and_steps_at_its_time() {
        // 5 Hz for a minute, then 12.3 Hz for another
        let x = (0..12_000).map(|i| {
            let t = f64::from(i) / 100.0;
            let hz = if t < 60.0 { 5.0 } else { 12.3 };
            (TAU * hz * t).sin()
        });
        let options = Spectrogram {
            segment_length: 256,
            columns_most: 1000,
        };
        let found = spectrogram(&record(x.collect()), 0, &options).unwrap();
        assert_eq!(found.columns.len(), (12_000 - 256) / 128 + 1);
        for column in &found.columns {
            let exact = if column.time_s < 60.0 { 5.0 } else { 12.3 };
            if (column.time_s - 60.0).abs() > 0.5 * found.hop_s {
                let off = (peak_hz(&found, column) - exact).abs();
                assert!(
                    off <= 0.5 * found.resolution_hz + 1e-9,
                    "{} s: {off}",
                    column.time_s
                );
            }
            // Parseval: half the square of the amplitude
            let power: f64 = column.density.iter().sum::<f64>() * found.resolution_hz;
            if (column.time_s - 60.0).abs() > 1.5 {
                assert!((power - 0.5).abs() < 1e-3, "{} s: {power}", column.time_s);
            }
        }
    }

    #[test]
    fn exact_a_chirp_rises_along_its_own_line() {
        // f = 2 + 0.2 t: phase 2π (2 t + 0.1 t²)
        let x = (0..20_000).map(|i| {
            let t = f64::from(i) / 100.0;
            (TAU * (2.0 * t + 0.1 * t * t)).sin()
        });
        let found = spectrogram(
            &record(x.collect()),
            0,
            &Spectrogram {
                segment_length: 200,
                columns_most: 50,
            },
        )
        .unwrap();
        assert!(found.columns.len() <= 50);
        let spread_hz = 0.2 * found.hop_s * found.columns[0].segments as f64;
        for column in &found.columns {
            let off = (peak_hz(&found, column) - (2.0 + 0.2 * column.time_s)).abs();
            assert!(
                off <= 0.5 * (found.resolution_hz + spread_hz),
                "{} s: {off}",
                column.time_s
            );
        }
    }

    /// Parseval: the mean of the columns is Welch's spectrum, and its sum the mean square.
    #[test]
    fn holds_the_mean_of_the_columns_is_the_spectrum_of_the_whole() {
        let mut random = Random::new(7, 0);
        let x: Vec<f64> = (0..10_000).map(|_| random.normal()).collect();
        for (segment_length, columns_most) in [(256, 1000), (255, 7), (1000, 1), (64, 100)] {
            let record = record(x.clone());
            let options = Spectrogram {
                segment_length,
                columns_most,
            };
            let found = spectrogram(&record, 0, &options).unwrap();
            let whole = cross_spectra(&record, &Welch { segment_length }).unwrap();
            assert!(found.columns.len() <= columns_most);
            let segments: usize = found.columns.iter().map(|column| column.segments).sum();
            assert_eq!(segments, whole.segments);
            for (line, power) in whole.power(0).into_iter().enumerate() {
                let each = found.columns.iter();
                let sum: f64 = each
                    .map(|column| column.density[line] * column.segments as f64)
                    .sum();
                assert!((sum / segments as f64 - power).abs() < 1e-12 * (1.0 + power));
            }
            assert_eq!(found.frequency_hz, whole.frequency_hz);
        }
    }

    #[test]
    fn refuses_segments_that_do_not_fit_and_no_columns() {
        let record = record(vec![0.0; 100]);
        for (segment_length, columns_most) in [(0, 10), (7, 10), (101, 10), (50, 0)] {
            let options = Spectrogram {
                segment_length,
                columns_most,
            };
            assert!(spectrogram(&record, 0, &options).is_err(), "{options:?}");
        }
    }
}
