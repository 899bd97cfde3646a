//! Products of matrices, on faer.

use crate::Matrix;
use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};

pub(crate) fn view(a: &Matrix) -> MatRef<'_, f64> {
    MatRef::from_column_major_slice(a.as_slice(), a.rows(), a.columns())
}

impl Matrix {
    /// Selfᵀ times `other`, without forming the transpose.
    pub fn transpose_times(&self, other: &Matrix) -> Matrix {
        let mut product = Matrix::zeros(self.columns(), other.columns());
        self.transpose_times_into(other, &mut product);
        product
    }

    /// Writes selfᵀ times `other` into `product`: for a product that is computed repeatedly.
    ///
    /// # Panics
    /// Unless `product` has as many rows as `self` has columns, and as many columns as `other`.
    pub fn transpose_times_into(&self, other: &Matrix, product: &mut Matrix) {
        assert_eq!(self.rows(), other.rows(), "Aᵀ B needs as many rows in A as in B");
        assert_eq!(
            (product.rows(), product.columns()),
            (self.columns(), other.columns()),
            "Aᵀ B has the columns of A as rows and those of B as columns"
        );
        multiply_transposed(self, other, product);
    }
}

impl std::ops::Mul for &Matrix {
    type Output = Matrix;
    fn mul(self, other: &Matrix) -> Matrix {
        assert_eq!(
            self.columns(),
            other.rows(),
            "A B needs as many columns in A as rows in B"
        );
        multiply(self, other)
    }
}

fn multiply(a: &Matrix, b: &Matrix) -> Matrix {
    let mut c = Matrix::zeros(a.rows(), b.columns());
    let target = MatMut::from_column_major_slice_mut(c.as_mut_slice(), a.rows(), b.columns());
    matmul(target, Accum::Replace, view(a), view(b), 1.0, Par::Seq);
    c
}

fn multiply_transposed(a: &Matrix, b: &Matrix, c: &mut Matrix) {
    let target = MatMut::from_column_major_slice_mut(c.as_mut_slice(), a.columns(), b.columns());
    matmul(
        target,
        Accum::Replace,
        view(a).transpose(),
        view(b),
        1.0,
        Par::Seq,
    );
}
