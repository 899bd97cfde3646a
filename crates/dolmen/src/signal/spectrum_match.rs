//! Spectrum matching: adds wavelets to a motion until its response spectrum equals a target.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | T, ω, ζ | `period_s`, `omega`, `zeta` | period, angular frequency and damping ratio of an oscillator | s, rad/s, – |
//! | t_i | `at_s` | time of the peak of oscillator i | s |
//! | f_j, γ_j | `frequency_hz`, `gamma` | frequency of wavelet j, width of its envelope | Hz, s |
//! | b_j | `b` | amplitude of wavelet j | m/s² |
//! | C_ij | `c` | response of oscillator i at t_i to wavelet j, over its target | s²/m |
//! | δ_i | `misfit` | (target − ordinate)/target | – |

use super::at_rest::{bring_to_rest, edges};
use super::response_spectrum::{SignedPeak, signed_peaks};
use super::{Component, GroundMotion, Processing, SignalError};
use dolmen_linalg::{Matrix, solve_least_squares};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Width of a wavelet, s: 1.178 f^−0.93 (Al Atik, Abrahamson 2010, eq. 12).
const GAMMA: [f64; 2] = [1.178, -0.93];
/// Half length of a wavelet, in widths: beyond it the height is below e^−12 of the peak.
const WIDTHS: f64 = 3.5;
/// A free oscillation is computed until this fraction of it remains.
const SWING_LEFT: f64 = 1e-4;
/// Length of the ramps of wavelets to zero at both ends of the motion, s. Our choice.
const EDGE_S: f64 = 0.5;
/// Initial weight of the amplitudes in the least squares, as a fraction of the largest column of C; and the factor by which the weight changes.
const WEIGHT: f64 = 0.1;
const WEIGHT_FACTORS: [f64; 2] = [0.5, 3.0];
/// Relative gain of the misfit that counts as progress; and the number of successive rounds without progress that ends the search.
const GAIN_LEAST: f64 = 0.01;
const IDLE_ROUNDS_MOST: usize = 6;

/// Options of the match.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpectrumMatch {
    /// Shortest period, s. Default 0.1.
    pub period_least_s: f64,
    /// Longest period, s. Default 3.
    pub period_most_s: f64,
    /// Damping ratio of the spectrum. Default 0.05.
    pub damping_ratio: f64,
    /// Number of periods at which the spectrum is compared with the target, evenly spaced in their logarithm; each round adds half as many
    /// wavelets. Default 150: their spacing is less than the width of a resonance with 5 % damping.
    pub periods: usize,
    /// Root mean square of the misfit at which the match is good enough. Default 0.01.
    pub misfit_enough: f64,
    /// Largest number of rounds. Default 40.
    pub rounds_most: usize,
}

impl Default for SpectrumMatch {
    fn default() -> Self {
        SpectrumMatch {
            period_least_s: 0.1,
            period_most_s: 3.0,
            damping_ratio: 0.05,
            periods: 150,
            misfit_enough: 0.01,
            rounds_most: 40,
        }
    }
}

/// Difference of a spectrum from its target: ordinate / target − 1 over the periods.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SpectrumMisfit {
    /// Root mean square.
    pub root_mean_square: f64,
    /// The lowest: −0.1 where an ordinate falls 10 % short.
    pub lowest: f64,
    /// The highest.
    pub highest: f64,
}

/// A motion matched to a spectrum, with its evidence.
#[derive(Clone, Debug, PartialEq)]
pub struct MatchedMotion {
    /// The motion; only the matched component is changed.
    pub motion: GroundMotion,
    /// Factor on the seed motion before any wavelet.
    pub factor: f64,
    /// Misfit of the scaled seed motion.
    pub before: SpectrumMisfit,
    /// Misfit of the matched motion.
    pub after: SpectrumMisfit,
    /// Number of rounds of wavelets.
    pub rounds: usize,
    /// Periods, s.
    pub periods_s: Vec<f64>,
    /// Target at each period, m/s².
    pub target_m_s2: Vec<f64>,
    /// Pseudo-acceleration of the matched motion at each period, m/s².
    pub matched_m_s2: Vec<f64>,
}

