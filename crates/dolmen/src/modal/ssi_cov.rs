//! Covariance-driven stochastic subspace identification: poles of every even model order from one decomposition.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | l, br | `channels`, `block_rows` | channels, block rows | |
//! | R_k | `correlations.lag(k)` | E[y(t + k) y(t)ᵀ] | l × l |
//! | H | `hankel` | blocks R_(i+j+1) | l br × l br |
//! | U, S, V | `u`, `s`, `v` | H = U diag(S) Vᵀ | l br × n |
//! | O↑, O↓ | `upper`, `lower` | U without its last, first block row | l (br-1) × n |
//! | A | `a` | state matrix, O↑ A = O↓ | n × n |
//! | λ, φ | `lambda`, `phi` | eigenvalue and vector of A | |

use super::ModalError;
use super::correlations::{Correlations, correlate, lags_before};
use super::indicators::{normalized, phase_collinearity, phase_deviation};
use crate::signal::Record;
use dolmen_linalg::{Complex64, Matrix, Qr, eigen, qr, svd};
use std::f64::consts::PI;

/// Singular values below this share of the largest are rounding (double precision, FFT sums of many samples).
const RANK_LEAST: f64 = 1e-13;

/// Options of [`ssi_cov`].
#[derive(Clone, Debug, PartialEq)]
pub struct SsiCov {
    /// Block rows br, at the rate after decimation: at least half a period of the lowest mode; at least 2.
    pub block_rows: usize,
    /// Highest model order, even, at most channels × (block_rows - 1); twice the modes looked for and more.
    pub order_most: usize,
    /// Samples before over samples after a low-pass filter of the correlations; 1 (default): none.
    pub decimation: usize,
    /// Consecutive blocks of time whose scatter gives the standard deviations; default 30 (the standard deviation
    /// is then itself known to 13 %); at least 2.
    pub time_blocks: usize,
}

impl Default for SsiCov {
    fn default() -> Self {
        SsiCov {
            block_rows: 30,
            order_most: 60,
            decimation: 1,
            time_blocks: 30,
        }
    }
}

/// One pole of one model order: upper half plane only, its conjugate is implied.
#[derive(Clone, Debug, PartialEq)]
pub struct Pole {
    /// Model order it was found at.
    pub order: usize,
    /// Natural (undamped) frequency, Hz.
    pub frequency_hz: f64,
    /// Damping ratio; negative if the pole grows.
    pub damping_ratio: f64,
    /// One component a channel; the largest is 1 + 0i.
    pub shape: Vec<Complex64>,
    /// Modal phase collinearity, 0 to 1.
    pub phase_collinearity: f64,
    /// Mean phase deviation over a right angle, 0 to 1.
    pub phase_deviation: f64,
    /// Eigenvalue of the discrete state matrix.
    pub eigenvalue: Complex64,
}

impl Pole {
    /// Continuous-time eigenvalue over 2π, Hz: -ζf ± i f√(1-ζ²).
    pub(crate) fn root_hz(&self) -> Complex64 {
        let zeta = self.damping_ratio;
        Complex64::new(-zeta, (1.0 - zeta * zeta).max(0.0).sqrt()) * self.frequency_hz
    }

    /// Long-record floor of the standard deviation of the frequency, f √(ζ/2πN_c) (Au 2014), Hz.
    pub(crate) fn floor_hz(&self, duration_s: f64) -> f64 {
        let cycles = self.frequency_hz * duration_s;
        self.frequency_hz * (self.damping_ratio / (2.0 * PI * cycles)).sqrt()
    }
}

/// Poles of every even order, with the decomposition they came from.
#[derive(Clone, Debug)]
pub struct Subspace {
    /// All oscillating poles, by order, then by frequency.
    pub poles: Vec<Pole>,
    /// Singular values of the Hankel matrix, descending.
    pub singular_values: Vec<f64>,
    /// Block rows.
    pub block_rows: usize,
    /// Highest order.
    pub order_most: usize,
    /// Sampling rate after decimation, Hz.
    pub sampling_rate_hz: f64,
    /// Duration of the record, s.
    pub duration_s: f64,
    pub(super) correlations: Correlations,
    /// First `order_most` left singular vectors.
    pub(super) u: Matrix,
    /// First `order_most` right singular vectors, each over its singular value.
    pub(super) v_over_s: Matrix,
    /// Q R of O↑.
    pub(super) upper: Qr,
    /// Qᵀ O↓.
    pub(super) shifted: Matrix,
}

