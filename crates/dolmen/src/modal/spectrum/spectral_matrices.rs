//! Spectral matrices of a record at every line, from its correlations through a lag window (Blackman & Tukey).
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | S(f) | `at` | one-sided spectral density, channels × channels | unit²/Hz |
//! | R_k | `lags` | correlations | unit² |
//! | M | `lines` | largest lag of the window | - |

use crate::modal::ModalError;
use crate::modal::correlations::windows;
use crate::modal::streaming_sums::StreamingSums;
use crate::signal::Record;
use dolmen_linalg::{Complex64, ComplexMatrix};
use realfft::RealFftPlanner;
use realfft::num_complex::Complex;

/// Sums of products of so many bytes are held at once: of a record of many channels those of some rows of the matrices, in as many passes
/// as it takes.
const SUMS_BYTES: usize = 1 << 26;
/// Bytes of a sum, complex.
const SUM_BYTES: usize = 16;

/// Lower triangle of S at every line, one pair of channels after the other.
pub(crate) struct SpectralMatrices {
    pub(super) channels: usize,
    pub(super) lines: usize,
    pairs: Vec<Complex<f64>>,
}

impl SpectralMatrices {
    /// ```text
    /// S_ab(f) = H_ab + conj H_ba,   H_ab = 2 dt Σ w_k R_ab,k e^(-2πi f k dt),  k = 0 … M - 1,  w_0 halved
    /// ```
    /// w is Parzen's window. No lag is kept beyond its pair of channels.
    ///
    /// # Errors
    /// [`ModalError::TooShort`].
    pub(crate) fn of(record: &Record, lines: usize) -> Result<Self, ModalError> {
        let (l, m) = (record.channels().len(), lines);
        let windows = windows(record, m, 1)?;
        let plan = RealFftPlanner::new().plan_fft_forward(2 * m);
        let (mut time, mut bins) = (plan.make_input_vec(), plan.make_output_vec());
        let mut scratch = plan.make_scratch_vec();
        let scale = 2.0 / (record.sampling_rate_hz() * windows.starts as f64);
        let weights: Vec<f64> = (0..m)
            .map(|k| scale * if k == 0 { 0.5 } else { parzen(k as f64 / m as f64) })
            .collect();
        let mut pairs = vec![Complex::default(); l * (l + 1) / 2 * (m + 1)];
        let held = SUMS_BYTES / SUM_BYTES / (l * (windows.segment + 1));
        let rows = held.max(1).next_multiple_of(2);
        for from in (0..l).step_by(rows) {
            let mut pass = StreamingSums::new(record, from..(from + rows).min(l), m, windows.segment);
            pass.block(0..windows.segments(), windows.starts, |[a, b], lags| {
                time.fill(0.0);
                for ((t, r), w) in time.iter_mut().zip(lags).zip(&weights) {
                    *t = *r * w;
                }
                let _ = plan.process_with_scratch(&mut time, &mut bins, &mut scratch); // lengths are the plan's own
                let at = pair(a, b) * (m + 1);
                for (s, h) in pairs[at..=at + m].iter_mut().zip(&bins) {
                    *s += if a >= b { *h } else { h.conj() };
                    if a == b {
                        *s += h.conj();
                    }
                }
            });
        }
        Ok(SpectralMatrices {
            channels: l,
            lines: m,
            pairs,
        })
    }

    pub(super) fn at(&self, line: usize) -> ComplexMatrix {
        ComplexMatrix::from_fn(self.channels, self.channels, |i, j| {
            let z = self.pairs[pair(i, j) * (self.lines + 1) + line];
            let im = if i == j { 0.0 } else { z.im };
            Complex64::new(z.re, if i >= j { im } else { -im })
        })
    }
}

/// Place of a pair of channels in the lower triangle, row by row.
fn pair(i: usize, j: usize) -> usize {
    let (a, b) = (i.max(j), i.min(j));
    a * (a + 1) / 2 + b
}

/// Parzen's lag window at x = lag over the longest lag, 0 to 1.
pub(super) fn parzen(x: f64) -> f64 {
    if x <= 0.5 {
        1.0 - 6.0 * x * x * (1.0 - x)
    } else {
        2.0 * (1.0 - x).powi(3)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::correlations::correlate;
    use crate::numeric::Random;
    use crate::signal::Channel;
    use std::f64::consts::PI;

    #[test]
    fn agrees_with_the_sum_over_windowed_correlations() {
        let (l, lines, rate_hz) = (3, 64, 10.0);
        let mut random = Random::new(5, 0);
        let samples = (0..l * 2000).map(|_| random.normal()).collect();
        let names = (0..l).map(|c| Channel::named(format!("{c}"))).collect();
        let record = Record::from_contiguous(names, samples, rate_hz).unwrap();
        let r = correlate(&record, lines, 1).unwrap();
        let found = SpectralMatrices::of(&record, lines).unwrap();
        for line in [0, 1, 17, lines] {
            let s = found.at(line);
            for (a, b) in [(0, 0), (2, 1), (1, 2), (0, 2)] {
                let exact: Complex64 = (-(lines as isize)..=lines as isize)
                    .map(|k| {
                        let lag = r.lag(k.unsigned_abs());
                        let value = if k >= 0 { lag[a * l + b] } else { lag[b * l + a] };
                        let weight = 2.0 / rate_hz * parzen(k.unsigned_abs() as f64 / lines as f64);
                        let turn = -PI * (k * line as isize) as f64 / lines as f64;
                        Complex64::from_polar(weight * value, turn)
                    })
                    .sum();
                assert!(
                    (s[(a, b)] - exact).norm() < 1e-14,
                    "{line} {a} {b} {} {exact}",
                    s[(a, b)]
                );
            }
        }
    }
}