/// Adds wavelets to one component until its pseudo-acceleration spectrum equals the target, which is a function of the period.
///
/// ```text
/// wavelet j       w_j(t) = cos(ω_j √(1−ζ²) (t − t_j + Δ_j)) e^(−((t − t_j + Δ_j)/γ_j)²) − line × envelope
///                 Δ_j = atan(√(1−ζ²)/ζ) / (ω_j √(1−ζ²))       γ_j = 1.178 f_j^−0.93
/// a round         min ‖C b − δ‖² + λ² ‖b‖²        C_ij = ω_i² u_i(t_i; w_j) sign(u_i) / target_i
///                                                 shape: periods × wavelets
/// ```
/// t_j is the peak time of the oscillator with the same period. The small term line × envelope brings the ground to rest after each wavelet;
/// such a term also brings the scaled seed to rest first. So the final velocity and displacement are zero for every motion whose first and last
/// samples are zero. λ falls after a round that reduces the misfit; any other round is undone, and λ rises.
///
/// # Errors
/// [`SignalError::Argument`] for options out of range or a target that is not positive; [`SignalError::NoMotion`];
/// [`SignalError::Period`]; [`SignalError::Numeric`].
///
/// # Limits
/// There is no guarantee for the misfit, so the result contains it. A misfit remains if the seed is too short for the longest period, or if no
/// such seed can reach the target. El Centro 1940 to the spectrum of KDS 17 10 00 (zone I, 2400 years, S4), 0.1 to 3 s: see the tests.
///
/// # Source
/// Al Atik, Abrahamson (2010) Earthquake Spectra 26(3):601-617, eqs 3-12, the improved tapered cosine wavelet. Differs from the source: there
/// are more periods than wavelets, in regularised least squares, instead of equal numbers with reduced off-diagonal terms; and each sampled
/// wavelet is brought to rest exactly, also if the beginning of the record cuts it off.
pub fn match_spectrum(
    motion: &GroundMotion,
    component: Component,
    target_m_s2: &dyn Fn(f64) -> f64,
    options: &SpectrumMatch,
) -> Result<MatchedMotion, SignalError> {
    let seed = motion.acceleration_m_s2(component);
    let matching = Matching::new(motion, component, target_m_s2, options)?;
    let first = matching.peaks(seed)?;
    // the factor that makes the mean logarithm of ordinate / target zero
    let logarithms = matching.ratios(&first).into_iter().map(f64::ln);
    let factor = (-logarithms.sum::<f64>() / matching.periods_s.len() as f64).exp();
    if !factor.is_finite() {
        return Err(SignalError::NoMotion {
            component: component.name(),
            peak_m_s2: motion.component_peak_m_s2(component),
        });
    }
    let mut best: Vec<f64> = seed.iter().map(|a| factor * a).collect();
    let ramp = matching.ramp();
    bring_to_rest(&mut best, 0, 0.5 * seed.len() as f64, |i| {
        edges(i, seed.len(), ramp)
    });
    let mut peaks = matching.peaks(&best)?;
    let before = misfit(&matching.ratios(&peaks));
    let (mut after, mut rounds, mut weight, mut idle) = (before, 0, WEIGHT, 0);
    let mut amplitudes = matching.prepared(&peaks);
    for _ in 0..options.rounds_most {
        if after.root_mean_square <= options.misfit_enough || idle >= IDLE_ROUNDS_MOST {
            break;
        }
        let tried = matching.added(&best, &amplitudes, weight)?;
        let tried_peaks = matching.peaks(&tried)?;
        let found = misfit(&matching.ratios(&tried_peaks));
        let gained = found.root_mean_square < after.root_mean_square;
        let much = found.root_mean_square < (1.0 - GAIN_LEAST) * after.root_mean_square;
        idle = if much { 0 } else { idle + 1 };
        weight *= WEIGHT_FACTORS[usize::from(!gained)];
        if gained {
            (best, peaks, after) = (tried, tried_peaks, found);
            amplitudes = matching.prepared(&peaks);
            rounds += 1;
        }
    }
    let series = Component::ALL
        .into_iter()
        .filter(|one| motion.has(*one) || *one == component);
    let series = series.map(|one| {
        (
            one,
            if one == component {
                best.clone()
            } else {
                motion.acceleration_m_s2(one).to_vec()
            },
        )
    });
    let mut matched = GroundMotion::new(motion.name(), motion.time_step_s(), series.collect())?;
    motion
        .history()
        .iter()
        .for_each(|step| matched.note(step.clone()));
    matched.note(Processing::Matched {
        component: component.name(),
        damping_ratio: options.damping_ratio,
        period_least_s: options.period_least_s,
        period_most_s: options.period_most_s,
    });
    let ratios = matching.ratios(&peaks);
    Ok(MatchedMotion {
        motion: matched,
        factor,
        before,
        after,
        rounds,
        matched_m_s2: ratios
            .iter()
            .zip(&matching.target)
            .map(|(ratio, target)| ratio * target)
            .collect(),
        target_m_s2: matching.target,
        periods_s: matching.periods_s,
    })
}

