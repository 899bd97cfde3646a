//! Cross spectral densities by averaging over segments (Welch).
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | L | `segment_length` | samples a segment |
//! | w | `window` | Hann window, periodic: w_i = (1 - cos(2π i / L)) / 2 |
//! | X | `transforms` | Fourier transform of one windowed segment of one channel |
//! | S | `density` | one-sided cross spectral density |

use super::{Record, SignalError};
use dolmen_linalg::{Complex64, ComplexMatrix};
use realfft::RealFftPlanner;
use std::f64::consts::TAU;

/// Fewer samples than this are no segment: the window alone takes 4 lines.
const SEGMENT_LEAST: usize = 8;

/// How the segments are taken. Neighbours overlap by half, which a Hann window makes nearly the best there is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Welch {
    /// Samples a segment, 8 to the length of the record; 2048 (chosen here: 0.05 Hz at 100 Hz). The longer, the finer the
    /// lines and the fewer the averages; powers of 2 are fastest.
    pub segment_length: usize,
}

impl Default for Welch {
    fn default() -> Self {
        Welch { segment_length: 2048 }
    }
}

/// One-sided cross spectral densities of all channels, line by line, with how many segments they rest on.
#[derive(Clone, Debug, PartialEq)]
pub struct CrossSpectra {
    /// Frequency of each line, Hz: 0 to the Nyquist frequency.
    pub frequency_hz: Vec<f64>,
    /// Segments averaged. The scatter of a density is about 1/√segments of it.
    pub segments: usize,
    /// Samples a segment.
    pub segment_length: usize,
    /// Distance of the lines, Hz: sampling rate / segment length.
    pub resolution_hz: f64,
    channels: usize,
    /// Lower triangle, row by row, (i, j ≤ i); each pair holds all its lines.
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
/// The mean of each segment is taken out first. The lines at 0 Hz and at the Nyquist frequency are not doubled. Samples
/// after the last whole segment, less than half a segment, are not used.
///
/// # Errors
/// [`SignalError::SegmentLength`] if a segment is shorter than 8 samples or longer than the record.
///
/// # Limits
/// A peak narrower than four lines is widened by the window: a mode of frequency f and damping ratio ζ wants
/// `resolution_hz` well below ζ f.
///
/// # Source
/// Welch (1967) IEEE Trans. Audio Electroacoust. 15(2):70-73. Agrees with `scipy.signal.csd(x_j, x_i)` with its defaults:
/// scipy conjugates its first argument, here the second index is conjugated, as modal analysis has it.
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
            // fails only for buffers of a wrong length
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
