//! Products, Cholesky factors and independent real parameters of small complex matrices.

use dolmen_linalg::{Complex64, ComplexMatrix};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Part {
    Real,
    Imaginary,
}

impl Part {
    pub(super) fn unit(self) -> Complex64 {
        match self {
            Part::Real => Complex64::new(1.0, 0.0),
            Part::Imaginary => Complex64::new(0.0, 1.0),
        }
    }
}

/// A Hermitian matrix as a real vector. The dot product of two such vectors is the trace of the product of the
/// matrices.
pub(super) fn real(a: &ComplexMatrix) -> Vec<f64> {
    let both = |z: Complex64, part: Part| match part {
        Part::Real => z.re,
        Part::Imaginary => z.im,
    };
    hermitian(a.rows())
        .map(|(i, j, part)| {
            if i == j {
                a[(i, i)].re
            } else {
                2.0_f64.sqrt() * both(a[(i, j)], part)
            }
        })
        .collect()
}

/// Indices and parts of the independent real parameters of a Hermitian matrix, on and below the diagonal.
pub(super) fn hermitian(size: usize) -> impl Iterator<Item = (usize, usize, Part)> {
    (0..size).flat_map(|i| {
        let below = (0..i).flat_map(move |j| [(i, j, Part::Real), (i, j, Part::Imaginary)]);
        below.chain(std::iter::once((i, i, Part::Real)))
    })
}

pub(super) fn add_hermitian(to: &mut ComplexMatrix, (i, j): (usize, usize), by: Complex64) {
    to[(i, j)] += by;
    if i != j {
        to[(j, i)] += by.conj();
    }
}

pub(super) fn plus(a: &ComplexMatrix, b: &ComplexMatrix) -> ComplexMatrix {
    ComplexMatrix::from_fn(a.rows(), a.columns(), |i, j| a[(i, j)] + b[(i, j)])
}

pub(super) fn scaled(a: &ComplexMatrix, by: f64) -> ComplexMatrix {
    ComplexMatrix::from_fn(a.rows(), a.columns(), |i, j| by * a[(i, j)])
}

pub(super) fn times(a: &ComplexMatrix, b: &ComplexMatrix) -> ComplexMatrix {
    ComplexMatrix::from_fn(a.rows(), b.columns(), |i, j| {
        (0..a.columns()).map(|k| a[(i, k)] * b[(k, j)]).sum()
    })
}

pub(super) fn adjoint(a: &ComplexMatrix) -> ComplexMatrix {
    ComplexMatrix::from_fn(a.columns(), a.rows(), |i, j| a[(j, i)].conj())
}

/// Cholesky factor of a small Hermitian matrix; `None` if the matrix is not positive definite.
pub(super) fn lower(a: &ComplexMatrix) -> Option<ComplexMatrix> {
    let n = a.rows();
    let mut l = ComplexMatrix::zeros(n, n);
    for j in 0..n {
        let taken: f64 = (0..j).map(|k| l[(j, k)].norm_sqr()).sum();
        let left = a[(j, j)].re - taken;
        if left.is_nan() || left <= 1e-12 * a[(j, j)].re {
            return None;
        }
        let own = left.sqrt();
        l[(j, j)] = own.into();
        for i in j + 1..n {
            let taken: Complex64 = (0..j).map(|k| l[(i, k)] * l[(j, k)].conj()).sum();
            l[(i, j)] = (a[(i, j)] - taken) / own;
        }
    }
    Some(l)
}

/// L⁻¹ A.
pub(super) fn forward(lower: &ComplexMatrix, a: &ComplexMatrix) -> ComplexMatrix {
    let mut x = a.clone();
    for j in 0..a.columns() {
        for i in 0..a.rows() {
            let taken: Complex64 = (0..i).map(|k| lower[(i, k)] * x[(k, j)]).sum();
            x[(i, j)] = (x[(i, j)] - taken) / lower[(i, i)].re;
        }
    }
    x
}

/// L⁻* A.
pub(super) fn backward(lower: &ComplexMatrix, a: &ComplexMatrix) -> ComplexMatrix {
    let n = a.rows();
    let mut x = a.clone();
    for j in 0..a.columns() {
        for i in (0..n).rev() {
            let taken: Complex64 = (i + 1..n).map(|k| lower[(k, i)].conj() * x[(k, j)]).sum();
            x[(i, j)] = (x[(i, j)] - taken) / lower[(i, i)].re;
        }
    }
    x
}

/// L⁻¹ A L⁻*.
pub(super) fn whitened(lower: &ComplexMatrix, a: &ComplexMatrix) -> ComplexMatrix {
    adjoint(&forward(lower, &adjoint(&forward(lower, a))))
}

/// L⁻* A L⁻¹.
pub(super) fn behind(lower: &ComplexMatrix, a: &ComplexMatrix) -> ComplexMatrix {
    adjoint(&backward(lower, &adjoint(&backward(lower, a))))
}