fn misfit(ratios: &[f64]) -> SpectrumMisfit {
    let squares: f64 = ratios.iter().map(|ratio| (ratio - 1.0).powi(2)).sum();
    SpectrumMisfit {
        root_mean_square: (squares / ratios.len() as f64).sqrt(),
        lowest: ratios
            .iter()
            .fold(f64::INFINITY, |low, ratio| low.min(ratio - 1.0)),
        highest: ratios
            .iter()
            .fold(f64::NEG_INFINITY, |high, ratio| high.max(ratio - 1.0)),
    }
}

struct Matching {
    h: f64,
    length: usize,
    zeta: f64,
    periods_s: Vec<f64>,
    target: Vec<f64>,
}

/// The wavelets of a round and the matrix of their responses.
struct MatchingRound {
    wavelets: Vec<Wavelet>,
    c: Matrix,
    misfit: Vec<f64>,
}

/// One wavelet: its samples from sample `first` on.
struct Wavelet {
    first: usize,
    samples: Vec<f64>,
}

impl Matching {
    fn new(
        motion: &GroundMotion,
        component: Component,
        target_m_s2: &dyn Fn(f64) -> f64,
        options: &SpectrumMatch,
    ) -> Result<Self, SignalError> {
        let refuse = |argument, given, allowed| {
            Err(SignalError::Argument {
                argument,
                given,
                allowed,
            })
        };
        let (least, most) = (options.period_least_s, options.period_most_s);
        if !(least > 0.0 && most > 1.1 * least) {
            return refuse(
                "period_most_s",
                most,
                "above period_least_s by a tenth of it or more",
            );
        }
        if !(8..=1000).contains(&options.periods) {
            return refuse("periods", options.periods as f64, "8 to 1000");
        }
        if !(0.005..=0.5).contains(&options.damping_ratio) {
            return refuse(
                "damping_ratio",
                options.damping_ratio,
                "0.005 to 0.5: is it in percent?",
            );
        }
        let count = options.periods;
        let period = |k: usize| least * (most / least).powf(k as f64 / (count - 1) as f64);
        let periods_s: Vec<f64> = (0..count).map(period).collect();
        let target: Vec<f64> = periods_s.iter().map(|period| target_m_s2(*period)).collect();
        if let Some(bad) = target.iter().find(|value| !(value.is_finite() && **value > 0.0)) {
            return refuse("target_m_s2", *bad, "a positive number at every period");
        }
        super::response_spectrum(motion, component, &[least, most], options.damping_ratio)?; // refuses periods
        Ok(Matching {
            h: motion.time_step_s(),
            length: motion.length(),
            zeta: options.damping_ratio,
            periods_s,
            target,
        })
    }

    fn peaks(&self, samples: &[f64]) -> Result<Vec<SignedPeak>, SignalError> {
        signed_peaks(samples, self.h, &self.periods_s, self.zeta)
    }

    /// Spectral ordinates over their targets.
    fn ratios(&self, peaks: &[SignedPeak]) -> Vec<f64> {
        let each = peaks.iter().zip(&self.periods_s).zip(&self.target);
        each.map(|((peak, period), target)| (TAU / period).powi(2) * peak.displacement_m.abs() / target)
            .collect()
    }

    /// Wavelets at the peaks of every second period, and their effects on all peaks.
    fn prepared(&self, peaks: &[SignedPeak]) -> MatchingRound {
        let chosen = (0..peaks.len()).step_by(2);
        let wavelets: Vec<Wavelet> = chosen
            .map(|j| self.wavelet(self.periods_s[j], peaks[j].at_s))
            .collect();
        let mut c = Matrix::zeros(peaks.len(), wavelets.len());
        for (i, peak) in peaks.iter().enumerate() {
            let omega = TAU / self.periods_s[i];
            let weights = self.influence(omega, peak.at_s);
            let scale = omega * omega * peak.displacement_m.signum() / self.target[i];
            for (j, wavelet) in wavelets.iter().enumerate() {
                let from = wavelet.first.max(weights.first);
                let to = (wavelet.first + wavelet.samples.len()).min(weights.first + weights.samples.len());
                if from < to {
                    let a = &wavelet.samples[from - wavelet.first..to - wavelet.first];
                    let w = &weights.samples[from - weights.first..to - weights.first];
                    c.column_mut(j)[i] = scale * a.iter().zip(w).map(|(a, w)| a * w).sum::<f64>();
                }
            }
        }
        let misfit = self.ratios(peaks).into_iter().map(|ratio| 1.0 - ratio).collect();
        MatchingRound { wavelets, c, misfit }
    }

