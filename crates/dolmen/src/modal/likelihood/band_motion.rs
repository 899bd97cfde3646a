//! Expected periodogram of modes under white-noise forces in a finite record, including exact leakage.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | k | `derivatives` | 0, 1, 2: displacement, velocity, acceleration | - |
//! | p | `root` | pole, ω₀(-ζ + i√(1 - ζ²)) | rad/s |
//! | r | `residue` | p^k/(p - p̄) | |
//! | T | `duration_s` | duration | s |

use dolmen_linalg::{Complex64, ComplexMatrix};
use std::f64::consts::TAU;

/// Frequency, Hz, and damping ratio of a mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Oscillator {
    pub(super) frequency_hz: f64,
    pub(super) damping_ratio: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Recorded {
    pub(super) derivatives: i32,
    pub(super) duration_s: f64,
}

/// Poles of the cross spectrum of two oscillators, each with its residue.
pub(super) struct CrossSpectrum {
    recorded: Recorded,
    /// In iω.
    ahead: [[Complex64; 2]; 2],
    /// In -iω.
    behind: [[Complex64; 2]; 2],
}

impl CrossSpectrum {
    /// Expected periodogram of two oscillators under the same white-noise force of spectral density 1.
    ///
    /// ```text
    /// H(s) = s^k / ((s - p)(s - p̄)),   H_a(iω) H_b(-iω) = [k = 2] + Σ r_a H_b(-p_a)/(iω - p_a) + Σ r_b H_a(-p_b)/(-iω - p_b)
    /// ```
    pub(super) fn new(a: Oscillator, b: Oscillator, recorded: Recorded) -> Self {
        let ahead = terms(a, b, recorded.derivatives);
        let behind = terms(b, a, recorded.derivatives);
        CrossSpectrum {
            recorded,
            ahead,
            behind,
        }
    }

    /// Expectation of y_a(ω) y_b(ω)*, the Fourier sums of the two motions over T, per T.
    ///
    /// ```text
    /// 1/x  →  ∫₀ᵀ (1 - τ/T) e^(-xτ) dτ = 1/x - (1 - e^(-xT))/(x²T)
    /// ```
    pub(super) fn at(&self, frequency_hz: f64) -> Complex64 {
        let s = Complex64::new(0.0, TAU * frequency_hz);
        let duration_s = self.recorded.duration_s;
        let seen = |terms: &[[Complex64; 2]; 2], s: Complex64| -> Complex64 {
            terms
                .iter()
                .map(|[root, residue]| {
                    let x = s - root;
                    residue / x * (1.0 - (1.0 - (-x * duration_s).exp()) / (x * duration_s))
                })
                .sum()
        };
        let direct = f64::from(self.recorded.derivatives == 2);
        direct + seen(&self.ahead, s) + seen(&self.behind, -s)
    }
}

/// The poles of `a`, each with r_a H_b(-p_a).
fn terms(a: Oscillator, b: Oscillator, derivatives: i32) -> [[Complex64; 2]; 2] {
    let (p, q) = (root(a), root(b));
    [p, p.conj()].map(|p| {
        let across = (-p).powi(derivatives) / ((-p - q) * (-p - q.conj()));
        [p, p.powi(derivatives) / (p - p.conj()) * across]
    })
}

/// The pole with a positive imaginary part.
pub(super) fn root(of: Oscillator) -> Complex64 {
    let zeta = of.damping_ratio;
    Complex64::new(-zeta, (1.0 - zeta * zeta).sqrt()) * (TAU * of.frequency_hz)
}

/// Expected cross spectra of a group of oscillators, and their slopes.
pub(super) struct Spectra {
    count: usize,
    pairs: Vec<CrossSpectrum>,
    /// For each frequency and damping ratio: all pairs with a slightly larger value, with a slightly smaller value, and the difference.
    beside: Vec<([Vec<CrossSpectrum>; 2], f64)>,
}

