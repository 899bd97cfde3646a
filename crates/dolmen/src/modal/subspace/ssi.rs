//! Stochastic subspace identification, covariance-driven and data-driven: poles of every even model order from one decomposition.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | l, r, br | `channels`, `references`, `block_rows` | channels, reference channels, block rows | |
//! | Y⁺, Y⁻ | | future of all channels, past of the reference channels (hankel.rs) | l br, r br |
//! | H | | the matrix that is decomposed | l br × r br |
//! | U, S, V | `u`, `s`, `v` | H = U diag(S) Vᵀ | l br × n |
//! | X | `x` | U = (Y⁺ Y⁻ᵀ) X | r br × n |
//! | O↑, O↓ | `upper`, `lower` | U without its last, first block row | l (br-1) × n |
//! | A | `a` | state matrix, O↑ A = O↓ | n × n |
//! | λ, φ | `lambda`, `phi` | eigenvalue and vector of A | |

use super::block_change::Block;
use super::decomposed::{Decomposed, of_covariance, of_data};
use super::ssi_options::Ssi;
use crate::modal::correlations::{Correlations, correlate_decimated};
use crate::modal::error::{at_least, references_of};
use crate::modal::indicators::{normalized, phase_collinearity, phase_deviation};
use crate::modal::{Method, ModalError};
use crate::signal::Record;
use dolmen_linalg::{Complex64, Matrix, Qr, eigen, qr};
use std::f64::consts::PI;

/// Singular values below this fraction of the largest are rounding (double precision, FFT sums of many samples).
pub(crate) const RANK_LEAST: f64 = 1e-13;

/// One pole of one model order. Only the upper half plane is stored; the conjugate is implied.
#[derive(Clone, Debug, PartialEq)]
pub struct Pole {
    /// Model order of the pole.
    pub order: usize,
    /// Natural (undamped) frequency, Hz.
    pub frequency_hz: f64,
    /// Damping ratio; negative if the motion of the pole grows.
    pub damping_ratio: f64,
    /// One component per channel; the largest is 1 + 0i.
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

    /// Lower bound of the standard deviation of the frequency for a long record, f √(ζ/2πN_c) (Au 2014), Hz.
    pub fn floor_hz(&self, duration_s: f64) -> f64 {
        let cycles = self.frequency_hz * duration_s;
        self.frequency_hz * (self.damping_ratio / (2.0 * PI * cycles)).sqrt()
    }
}

/// Poles of every even order, with their decomposition.
#[derive(Clone, Debug)]
pub struct Subspace {
    /// All oscillating poles, by order, then by frequency.
    pub poles: Vec<Pole>,
    /// Singular values of H, descending: all, or the first `order_most` of a large H.
    pub singular_values: Vec<f64>,
    /// The method of identification.
    pub method: Method,
    /// Reference channels, by index.
    pub references: Vec<usize>,
    /// Block rows.
    pub block_rows: usize,
    /// Highest order.
    pub order_most: usize,
    /// Sampling rate after decimation, Hz.
    pub sampling_rate_hz: f64,
    /// Duration of the record, s.
    pub duration_s: f64,
    pub(crate) correlations: Correlations,
    /// First `order_most` left singular vectors.
    pub(crate) u: Matrix,
    /// Factor that gives U from the sums of products: U = (Y⁺ Y⁻ᵀ) X.
    pub(crate) x: Matrix,
    /// Q R of O↑.
    pub(crate) upper: Qr,
    /// Qᵀ O↓.
    pub(crate) shifted: Matrix,
    /// dH X of each block of time, projected, for merged setups, whose correlations do not include dH.
    pub(crate) moved: Vec<Block>,
}

