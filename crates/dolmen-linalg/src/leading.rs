use crate::decompose::finite;
use crate::product::view;
use crate::{LinalgError, Matrix, Svd, qr, svd};
use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};

/// Number of vectors that are multiplied together: with fewer vectors the operator is read more often, with more the
/// space is larger.
const BLOCK: usize = 16;
/// Ratio of the residual to the largest singular value at which a triplet has converged: a few hundred roundings, as in
/// a full decomposition.
const RESIDUAL_MOST: f64 = 5e-14;
/// Size of the space, in multiples of the requested number of vectors, at which the iteration ends without a result.
const SPACE_MOST: usize = 16;
/// Relative norm, to the largest singular value, below which a new direction is rounding: the operator then has no
/// further directions.
const DIRECTION_LEAST: f64 = 1e-14;

/// A linear map and its transpose, each given by its effect on a block of columns.
pub trait Operator {
    /// Rows and columns.
    fn shape(&self) -> [usize; 2];
    /// A X.
    ///
    /// # Errors
    /// Any error of the map itself.
    fn times(&self, x: Matrix) -> Result<Matrix, LinalgError>;
    /// Aᵀ Y.
    ///
    /// # Errors
    /// Any error of the map itself.
    fn transpose_times(&self, y: Matrix) -> Result<Matrix, LinalgError>;
}

/// The `count` largest singular values with their vectors, to the accuracy of a full decomposition. The start is random,
/// but the iteration continues until the result does not depend on it.
///
/// Block Golub–Kahan–Lanczos bidiagonalisation with full reorthogonalisation:
/// ```text
/// A V = U T,   Aᵀ U = V Tᵀ + V₊ S Eᵀ          residual of triplet i: |S Eᵀ p_i|,  T = P diag(s) Qᵀ
/// ```
///
/// # Errors
/// [`LinalgError::NoConvergence`] if a space of 16 times `count` is not sufficient, or the rank of the map is smaller:
/// use [`svd`] then. Errors of the map itself.
///
/// # Source
/// Golub, Luk & Overton (1981) ACM Trans. Math. Softw. 7:149-169.
pub fn leading_svd(a: &dyn Operator, count: usize) -> Result<Svd, LinalgError> {
    const WHAT: &str = "leading_svd";
    let [rows, columns] = a.shape();
    let most = (SPACE_MOST * count).min(rows.min(columns)) / BLOCK * BLOCK;
    let mut u = Basis::new(rows, most);
    let mut v = Basis::new(columns, most + BLOCK);
    let mut t = Matrix::zeros(most, most);
    let mut next = qr(&start(columns))?.q;
    let mut check_at = (2 * count).next_multiple_of(BLOCK);
    let mut largest: f64 = 0.0;
    while u.count + BLOCK <= most {
        let at = u.count;
        v.push(&next);
        let mut w = a.times(next)?;
        finite(WHAT, &w)?;
        let along = u.remove(&mut w);
        let f = qr(&w)?;
        for j in 0..BLOCK {
            t.column_mut(at + j)[..at].copy_from_slice(along.column(j));
            t.column_mut(at + j)[at..at + BLOCK].copy_from_slice(f.r.column(j));
            largest = largest.max(f.r.column(j).iter().map(|x| x * x).sum::<f64>().sqrt());
        }
        // the columns of a nearly dependent block are orthogonal to each other but not to what came before
        let mut q = f.q;
        u.remove(&mut q);
        u.push(&q);
        let mut z = a.transpose_times(q)?;
        v.remove(&mut z);
        let f = qr(&z)?;
        let least = (0..BLOCK)
            .map(|j| f.r[(j, j)].abs())
            .fold(f64::INFINITY, f64::min);
        if least <= DIRECTION_LEAST * largest {
            return Err(LinalgError::NoConvergence { what: WHAT });
        }
        next = f.q;
        v.remove(&mut next);
        if u.count >= check_at || u.count + BLOCK > most {
            let k = u.count;
            let inner = svd(&t.block(0, 0, k, k))?;
            let residual = &f.r * &inner.u.block(k - BLOCK, 0, BLOCK, count);
            let norm = |j: usize| residual.column(j).iter().map(|x| x * x).sum::<f64>().sqrt();
            if (0..count).all(|j| norm(j) <= RESIDUAL_MOST * inner.s[0]) {
                return Ok(Svd {
                    u: u.times(&inner.u.block(0, 0, k, count)),
                    s: inner.s[..count].to_vec(),
                    v: v.times(&inner.v.block(0, 0, k, count)),
                });
            }
            check_at = k + (k / 6).next_multiple_of(BLOCK);
        }
    }
    Err(LinalgError::NoConvergence { what: WHAT })
}

