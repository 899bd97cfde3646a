//! A record as a sum of exponential decays, fitted to all its samples.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | μ | `roots` | continuous-time eigenvalue -ζω + iω√(1-ζ²) | rad/s |
//! | B | `basis` | Re e^(μt), -Im e^(μt) of every mode | samples × 2K |
//! | D | `slope` | derivatives of the motion with respect to Re μ, Im μ | samples × 2K |

use super::decay_left::{is_shaken, over_white};
use crate::modal::indicators::{assurance, normalized, phase_collinearity};
use crate::modal::{ModalError, Mode};
use crate::signal::Record;
use dolmen_linalg::{Complex64, Matrix, qr, solve};
use std::f64::consts::PI;

pub(super) struct Fit {
    pub(super) roots: Vec<Complex64>,
    /// Amplitude of each mode at each channel: modes × channels.
    amplitudes: Vec<Vec<Complex64>>,
    /// Covariance of (Re μ, Im μ) of all modes.
    covariance: Matrix,
    pub(super) noise: Vec<f64>,
    pub(super) explained: f64,
    /// Energy of each mode over the noise.
    pub(super) energy: Vec<f64>,
    pub(super) rest: Vec<Vec<f64>>,
    /// Standard deviation of each mode over that in white noise of the same power; 1 or more.
    pub(super) over_white: Vec<f64>,
}

/// Keeps the modes that are stronger than white noise, and those that the response of a stronger mode to random forces does not explain: removes the
/// weakest other mode and fits the rest again, until all are significant.
///
/// ```text
/// E_k = Σ_c Σ_t (Re a_kc e^(μ_k t))²/σ_c² > 2 l + 6 ln N        noise alone passes once in N² records: P(χ²₂ > 6 ln N) = N⁻³
/// ```
pub(super) fn significant(
    record: &Record,
    mut roots: Vec<Complex64>,
    order: usize,
) -> Result<Fit, ModalError> {
    let (l, samples) = (record.channels().len(), record.length());
    let least = 2.0 * l as f64 + 6.0 * (samples as f64).ln();
    while !roots.is_empty() {
        let fit = fitted(record, roots)?;
        let mut by_energy: Vec<usize> = (0..fit.roots.len()).collect();
        by_energy.sort_by(|a, b| fit.energy[*a].total_cmp(&fit.energy[*b]));
        let weakest = by_energy.first().copied().filter(|k| fit.energy[*k] < least);
        let removed = match weakest {
            None => fit.of_random_forces(record, &by_energy)?,
            some => some,
        };
        match removed {
            None => return Ok(fit),
            Some(k) => {
                roots = fit.roots;
                roots.remove(k);
            }
        }
    }
    Err(ModalError::NoDecay { order, samples })
}

/// Roots fitted to all samples, starting from these.
fn fitted(record: &Record, mut roots: Vec<Complex64>) -> Result<Fit, ModalError> {
    const STEPS: usize = 12;
    const FAR: f64 = 0.02; // of a root: a longer step leaves what the realization found
    let mut here = Linear::at(record, &roots)?;
    for _ in 0..STEPS {
        let step = here.step()?;
        let longest = step
            .iter()
            .zip(&roots)
            .map(|(d, mu)| d.norm() / mu.norm())
            .fold(0.0, f64::max);
        if longest.is_nan() || !(1e-14..FAR).contains(&longest) {
            break;
        }
        let next: Vec<Complex64> = roots.iter().zip(&step).map(|(mu, d)| mu + d).collect();
        if next.iter().any(|mu| mu.re >= 0.0 || mu.im <= 0.0) {
            break;
        }
        let there = Linear::at(record, &next)?;
        if there.left > here.left {
            break;
        }
        (roots, here) = (next, there);
    }
    let covariance = solve(&here.information, &Matrix::identity(2 * roots.len()))?;
    let of = |(root, amplitudes): (&Complex64, &Vec<Complex64>)| {
        over_white(record, &here.rest, (*root, amplitudes, &here.noise))
    };
    let over_white: Vec<f64> = roots
        .iter()
        .zip(&here.amplitudes)
        .map(of)
        .collect::<Result<_, _>>()?;
    Ok(Fit {
        covariance,
        amplitudes: here.amplitudes,
        noise: here.noise,
        energy: here.energy,
        explained: 1.0 - here.left / here.power.max(f64::MIN_POSITIVE),
        rest: here.rest,
        over_white,
        roots,
    })
}

/// The linear part of the fit for given roots.
struct Linear {
    amplitudes: Vec<Vec<Complex64>>,
    noise: Vec<f64>,
    /// Σ_c Dᵀ(I - P)D/σ_c², and Σ_c Dᵀ(I - P) r/σ_c².
    information: Matrix,
    towards: Vec<f64>,
    energy: Vec<f64>,
    /// Power of the residual, each channel relative to its own power.
    left: f64,
    power: f64,
    rest: Vec<Vec<f64>>,
}