/// Poles of the model orders 2, 4 … `order_most` of an ambient record, from its correlations.
///
/// ```text
/// H = Y⁺ Y⁻ᵀ / S = U diag(S) Vᵀ                    shape: l br × r br; all windows as stacked samples have them
/// O↑ = Q R;  A_n = R_n⁻¹ (Qᵀ O↓)_n                 leading n × n blocks: one QR serves every order n
/// λ = eig A_n;  μ = ln λ / dt;  f = |μ| / 2π;  ζ = -Re μ / |μ|;  shape = first block row of U φ
/// ```
/// The correlation at lag 0 is not used, so that white sensor noise has no effect.
///
/// # Errors
/// [`ModalError::Order`], [`ModalError::Rank`], [`ModalError::Option`], [`ModalError::TooShort`], [`ModalError::Linalg`].
///
/// # Limits
/// With fewer than fs/(2 f1) block rows the first mode is lost or its damping is wrong by a factor of several; `identify` chooses the block
/// rows from the data. After decimation H holds R_(i+j+1): the windows differ by 2 br samples.
///
/// # Source
/// Peeters & De Roeck (1999) Mech. Syst. Signal Process. 13(6):855-878; all orders from one QR: Döhler & Mevel (2012) Control Eng. Pract.
/// 20:1078-1086 (their algorithm 2). Differs from the sources: the sums for other windows follow from those for one window; U is not scaled
/// with √S, which changes no pole.
pub fn ssi_cov(record: &Record, options: &Ssi) -> Result<Subspace, ModalError> {
    let (options, correlations) = correlated(record, options, false)?;
    let parts = of_covariance(&correlations, &options)?;
    subspace(
        correlations,
        &options,
        (Method::SsiCov, record.duration_s()),
        parts,
    )
}

/// Poles of the model orders 2, 4 … `order_most` of an ambient record, from the projection of its future on its past.
///
/// ```text
/// H = Y⁺ Y⁻ᵀ L⁻ᵀ,   Y⁻ Y⁻ᵀ = L Lᵀ                  shape: l br × r br: the R₂₁ of a QR of the stacked samples
/// ```
/// then as [`ssi_cov`]. Both matrices follow from the correlations of one pass over the record and its end samples; the stacked samples, (l
/// + r) br rows with one column per sample, are never formed.
///
/// # Errors
/// As [`ssi_cov`].
///
/// # Limits
/// If the past is nearly linearly dependent (noise-free records), the sums of products would square its condition number. The samples are
/// then decomposed by QR in pieces, which takes as long as in other programs. After decimation this is not possible, and the result is an
/// error.
///
/// # Source
/// Peeters & De Roeck (1999), as above; sums of products instead of samples: Van Overschee & De Moor (1996) Subspace Identification for
/// Linear Systems, section 4.4. Differs from the sources: sums that follow from other windows instead of products of the stacked matrix.
pub fn ssi_data(record: &Record, options: &Ssi) -> Result<Subspace, ModalError> {
    let (options, correlations) = correlated(record, options, true)?;
    let parts = of_data(record, &correlations, &options)?;
    subspace(
        correlations,
        &options,
        (Method::SsiData, record.duration_s()),
        parts,
    )
}

/// Options with an explicit list of reference channels, and the necessary correlations; `is_padded` is for those of the past with itself.
fn correlated(record: &Record, options: &Ssi, is_padded: bool) -> Result<(Ssi, Correlations), ModalError> {
    let channels = record.channels().len();
    let options = check_ssi(options, channels)?;
    let lags = (2 * options.block_rows - 1, options.time_blocks);
    let how = (options.decimation, is_padded);
    let correlations = correlate_decimated(record, lags, how, &options.references)?;
    Ok((options, correlations))
}