    /// Number of samples in the ramps of wavelets at both ends.
    fn ramp(&self) -> usize {
        ((EDGE_S / self.h) as usize).clamp(1, self.length / 2)
    }

    /// The wavelet for an oscillator of this period with a peak at this time.
    fn wavelet(&self, period_s: f64, at_s: f64) -> Wavelet {
        let under = (1.0 - self.zeta * self.zeta).sqrt();
        let omega_d = TAU / period_s * under;
        let gamma = GAMMA[0] * period_s.powf(-GAMMA[1]);
        let centre_s = at_s - (under / self.zeta).atan() / omega_d;
        let sample = |t: f64| (t / self.h).clamp(0.0, (self.length - 1) as f64);
        let first = sample(centre_s - WIDTHS * gamma).floor() as usize;
        let last = sample(centre_s + WIDTHS * gamma).ceil() as usize;
        let ramp = self.ramp();
        let envelope = |i: usize| {
            let t = i as f64 * self.h - centre_s;
            (-(t / gamma).powi(2)).exp() * edges(i, self.length, ramp)
        };
        let shape = |i: usize| (omega_d * (i as f64 * self.h - centre_s)).cos() * envelope(i);
        let mut samples: Vec<f64> = (first..=last).map(shape).collect();
        bring_to_rest(&mut samples, first, centre_s / self.h, envelope);
        Wavelet { first, samples }
    }

    /// ∂u(t*)/∂a_k for every sample k before t*: the closed-form response to a triangular pulse at one sample.
    ///
    /// ```text
    /// u(t*) = −∫ Im e^(s (t* − τ))/ω_D a(τ) dτ     s = −ζω + i ω_D     hat of width 2h: h (sinh(sh/2)/(sh/2))²
    /// ```
    fn influence(&self, omega: f64, at_s: f64) -> Wavelet {
        let s = Complex64::new(-self.zeta * omega, omega * (1.0 - self.zeta * self.zeta).sqrt());
        let half = 0.5 * self.h * s;
        let hat = self.h * (half.sinh() / half).powi(2) / s.im;
        let last = ((at_s / self.h).floor() as usize).min(self.length - 1);
        let reach = (-SWING_LEFT.ln() / (self.zeta * omega * self.h)).ceil() as usize;
        let first = last.saturating_sub(reach);
        let mut swing = (s * (at_s - last as f64 * self.h)).exp() * hat;
        let step = (s * self.h).exp();
        let mut samples = vec![0.0; last - first + 1];
        for sample in samples.iter_mut().rev() {
            *sample = -swing.im;
            swing *= step;
        }
        Wavelet { first, samples }
    }

    /// The motion with the wavelets of a round added.
    fn added(&self, samples: &[f64], round: &MatchingRound, weight: f64) -> Result<Vec<f64>, SignalError> {
        let (rows, columns) = (round.c.rows(), round.c.columns());
        let size = |j: usize| round.c.column(j).iter().map(|c| c * c).sum::<f64>().sqrt();
        let largest = (0..columns).map(size).fold(0.0, f64::max);
        let a = Matrix::from_fn(rows + columns, columns, |i, j| match i.checked_sub(rows) {
            None => round.c.column(j)[i],
            Some(k) if k == j => weight * largest,
            Some(_) => 0.0,
        });
        let mut right = round.misfit.clone();
        right.resize(rows + columns, 0.0);
        let b =
            solve_least_squares(&a, &Matrix::from_column(&right)).map_err(|fault| SignalError::Match {
                why: fault.to_string(),
            })?;
        let mut sum = samples.to_vec();
        for (wavelet, b) in round.wavelets.iter().zip(b.column(0)) {
            let part = &mut sum[wavelet.first..wavelet.first + wavelet.samples.len()];
            part.iter_mut()
                .zip(&wavelet.samples)
                .for_each(|(a, w)| *a += b * w);
        }
        Ok(sum)
    }
}