/// Poles of the model orders 2, 4 … `order_most` of an ambient record.
///
/// ```text
/// H = [R_(i+j+1)] = U S Vᵀ,  i, j = 0 … br-1       shape: l br × l br
/// O↑ = Q R;  A_n = R_n⁻¹ (Qᵀ O↓)_n                 leading n × n blocks: one QR serves every order n
/// λ = eig A_n;  μ = ln λ / dt;  f = |μ| / 2π;  ζ = -Re μ / |μ|;  shape = first block row of U φ
/// ```
/// R_0 is left out, so that white sensor noise does not enter.
///
/// # Errors
/// [`ModalError::Order`], [`ModalError::Rank`], [`ModalError::Option`], [`ModalError::TooShort`],
/// [`ModalError::Linalg`].
///
/// # Limits
/// With fewer than fs/(2 f1) block rows the first mode is lost or its damping is wrong by several times; see
/// `identify`, which chooses them from the data.
///
/// # Source
/// Peeters & De Roeck (1999) Mech. Syst. Signal Process. 13(6):855-878; all orders from one QR: Döhler & Mevel (2012)
/// Control Eng. Pract. 20:1078-1086 (their algorithm 2). Differs from the sources: all lags sum over the same start
/// times; U is not scaled with √S, which changes no pole.
pub fn ssi_cov(record: &Record, options: &SsiCov) -> Result<Subspace, ModalError> {
    let channels = record.channels().len();
    check(options, channels)?;
    let lags = 2 * options.block_rows - 1;
    let correlations = correlate(record, lags_before(lags, options.decimation), options.time_blocks)?
        .decimated(options.decimation);
    subspace(correlations, options, record.duration_s())
}

fn check(options: &SsiCov, channels: usize) -> Result<(), ModalError> {
    let least = [
        ("block_rows", options.block_rows, 2, "at least 2"),
        ("decimation", options.decimation, 1, "at least 1"),
        ("time_blocks", options.time_blocks, 2, "at least 2"),
        (
            "order_most",
            options.order_most,
            2,
            "an even number of at least 2",
        ),
    ];
    for (option, given, bound, allowed) in least {
        if given < bound {
            return Err(ModalError::Option {
                option,
                given: given as f64,
                allowed,
            });
        }
    }
    let most = channels * (options.block_rows - 1) / 2 * 2;
    if options.order_most > most {
        return Err(ModalError::Order {
            given: options.order_most,
            block_rows: options.block_rows,
            channels,
            most,
        });
    }
    Ok(())
}

fn subspace(correlations: Correlations, options: &SsiCov, duration_s: f64) -> Result<Subspace, ModalError> {
    let (l, br, n) = (correlations.channels, options.block_rows, options.order_most);
    let hankel = Matrix::from_fn(l * br, l * br, |i, j| {
        correlations.lag(i / l + j / l + 1)[i % l * l + j % l]
    });
    let f = svd(&hankel)?;
    drop(hankel);
    let rank = f.s.iter().filter(|s| **s > RANK_LEAST * f.s[0]).count();
    if n > rank {
        return Err(ModalError::Rank { given: n, rank });
    }
    let u = f.u.block(0, 0, l * br, n);
    let v_over_s = Matrix::from_fn(l * br, n, |i, j| f.v[(i, j)] / f.s[j].max(f64::MIN_POSITIVE));
    let upper = qr(&u.block(0, 0, l * (br - 1), n))?;
    let shifted = upper.q.transpose_times(&u.block(l, 0, l * (br - 1), n));
    let mut poles = Vec::new();
    for order in (2..=n).step_by(2) {
        poles.extend(poles_of(
            &state(&upper.r, &shifted, order),
            &u,
            l,
            correlations.step_s,
        )?);
    }
    Ok(Subspace {
        poles,
        singular_values: f.s,
        block_rows: br,
        order_most: n,
        sampling_rate_hz: 1.0 / correlations.step_s,
        duration_s,
        correlations,
        u,
        v_over_s,
        upper,
        shifted,
    })
}

