//! Singular value decomposition of the matrix of each subspace method.

use super::block_hankel::FuturePast;
use super::hankel::{future_past, past_past};
use super::ssi_options::Ssi;
use crate::modal::ModalError;
use crate::modal::correlations::Correlations;
use crate::signal::Record;
use dolmen_linalg::{
    LinalgError, Matrix, Operator, Svd, cholesky_in_its_place, leading_svd, qr, solve_lower,
    solve_lower_transposed, svd,
};

/// Largest matrix that is decomposed in full; for larger ones, an iteration computes only the required vectors.
const FULL_MOST: usize = 500;
/// Least fraction of the power of a past sample that the other samples do not explain. Below it the sums of products
/// have lost half their digits, so the samples themselves are decomposed.
const UNEXPLAINED_LEAST: f64 = 1e-8;

/// Left singular vectors U, the singular values, and X with U = (Y⁺ Y⁻ᵀ) X.
pub(crate) struct Decomposed {
    pub(crate) u: Matrix,
    pub(crate) x: Matrix,
    pub(crate) s: Vec<f64>,
}

pub(super) fn of_covariance(r: &Correlations, options: &Ssi) -> Result<Decomposed, ModalError> {
    let (references, br) = (&options.references, options.block_rows);
    let operator = FuturePast::new(r, references, br);
    of_operator(&operator, options.order_most, || {
        Ok(future_past(r, references, br))
    })
}

/// Decomposition of A Bᵀ from that of R_A R_Bᵀ.   shape: m × n and k × n
pub(crate) fn of_product(a: &Matrix, b: &Matrix) -> Result<Decomposed, ModalError> {
    let (a, b) = (qr(a)?, qr(b)?);
    let f = svd(&(&a.r * &b.r.transpose()))?;
    let n = f.s.len();
    Ok(Decomposed {
        u: &a.q * &f.u,
        x: &b.q * &over_singular_values(&f, n),
        s: f.s,
    })
}

/// Decomposition of a correlation matrix that is given as an operator, without forming it.
pub(crate) fn of_operator(
    cross: &dyn Operator,
    order_most: usize,
    dense: impl Fn() -> Result<Matrix, LinalgError>,
) -> Result<Decomposed, ModalError> {
    let f = leading(cross, order_most, dense)?;
    let n = order_most.min(f.s.len());
    Ok(Decomposed {
        x: over_singular_values(&f, n),
        u: f.u.block(0, 0, f.u.rows(), n),
        s: f.s,
    })
}

/// Decomposition of the projection of the future on the past.
pub(super) fn of_data(record: &Record, r: &Correlations, options: &Ssi) -> Result<Decomposed, ModalError> {
    let lower = match independent_past(r, options)? {
        Some(lower) => lower,
        None if r.ends.is_none() => {
            return Err(ModalError::Dependent {
                decimation: options.decimation,
            });
        }
        None => return of_samples(record, options),
    };
    let (references, br) = (&options.references, options.block_rows);
    let projected = Projected {
        cross: &FuturePast::new(r, references, br),
        lower: &lower,
    };
    let f = leading(&projected, options.order_most, || {
        let cross = future_past(r, references, br);
        Ok(solve_lower(&lower, cross.transpose())?.transpose())
    })?;
    let n = options.order_most.min(f.s.len());
    Ok(Decomposed {
        x: solve_lower_transposed(&lower, over_singular_values(&f, n))?,
        u: f.u.block(0, 0, f.u.rows(), n),
        s: f.s,
    })
}

/// Cholesky factor L of Y⁻ Y⁻ᵀ / S = L Lᵀ; `None` if a past sample is nearly a linear combination of the others.
fn independent_past(r: &Correlations, options: &Ssi) -> Result<Option<Matrix>, ModalError> {
    let past = past_past(r, &options.references, options.block_rows);
    let power: Vec<f64> = (0..past.rows()).map(|i| past[(i, i)]).collect();
    match cholesky_in_its_place(past) {
        Ok(lower) => {
            let explained = |(i, power): (usize, &f64)| lower[(i, i)].powi(2) > UNEXPLAINED_LEAST * power;
            Ok(power.iter().enumerate().all(explained).then_some(lower))
        }
        Err(LinalgError::NotPositiveDefinite { .. }) => Ok(None),
        Err(other) => Err(other.into()),
    }
}

