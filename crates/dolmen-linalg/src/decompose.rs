use crate::product::view;
use crate::{ComplexMatrix, LinalgError, Matrix};
use faer::linalg::solvers::{Solve as _, SolveLstsq as _};
use faer::{MatRef, Side};
use num_complex::Complex64;

/// Eigenvalues (ascending) and orthonormal eigenvectors (columns) of a symmetric matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct SymmetricEigen {
    /// Eigenvalues, ascending.
    pub values: Vec<f64>,
    /// `n × n`, eigenvector `j` in column `j`.
    pub vectors: Matrix,
}

/// Eigenvalues (ascending) and orthonormal eigenvectors (columns) of a Hermitian matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct HermitianEigen {
    /// Eigenvalues, ascending.
    pub values: Vec<f64>,
    /// `n × n`, eigenvector `j` in column `j`.
    pub vectors: ComplexMatrix,
}

/// Eigenvalues and right eigenvectors of a general real matrix, in no particular order.
#[derive(Clone, Debug, PartialEq)]
pub struct Eigen {
    /// Eigenvalues; complex ones come in conjugate pairs.
    pub values: Vec<Complex64>,
    /// `n × n`, right eigenvector `j` in column `j`.
    pub vectors: ComplexMatrix,
}

/// A = U diag(s) Vᵀ, thin: k = min(rows, columns).
#[derive(Clone, Debug, PartialEq)]
pub struct Svd {
    /// `rows × k`.
    pub u: Matrix,
    /// Singular values, descending, `k` of them.
    pub s: Vec<f64>,
    /// `columns × k`.
    pub v: Matrix,
}

/// A = Q R, thin: k = min(rows, columns).
#[derive(Clone, Debug, PartialEq)]
pub struct Qr {
    /// `rows × k`, orthonormal columns.
    pub q: Matrix,
    /// `k × columns`, upper triangular.
    pub r: Matrix,
}

fn owned(a: MatRef<'_, f64>) -> Matrix {
    Matrix::from_fn(a.nrows(), a.ncols(), |i, j| a[(i, j)])
}

fn owned_complex(a: MatRef<'_, Complex64>) -> ComplexMatrix {
    ComplexMatrix::from_fn(a.nrows(), a.ncols(), |i, j| a[(i, j)])
}

pub(crate) fn finite(what: &'static str, a: &Matrix) -> Result<(), LinalgError> {
    match a.as_slice().iter().position(|x| !x.is_finite()) {
        None => Ok(()),
        Some(at) => {
            let (row, column) = (at % a.rows(), at / a.rows());
            Err(LinalgError::NotFinite {
                what,
                row,
                column,
                value: a.as_slice()[at],
            })
        }
    }
}

pub(crate) fn shaped(
    what: &'static str,
    a: &Matrix,
    fits: bool,
    needed: &'static str,
) -> Result<(), LinalgError> {
    if fits {
        return Ok(());
    }
    Err(LinalgError::Shape {
        what,
        rows: a.rows(),
        columns: a.columns(),
        needed,
    })
}

pub(crate) fn square(what: &'static str, a: &Matrix) -> Result<(), LinalgError> {
    shaped(
        what,
        a,
        a.rows() == a.columns() && a.rows() > 0,
        "square and not empty",
    )?;
    finite(what, a)
}

/// Eigenvalues and vectors of a symmetric matrix (its lower triangle is read).
///
/// # Errors
/// [`LinalgError::Shape`], [`LinalgError::NotFinite`], [`LinalgError::NoConvergence`].
pub fn symmetric_eigen(a: &Matrix) -> Result<SymmetricEigen, LinalgError> {
    const WHAT: &str = "symmetric_eigen";
    square(WHAT, a)?;
    let e = view(a)
        .self_adjoint_eigen(Side::Lower)
        .map_err(|_| LinalgError::NoConvergence { what: WHAT })?;
    Ok(SymmetricEigen {
        values: e.S().column_vector().iter().copied().collect(),
        vectors: owned(e.U()),
    })
}

