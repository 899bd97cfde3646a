//! Spectral matrices of a record at every line, from its windowed correlations (Blackman & Tukey).
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | S(f) | `at` | one-sided spectral density, channels × channels | unit²/Hz |
//! | R_k | `lags` | correlations | unit² |
//! | M | `lines` | largest lag of the window | - |

use crate::modal::ModalError;
use crate::modal::correlations::windows;
use crate::modal::products;
use crate::modal::streaming_sums::StreamingSums;
use crate::signal::Record;
use dolmen_linalg::{Complex64, ComplexMatrix};
use realfft::RealFftPlanner;
use realfft::num_complex::Complex;
use std::cmp::Ordering;

/// Largest memory for sums of products, bytes. For many channels only some rows of the matrices are computed at a time, in several passes.
const SUMS_BYTES: usize = 3 << 24;
const SUM_BYTES: usize = 16;

/// Largest size of the triangles in 64 bits; larger ones use 32 bits. With up to a hundred channels the singular values are then accurate
/// to six digits of the largest.
const PAIRS_BYTES: usize = 1 << 26;

/// Lower triangle of S at every line, one pair of channels after the other.
pub(crate) struct SpectralMatrices {
    pub(super) channels: usize,
    pub(super) lines: usize,
    pairs: Pairs,
}

enum Pairs {
    Wide(Vec<Complex<f64>>),
    Narrow(Vec<Complex<f32>>),
}

impl SpectralMatrices {
    /// ```text
    /// S_ab(f) = H_ab + conj H_ba,   H_ab = 2 dt Σ w_k R_ab,k e^(-2πi f k dt),  k = 0 … M - 1,  w_0 halved
    /// ```
    /// w is Parzen's window. The lags of a channel pair are not kept after its transform.
    ///
    /// # Errors
    /// [`ModalError::TooShort`].
    pub(crate) fn of(record: &Record, lines: usize) -> Result<Self, ModalError> {
        let (l, m) = (record.channels().len(), lines);
        let size = l * (l + 1) / 2 * (m + 1);
        Self::held(record, lines, Pairs::new(size, size * SUM_BYTES > PAIRS_BYTES))
    }

    fn held(record: &Record, lines: usize, mut pairs: Pairs) -> Result<Self, ModalError> {
        let (l, m) = (record.channels().len(), lines);
        let windows = windows(record, m, 1)?;
        let plan = RealFftPlanner::new().plan_fft_forward(2 * m);
        let (mut time, mut bins) = (plan.make_input_vec(), plan.make_output_vec());
        let mut scratch = plan.make_scratch_vec();
        let scale = 2.0 / (record.sampling_rate_hz() * windows.starts as f64);
        let weights: Vec<f64> = (0..m)
            .map(|k| scale * if k == 0 { 0.5 } else { parzen(k as f64 / m as f64) })
            .collect();
        let held = SUMS_BYTES / SUM_BYTES / (l * (windows.segment + 1));
        let rows = held.max(1).next_multiple_of(2);
        let mut before: Option<StreamingSums<'_>> = None;
        for from in (0..l).step_by(rows) {
            let own = vec![products::Pairs {
                rows: from..(from + rows).min(l),
                columns: 0..l,
            }];
            let mut pass = match before.take() {
                Some(pass) => pass.turned_to(own),
                None => StreamingSums::new(record, ((0..l).collect(), own), m, windows.segment),
            };
            pass.block(0..windows.segments(), windows.starts, |[a, b], lags| {
                time.fill(0.0);
                for ((t, r), w) in time.iter_mut().zip(lags).zip(&weights) {
                    *t = *r * w;
                }
                let _ = plan.process_with_scratch(&mut time, &mut bins, &mut scratch); // lengths are the plan's own
                for h in &mut bins {
                    *h = match a.cmp(&b) {
                        Ordering::Greater => *h,
                        Ordering::Equal => Complex::new(2.0 * h.re, 0.0),
                        Ordering::Less => h.conj(),
                    };
                }
                pairs.add(pair(a, b) * (m + 1), &bins);
            });
            before = Some(pass);
        }
        Ok(SpectralMatrices {
            channels: l,
            lines: m,
            pairs,
        })
    }

    /// Number of the last line, at half the sampling rate.
    pub(crate) fn lines(&self) -> usize {
        self.lines
    }

    /// Density of one channel at a line.
    pub(crate) fn power(&self, channel: usize, line: usize) -> f64 {
        let at = pair(channel, channel) * (self.lines + 1) + line;
        match &self.pairs {
            Pairs::Wide(pairs) => pairs[at].re,
            Pairs::Narrow(pairs) => pairs[at].re.into(),
        }
    }

    pub(crate) fn at(&self, line: usize) -> ComplexMatrix {
        let mut whole = ComplexMatrix::zeros(self.channels, self.channels);
        self.lower_into(line, &mut whole);
        for j in 0..self.channels {
            for i in 0..j {
                whole[(i, j)] = whole[(j, i)].conj();
            }
        }
        whole
    }

    /// Writes the lower triangle of one line to `lower`.
    pub(super) fn lower_into(&self, line: usize, lower: &mut ComplexMatrix) {
        let mut at = line;
        for i in 0..self.channels {
            for j in 0..=i {
                lower[(i, j)] = match &self.pairs {
                    Pairs::Wide(pairs) => Complex64::new(pairs[at].re, pairs[at].im),
                    Pairs::Narrow(pairs) => Complex64::new(pairs[at].re.into(), pairs[at].im.into()),
                };
                at += self.lines + 1;
            }
        }
    }
}

impl Pairs {
    fn new(size: usize, is_narrow: bool) -> Self {
        match is_narrow {
            true => Pairs::Narrow(vec![Complex::default(); size]),
            false => Pairs::Wide(vec![Complex::default(); size]),
        }
    }

    fn add(&mut self, at: usize, bins: &[Complex<f64>]) {
        match self {
            Pairs::Wide(pairs) => pairs[at..].iter_mut().zip(bins).for_each(|(s, h)| *s += h),
            Pairs::Narrow(pairs) => pairs[at..].iter_mut().zip(bins).for_each(|(s, h)| {
                s.re += h.re as f32;
                s.im += h.im as f32;
            }),
        }
    }
}

/// Place of a pair of channels in the lower triangle, row by row.
fn pair(i: usize, j: usize) -> usize {
    let (a, b) = (i.max(j), i.min(j));
    a * (a + 1) / 2 + b
}

/// Parzen's lag window at x = lag over the longest lag, 0 to 1.
pub(crate) fn parzen(x: f64) -> f64 {
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
        let narrow = SpectralMatrices::held(&record, lines, Pairs::new(6 * 65, true)).unwrap();
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
                let narrow = narrow.at(line)[(a, b)];
                assert!(
                    (narrow - exact).norm() < 1e-6 * exact.norm(),
                    "{line} {a} {b} {narrow} {exact}"
                );
            }
        }
    }
}