pub(crate) fn check_ssi(options: &Ssi, channels: usize) -> Result<Ssi, ModalError> {
    at_least(&[
        ("block_rows", options.block_rows, 2, "at least 2"),
        ("decimation", options.decimation, 1, "at least 1"),
        ("time_blocks", options.time_blocks, 2, "at least 2"),
        (
            "order_most",
            options.order_most,
            2,
            "an even number of at least 2",
        ),
    ])?;
    let options = Ssi {
        references: references_of(&options.references, channels)?,
        ..options.clone()
    };
    let rows = channels * (options.block_rows - 1);
    let most = rows.min(options.references.len() * options.block_rows) / 2 * 2;
    if options.order_most > most {
        return Err(ModalError::Order {
            given: options.order_most,
            block_rows: options.block_rows,
            channels,
            most,
        });
    }
    Ok(options)
}

pub(crate) fn subspace(
    correlations: Correlations,
    options: &Ssi,
    (method, duration_s): (Method, f64),
    parts: Decomposed,
) -> Result<Subspace, ModalError> {
    let (l, br, n) = (correlations.channels, options.block_rows, options.order_most);
    let Decomposed { u, x, s } = parts;
    let rank = s.iter().filter(|value| **value > RANK_LEAST * s[0]).count();
    if n > rank {
        return Err(ModalError::Rank { given: n, rank });
    }
    let upper = qr(&u.block(0, 0, l * (br - 1), n))?;
    let shifted = upper.q.transpose_times(&u.block(l, 0, l * (br - 1), n));
    let mut poles = Vec::new();
    for order in (2..=n).step_by(2) {
        let a = state(&upper.r, &shifted, order);
        poles.extend(poles_of(&a, &u, l, correlations.step_s)?);
    }
    Ok(Subspace {
        poles,
        singular_values: s,
        method,
        references: options.references.clone(),
        block_rows: br,
        order_most: n,
        sampling_rate_hz: 1.0 / correlations.step_s,
        duration_s,
        correlations,
        u,
        x,
        upper,
        shifted,
        moved: Vec::new(),
    })
}

/// A_n = R_n⁻¹ (Qᵀ O↓)_n by back substitution.
pub(crate) fn state(r: &Matrix, shifted: &Matrix, n: usize) -> Matrix {
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

/// Oscillating poles of one state matrix, with their shapes.
pub(crate) fn poles_of(
    a: &Matrix,
    u: &Matrix,
    channels: usize,
    step_s: f64,
) -> Result<Vec<Pole>, ModalError> {
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

    /// Correlations of free modes under white-noise forces, up to a factor: Σ φ φᵀ e^(-ζωτ) cos(ω_d τ).
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
            columns: vec![0, 1, 2],
            step_s: STEP_S,
            mean,
            deviations: Vec::new(),
            ends: None,
            padded: None,
        }
    }

    fn found(options: &Ssi) -> Result<Subspace, ModalError> {
        let (options, r) = (check_ssi(options, 3)?, analytic(19));
        let parts = of_covariance(&r, &options)?;
        subspace(r, &options, (Method::SsiCov, 100.0), parts)
    }

    #[test]
    fn exact_poles_and_shapes_of_exact_correlations() {
        let options = Ssi {
            block_rows: 10,
            order_most: 4,
            ..Default::default()
        };
        let found = found(&options).unwrap();
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
        let options = |order_most| Ssi {
            block_rows: 10,
            order_most,
            ..Default::default()
        };
        let fault = check_ssi(&options(28), 3).unwrap_err().to_string();
        assert_eq!(
            fault,
            "order_most is 28, but 10 block rows of 3 channels allow at most 26: raise block_rows or lower order_most"
        );
        let fault = found(&options(6)).unwrap_err().to_string();
        assert!(
            fault.starts_with("order_most is 6, but the correlations have rank 4"),
            "{fault}"
        );
    }

    #[test]
    fn refuses_a_reference_that_is_no_channel_or_named_twice() {
        for references in [vec![0, 3], vec![1, 1]] {
            let options = Ssi {
                references,
                order_most: 4,
                ..Default::default()
            };
            let fault = check_ssi(&options, 3).unwrap_err().to_string();
            assert!(fault.starts_with("references is "), "{fault}");
        }
    }
}
