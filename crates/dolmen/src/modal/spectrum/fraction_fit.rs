//! A right matrix fraction of one degree: least-squares fit, poles and shapes.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | A, B | `alpha`, `numerator` | denominator Σ α_k z^k, numerator Σ β_k z^k | r × r, l × r |
//! | λ, v, φ | `lambda`, `v` | pole; A(λ) v = 0; shape B(λ) v | |

use super::half_spectra::Sums;
use crate::modal::ModalError;
use crate::modal::indicators::{normalized, phase_collinearity, phase_deviation};
use crate::modal::subspace::Pole;
use dolmen_linalg::{
    Complex64, LinalgError, Matrix, cholesky, eigen, solve_lower, solve_lower_transposed, symmetric_eigen,
};
use std::f64::consts::PI;

/// Eigenvalues of a symmetric matrix below this fraction of the largest are rounding; their directions are
/// ignored.
const RANK_LEAST: f64 = 1e-13;

pub(super) struct Fit {
    degree: usize,
    references: usize,
    /// α_1 … α_p, one below the other.   shape: p r × r
    pub(super) alpha: Matrix,
    /// β_0 … β_p, one below the other; one matrix for each output.   shape: (p + 1) × r
    numerator: Vec<Matrix>,
}

impl Fit {
    pub(super) fn new(sums: &Sums, degree: usize) -> Result<Self, ModalError> {
        let (r, size) = (sums.references, (degree + 1) * sums.references);
        let root = inverse_root(&sums.lines_with_lines(degree))?;
        let weighed: Vec<Matrix> = (0..sums.channels)
            .map(|o| &root * &sums.lines_with_spectra(o, degree))
            .collect();
        let mut reduced = sums.spectra_with_spectra(degree);
        for w in &weighed {
            let taken = w.transpose_times(w);
            for (m, t) in reduced.as_mut_slice().iter_mut().zip(taken.as_slice()) {
                *m -= t;
            }
        }
        let free = size - r;
        let right = reduced.block(r, 0, free, r).scaled(-1.0);
        let alpha = solve_semidefinite(&reduced.block(r, r, free, free), right)?;
        let whole = Matrix::from_fn(size, r, |i, j| match i.checked_sub(r) {
            Some(i) => alpha[(i, j)],
            None => f64::from(i == j),
        });
        let numerator = weighed.iter().map(|w| &root * &(w * &whole)).collect();
        Ok(Fit {
            degree,
            references: r,
            alpha,
            numerator,
        })
    }

    /// Eigenvalues 1/λ of the block companion of z^-p A(z), and the null vectors.
    pub(super) fn poles(&self, beta: f64, step_s: f64) -> Result<Vec<Pole>, ModalError> {
        let (p, r) = (self.degree, self.references);
        let mut companion = Matrix::zeros(p * r, p * r);
        for j in 0..p * r {
            for i in 0..r {
                companion[(i, j)] = -self.alpha[(j / r * r + i, j % r)];
            }
            if j + r < p * r {
                companion[(j + r, j)] = 1.0;
            }
        }
        let e = eigen(&companion)?;
        let mut poles = Vec::new();
        for (k, inverse) in e.values.iter().enumerate() {
            // only the upper half plane, and only poles that decay under the window
            if inverse.im >= 0.0 || inverse.norm() <= 1.0 {
                continue;
            }
            let windowed = inverse.inv();
            let shape = self.shape(windowed, &e.vectors.column(k)[..r]);
            let mu = (windowed.ln() + beta) / step_s;
            poles.push(Pole {
                order: p * r,
                frequency_hz: mu.norm() / (2.0 * PI),
                damping_ratio: -mu.re / mu.norm(),
                phase_collinearity: phase_collinearity(&shape),
                phase_deviation: phase_deviation(&shape),
                shape: normalized(&shape),
                eigenvalue: windowed * beta.exp(),
            });
        }
        poles.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
        Ok(poles)
    }

    /// B(λ) v.
    fn shape(&self, lambda: Complex64, v: &[Complex64]) -> Vec<Complex64> {
        let of_output = |beta: &Matrix| {
            let mut power = Complex64::ONE;
            let mut sum = Complex64::ZERO;
            for k in 0..=self.degree {
                let row: Complex64 = v.iter().enumerate().map(|(j, v)| v * beta[(k, j)]).sum();
                sum += power * row;
                power *= lambda;
            }
            sum
        };
        self.numerator.iter().map(of_output).collect()
    }

    /// A(z), and A'(z).
    pub(super) fn denominator(&self, z: Complex64) -> [Vec<Complex64>; 2] {
        let r = self.references;
        let mut a = vec![Complex64::ZERO; r * r];
        let mut slope = vec![Complex64::ZERO; r * r];
        for i in 0..r {
            a[i * r + i] = Complex64::ONE;
        }
        let mut power = Complex64::ONE; // z^(k - 1)
        for k in 1..=self.degree {
            for i in 0..r {
                for j in 0..r {
                    let alpha = self.alpha[((k - 1) * r + i, j)];
                    a[i * r + j] += power * z * alpha;
                    slope[i * r + j] += power * (k as f64 * alpha);
                }
            }
            power *= z;
        }
        [a, slope]
    }
}

/// Symmetric W with W² the inverse of a semidefinite matrix, without the eigenvalues that are only rounding.
fn inverse_root(a: &Matrix) -> Result<Matrix, LinalgError> {
    let e = symmetric_eigen(a)?;
    let n = a.rows();
    let largest = e.values.last().copied().unwrap_or(0.0);
    let kept: Vec<usize> = (0..n).filter(|&k| e.values[k] > RANK_LEAST * largest).collect();
    let half = Matrix::from_fn(kept.len(), n, |k, i| {
        e.vectors[(i, kept[k])] / e.values[kept[k]].powf(0.25)
    });
    Ok(half.transpose_times(&half))
}

/// Solution of a semidefinite system; the shortest one if there are several.
fn solve_semidefinite(a: &Matrix, b: Matrix) -> Result<Matrix, LinalgError> {
    if let Ok(lower) = cholesky(a) {
        let diagonal = (0..a.rows()).map(|i| lower[(i, i)].powi(2) / a[(i, i)]);
        if diagonal.fold(f64::INFINITY, f64::min) > 1e3 * RANK_LEAST {
            return solve_lower_transposed(&lower, solve_lower(&lower, b)?);
        }
    }
    let e = symmetric_eigen(a)?;
    let largest = e.values.last().copied().unwrap_or(0.0);
    let mut along = e.vectors.transpose_times(&b);
    for j in 0..along.columns() {
        for (x, value) in along.column_mut(j).iter_mut().zip(&e.values) {
            *x = if *value > RANK_LEAST * largest {
                *x / value
            } else {
                0.0
            };
        }
    }
    Ok(&e.vectors * &along)
}