/// Fixed pseudo-random numbers between -1 and 1 (xorshift).
fn start(rows: usize) -> Matrix {
    let mut state: u64 = 0x9E37_79B9_7F4A_7C15;
    Matrix::from_fn(rows, BLOCK, |_, _| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    })
}

/// Orthonormal columns in memory of fixed size.
struct Basis {
    rows: usize,
    count: usize,
    data: Vec<f64>,
}

impl Basis {
    fn new(rows: usize, most: usize) -> Self {
        Basis {
            rows,
            count: 0,
            data: Vec::with_capacity(rows * most),
        }
    }

    fn push(&mut self, block: &Matrix) {
        self.data.extend_from_slice(block.as_slice());
        self.count += block.columns();
    }

    fn view(&self) -> MatRef<'_, f64> {
        MatRef::from_column_major_slice(&self.data, self.rows, self.count)
    }

    /// Subtracts from `w` its part within the basis, twice; returns the coordinates of this part, count × columns.
    fn remove(&self, w: &mut Matrix) -> Matrix {
        let mut all = Matrix::zeros(self.count, w.columns());
        if self.count == 0 {
            return all;
        }
        for _ in 0..2 {
            let mut along = Matrix::zeros(self.count, w.columns());
            product(
                &mut along,
                self.view().transpose(),
                view(w),
                (Accum::Replace, 1.0),
            );
            product(w, self.view(), view(&along), (Accum::Add, -1.0));
            all = &all + &along;
        }
        all
    }

    fn times(&self, x: &Matrix) -> Matrix {
        let mut y = Matrix::zeros(self.rows, x.columns());
        let used = MatRef::from_column_major_slice(&self.data[..self.rows * x.rows()], self.rows, x.rows());
        product(&mut y, used, view(x), (Accum::Replace, 1.0));
        y
    }
}

fn product(target: &mut Matrix, a: MatRef<'_, f64>, b: MatRef<'_, f64>, (how, factor): (Accum, f64)) {
    let (rows, columns) = (target.rows(), target.columns());
    let target = MatMut::from_column_major_slice_mut(target.as_mut_slice(), rows, columns);
    matmul(target, how, a, b, factor, Par::Seq);
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Dense(Matrix);

    impl Operator for Dense {
        fn shape(&self) -> [usize; 2] {
            [self.0.rows(), self.0.columns()]
        }
        fn times(&self, x: Matrix) -> Result<Matrix, LinalgError> {
            Ok(&self.0 * &x)
        }
        fn transpose_times(&self, y: Matrix) -> Result<Matrix, LinalgError> {
            Ok(self.0.transpose_times(&y))
        }
    }

    #[test]
    fn exact_singular_values_and_vectors_of_a_full_decomposition() {
        // a few large values above slowly decreasing small ones, as for correlations
        let (rows, columns) = (300, 340);
        let turn = |n: usize, k: f64| {
            let entry =
                |i: usize, j: usize| ((i * (j + 1)) as f64 * k).sin() + if i == j { 2.0 } else { 0.0 };
            qr(&Matrix::from_fn(n, rows, entry)).unwrap().q
        };
        let values: Vec<f64> = (0..rows)
            .map(|i| 50.0 * (-0.35 * i as f64).exp() + 0.02 - 5e-5 * i as f64)
            .collect();
        let a = &(&turn(rows, 1.3) * &Matrix::from_diagonal(&values)) * &turn(columns, 0.7).transpose();
        let found = leading_svd(&Dense(a.clone()), 12).unwrap();
        for (j, value) in values.iter().take(12).enumerate() {
            assert!((found.s[j] - value).abs() < 1e-12, "{j}: {} {value}", found.s[j]);
            let v = Matrix::from_column(found.v.column(j));
            let u = Matrix::from_column(found.u.column(j));
            let rest = &(&a * &v) - &u.scaled(found.s[j]);
            assert!(rest.as_slice().iter().all(|x| x.abs() < 1e-11));
            let rest = &a.transpose_times(&u) - &v.scaled(found.s[j]);
            assert!(rest.as_slice().iter().all(|x| x.abs() < 1e-11));
        }
    }

    #[test]
    fn refuses_a_map_whose_rank_ends_before_the_count() {
        let thin = Matrix::from_fn(200, 200, |i, j| (i as f64 * 0.1).sin() * (j as f64 * 0.2).cos());
        let fault = leading_svd(&Dense(thin), 12).unwrap_err();
        assert!(matches!(fault, LinalgError::NoConvergence { .. }), "{fault}");
    }
}