/// Eigenvalues of a symmetric matrix, ascending (its lower triangle is read).
///
/// # Errors
/// As [`symmetric_eigen`].
pub fn symmetric_eigenvalues(a: &Matrix) -> Result<Vec<f64>, LinalgError> {
    const WHAT: &str = "symmetric_eigenvalues";
    square(WHAT, a)?;
    view(a)
        .self_adjoint_eigenvalues(Side::Lower)
        .map_err(|_| LinalgError::NoConvergence { what: WHAT })
}

/// K φ = λ M φ with M positive definite: λ ascending, φᵀ M φ = 1.
///
/// Cholesky M = L Lᵀ, two triangular solves, the symmetric problem of L⁻¹ K L⁻ᵀ.
///
/// # Errors
/// [`LinalgError::NotPositiveDefinite`] if M is not positive definite; otherwise as [`symmetric_eigen`].
pub fn generalized_symmetric_eigen(k: &Matrix, m: &Matrix) -> Result<SymmetricEigen, LinalgError> {
    const WHAT: &str = "generalized_symmetric_eigen";
    square(WHAT, k)?;
    shaped(WHAT, m, m.rows() == k.rows(), "of the same size as the first")?;
    let lower = cholesky(m)?;
    let l = view(&lower);
    let mut reduced = view(k).to_owned();
    l.solve_lower_triangular_in_place(&mut reduced); // L⁻¹ K
    let mut reduced = reduced.transpose().to_owned();
    l.solve_lower_triangular_in_place(&mut reduced); // L⁻¹ K L⁻ᵀ, transposed
    let symmetric = Matrix::from_fn(k.rows(), k.rows(), |i, j| {
        0.5 * (reduced[(i, j)] + reduced[(j, i)])
    });
    let e = symmetric_eigen(&symmetric)?;
    let mut vectors = view(&e.vectors).to_owned();
    l.transpose().solve_upper_triangular_in_place(&mut vectors);
    Ok(SymmetricEigen {
        values: e.values,
        vectors: owned(vectors.as_ref()),
    })
}

/// The lower triangle L of A = L Lᵀ.
///
/// # Errors
/// [`LinalgError::NotPositiveDefinite`], [`LinalgError::Shape`], [`LinalgError::NotFinite`].
pub fn cholesky(a: &Matrix) -> Result<Matrix, LinalgError> {
    const WHAT: &str = "cholesky";
    square(WHAT, a)?;
    let factor = view(a)
        .llt(Side::Lower)
        .map_err(|_| LinalgError::NotPositiveDefinite { what: WHAT })?;
    Ok(owned(factor.L()))
}

/// X of A X = B, A square, by LU with partial pivoting.
///
/// # Errors
/// [`LinalgError::Singular`] if a pivot is below 1e-15 of the largest; [`LinalgError::Shape`],
/// [`LinalgError::NotFinite`].
pub fn solve(a: &Matrix, b: &Matrix) -> Result<Matrix, LinalgError> {
    const WHAT: &str = "solve";
    const PIVOT_LEAST: f64 = 1e-15; // relative; a few rounding errors of f64
    square(WHAT, a)?;
    shaped(WHAT, b, b.rows() == a.rows(), "as many rows as the first")?;
    finite(WHAT, b)?;
    let lu = view(a).partial_piv_lu();
    let pivots = (0..a.rows()).map(|i| lu.U()[(i, i)].abs());
    let (least, most) = pivots.fold((f64::INFINITY, 0.0_f64), |(lo, hi), p| (lo.min(p), hi.max(p)));
    if least.is_nan() || least <= most * PIVOT_LEAST {
        return Err(LinalgError::Singular { what: WHAT });
    }
    Ok(owned(lu.solve(view(b)).as_ref()))
}

/// X that minimises ‖A X − B‖, for A with at least as many rows as columns and full column rank, by QR.
///
/// # Errors
/// [`LinalgError::Singular`] if a diagonal entry of R is below 1e-14 of the largest; [`LinalgError::Shape`],
/// [`LinalgError::NotFinite`].
pub fn solve_least_squares(a: &Matrix, b: &Matrix) -> Result<Matrix, LinalgError> {
    const WHAT: &str = "solve_least_squares";
    const DIAGONAL_LEAST: f64 = 1e-14; // relative
    shaped(
        WHAT,
        a,
        a.rows() >= a.columns() && a.columns() > 0,
        "at least as tall as wide and not empty",
    )?;
    shaped(WHAT, b, b.rows() == a.rows(), "as many rows as the first")?;
    finite(WHAT, a)?;
    finite(WHAT, b)?;
    let factor = view(a).qr();
    let diagonal = (0..a.columns()).map(|i| factor.thin_R()[(i, i)].abs());
    let (least, most) = diagonal.fold((f64::INFINITY, 0.0_f64), |(lo, hi), p| (lo.min(p), hi.max(p)));
    if least.is_nan() || least <= most * DIAGONAL_LEAST {
        return Err(LinalgError::Singular { what: WHAT });
    }
    Ok(owned(factor.solve_lstsq(view(b)).as_ref()))
}