/// As [`of_data`], but from the samples: R of their QR factorisation, computed in pieces.
fn of_samples(record: &Record, options: &Ssi) -> Result<Decomposed, ModalError> {
    const PIECES: usize = 4; // number of column sets per piece, which keeps the memory at a few R
    let (l, r, br) = (
        record.channels().len(),
        options.references.len(),
        options.block_rows,
    );
    let starts = record.length() + 1 - 2 * br;
    let columns = (l + r) * br;
    let means: Vec<f64> = (0..l)
        .map(|c| record.samples(c).iter().sum::<f64>() / record.length() as f64)
        .collect();
    let scale = 1.0 / (starts as f64).sqrt();
    let sample = |t: usize, column: usize| {
        let (c, at) = if column < r * br {
            (options.references[column % r], t + br - 1 - column / r)
        } else {
            ((column - r * br) % l, t + br + (column - r * br) / l)
        };
        scale * (record.samples(c)[at] - means[c])
    };
    let mut triangle = Matrix::zeros(0, columns);
    for from in (0..starts).step_by(PIECES * columns) {
        let above = triangle.rows();
        let piece = (PIECES * columns).min(starts - from);
        let stacked = Matrix::from_fn(above + piece, columns, |i, j| {
            if i < above {
                triangle[(i, j)]
            } else {
                sample(from + i - above, j)
            }
        });
        triangle = qr(&stacked)?.r;
    }
    let past = r * br;
    let projection = Matrix::from_fn(l * br, past, |i, j| triangle[(j, past + i)]);
    let f = svd(&projection)?;
    let n = options.order_most.min(f.s.len());
    // directions outside the span of the past have no scatter: keep their diagonal above zero
    let largest = (0..past).map(|i| triangle[(i, i)].abs()).fold(0.0, f64::max);
    let floor = UNEXPLAINED_LEAST * largest;
    let lower = Matrix::from_fn(past, past, |i, j| match i.cmp(&j) {
        std::cmp::Ordering::Less => 0.0,
        std::cmp::Ordering::Equal => triangle[(i, i)].abs().max(floor).copysign(triangle[(i, i)]),
        std::cmp::Ordering::Greater => triangle[(j, i)],
    });
    Ok(Decomposed {
        x: solve_lower_transposed(&lower, over_singular_values(&f, n))?,
        u: f.u.block(0, 0, f.u.rows(), n),
        s: f.s,
    })
}

/// The first `n` columns of V S⁻¹.
fn over_singular_values(f: &Svd, n: usize) -> Matrix {
    Matrix::from_fn(f.v.rows(), n, |i, j| f.v[(i, j)] / f.s[j].max(f64::MIN_POSITIVE))
}

/// The first `count` singular triplets of a large matrix, or all of a small one.
fn leading(
    operator: &dyn Operator,
    count: usize,
    dense: impl Fn() -> Result<Matrix, LinalgError>,
) -> Result<Svd, LinalgError> {
    let [rows, columns] = operator.shape();
    if rows.min(columns) > FULL_MOST {
        match leading_svd(operator, count) {
            Err(LinalgError::NoConvergence { .. }) => {}
            result => return result,
        }
    }
    svd(&dense()?)
}

/// The operator Y⁺ Y⁻ᵀ L⁻ᵀ, never formed as a matrix.
struct Projected<'a> {
    cross: &'a FuturePast,
    lower: &'a Matrix,
}

impl Operator for Projected<'_> {
    fn shape(&self) -> [usize; 2] {
        self.cross.shape()
    }
    fn times(&self, x: Matrix) -> Result<Matrix, LinalgError> {
        self.cross.times(solve_lower_transposed(self.lower, x)?)
    }
    fn transpose_times(&self, y: Matrix) -> Result<Matrix, LinalgError> {
        solve_lower(self.lower, self.cross.transpose_times(y)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::correlations::correlate;
    use crate::numeric::Random;
    use crate::signal::Channel;

    #[test]
    fn agrees_with_the_qr_of_the_stacked_samples() {
        let (l, length, br) = (3, 900, 6);
        let mut random = Random::new(5, 0);
        let mut before = [0.0; 2];
        let rows: Vec<[f64; 3]> = (0..length)
            .map(|_| {
                before = [1.8 * before[0] - 0.95 * before[1] + random.normal(), before[0]];
                [1.0, -0.4, 0.7].map(|phi| phi * before[0] + 0.3 * random.normal())
            })
            .collect();
        let samples = (0..l).map(|c| rows.iter().map(|row| row[c]).collect()).collect();
        let names = (0..l).map(|c| Channel::named(format!("{c}"))).collect();
        let record = Record::new(names, samples, 10.0).unwrap();
        let options = Ssi {
            block_rows: br,
            order_most: 4,
            references: vec![1, 2],
            ..Default::default()
        };
        let r = correlate(&record, 2 * br - 1, 2).unwrap();
        let (sums, qr) = (
            of_data(&record, &r, &options).unwrap(),
            of_samples(&record, &options).unwrap(),
        );
        for (a, b) in sums.s.iter().zip(&qr.s) {
            assert!((a - b).abs() < 1e-12 * sums.s[0], "{a} {b}");
        }
        for j in 0..4 {
            let along: f64 = sums
                .u
                .column(j)
                .iter()
                .zip(qr.u.column(j))
                .map(|(a, b)| a * b)
                .sum();
            assert!((along.abs() - 1.0).abs() < 1e-11);
            let sign = along.signum();
            for (a, b) in sums.x.column(j).iter().zip(qr.x.column(j)) {
                assert!((a - sign * b).abs() < 1e-9 * a.abs().max(0.01), "{a} {b}");
            }
        }
    }
}