/// A_n = R_n⁻¹ (Qᵀ O↓)_n by back substitution.
pub(super) fn state(r: &Matrix, shifted: &Matrix, n: usize) -> Matrix {
    let mut a = shifted.block(0, 0, n, n);
    for j in 0..n {
        back_substitute(r, &mut a.column_mut(j)[..n]);
    }
    a
}

/// x ← R_n⁻¹ x with R_n the leading triangle.
pub(super) fn back_substitute(r: &Matrix, x: &mut [f64]) {
    for i in (0..x.len()).rev() {
        x[i] /= r[(i, i)];
        let (above, xi) = (&r.column(i)[..i], x[i]);
        for (x, r) in x.iter_mut().zip(above) {
            *x -= r * xi;
        }
    }
}

fn poles_of(a: &Matrix, u: &Matrix, channels: usize, step_s: f64) -> Result<Vec<Pole>, ModalError> {
    let n = a.rows();
    let e = eigen(a)?;
    let mut poles = Vec::with_capacity(n / 2);
    for (j, lambda) in e.values.iter().enumerate().filter(|(_, z)| z.im > 0.0) {
        let mu = lambda.ln() / step_s;
        let phi = e.vectors.column(j);
        let shape: Vec<Complex64> = (0..channels)
            .map(|c| (0..n).map(|k| phi[k] * u[(c, k)]).sum())
            .collect();
        poles.push(Pole {
            order: n,
            frequency_hz: mu.norm() / (2.0 * PI),
            damping_ratio: -mu.re / mu.norm(),
            phase_collinearity: phase_collinearity(&shape),
            phase_deviation: phase_deviation(&shape),
            shape: normalized(&shape),
            eigenvalue: *lambda,
        });
    }
    poles.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    Ok(poles)
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEP_S: f64 = 0.05;
    const MODES: [(f64, f64, [f64; 3]); 2] = [(1.0, 0.01, [1.0, 0.5, -0.2]), (2.5, 0.03, [0.3, -0.8, 1.0])];

    /// Correlations of free modes under white force, up to a scale: Σ φ φᵀ e^(-ζωτ) cos(ω_d τ).
    fn analytic(lags: usize) -> Correlations {
        let mut mean = Vec::new();
        for k in 0..=lags {
            let entry = |a: usize, b: usize| -> f64 {
                let of = MODES.iter().map(|(f, zeta, phi)| {
                    let (omega, tau) = (2.0 * PI * f, k as f64 * STEP_S);
                    let turn = omega * (1.0 - zeta * zeta).sqrt() * tau;
                    phi[a] * phi[b] * (-zeta * omega * tau).exp() * turn.cos()
                });
                of.sum()
            };
            mean.extend((0..9).map(|i| entry(i / 3, i % 3)));
        }
        Correlations {
            channels: 3,
            lags,
            step_s: STEP_S,
            mean,
            deviations: Vec::new(),
        }
    }

    #[test]
    fn exact_poles_and_shapes_of_exact_correlations() {
        let options = SsiCov {
            block_rows: 10,
            order_most: 4,
            ..Default::default()
        };
        let found = subspace(analytic(19), &options, 100.0).unwrap();
        let at_four: Vec<&Pole> = found.poles.iter().filter(|p| p.order == 4).collect();
        assert_eq!(at_four.len(), 2);
        for (pole, (frequency_hz, zeta, phi)) in at_four.iter().zip(MODES) {
            assert!((pole.frequency_hz / frequency_hz - 1.0).abs() < 1e-11, "{pole:?}");
            assert!((pole.damping_ratio - zeta).abs() < 1e-11, "{pole:?}");
            for (z, phi) in pole.shape.iter().zip(phi) {
                assert!((z - phi).norm() < 1e-9, "{pole:?}");
            }
        }
    }

    #[test]
    fn refuses_an_order_above_what_block_rows_or_rank_allow() {
        let options = |order_most| SsiCov {
            block_rows: 10,
            order_most,
            ..Default::default()
        };
        let fault = check(&options(28), 3).unwrap_err().to_string();
        assert_eq!(
            fault,
            "order_most is 28, but 10 block rows of 3 channels allow at most 26: raise block_rows or lower order_most"
        );
        let fault = subspace(analytic(19), &options(6), 100.0)
            .unwrap_err()
            .to_string();
        assert!(
            fault.starts_with("order_most is 6, but the correlations have rank 4"),
            "{fault}"
        );
    }
}