/// Thin QR decomposition.
///
/// # Errors
/// [`LinalgError::NotFinite`].
pub fn qr(a: &Matrix) -> Result<Qr, LinalgError> {
    finite("qr", a)?;
    let factor = view(a).qr();
    Ok(Qr {
        q: owned(factor.compute_thin_Q().as_ref()),
        r: owned(factor.thin_R()),
    })
}

/// Thin singular value decomposition, complete (not randomised).
///
/// # Errors
/// [`LinalgError::NotFinite`], [`LinalgError::NoConvergence`].
pub fn svd(a: &Matrix) -> Result<Svd, LinalgError> {
    const WHAT: &str = "svd";
    shaped(WHAT, a, a.rows() > 0 && a.columns() > 0, "not empty")?;
    finite(WHAT, a)?;
    let f = view(a)
        .thin_svd()
        .map_err(|_| LinalgError::NoConvergence { what: WHAT })?;
    Ok(Svd {
        u: owned(f.U()),
        s: f.S().column_vector().iter().copied().collect(),
        v: owned(f.V()),
    })
}

/// Eigenvalues and right eigenvectors of a general real matrix.
///
/// # Errors
/// [`LinalgError::Shape`], [`LinalgError::NotFinite`], [`LinalgError::NoConvergence`].
pub fn eigen(a: &Matrix) -> Result<Eigen, LinalgError> {
    const WHAT: &str = "eigen";
    square(WHAT, a)?;
    let e = view(a)
        .eigen()
        .map_err(|_| LinalgError::NoConvergence { what: WHAT })?;
    Ok(Eigen {
        values: e.S().column_vector().iter().copied().collect(),
        vectors: owned_complex(e.U()),
    })
}

/// Eigenvalues and vectors of a Hermitian matrix (its lower triangle is read).
///
/// # Errors
/// [`LinalgError::Shape`], [`LinalgError::NotFinite`], [`LinalgError::NoConvergence`].
pub fn hermitian_eigen(a: &ComplexMatrix) -> Result<HermitianEigen, LinalgError> {
    const WHAT: &str = "hermitian_eigen";
    let e = square_complex(WHAT, a)?
        .self_adjoint_eigen(Side::Lower)
        .map_err(|_| LinalgError::NoConvergence { what: WHAT })?;
    Ok(HermitianEigen {
        values: e.S().column_vector().iter().map(|z| z.re).collect(),
        vectors: owned_complex(e.U()),
    })
}

