//! The modes of one band of the spectrum and all other motion in it, as free parameters.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | D | `Spectra` | expected cross spectra of the modes under unit force densities | m × m |
//! | Ψ, P, B | `shapes`, `forces`, `noise` | shapes in the coordinates of the fit; spectral densities of the
//! modal forces, and of all other motion | r × m, m × m, r × r |
//! | a, b | `rise`, `tilt` | exponents of the frequency in the force density, and in the density of all other motion | - |
//! | S | | (f/f_m)^a Ψ (P ∘ D) Ψ* + (f/f_m)^b B | r × r |
//! | Q | `quiet` | prior of B, of the weight of one line | r × r |

use super::band_motion::{Oscillator, Spectra};
use super::hermitian::{Part, add_hermitian, adjoint, hermitian, lower, plus, real, scaled, times, whitened};
use dolmen_linalg::{Complex64, ComplexMatrix, Matrix};

const DAMPING_MOST: f64 = 0.5;
/// Largest exponent of the frequency, positive or negative.
const RISE_MOST: f64 = 20.0;
/// Largest logarithm of the ratio of the densities at the ends of a band with free noise.
const ACROSS_MOST: f64 = 10.0;
/// Largest coherence between the forces of two modes.
const COHERENCE_MOST: f64 = 0.999;

/// A frequency band and the unknowns of its modes.
#[derive(Clone, Debug)]
pub(super) struct Band {
    pub(super) oscillators: Vec<Oscillator>,
    pub(super) shapes: ComplexMatrix,
    pub(super) forces: ComplexMatrix,
    pub(super) noise: ComplexMatrix,
    /// Whether the forces of different modes are independent.
    pub(super) independent: bool,
    /// Lowest and highest line, Hz: `forces` holds at their geometric mean.
    pub(super) range_hz: [f64; 2],
    /// Exponent of the frequency in the force density.
    pub(super) rise: f64,
    /// Exponent of the frequency in the density of all other motion, and its prior, if it is free.
    pub(super) tilt: Option<Tilt>,
}

/// A free density of all other motion: a mode that hides it, or a band that is narrow, must not drive it out of what is possible.
#[derive(Clone, Debug)]
pub(super) struct Tilt {
    /// Exponent of the frequency.
    pub(super) exponent: f64,
    /// Q: density that one line more, on which the modes are silent, is taken to show.
    pub(super) quiet: ComplexMatrix,
}

/// One real free parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Free {
    Frequency(usize),
    Damping(usize),
    Shape(usize, usize, Part),
    Force(usize, usize, Part),
    Noise(usize, usize, Part),
    Rise,
    Tilt,
}

impl Band {
    pub(super) fn free(&self) -> Vec<Free> {
        let (r, m) = (self.shapes.rows(), self.oscillators.len());
        let mut free: Vec<Free> = (0..m)
            .flat_map(|i| [Free::Frequency(i), Free::Damping(i)])
            .collect();
        for mode in 0..m {
            let norm = |row: &usize| self.shapes[(*row, mode)].norm();
            let held = (0..r).max_by(|a, b| norm(a).total_cmp(&norm(b)));
            for row in (0..r).filter(|row| Some(*row) != held) {
                free.extend([Part::Real, Part::Imaginary].map(|part| Free::Shape(row, mode, part)));
            }
        }
        let together = hermitian(m).filter(|(i, j, _)| i == j || !self.independent);
        free.extend(together.map(|(i, j, part)| Free::Force(i, j, part)));
        free.extend(hermitian(r).map(|(i, j, part)| Free::Noise(i, j, part)));
        free.extend((m > 0).then_some(Free::Rise));
        free.extend(self.tilt.is_some().then_some(Free::Tilt));
        free
    }

