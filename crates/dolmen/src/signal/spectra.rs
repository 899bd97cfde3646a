//! Cross spectral densities by averaging over segments (Welch).
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | L | `segment_length` | samples of a segment |
//! | w | `window` | Hann window, periodic: w_i = (1 - cos(2π i / L)) / 2 |
//! | X | `transforms` | Fourier transform of one windowed segment of one channel |
//! | S | `density` | one-sided cross spectral density |

use super::{Record, SignalError};
use dolmen_linalg::{Complex64, ComplexMatrix};
use realfft::RealFftPlanner;
use std::f64::consts::TAU;

/// Fewest samples of a segment: the window alone spreads over 4 lines.
const SEGMENT_LEAST: usize = 8;

/// Options of the segments. Neighbouring segments overlap by half, which is nearly optimal for a Hann window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Welch {
    /// Samples of a segment, from 8 to the length of the record. Default 2048 (our choice: 0.05 Hz at 100 Hz). Longer segments give finer
    /// lines but fewer averages; powers of 2 are fastest.
    pub segment_length: usize,
}

impl Default for Welch {
    fn default() -> Self {
        Welch { segment_length: 2048 }
    }
}

/// One-sided cross spectral densities of all channels at each line, with the number of averaged segments.
#[derive(Clone, Debug, PartialEq)]
pub struct CrossSpectra {
    /// Frequency of each line, Hz: 0 to the Nyquist frequency.
    pub frequency_hz: Vec<f64>,
    /// Number of averaged segments. The relative scatter of a density is about 1/√segments.
    pub segments: usize,
    /// Samples of a segment.
    pub segment_length: usize,
    /// Spacing of the lines, Hz: sampling rate / segment length.
    pub resolution_hz: f64,
    channels: usize,
    /// Lower triangle, row by row (i, j ≤ i); all lines of a pair are together.
    density: Vec<Complex64>,
}

impl CrossSpectra {
    /// Number of channels.
    pub fn channels(&self) -> usize {
        self.channels
    }

    /// S_ij at one line, unit of i × unit of j / Hz. S_ji is its conjugate.
    pub fn density(&self, i: usize, j: usize, line: usize) -> Complex64 {
        let pair = |i: usize, j: usize| self.density[(i * (i + 1) / 2 + j) * self.frequency_hz.len() + line];
        if j <= i { pair(i, j) } else { pair(j, i).conj() }
    }

    /// The power spectral density of one channel, unit²/Hz, all lines.
    pub fn power(&self, channel: usize) -> Vec<f64> {
        (0..self.frequency_hz.len())
            .map(|line| self.density(channel, channel, line).re)
            .collect()
    }

    /// The Hermitian matrix of all channels at one line.
    pub fn matrix(&self, line: usize) -> ComplexMatrix {
        ComplexMatrix::from_fn(self.channels, self.channels, |i, j| self.density(i, j, line))
    }
}