/// The matrix in the form of faer, if it is square and finite.
pub(crate) fn square_complex<'a>(
    what: &'static str,
    a: &'a ComplexMatrix,
) -> Result<MatRef<'a, Complex64>, LinalgError> {
    let (rows, columns) = (a.rows(), a.columns());
    if rows != columns || rows == 0 {
        return Err(LinalgError::Shape {
            what,
            rows,
            columns,
            needed: "square and not empty",
        });
    }
    if let Some(at) = a.as_slice().iter().position(|z| !z.is_finite()) {
        let z = a.as_slice()[at];
        let value = if z.re.is_finite() { z.im } else { z.re };
        return Err(LinalgError::NotFinite {
            what,
            row: at % rows,
            column: at / rows,
            value,
        });
    }
    Ok(MatRef::from_column_major_slice(a.as_slice(), rows, columns))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: &Matrix, b: &Matrix, tolerance: f64) -> bool {
        a.as_slice()
            .iter()
            .zip(b.as_slice())
            .all(|(x, y)| (x - y).abs() <= tolerance)
    }

    fn sample() -> Matrix {
        Matrix::from_rows(&[[4.0, 1.0, -0.5], [1.0, 3.0, 0.25], [-0.5, 0.25, 2.0]])
    }

    #[test]
    fn holds_symmetric_eigenvectors_rebuild_the_matrix() {
        let a = sample();
        let e = symmetric_eigen(&a).unwrap();
        let rebuilt = &(&e.vectors * &Matrix::from_diagonal(&e.values)) * &e.vectors.transpose();
        assert!(close(&rebuilt, &a, 1e-14));
        assert!(e.values.is_sorted());
    }

    #[test]
    fn exact_generalized_eigenvalues_of_two_masses() {
        // K = [[2, -1], [-1, 1]], M = diag(2, 1): ω² = 1 ∓ 1/√2
        let k = Matrix::from_rows(&[[2.0, -1.0], [-1.0, 1.0]]);
        let m = Matrix::from_diagonal(&[2.0, 1.0]);
        let e = generalized_symmetric_eigen(&k, &m).unwrap();
        assert!((e.values[0] - (1.0 - 0.5_f64.sqrt())).abs() < 1e-14);
        assert!((e.values[1] - (1.0 + 0.5_f64.sqrt())).abs() < 1e-14);
        let unit = e.vectors.transpose_times(&(&m * &e.vectors));
        assert!(close(&unit, &Matrix::identity(2), 1e-14));
    }

    #[test]
    fn exact_rotation_has_eigenvalues_of_modulus_one() {
        let (s, c) = 0.3_f64.sin_cos();
        let e = eigen(&Matrix::from_rows(&[[c, -s], [s, c]])).unwrap();
        for value in e.values {
            assert!((value.norm() - 1.0).abs() < 1e-14);
            assert!((value.arg().abs() - 0.3).abs() < 1e-14);
        }
    }

    #[test]
    fn holds_svd_and_qr_rebuild_a_tall_matrix() {
        let a = Matrix::from_fn(5, 3, |i, j| ((i * 7 + j * 3) % 5) as f64 - 1.5 + 0.1 * j as f64);
        let f = svd(&a).unwrap();
        assert!(close(
            &(&(&f.u * &Matrix::from_diagonal(&f.s)) * &f.v.transpose()),
            &a,
            1e-13
        ));
        let f = qr(&a).unwrap();
        assert!(close(&(&f.q * &f.r), &a, 1e-13));
    }

    #[test]
    fn holds_least_squares_residual_is_orthogonal() {
        let a = Matrix::from_rows(&[[1.0, 0.0], [1.0, 1.0], [1.0, 2.0]]);
        let b = Matrix::from_column(&[1.0, 0.0, 2.0]);
        let residual = &(&a * &solve_least_squares(&a, &b).unwrap()) - &b;
        assert!(close(&a.transpose_times(&residual), &Matrix::zeros(2, 1), 1e-14));
    }

    #[test]
    fn exact_hermitian_pauli_matrix() {
        let i = Complex64::I;
        let a = ComplexMatrix::from_fn(2, 2, |r, c| {
            if r == c {
                Complex64::ZERO
            } else if r > c {
                i
            } else {
                -i
            }
        });
        let e = hermitian_eigen(&a).unwrap();
        assert!((e.values[0] + 1.0).abs() < 1e-15 && (e.values[1] - 1.0).abs() < 1e-15);
    }

    #[test]
    fn refuses_nan_and_says_where() {
        let mut a = sample();
        a[(2, 1)] = f64::NAN;
        let message = symmetric_eigen(&a).unwrap_err().to_string();
        assert!(message.contains("row 2, column 1 is NaN"), "{message}");
    }

    #[test]
    fn refuses_singular_and_indefinite() {
        let singular = Matrix::from_rows(&[[1.0, 2.0], [2.0, 4.0]]);
        let b = Matrix::from_column(&[1.0, 1.0]);
        assert_eq!(solve(&singular, &b), Err(LinalgError::Singular { what: "solve" }));
        let indefinite = Matrix::from_rows(&[[1.0, 2.0], [2.0, 1.0]]);
        assert_eq!(
            cholesky(&indefinite),
            Err(LinalgError::NotPositiveDefinite { what: "cholesky" })
        );
    }
}
