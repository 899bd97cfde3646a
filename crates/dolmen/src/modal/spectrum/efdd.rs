//! Enhanced and spatial frequency domain decomposition: damping from the peaks of the spectrum.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | S(f), s_k, u_k | | spectral matrix, its singular values and vectors (fdd.rs) |
//! | φ | `phi` | u_1 at the top of the peak |
//! | b(f) | `bell` | part of the spectrum that belongs to the mode |
//! | a(τ) | `decay` | correlation of the mode, complex: its modulus decays, its phase rotates |
//! | w(τ) | `parzen` | window of the correlations behind S |

use super::fdd::{Fdd, FddResult, peaks_of};
use super::spectral_matrices::{SpectralMatrices, parzen};
use crate::modal::error::refused;
use crate::modal::indicators::assurance;
use crate::modal::{Criteria, Method, ModalError, Mode};
use crate::signal::Record;
use dolmen_linalg::{Complex64, hermitian_eigen};
use std::f64::consts::PI;

/// Amplitudes, over the initial one, between which the decay is fitted. The truncated bell distorts larger amplitudes; noise distorts smaller ones.
const FIT_FROM: f64 = 0.85;
const FIT_TO: f64 = 0.25;
/// Least value of the window for which its effect is removed from the decay: for smaller values the division would amplify noise.
const WINDOW_LEAST: f64 = 0.12;
const POINTS_LEAST: usize = 5;
/// Number of points of the decay in one inverse width of the bell.
const POINTS_A_WIDTH: f64 = 40.0;

/// Largest height, relative to the peak, at which another mode may cut off the bell. A bell cut off higher is too narrow for its damping: the error
/// is -30 to -80 % for the close modes of the twisting building, which are cut off above a quarter.
const CUT_MOST: f64 = 0.06;

/// Largest distance between the frequency of a decay and its peak, in lines; or half the width of the peak if that is larger. Our choice.
const LINES_AWAY: f64 = 4.0;

/// Options of [`efdd`].
#[derive(Clone, Debug, PartialEq)]
pub struct Efdd {
    /// The spectrum and its peaks.
    pub fdd: Fdd,
    /// `Efdd` (default): the bell is the singular value whose vector is similar to φ; `Fsdd`: φ* S φ.
    pub method: Method,
    /// Least MAC between φ and the singular vector of a line in the bell; default 0.8 (Jacobsen's group uses 0.8 to 0.95; pyOMA2 0.85).
    pub assurance_least: f64,
}

impl Default for Efdd {
    fn default() -> Self {
        Efdd {
            fdd: Fdd::default(),
            method: Method::Efdd,
            assurance_least: 0.8,
        }
    }
}

/// Modes at the peaks of the spectrum, with damping from the decay of the correlation of each peak.
///
/// ```text
/// b(f) = s_k(f) where MAC(u_k(f), φ) ≥ assurance_least (EFDD);  φ* S(f) φ there (FSDD)      lines about the peak, to the saddles beside it
/// a(τ) = Σ b(f) e^(2πi f τ) / w(τ)
/// ln |a| falls with -ζωτ;  arg a turns with ω√(1-ζ²) τ                straight lines from |a| = 0.85 to 0.25 of a(0)
/// ```
/// The decay is divided by the window w, which removes most of the bias of damping due to short correlations; `Mode::window_bias` gives the removed
/// bias.
///
/// # Errors
/// As [`fdd`](crate::modal::fdd()). A peak has no damping if its decay is too short for a fit, if another mode cuts off its bell above 6 % of the
/// peak, if the frequency of the decay differs from that of the peak, or if the damping ratio exceeds 15 %.
///
/// # Limits
/// For modes separated by several bandwidths; closer modes may have a single peak. There is no standard deviation; the lower bound given is the best
/// possible.
///
/// # Source
/// Brincker, Ventura & Andersen (2001) Proc. 19th IMAC (EFDD); Zhang, Wang & Tamura (2010) Mech. Syst. Signal Process. 24:1227-1239 (FSDD). Differs
/// from the sources: the complex correlation instead of extremes and zero crossings; S is transformed instead of √S; the effect of its window is
/// removed.
pub fn efdd(record: &Record, options: &Efdd) -> Result<FddResult, ModalError> {
    if !(options.assurance_least > 0.0 && options.assurance_least < 1.0) {
        return refused("assurance_least", options.assurance_least, "between 0 and 1");
    }
    let lines = options.fdd.lines_of(record)?;
    let matrices = SpectralMatrices::of(record, lines)?;
    let mut found = peaks_of(record, &matrices, &options.fdd)?;
    found.modes.method = options.method;
    let step_hz = 0.5 * record.sampling_rate_hz() / lines as f64;
    let duration_s = record.duration_s();
    for mode in &mut found.modes.modes {
        let line = ((mode.frequency_hz / step_hz).round() as usize).min(lines);
        let bell = bell(&matrices, line, options)?;
        if !bell.cut {
            refine(mode, &bell, (line, step_hz, lines), duration_s);
        }
    }
    Ok(found)
}

