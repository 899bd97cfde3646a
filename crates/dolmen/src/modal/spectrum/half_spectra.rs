//! Half spectra of correlations, and the sums over their lines for least squares.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | S⁺ | `values` | half spectrum of windowed correlations | l × r |
//! | ω | `omega` | angle of a line on the unit circle, 2πm/(M + 1) | |
//! | r_d | `lines` | Re Σ e^(iωd) | |
//! | c_d | `cross` | Re Σ e^(iωd) S⁺ | l × r |
//! | t_d | `square` | Re Σ e^(iωd) S⁺* S⁺ | r × r |

use super::plscf_options::Plscf;
use crate::modal::correlations::Correlations;
use dolmen_linalg::{Complex64, Matrix};
use realfft::RealFftPlanner;
use std::f64::consts::PI;
use std::ops::RangeInclusive;

pub(super) struct HalfSpectra {
    pub(super) channels: usize,
    pub(super) references: usize,
    /// Angle of each line.
    pub(super) omega: Vec<f64>,
    /// Decay of the window per lag.
    pub(super) beta: f64,
    /// Line after line, each row by row.
    values: Vec<Complex64>,
}

/// The lines of a range, counted from zero frequency.
pub(super) struct Lines(RangeInclusive<usize>);

impl Lines {
    pub(super) fn len(&self) -> usize {
        (self.0.end() + 1).saturating_sub(*self.0.start())
    }
}

impl HalfSpectra {
    /// The lines that `options` request at this rate.
    pub(super) fn range(options: &Plscf, rate_hz: f64) -> Lines {
        let count = options.lags + 1;
        let step_hz = rate_hz / count as f64;
        let first = (options.frequency_low_hz / step_hz).ceil() as usize;
        let last = (options.frequency_high_hz / step_hz).min((count / 2) as f64) as usize;
        Lines(first..=last)
    }

    /// Half spectra of `lags`, which are R_0 … R_M in the order of `r`.
    pub(super) fn new(r: &Correlations, lags: &[f64], options: &Plscf) -> Self {
        let (l, n) = (r.channels, options.references.len());
        let count = options.lags + 1;
        let beta = -options.window_end.ln() / options.lags as f64;
        let Lines(range) = Self::range(options, 1.0 / r.step_s);
        let omega: Vec<f64> = range
            .clone()
            .map(|m| 2.0 * PI * m as f64 / count as f64)
            .collect();
        let plan = RealFftPlanner::new().plan_fft_forward(count);
        let (mut time, mut bins) = (plan.make_input_vec(), plan.make_output_vec());
        let mut values = vec![Complex64::ZERO; omega.len() * l * n];
        for o in 0..l {
            for (j, reference) in options.references.iter().enumerate() {
                for (k, t) in time.iter_mut().enumerate() {
                    let weight = if k == 0 { 0.5 } else { (-beta * k as f64).exp() };
                    *t = weight * lags[k * l * l + o * l + reference];
                }
                let _ = plan.process(&mut time, &mut bins); // lengths are the plan's own
                for (line, z) in values.chunks_exact_mut(l * n).zip(&bins[range.clone()]) {
                    line[o * n + j] = Complex64::new(z.re, z.im);
                }
            }
        }
        HalfSpectra {
            channels: l,
            references: n,
            omega,
            beta,
            values,
        }
    }
}

/// Sums over lines; the sums for the highest degree include those for all lower degrees.
pub(super) struct Sums {
    pub(super) channels: usize,
    pub(super) references: usize,
    degree: usize,
    lines: Vec<f64>,
    /// d = -p … p, each row by row.
    cross: Vec<f64>,
    /// d = 0 … p, each row by row.
    square: Vec<f64>,
}

impl Sums {
    pub(super) fn new(spectra: &HalfSpectra, degree: usize) -> Self {
        let (l, n) = (spectra.channels, spectra.references);
        let mut sums = Sums {
            channels: l,
            references: n,
            degree,
            lines: vec![0.0; degree + 1],
            cross: vec![0.0; (2 * degree + 1) * l * n],
            square: vec![0.0; (degree + 1) * n * n],
        };
        let mut product = vec![Complex64::ZERO; n * n];
        for (omega, s) in spectra.omega.iter().zip(spectra.values.chunks_exact(l * n)) {
            product.fill(Complex64::ZERO);
            for row in s.chunks_exact(n) {
                for (a, target) in row.iter().zip(product.chunks_exact_mut(n)) {
                    for (b, x) in row.iter().zip(target) {
                        *x += a.conj() * b;
                    }
                }
            }
            let turn = |d: f64| Complex64::from_polar(1.0, omega * d);
            for (d, sum) in sums.lines.iter_mut().enumerate() {
                *sum += turn(d as f64).re;
            }
            for (d, sum) in sums.cross.chunks_exact_mut(l * n).enumerate() {
                add_real(sum, turn(d as f64 - degree as f64), s);
            }
            for (d, sum) in sums.square.chunks_exact_mut(n * n).enumerate() {
                add_real(sum, turn(d as f64), &product);
            }
        }
        sums
    }

    /// Re Σ Ω* Ω with Ω = [1, z … z^p].   shape: p + 1 square
    pub(super) fn lines_with_lines(&self, degree: usize) -> Matrix {
        Matrix::from_fn(degree + 1, degree + 1, |j, k| self.lines[j.abs_diff(k)])
    }

    /// Re Σ Ω* [S_o, z S_o … z^p S_o] for one output.   shape: p + 1 × r (p + 1)
    pub(super) fn lines_with_spectra(&self, output: usize, degree: usize) -> Matrix {
        let (l, n) = (self.channels, self.references);
        Matrix::from_fn(degree + 1, (degree + 1) * n, |j, column| {
            let d = self.degree + column / n - j;
            self.cross[d * l * n + output * n + column % n]
        })
    }

    /// Re Σ over lines and outputs of [S, z S …]* [S, z S …].   shape: r (p + 1) square
    pub(super) fn spectra_with_spectra(&self, degree: usize) -> Matrix {
        let n = self.references;
        let size = (degree + 1) * n;
        Matrix::from_fn(size, size, |i, j| {
            let (a, b) = (i % n, j % n);
            match (j / n).checked_sub(i / n) {
                Some(d) => self.square[d * n * n + a * n + b],
                None => self.square[(i / n - j / n) * n * n + b * n + a],
            }
        })
    }
}

/// sum += Re(z x).
fn add_real(sum: &mut [f64], z: Complex64, x: &[Complex64]) {
    for (sum, x) in sum.iter_mut().zip(x) {
        *sum += z.re * x.re - z.im * x.im;
    }
}