    pub(super) fn moved(&self, free: &[Free], step: &[f64]) -> Band {
        let mut to = self.clone();
        for (free, by) in free.iter().zip(step) {
            match *free {
                Free::Frequency(i) => to.oscillators[i].frequency_hz += by,
                Free::Damping(i) => to.oscillators[i].damping_ratio += by,
                Free::Shape(row, mode, part) => to.shapes[(row, mode)] += by * part.unit(),
                Free::Force(i, j, part) => add_hermitian(&mut to.forces, (i, j), by * part.unit()),
                Free::Noise(i, j, part) => add_hermitian(&mut to.noise, (i, j), by * part.unit()),
                Free::Rise => to.rise += by,
                Free::Tilt => to.tilt.iter_mut().for_each(|tilt| tilt.exponent += by),
            }
        }
        for i in 0..to.oscillators.len() {
            for j in 0..i {
                let most = COHERENCE_MOST * (to.forces[(i, i)].re * to.forces[(j, j)].re).max(0.0).sqrt();
                let norm = to.forces[(i, j)].norm();
                if norm > most {
                    let held = to.forces[(i, j)] * (most / norm);
                    to.forces[(i, j)] = held;
                    to.forces[(j, i)] = held.conj();
                }
            }
        }
        to
    }

    pub(super) fn possible(&self) -> bool {
        let m = self.oscillators.len();
        let damped = |o: &Oscillator| o.damping_ratio > 0.0 && o.damping_ratio < DAMPING_MOST;
        let most = self.exponent_most();
        self.rise.abs() < most
            && self.tilt.as_ref().is_none_or(|tilt| tilt.exponent.abs() < most)
            && self.oscillators.iter().all(|o| damped(o) && o.frequency_hz > 0.0)
            && (0..m).all(|i| self.forces[(i, i)].re > 0.0)
    }

    /// Largest exponent of the frequency. Where noise may be the skirt of a mode beside the band, it is as steep as in any band.
    fn exponent_most(&self) -> f64 {
        let [low, high] = self.range_hz;
        let reach = (high / low).ln().max(f64::MIN_POSITIVE);
        match &self.tilt {
            Some(_) => RISE_MOST.max(ACROSS_MOST / reach),
            None => RISE_MOST,
        }
    }

    pub(super) fn coherence(&self) -> f64 {
        let m = self.oscillators.len();
        let of = |i: usize, j: usize| {
            self.forces[(i, j)].norm() / (self.forces[(i, i)].re * self.forces[(j, j)].re).sqrt()
        };
        (0..m)
            .flat_map(|i| (0..i).map(move |j| of(i, j)))
            .fold(0.0, f64::max)
    }

    /// S = (f/f_m)^a Ψ (P ∘ D) Ψ* + (f/f_m)^b B.
    pub(super) fn expected(&self, d: &ComplexMatrix, frequency_hz: f64) -> ComplexMatrix {
        let motion = self.along_shapes(&self.under_forces(d));
        let noise = scaled(&self.noise, self.tilted(frequency_hz));
        plus(&scaled(&motion, self.risen(frequency_hz)), &noise)
    }

    /// Density of all other motion relative to that at the middle of the band.
    fn tilted(&self, frequency_hz: f64) -> f64 {
        let tilted = |tilt: &Tilt| (tilt.exponent * self.logarithm(frequency_hz)).exp();
        self.tilt.as_ref().map_or(1.0, tilted)
    }

    /// Logarithm of the prior of B and of the exponents; 0 if B has no exponent. `None` if B is no density.
    ///
    /// ```text
    /// - ln det B - tr B⁻¹ Q - (a² + b²)/2s²
    /// ```
    pub(super) fn log_prior(&self) -> Option<f64> {
        let Some(tilt) = &self.tilt else { return Some(0.0) };
        let lower = lower(&self.noise)?;
        let white = whitened(&lower, &tilt.quiet);
        let each = (0..white.rows()).map(|i| 2.0 * lower[(i, i)].re.ln() + white[(i, i)].re);
        let exponents = (self.rise.powi(2) + tilt.exponent.powi(2)) / self.exponent_variance();
        Some(-each.sum::<f64>() - 0.5 * exponents)
    }