/// Lines of one mode near its peak.
struct Bell {
    first: usize,
    value: Vec<f64>,
    /// Whether another mode cuts off the bell above `CUT_MOST` of its peak.
    cut: bool,
}

fn bell(matrices: &SpectralMatrices, peak: usize, options: &Efdd) -> Result<Bell, ModalError> {
    let channels = matrices.channels;
    let e = hermitian_eigen(&matrices.at(peak))?;
    let phi: Vec<Complex64> = e.vectors.column(channels - 1).to_vec();
    let top = e.values[channels - 1];
    let value = |line: usize| -> Result<Option<f64>, ModalError> {
        let s = matrices.at(line);
        let e = hermitian_eigen(&s)?;
        // the singular vector, of the two largest values, that is similar to φ, because the bells of two modes may cross
        let like = (0..channels.min(2))
            .map(|k| channels - 1 - k)
            .find(|&k| assurance(e.vectors.column(k), &phi) >= options.assurance_least);
        Ok(like.map(|k| match options.method {
            Method::Fsdd => (0..channels)
                .flat_map(|i| (0..channels).map(move |j| (i, j)))
                .map(|(i, j)| (phi[i].conj() * s[(i, j)] * phi[j]).re)
                .sum(),
            _ => e.values[k],
        }))
    };
    const SIDE_LEAST: f64 = 1e-3; // of the top: further down the sides it is noise
    let mut cut = false;
    let rise = 10f64.powf(0.1 * options.fdd.prominence_db);
    let mut side = |next: &dyn Fn(usize) -> Option<usize>| -> Result<Vec<f64>, ModalError> {
        let (mut at, mut values, mut least) = (peak, Vec::new(), top);
        while let Some(line) = next(at) {
            match value(line)? {
                // another peak with a similar shape begins (with one channel all shapes are equal): the bell ends at the minimum between them
                Some(x) if x > rise * least => {
                    let saddle = values.iter().rposition(|v| *v == least).map_or(0, |i| i + 1);
                    values.truncate(saddle);
                    cut |= least > CUT_MOST * top;
                    break;
                }
                Some(x) if x > SIDE_LEAST * top => {
                    least = least.min(x);
                    values.push(x);
                }
                Some(_) => break,
                None => {
                    cut |= values.last().is_none_or(|x| *x > CUT_MOST * top);
                    break;
                }
            }
            at = line;
        }
        Ok(values)
    };
    let mut left = side(&|line| line.checked_sub(1).filter(|line| *line > 0))?;
    let right = side(&|line| (line < matrices.lines).then_some(line + 1))?;
    let first = peak - left.len();
    left.reverse();
    left.push(top);
    left.extend(right);
    Ok(Bell {
        first,
        value: left,
        cut,
    })
}

