use crate::decompose::{finite, shaped, square};
use crate::product::view;
use crate::{LinalgError, Matrix};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{cholesky_in_place, cholesky_in_place_scratch};
use faer::{MatMut, MatRef, Par};

fn view_mut(a: &mut Matrix) -> MatMut<'_, f64> {
    let (rows, columns) = (a.rows(), a.columns());
    MatMut::from_column_major_slice_mut(a.as_mut_slice(), rows, columns)
}

/// The lower triangle L of A = L Lᵀ, in the memory of A (its lower triangle is read).
///
/// # Errors
/// As [`cholesky`](crate::cholesky).
pub fn cholesky_in_its_place(mut a: Matrix) -> Result<Matrix, LinalgError> {
    const WHAT: &str = "cholesky";
    square(WHAT, &a)?;
    let n = a.rows();
    let mut memory = MemBuffer::new(cholesky_in_place_scratch::<f64>(n, Par::Seq, Default::default()));
    cholesky_in_place(
        view_mut(&mut a),
        Default::default(),
        Par::Seq,
        MemStack::new(&mut memory),
        Default::default(),
    )
    .map_err(|_| LinalgError::NotPositiveDefinite { what: WHAT })?;
    for j in 1..n {
        a.column_mut(j)[..j].fill(0.0);
    }
    Ok(a)
}

/// L⁻¹ B with L lower triangular, in the memory of B.
///
/// # Errors
/// [`LinalgError::Singular`] if a diagonal entry is zero; [`LinalgError::Shape`], [`LinalgError::NotFinite`].
pub fn solve_lower(lower: &Matrix, b: Matrix) -> Result<Matrix, LinalgError> {
    solve_triangle("solve_lower", lower, b, |l, b| {
        l.solve_lower_triangular_in_place(b)
    })
}

/// L⁻ᵀ B with L lower triangular, in the memory of B.
///
/// # Errors
/// As [`solve_lower`].
pub fn solve_lower_transposed(lower: &Matrix, b: Matrix) -> Result<Matrix, LinalgError> {
    let solve = |l: MatRef<'_, f64>, b: MatMut<'_, f64>| l.transpose().solve_upper_triangular_in_place(b);
    solve_triangle("solve_lower_transposed", lower, b, solve)
}

fn solve_triangle(
    what: &'static str,
    lower: &Matrix,
    mut b: Matrix,
    solve: impl Fn(MatRef<'_, f64>, MatMut<'_, f64>),
) -> Result<Matrix, LinalgError> {
    shaped(
        what,
        lower,
        lower.rows() == lower.columns() && lower.rows() > 0,
        "square and not empty",
    )?;
    shaped(what, &b, b.rows() == lower.rows(), "as many rows as the first")?;
    finite(what, &b)?;
    if (0..lower.rows()).any(|i| lower[(i, i)] == 0.0) {
        return Err(LinalgError::Singular { what });
    }
    solve(view(lower), view_mut(&mut b));
    Ok(b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cholesky;

    #[test]
    fn exact_triangles_solve_what_they_multiply() {
        let n = 60;
        let lower = Matrix::from_fn(n, n, |i, j| match i.cmp(&j) {
            std::cmp::Ordering::Less => 0.0,
            std::cmp::Ordering::Equal => 2.0 + (i % 3) as f64,
            std::cmp::Ordering::Greater => 0.1 * ((i * 7 + j * 5) % 11) as f64 / n as f64,
        });
        let x = Matrix::from_fn(n, 3, |i, j| (i as f64 - 20.0) * 0.1 + j as f64);
        let near = |a: &Matrix, b: &Matrix| (a - b).as_slice().iter().all(|d| d.abs() < 1e-12);
        assert!(near(&solve_lower(&lower, &lower * &x).unwrap(), &x));
        assert!(near(
            &solve_lower_transposed(&lower, &lower.transpose() * &x).unwrap(),
            &x
        ));
        let a = &lower * &lower.transpose();
        assert!(near(&cholesky_in_its_place(a.clone()).unwrap(), &lower));
        assert!(near(
            &cholesky_in_its_place(a.clone()).unwrap(),
            &cholesky(&a).unwrap()
        ));
    }

    #[test]
    fn refuses_an_indefinite_matrix_and_a_zero_on_the_diagonal() {
        let a = Matrix::from_rows(&[[1.0, 2.0], [2.0, 1.0]]);
        assert!(matches!(
            cholesky_in_its_place(a),
            Err(LinalgError::NotPositiveDefinite { .. })
        ));
        let flat = Matrix::from_rows(&[[1.0, 0.0], [2.0, 0.0]]);
        assert!(matches!(
            solve_lower(&flat, Matrix::zeros(2, 1)),
            Err(LinalgError::Singular { .. })
        ));
    }
}