impl Spectra {
    pub(super) fn new(oscillators: &[Oscillator], recorded: Recorded) -> Self {
        const STEP: f64 = 1e-4; // of the half-power width: the slope is good to 1e-8
        let pairs = |of: &[Oscillator]| -> Vec<CrossSpectrum> {
            let with = |a: &Oscillator| -> Vec<CrossSpectrum> {
                of.iter().map(|b| CrossSpectrum::new(*a, *b, recorded)).collect()
            };
            of.iter().flat_map(with).collect()
        };
        let mut beside = Vec::with_capacity(2 * oscillators.len());
        for (i, own) in oscillators.iter().enumerate() {
            let moved = |frequency_by: f64, damping_by: f64| {
                let mut all = oscillators.to_vec();
                all[i].frequency_hz += frequency_by;
                all[i].damping_ratio += damping_by;
                pairs(&all)
            };
            let by = STEP * own.damping_ratio;
            let by_hz = by * own.frequency_hz;
            beside.push(([moved(by_hz, 0.0), moved(-by_hz, 0.0)], 2.0 * by_hz));
            beside.push(([moved(0.0, by), moved(0.0, -by)], 2.0 * by));
        }
        Spectra {
            count: oscillators.len(),
            pairs: pairs(oscillators),
            beside,
        }
    }

    pub(super) fn at(&self, frequency_hz: f64) -> ComplexMatrix {
        let m = self.count;
        ComplexMatrix::from_fn(m, m, |i, j| self.pairs[i * m + j].at(frequency_hz))
    }

    pub(super) fn slope(&self, which: usize, frequency_hz: f64) -> ComplexMatrix {
        let (m, own) = (self.count, which / 2);
        let ([above, below], by) = &self.beside[which];
        ComplexMatrix::from_fn(m, m, |i, j| {
            if i != own && j != own {
                return Complex64::default();
            }
            let at = |of: &[CrossSpectrum]| of[i * m + j].at(frequency_hz);
            (at(above) - at(below)) / *by
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: Oscillator = Oscillator {
        frequency_hz: 1.5,
        damping_ratio: 0.02,
    };
    const B: Oscillator = Oscillator {
        frequency_hz: 1.7,
        damping_ratio: 0.05,
    };

    /// H(iω) in textbook form.
    fn transfer(of: Oscillator, derivatives: i32, hz: f64) -> Complex64 {
        let (w0, w) = (TAU * of.frequency_hz, TAU * hz);
        let iw = Complex64::new(0.0, w);
        iw.powi(derivatives) / Complex64::new(w0 * w0 - w * w, 2.0 * of.damping_ratio * w0 * w)
    }

    #[test]
    fn exact_product_of_two_transfer_functions_without_an_end() {
        for derivatives in 0..3 {
            let recorded = Recorded {
                derivatives,
                duration_s: 1e12,
            };
            let of = CrossSpectrum::new(A, B, recorded);
            for hz in [0.3, 1.4999, 1.6, 1.73, 4.0] {
                let known = transfer(A, derivatives, hz) * transfer(B, derivatives, hz).conj();
                let found = of.at(hz);
                assert!(
                    (found - known).norm() < 1e-9 * known.norm(),
                    "{derivatives} {hz} {found} {known}"
                );
            }
        }
    }

    #[test]
    fn exact_leakage_is_fejers_kernel_over_the_spectrum() {
        let recorded = Recorded {
            derivatives: 1,
            duration_s: 40.0,
        };
        let of = CrossSpectrum::new(A, B, recorded);
        let (hz, step, mut known) = (1.55, 1e-4, Complex64::default());
        for i in -400_000..400_000_i32 {
            let f = (f64::from(i) + 0.5) * step;
            let x = std::f64::consts::PI * (hz - f) * recorded.duration_s;
            let fejer = recorded.duration_s * (x.sin() / x).powi(2);
            known += step * fejer * transfer(A, 1, f) * transfer(B, 1, f).conj();
        }
        let found = of.at(hz);
        assert!((found - known).norm() < 1e-6 * known.norm(), "{found} {known}");
        let without = transfer(A, 1, hz) * transfer(B, 1, hz).conj();
        assert!((found - without).norm() > 0.01 * known.norm());
    }
}
