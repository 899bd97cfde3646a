//! Standard deviations of the poles of a matrix fraction, from the scatter of the correlations between blocks of
//! time.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | dα | `changes` | change of the denominator when the deviation of one block is added to the correlations | p r × r |
//! | v, w | `right`, `left` | A(λ) v = 0, wᵀ A(λ) = 0 | r |

use super::fraction_fit::Fit;
use super::half_spectra::{HalfSpectra, Sums};
use super::plscf::MatrixFraction;
use crate::modal::subspace::Pole;
use crate::modal::subspace::{Deviations, correction, frequency_and_damping};
use crate::modal::{ModalError, PoleDeviation};
use dolmen_linalg::{Complex64, ComplexMatrix, Matrix, hermitian_eigen};

/// First-order scatter of the poles of one [`MatrixFraction`].
///
/// ```text
/// dα_j = α(R + dR_j) - α(R);   dλ = -wᵀ dA(λ) v / wᵀ A'(λ) v;   var f = b/(b-1) Σ df²      over the b blocks of time
/// ```
/// dR_j is the contribution of block j to the mean, minus the mean contribution, so that the sum equals that of the
/// jackknife. Shapes have no standard deviation.
pub(crate) struct FractionScatter<'a> {
    fraction: &'a MatrixFraction,
    /// Spectral sums of the mean, then of the change of each block; computed at first use.
    sums: Vec<Sums>,
    degrees: Vec<Option<Degree>>,
}

struct Degree {
    fit: Fit,
    changes: Vec<Matrix>,
}

impl<'a> FractionScatter<'a> {
    pub(crate) fn new(fraction: &'a MatrixFraction) -> Self {
        let degrees = fraction.order_most / fraction.references.len();
        FractionScatter {
            fraction,
            sums: Vec::new(),
            degrees: (0..=degrees).map(|_| None).collect(),
        }
    }

    /// Changes of frequency, Hz, and damping ratio due to each block of time.
    fn changes(&mut self, pole: &Pole) -> Result<Vec<[f64; 2]>, ModalError> {
        let (fraction, r) = (self.fraction, self.fraction.references.len());
        let beta = -fraction.options.window_end.ln() / fraction.options.lags as f64;
        let degree = self.degree(pole.order / r)?;
        let windowed = pole.eigenvalue * (-beta).exp();
        let [a, slope] = degree.fit.denominator(windowed);
        let (right, left) = null_vectors(&a, r)?;
        let through = |m: &[Complex64]| -> Complex64 {
            let rows = m.chunks_exact(r).zip(&left);
            rows.map(|(row, w)| w * row.iter().zip(&right).map(|(m, v)| m * v).sum::<Complex64>())
                .sum()
        };
        let slope = through(&slope);
        let of_block = |change: &Matrix| {
            let mut power = windowed;
            let mut moved = vec![Complex64::ZERO; r * r];
            for k in 0..change.rows() / r {
                for (at, x) in moved.iter_mut().enumerate() {
                    *x += power * change[(k * r + at / r, at % r)];
                }
                power *= windowed;
            }
            // λ is e^β times the pole of the windowed correlations
            let d_lambda = -through(&moved) / slope * beta.exp();
            frequency_and_damping(pole, d_lambda, fraction.sampling_rate_hz)
        };
        Ok(degree.changes.iter().map(of_block).collect())
    }

    fn degree(&mut self, degree: usize) -> Result<&Degree, ModalError> {
        if self.sums.is_empty() {
            let f = self.fraction;
            let most = f.order_most / f.references.len();
            let of = |lags: &[f64]| Sums::new(&HalfSpectra::new(&f.correlations, lags, &f.options), most);
            self.sums.push(of(&f.correlations.mean));
            for block in &f.correlations.deviations {
                let moved: Vec<f64> = f
                    .correlations
                    .mean
                    .iter()
                    .zip(block)
                    .map(|(a, b)| a + f64::from(*b))
                    .collect();
                self.sums.push(of(&moved));
            }
        }
        let slot = &mut self.degrees[degree];
        Ok(match slot {
            Some(known) => known,
            None => {
                let fit = Fit::new(&self.sums[0], degree)?;
                let mut changes = Vec::with_capacity(self.sums.len() - 1);
                for sums in &self.sums[1..] {
                    let mut moved = Fit::new(sums, degree)?.alpha;
                    for (x, before) in moved.as_mut_slice().iter_mut().zip(fit.alpha.as_slice()) {
                        *x -= before;
                    }
                    changes.push(moved);
                }
                slot.insert(Degree { fit, changes })
            }
        })
    }
}

impl Deviations for FractionScatter<'_> {
    fn frequency_sd_hz(&mut self, pole: &Pole) -> Result<f64, ModalError> {
        let changes = self.changes(pole)?;
        let sum: f64 = changes.iter().map(|[df, _]| df * df).sum();
        Ok((correction(changes.len()) * sum).sqrt())
    }

    fn deviation(&mut self, pole: &Pole) -> Result<PoleDeviation, ModalError> {
        let changes = self.changes(pole)?;
        let sd = |at: usize| {
            let sum: f64 = changes.iter().map(|d| d[at] * d[at]).sum();
            (correction(changes.len()) * sum).sqrt()
        };
        Ok(PoleDeviation {
            frequency_sd_hz: sd(0),
            frequency_changes_hz: changes
                .iter()
                .map(|[df, _]| correction(changes.len()).sqrt() * df)
                .collect(),
            damping_ratio_sd: sd(1),
            shape_sd: Vec::new(),
        })
    }
}

/// Null vectors v and w with A v = 0 and wᵀ A = 0. `a` is stored row by row.
fn null_vectors(a: &[Complex64], r: usize) -> Result<(Vec<Complex64>, Vec<Complex64>), ModalError> {
    let of_right = ComplexMatrix::from_fn(r, r, |i, j| {
        (0..r).map(|k| a[k * r + i].conj() * a[k * r + j]).sum()
    });
    let of_left = ComplexMatrix::from_fn(r, r, |i, j| {
        (0..r).map(|k| a[i * r + k] * a[j * r + k].conj()).sum()
    });
    let right = hermitian_eigen(&hermitian(of_right, r))?
        .vectors
        .column(0)
        .to_vec();
    let left = hermitian_eigen(&hermitian(of_left, r))?
        .vectors
        .column(0)
        .to_vec();
    Ok((right, left.iter().map(Complex64::conj).collect()))
}

/// Makes a product of A and A* exactly Hermitian, by removing its rounding error.
fn hermitian(a: ComplexMatrix, r: usize) -> ComplexMatrix {
    ComplexMatrix::from_fn(r, r, |i, j| 0.5 * (a[(i, j)] + a[(j, i)].conj()))
}