/// Cross spectral densities of all channels of a record.
///
/// ```text
/// S_ij(f) = 2 / (f_s Σ w²) · mean over segments of X_i(f) X_j(f)*        (channels × channels × lines)
/// ```
///
/// The mean of each segment is removed first. The lines at 0 Hz and at the Nyquist frequency are not doubled. Samples after the last whole
/// segment (less than half a segment) are not used.
///
/// # Errors
/// [`SignalError::SegmentLength`] if a segment is shorter than 8 samples or longer than the record.
///
/// # Limits
/// The window widens a peak narrower than four lines: for a mode with frequency f and damping ratio ζ, choose `resolution_hz` well below ζ f.
///
/// # Source
/// Welch (1967) IEEE Trans. Audio Electroacoust. 15(2):70-73. Agrees with the defaults of `scipy.signal.csd(x_j, x_i)`: SciPy conjugates its
/// first argument; here the second index is conjugated, as usual in modal analysis.
///
/// # Example
/// ```
/// use dolmen::signal::{Channel, Record, Welch, cross_spectra};
/// let x: Vec<f64> = (0..8192).map(|i| (std::f64::consts::TAU * 12.5 * i as f64 / 100.0).sin()).collect();
/// let spectra = cross_spectra(&Record::new(vec![Channel::named("x")], vec![x], 100.0)?, &Welch::default())?;
/// let power: f64 = spectra.power(0).iter().sum::<f64>() * spectra.resolution_hz;
/// assert!((power - 0.5).abs() < 1e-9); // mean square of a sine
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn cross_spectra(record: &Record, options: &Welch) -> Result<CrossSpectra, SignalError> {
    let (length, channels, rate) = (
        options.segment_length,
        record.channels().len(),
        record.sampling_rate_hz(),
    );
    if !(SEGMENT_LEAST..=record.length()).contains(&length) {
        return Err(SignalError::SegmentLength {
            given: length,
            least: SEGMENT_LEAST,
            most: record.length(),
        });
    }
    let window: Vec<f64> = (0..length)
        .map(|i| 0.5 - 0.5 * (TAU * i as f64 / length as f64).cos())
        .collect();
    let lines = length / 2 + 1;
    let hop = length - length / 2;
    let segments = (record.length() - length) / hop + 1;

    let plan = RealFftPlanner::<f64>::new().plan_fft_forward(length);
    let mut scratch = plan.make_scratch_vec();
    let mut segment = vec![0.0; length];
    let mut transforms = vec![Complex64::ZERO; channels * lines];
    let mut density = vec![Complex64::ZERO; channels * (channels + 1) / 2 * lines];
    for start in (0..segments).map(|s| s * hop) {
        for (channel, transform) in transforms.chunks_exact_mut(lines).enumerate() {
            let x = &record.samples(channel)[start..start + length];
            let mean = x.iter().sum::<f64>() / length as f64;
            for ((s, x), w) in segment.iter_mut().zip(x).zip(&window) {
                *s = w * (x - mean);
            }
            // only a buffer of a wrong length is an error
            let done = plan.process_with_scratch(&mut segment, transform, &mut scratch);
            debug_assert!(done.is_ok());
        }
        let mut sums = density.chunks_exact_mut(lines);
        for (i, x_i) in transforms.chunks_exact(lines).enumerate() {
            for (x_j, sum) in transforms.chunks_exact(lines).zip(&mut sums).take(i + 1) {
                for ((s, a), b) in sum.iter_mut().zip(x_i).zip(x_j) {
                    *s += a * b.conj();
                }
            }
        }
    }
    let energy: f64 = window.iter().map(|w| w * w).sum();
    let scale = 1.0 / (rate * energy * segments as f64);
    for sum in density.chunks_exact_mut(lines) {
        for (line, s) in sum.iter_mut().enumerate() {
            let one_sided = if line == 0 || 2 * line == length { 1.0 } else { 2.0 };
            *s *= scale * one_sided;
        }
    }
    Ok(CrossSpectra {
        frequency_hz: (0..lines)
            .map(|line| line as f64 * rate / length as f64)
            .collect(),
        segments,
        segment_length: length,
        resolution_hz: rate / length as f64,
        channels,
        density,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::signal::Channel;
    use proptest::prelude::*;

    fn record(channels: Vec<Vec<f64>>) -> Record {
        let names = (0..channels.len())
            .map(|c| Channel::named(format!("{c}")))
            .collect();
        Record::new(names, channels, 100.0).unwrap()
    }

    // numpy 2.4.6, scipy 1.17.1:
    //   i = np.arange(2000); u = np.sin(.37*i) + .5*np.cos(1.1*i+.3); v = np.cos(.37*i) + .3*np.sin(2.2*i)
    //   f, S = csd(v, u, fs=100, nperseg=n); f, P = welch(u, fs=100, nperseg=n)
    #[test]
    #[rustfmt::skip]
    fn agrees_with_csd_and_welch() {
        let i = || (0..2000).map(f64::from);
        let u = i().map(|i| (0.37 * i).sin() + 0.5 * (1.1 * i + 0.3).cos()).collect();
        let v = i().map(|i| (0.37 * i).cos() + 0.3 * (2.2 * i).sin()).collect();
        let record = record(vec![u, v]);
        for (segment_length, segments, lines) in [
            (256, 14, [
                (0, 0.0, 3.400756806897638e-06, 0.0, 2.3947714734474503e-05),
                (1, 0.390625, 1.673681315899749e-06, 3.7345724743596156e-08, 1.1691963027673635e-05),
                (15, 5.859375, -4.0433820936457875e-07, -0.8471365844227013, 0.8471368622921902),
                (128, 50.0, -8.62441357095825e-15, 0.0, 1.6878235244324313e-14),
            ]),
            (255, 14, [
                (0, 0.0, 1.1557361308841832e-06, 0.0, 8.901731081236409e-06),
                (1, 0.392156862745098, 5.689617752507492e-07, 1.597309299843662e-09, 4.431124290274224e-06),
                (15, 5.882352941176469, -6.602204778458468e-07, -0.8497099029854163, 0.8497100020794519),
                (127, 49.803921568627445, -9.010737691340479e-15, 1.0590371108341588e-15, 7.663063638094194e-14),
            ]),
        ] {
            let spectra = cross_spectra(&record, &Welch { segment_length }).unwrap();
            assert_eq!(spectra.segments, segments);
            for (line, frequency_hz, re, im, power) in lines {
                assert!((spectra.frequency_hz[line] - frequency_hz).abs() < 1e-12);
                let s = spectra.density(0, 1, line);
                assert!((s - Complex64::new(re, im)).norm() < 1e-13, "{segment_length}, line {line}: {s}");
                assert!((spectra.power(0)[line] - power).abs() < 1e-13);
                assert_eq!(spectra.density(1, 0, line), s.conj());
                assert_eq!(spectra.matrix(line).column(1)[0], s);
            }
        }
    }

    proptest! {
        /// Parseval: the densities add up to the mean square of the windowed samples.
        #[test]
        fn holds_power_is_kept(x in prop::collection::vec(-1.0..1.0, 8..200)) {
            let n = x.len();
            let mean = x.iter().sum::<f64>() / n as f64;
            let window = |i: usize| (std::f64::consts::PI * i as f64 / n as f64).sin().powi(2);
            let square: f64 = x.iter().enumerate().map(|(i, v)| (window(i) * (v - mean)).powi(2)).sum();
            let energy: f64 = (0..n).map(|i| window(i).powi(2)).sum();
            let spectra = cross_spectra(&record(vec![x]), &Welch { segment_length: n }).unwrap();
            let total = spectra.power(0).iter().sum::<f64>() * spectra.resolution_hz;
            prop_assert!((total - square / energy).abs() < 1e-12, "{} {}", total, square / energy);
        }
    }

    #[test]
    fn refuses_segments_that_do_not_fit() {
        let record = record(vec![vec![0.0; 100]]);
        for segment_length in [0, 7, 101] {
            assert_eq!(
                cross_spectra(&record, &Welch { segment_length })
                    .unwrap_err()
                    .to_string(),
                format!(
                    "segment_length is {segment_length}, but must be 8 to 100 samples, the length of the record"
                )
            );
        }
    }
}