/// Frequency, damping ratio and the bias due to the window, from the decay of the bell.
fn refine(mode: &mut Mode, bell: &Bell, (peak, step_hz, lines): (usize, f64, usize), duration_s: f64) {
    let half = 0.5 / step_hz; // half a period of the lines: the longest lag, lines × dt
    let total: f64 = bell.value.iter().sum();
    let width_hz = total * step_hz / bell.value[peak - bell.first];
    let step_s = (1.0 / (POINTS_A_WIDTH * width_hz)).min(half / lines.min(400) as f64);
    let mut plain = Vec::new();
    let mut corrected = Vec::new();
    for k in 0..(half / step_s) as usize {
        let tau_s = k as f64 * step_s;
        let window = parzen(tau_s / half);
        if window < WINDOW_LEAST {
            break;
        }
        // relative to the peak's line, so that the phase rotates slowly
        let turned = |(i, b): (usize, &f64)| {
            let offset = (bell.first + i) as f64 - peak as f64;
            Complex64::from_polar(*b, 2.0 * PI * offset * step_hz * tau_s)
        };
        let a: Complex64 = bell.value.iter().enumerate().map(turned).sum::<Complex64>() / total;
        plain.push((tau_s, a));
        corrected.push((tau_s, a / window));
    }
    let Some([decay, turn_hz]) = rates(&corrected) else {
        return;
    };
    let damped_hz = peak as f64 * step_hz + turn_hz;
    let frequency_hz = damped_hz.hypot(decay / (2.0 * PI));
    let zeta = decay / (2.0 * PI * frequency_hz);
    // the decay does not belong to the peak: its frequency is outside the bell, or its damping is not that of a mode
    let away_hz = (frequency_hz - peak as f64 * step_hz).abs();
    let far = away_hz > (LINES_AWAY * step_hz).max(zeta * frequency_hz);
    if !(zeta > 0.0 && zeta <= Criteria::default().damping_ratio_most && frequency_hz.is_finite()) || far {
        return;
    }
    mode.frequency_hz = frequency_hz;
    mode.damping_ratio = Some(zeta);
    mode.window_bias = rates(&plain).map(|[with, _]| with / decay - 1.0);
    mode.cycles = frequency_hz * duration_s;
}

/// Decay rate, 1/s, and frequency, Hz, of a complex correlation: from straight lines through its logarithm and phase.
fn rates(a: &[(f64, Complex64)]) -> Option<[f64; 2]> {
    let from = a.iter().position(|(_, a)| a.norm() < FIT_FROM)?;
    let end = a[from..]
        .iter()
        .position(|(_, a)| a.norm() < FIT_TO)
        .map_or(a.len(), |n| from + n);
    let used = &a[from..end];
    if used.len() < POINTS_LEAST {
        return None;
    }
    let mut phase = used[0].1.arg();
    let mut phases = vec![phase];
    for pair in used.windows(2) {
        phase += (pair[1].1 * pair[0].1.conj()).arg();
        phases.push(phase);
    }
    let slope = |values: &[f64]| {
        let n = used.len() as f64;
        let (mt, mv) = (
            used.iter().map(|p| p.0).sum::<f64>() / n,
            values.iter().sum::<f64>() / n,
        );
        let pairs = used.iter().map(|p| p.0 - mt).zip(values.iter().map(|v| v - mv));
        let (cross, square) = pairs.fold((0.0, 0.0), |(c, s), (t, v)| (c + t * v, s + t * t));
        cross / square
    };
    let logs: Vec<f64> = used.iter().map(|(_, a)| a.norm().ln()).collect();
    Some([-slope(&logs), slope(&phases) / (2.0 * PI)])
}

#[cfg(test)]
mod tests {
    use super::super::fdd::Fdd;
    use super::*;
    use crate::numeric::Random;
    use crate::signal::Channel;

    #[test]
    fn holds_bells_of_one_channel_end_at_the_saddles() {
        // three modes with 2 % damping under white-noise forces, 10 min at 50 Hz; with one channel all lines have the same shape
        let (rate_hz, zeta) = (50.0, 0.02);
        let truth = [1.8, 4.9, 7.7];
        let mut random = Random::new(5, 0);
        let mut sum = vec![0.0; 30_000];
        for f in truth {
            let omega = 2.0 * PI * f;
            let pole = Complex64::new(-zeta * omega, omega * (1.0 - zeta * zeta).sqrt());
            let keeps = (pole / rate_hz).exp();
            let (mut state, size) = (Complex64::ZERO, omega.sqrt());
            for y in &mut sum {
                state = keeps * state + random.normal() / size;
                *y += omega * state.im;
            }
        }
        let record = Record::new(vec![Channel::named("y")], vec![sum], rate_hz).unwrap();
        for method in [Method::Efdd, Method::Fsdd] {
            let options = Efdd {
                fdd: Fdd::default(),
                method,
                ..Efdd::default()
            };
            let found = efdd(&record, &options).unwrap().modes.modes;
            assert_eq!(found.len(), 3, "{found:?}");
            for (mode, f) in found.iter().zip(truth) {
                assert!((mode.frequency_hz / f - 1.0).abs() < 0.02, "{mode:?}");
                assert!(
                    mode.damping_ratio.is_none_or(|z| (0.01..0.035).contains(&z)),
                    "{mode:?}"
                );
            }
        }
    }
}