impl Linear {
    fn at(record: &Record, roots: &[Complex64]) -> Result<Self, ModalError> {
        let (samples, k) = (record.length(), roots.len());
        let step_s = 1.0 / record.sampling_rate_hz();
        let wave = |t: usize, k: usize| (roots[k] * (t as f64 * step_s)).exp();
        let basis = Matrix::from_fn(samples, 2 * k, |t, j| {
            let z = wave(t, j / 2);
            if j % 2 == 0 { z.re } else { -z.im }
        });
        let base = qr(&basis)?;
        let free = samples
            .saturating_sub(2 * k + 2 * k / record.channels().len().max(1))
            .max(1) as f64;
        let mut found = Linear {
            amplitudes: vec![Vec::new(); k],
            noise: Vec::new(),
            information: Matrix::zeros(2 * k, 2 * k),
            towards: vec![0.0; 2 * k],
            energy: vec![0.0; k],
            left: 0.0,
            power: 0.0,
            rest: Vec::new(),
        };
        for c in 0..record.channels().len() {
            let y = record.samples(c);
            let along = base.q.transpose_times(&Matrix::from_column(y));
            let coefficients = solve(&base.r, &along)?;
            let model = basis.times(coefficients.column(0));
            let left: Vec<f64> = y.iter().zip(&model).map(|(y, m)| y - m).collect();
            let (power, rest) = (squares(y), squares(&left));
            found.power += 1.0;
            found.left += rest / power.max(f64::MIN_POSITIVE);
            // an exact decay leaves only rounding: the limit keeps the weights finite
            let variance = (rest / free)
                .max((1e-15_f64).powi(2) * power / samples as f64)
                .max(f64::MIN_POSITIVE);
            found.noise.push((rest / free).sqrt());
            let amplitudes: Vec<Complex64> = (0..k)
                .map(|k| Complex64::new(coefficients[(2 * k, 0)], coefficients[(2 * k + 1, 0)]))
                .collect();
            for (mode, (a, energy)) in amplitudes.iter().zip(&mut found.energy).enumerate() {
                let motion = (0..samples).map(|t| (a * wave(t, mode)).re.powi(2));
                *energy += motion.sum::<f64>() / variance;
            }
            let slope = Matrix::from_fn(samples, 2 * k, |t, j| {
                let z = amplitudes[j / 2] * wave(t, j / 2) * (t as f64 * step_s);
                if j % 2 == 0 { z.re } else { -z.im }
            });
            let within = base.q.transpose_times(&slope);
            let whole = slope.transpose_times(&slope);
            let taken = within.transpose_times(&within);
            let gradient = slope.transpose_times(&Matrix::from_column(&left));
            for i in 0..2 * k {
                found.towards[i] += gradient[(i, 0)] / variance;
                for j in 0..2 * k {
                    found.information[(i, j)] += (whole[(i, j)] - taken[(i, j)]) / variance;
                }
            }
            for (of_mode, a) in found.amplitudes.iter_mut().zip(amplitudes) {
                of_mode.push(a);
            }
            found.rest.push(left);
        }
        Ok(found)
    }

    /// Gauss–Newton step of the roots.
    fn step(&self) -> Result<Vec<Complex64>, ModalError> {
        let step = solve(&self.information, &Matrix::from_column(&self.towards))?;
        let pairs = step.column(0).chunks_exact(2);
        Ok(pairs.map(|d| Complex64::new(d[0], d[1])).collect())
    }
}

impl Fit {
    /// The weakest mode that the response of a stronger one with the same shape to random forces explains.
    fn of_random_forces(&self, record: &Record, by_energy: &[usize]) -> Result<Option<usize>, ModalError> {
        const ALIKE: f64 = 0.9; // MAC
        for (at, weak) in by_energy.iter().enumerate() {
            let is_alike = |of: &&usize| assurance(&self.amplitudes[**of], &self.amplitudes[*weak]) >= ALIKE;
            for strong in by_energy[at + 1..].iter().filter(is_alike) {
                let [strong, weak] = [*strong, *weak].map(|k| (self.roots[k], self.amplitudes[k].as_slice()));
                if is_shaken(record, (&self.rest, &self.noise), strong, weak)? {
                    return Ok(Some(by_energy[at]));
                }
            }
        }
        Ok(None)
    }

    pub(super) fn mode(&self, k: usize, duration_s: f64, order: usize) -> Mode {
        let mu = self.roots[k];
        let omega = mu.norm();
        let var = |i: usize, j: usize| self.covariance[(2 * k + i, 2 * k + j)];
        let sd = |g: [f64; 2]| {
            let v = g[0] * g[0] * var(0, 0) + 2.0 * g[0] * g[1] * var(0, 1) + g[1] * g[1] * var(1, 1);
            self.over_white[k] * v.max(0.0).sqrt()
        };
        let along = [mu.re / omega, mu.im / omega]; // dω
        let of_damping = [
            -1.0 / omega + mu.re * along[0] / (omega * omega),
            mu.re * along[1] / (omega * omega),
        ];
        let shape = normalized(&self.amplitudes[k]);
        Mode {
            frequency_hz: omega / (2.0 * PI),
            frequency_sd_hz: Some(sd(along) / (2.0 * PI)),
            frequency_changes_hz: Vec::new(),
            damping_ratio: Some(-mu.re / omega),
            damping_ratio_sd: Some(sd(of_damping)),
            phase_collinearity: phase_collinearity(&shape),
            shape,
            shape_sd: None,
            cycles: omega / (2.0 * PI) * duration_s,
            orders: vec![order],
            kurtosis: None,
            wander: None,
            window_bias: None,
            accepted: None,
        }
    }
}

fn squares(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum()
}
