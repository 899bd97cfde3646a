//! Time histories of the forces of a turbulent wind on the strips of a face: sums of cosines with random amplitudes.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | Δn | `spacing_hz` | between lines: one over the period of the history | Hz |
//! | A | `factor` | A Aᵀ = S_F, the cross spectra of the forces on the strips at a line | N/√Hz |
//! | c | `GustForces::line_n` | complex amplitude of each strip at a line | N |

use super::GustFace;
use crate::numeric::Random;
use dolmen_linalg::{Complex64, LinalgError, symmetric_eigen};
use rayon::prelude::*;

/// Samples per period of the highest line. Our choice: the largest sample of a single cosine is then at most 1 − cos 45° too small, and lines
/// of such high frequency hardly contribute to sway.
const SAMPLES_PER_LINE: usize = 4;
/// The number of samples is a multiple of this, for a fast Fourier transform. Our choice.
const SMOOTH: f64 = 1200.0;

/// Times of the samples of a history, and the period after which it repeats.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GustTimes {
    /// Time between samples, s.
    pub time_step_s: f64,
    /// Number of samples in a whole period.
    pub samples: usize,
    /// Number of used samples, from the first on.
    pub looked_at: usize,
}

impl GustTimes {
    /// Samples over `duration_s`, from a period of at least `period_least_s`; both positive.
    pub fn new(duration_s: f64, time_step_s: f64, period_least_s: f64) -> Self {
        let whole = duration_s.max(period_least_s);
        // avoids that 600/0.02 is rounded up
        let samples = SMOOTH * (whole / time_step_s / SMOOTH * (1.0 - 1e-12)).ceil();
        GustTimes {
            time_step_s,
            samples: samples as usize,
            looked_at: ((duration_s / time_step_s).round() as usize + 1).min(samples as usize),
        }
    }

    /// Period after which the history repeats, s.
    pub fn period_s(&self) -> f64 {
        self.samples as f64 * self.time_step_s
    }

    /// Δn, Hz.
    pub fn spacing_hz(&self) -> f64 {
        1.0 / self.period_s()
    }

    /// Number of spectral lines, including that at frequency 0.
    pub fn lines(&self) -> usize {
        self.samples / SAMPLES_PER_LINE + 1
    }

    /// The frequency of a line, Hz.
    pub fn frequency_hz(&self, line: usize) -> f64 {
        line as f64 * self.spacing_hz()
    }
}

/// Random numbers of a history: equal seeds and draws give equal histories.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GustDraw {
    /// Seed of the history; any number.
    pub seed: u64,
    /// Number of the history with that seed, for winds at other times or from other sides.
    pub stream: u64,
}

/// One history of the forces on the strips of a face: mean and gusts.
#[derive(Clone, Debug, PartialEq)]
pub struct GustForces {
    /// Its random numbers.
    pub draw: GustDraw,
    /// Times of its samples, and its period.
    pub times: GustTimes,
    /// Mean force on each strip, N.
    pub mean_n: Vec<f64>,
    lines: Vec<Vec<Complex64>>,
}

impl GustForces {
    /// Complex amplitude c of each strip at a line: the gusts are Σ Re[c e^(2πi n t)], N.
    pub fn line_n(&self, line: usize) -> &[Complex64] {
        &self.lines[line]
    }

    /// The force on each strip at a time, N, mean and gusts.
    pub fn at_n(&self, time_s: f64) -> Vec<f64> {
        let mut forces = self.mean_n.clone();
        for (line, amplitudes) in self.lines.iter().enumerate() {
            let turn = std::f64::consts::TAU * (self.times.frequency_hz(line) * time_s).fract();
            let (sin, cos) = turn.sin_cos();
            for (force, c) in forces.iter_mut().zip(amplitudes) {
                *force += c.re * cos - c.im * sin;
            }
        }
        forces
    }
}

impl GustFace {
    /// A history for each draw: a periodic Gaussian process that has the cross spectra of the face at each line.
    ///
    /// ```text
    /// F(t) = F̄ + Σ_k √Δn A(n_k) [a_k cos 2πn_k t + b_k sin 2πn_k t],  n_k = k Δn,  a, b normal     strips
    /// ```
    /// The line at frequency 0 represents half a spacing: it shifts the whole history, as gusts slower than its period do.
    ///
    /// # Errors
    /// [`LinalgError`] if a decomposition fails, as for a face that [`GustFace::check`] refuses.
    ///
    /// # Limits
    /// Gaussian forces. Frequencies above a quarter of the sampling rate are left out. Tested by `gust_histories`.
    ///
    /// # Source
    /// Shinozuka M. & Deodatis G. (1991) Appl. Mech. Rev. 44(4):191–204. Differs from the source: amplitudes are normally distributed (in the
    /// source only phases are random), so that ten minutes scatter like those of a Gaussian process.
    pub fn histories(&self, times: &GustTimes, draws: &[GustDraw]) -> Result<Vec<GustForces>, LinalgError> {
        let strips = self.strips.len();
        let spacing_hz = times.spacing_hz();
        let factors = (0..times.lines()).into_par_iter().map(|line| {
            let hz = times.frequency_hz(line).max(self.lowest_hz());
            let found = symmetric_eigen(&self.force_density_n2_hz(hz))?;
            let width_hz = if line == 0 { 0.5 * spacing_hz } else { spacing_hz };
            // each pair of strips has its own mean speed, which may make a density slightly negative
            let sizes: Vec<f64> = found
                .values
                .iter()
                .map(|s| (s.max(0.0) * width_hz).sqrt())
                .collect();
            let mut factor = found.vectors;
            for (j, size) in sizes.into_iter().enumerate() {
                factor.column_mut(j).iter_mut().for_each(|entry| *entry *= size);
            }
            Ok(factor)
        });
        let factors: Vec<dolmen_linalg::Matrix> = factors.collect::<Result<_, LinalgError>>()?;
        let drawn = draws.par_iter().map(|draw| {
            let mut random = Random::new(draw.seed, draw.stream);
            let mut lines = Vec::with_capacity(factors.len());
            for (line, factor) in factors.iter().enumerate() {
                let mut amplitudes = vec![Complex64::ZERO; strips];
                for j in 0..strips {
                    let (a, b) = (random.normal(), random.normal());
                    let own = Complex64::new(a, if line == 0 { 0.0 } else { -b });
                    for (sum, entry) in amplitudes.iter_mut().zip(factor.column(j)) {
                        *sum += own * *entry;
                    }
                }
                lines.push(amplitudes);
            }
            GustForces {
                draw: *draw,
                times: *times,
                mean_n: self.mean_forces_n(),
                lines,
            }
        });
        Ok(drawn.collect())
    }
}