    /// Adds its slopes and its information.
    pub(super) fn add_prior(
        &self,
        free: &[Free],
        gradient: &mut [f64],
        information: &mut Matrix,
    ) -> Option<()> {
        let Some(tilt) = &self.tilt else { return Some(()) };
        let r = self.noise.rows();
        let lower = lower(&self.noise)?;
        let white = whitened(&lower, &tilt.quiet);
        let left = real(&ComplexMatrix::from_fn(r, r, |i, j| {
            white[(i, j)] - f64::from(u8::from(i == j))
        }));
        let slope = |free: &Free| match *free {
            Free::Noise(i, j, part) => {
                let mut unit = ComplexMatrix::zeros(r, r);
                add_hermitian(&mut unit, (i, j), part.unit());
                Some(real(&whitened(&lower, &unit)))
            }
            _ => None,
        };
        let slopes: Vec<Option<Vec<f64>>> = free.iter().map(slope).collect();
        let inner = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
        for (a, of) in free.iter().enumerate() {
            let exponent = match of {
                Free::Rise => Some(self.rise),
                Free::Tilt => Some(tilt.exponent),
                _ => None,
            };
            if let Some(exponent) = exponent {
                gradient[a] -= exponent / self.exponent_variance();
                information[(a, a)] += self.exponent_variance().recip();
            }
            let Some(slope) = &slopes[a] else { continue };
            gradient[a] += inner(slope, &left);
            for (b, other) in slopes.iter().enumerate() {
                information[(a, b)] += other.as_ref().map_or(0.0, |other| inner(slope, other));
            }
        }
        Some(())
    }

    /// s²: the largest exponent is four deviations off.
    fn exponent_variance(&self) -> f64 {
        (0.25 * self.exponent_most()).powi(2)
    }

    /// Force density relative to that at the middle of the band; constant outside the band.
    pub(super) fn risen(&self, frequency_hz: f64) -> f64 {
        (self.rise * self.logarithm(frequency_hz)).exp()
    }

    fn logarithm(&self, frequency_hz: f64) -> f64 {
        let [low, high] = self.range_hz;
        (frequency_hz.clamp(low, high) / (low * high).sqrt()).ln()
    }

    /// P ∘ D.
    pub(super) fn under_forces(&self, d: &ComplexMatrix) -> ComplexMatrix {
        let m = self.oscillators.len();
        ComplexMatrix::from_fn(m, m, |i, j| self.forces[(i, j)] * d[(i, j)])
    }

    /// Ψ X Ψ*.
    fn along_shapes(&self, x: &ComplexMatrix) -> ComplexMatrix {
        times(&times(&self.shapes, x), &adjoint(&self.shapes))
    }

    /// ∂S with respect to one free parameter.
    pub(super) fn derivative(
        &self,
        free: Free,
        spectra: &Spectra,
        frequency_hz: f64,
        d: &ComplexMatrix,
    ) -> ComplexMatrix {
        let (r, m) = (self.noise.rows(), self.oscillators.len());
        let forces = self.risen(frequency_hz);
        let ln = self.logarithm(frequency_hz);
        let moving = |x: &ComplexMatrix| scaled(&self.along_shapes(&self.under_forces(x)), forces);
        let with_adjoint =
            |a: ComplexMatrix| ComplexMatrix::from_fn(r, r, |i, j| a[(i, j)] + a[(j, i)].conj());
        match free {
            Free::Frequency(i) => moving(&spectra.slope(2 * i, frequency_hz)),
            Free::Damping(i) => moving(&spectra.slope(2 * i + 1, frequency_hz)),
            Free::Rise => scaled(&moving(d), ln),
            Free::Shape(row, mode, part) => {
                let right = times(&self.under_forces(d), &adjoint(&self.shapes));
                with_adjoint(ComplexMatrix::from_fn(r, r, |i, j| {
                    if i == row {
                        forces * part.unit() * right[(mode, j)]
                    } else {
                        Complex64::default()
                    }
                }))
            }
            Free::Force(a, b, part) => {
                let mut unit = ComplexMatrix::zeros(m, m);
                add_hermitian(&mut unit, (a, b), part.unit());
                let seen = ComplexMatrix::from_fn(m, m, |i, j| unit[(i, j)] * d[(i, j)]);
                scaled(&self.along_shapes(&seen), forces)
            }
            Free::Noise(a, b, part) => {
                let mut unit = ComplexMatrix::zeros(r, r);
                add_hermitian(&mut unit, (a, b), part.unit());
                scaled(&unit, self.tilted(frequency_hz))
            }
            Free::Tilt => scaled(&self.noise, ln * self.tilted(frequency_hz)),
        }
    }
}
