//! Eigenvalues of Hermitian matrices, without vectors: faer reduces the matrix to tridiagonal form, and the square-root-free QL iteration follows.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | d | `d` | diagonal |
//! | e² | `e2` | squares of the entries below it |

use crate::decompose::square_complex;
use crate::{Complex64, ComplexMatrix, LinalgError};
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::evd::tridiag::{tridiag_in_place, tridiag_in_place_scratch};
use faer::{Mat, Par, Spec};

const WHAT: &str = "hermitian_eigenvalues";
/// Largest number of iterations per eigenvalue, as in EISPACK: two are usual.
const ITERATIONS_MOST: usize = 30;

/// Eigenvalues of a Hermitian matrix, ascending (its lower triangle is read).
///
/// # Errors
/// As [`hermitian_eigen`](crate::hermitian_eigen).
///
/// # Source
/// Reinsch (1973) Comm. ACM 16(11):689, algorithm 464 (EISPACK's tqlrat). The error of each value is a few roundings of the largest.
pub fn hermitian_eigenvalues(a: &ComplexMatrix) -> Result<Vec<f64>, LinalgError> {
    let a = square_complex(WHAT, a)?;
    let n = a.nrows();
    let mut lower: Mat<Complex64> = Mat::zeros(n, n);
    lower.copy_from_triangular_lower(a);
    let mut reflectors: Mat<Complex64> = Mat::zeros(1, n - 1);
    let request: StackReq = tridiag_in_place_scratch::<Complex64>(n, Par::Seq, Spec::default());
    tridiag_in_place(
        lower.as_mut(),
        reflectors.as_mut(),
        Par::Seq,
        MemStack::new(&mut MemBuffer::new(request)),
        Spec::default(),
    );
    let mut d: Vec<f64> = (0..n).map(|i| lower[(i, i)].re).collect();
    let mut e2: Vec<f64> = (1..n).map(|i| lower[(i, i - 1)].norm_sqr()).collect();
    e2.push(0.0);
    // squares must neither overflow nor underflow
    let beside = e2.iter().map(|e2| e2.sqrt());
    let scale = d.iter().map(|d| d.abs()).chain(beside).fold(0.0, f64::max);
    if scale > 0.0 {
        d.iter_mut().for_each(|d| *d /= scale);
        let below = (1..n).map(|i| (lower[(i, i - 1)] / scale).norm_sqr());
        e2.iter_mut().zip(below).for_each(|(e2, square)| *e2 = square);
        of_three_diagonals(&mut d, &mut e2)?;
        d.iter_mut().for_each(|d| *d *= scale);
    }
    d.sort_by(f64::total_cmp);
    Ok(d)
}

/// Replaces the diagonal by the eigenvalues, in no particular order. The last of `e2` is zero; the largest entry is about 1.
fn of_three_diagonals(d: &mut [f64], e2: &mut [f64]) -> Result<(), LinalgError> {
    let n = d.len();
    let (mut shifted, mut largest, mut tiny, mut tiny_square) = (0.0, 0.0, 0.0, 0.0);
    for first in 0..n {
        let here = d[first].abs() + e2[first].sqrt();
        if largest <= here {
            largest = here;
            tiny = f64::EPSILON * largest;
            tiny_square = tiny * tiny;
        }
        let last = (first..n).find(|m| e2[*m] <= tiny_square).unwrap_or(n - 1);
        let mut iterations = 0;
        let mut is_found = last == first;
        while !is_found {
            if iterations == ITERATIONS_MOST {
                return Err(LinalgError::NoConvergence { what: WHAT });
            }
            iterations += 1;
            let (below, top) = (e2[first].sqrt(), d[first]);
            let p = (d[first + 1] - top) / (2.0 * below);
            d[first] = below / (p + p.hypot(1.0).copysign(p));
            let shift = top - d[first];
            d[first + 1..].iter_mut().for_each(|d| *d -= shift);
            shifted += shift;
            let [g, h, s] = swept(&mut d[first..=last], &mut e2[first..=last], tiny);
            e2[first] = s * g;
            d[first] = h;
            is_found = h == 0.0 || e2[first].abs() <= (tiny_square / h).abs();
            if !is_found {
                e2[first] *= h;
                is_found = e2[first] == 0.0;
            }
        }
        d[first] += shifted;
    }
    Ok(())
}

/// One sweep of the iteration, from the last entry to the first; returns its g, h and s.
fn swept(d: &mut [f64], e2: &mut [f64], tiny: f64) -> [f64; 3] {
    let not_zero = |g: f64| if g == 0.0 { tiny } else { g };
    let last = d.len() - 1;
    let mut g = not_zero(d[last]);
    let (mut h, mut s) = (g, 0.0);
    for i in (0..last).rev() {
        let p = g * h;
        let r = p + e2[i];
        e2[i + 1] = s * r;
        s = e2[i] / r;
        d[i + 1] = h + s * (h + d[i]);
        g = not_zero(d[i] - e2[i] / g);
        h = g * p / r;
    }
    [g, h, s]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hermitian_eigen;

    fn made(n: usize, entry: impl Fn(usize, usize) -> Complex64) -> ComplexMatrix {
        ComplexMatrix::from_fn(n, n, |i, j| match i.cmp(&j) {
            std::cmp::Ordering::Less => entry(j, i).conj(),
            std::cmp::Ordering::Equal => Complex64::new(entry(i, i).re, 0.0),
            std::cmp::Ordering::Greater => entry(i, j),
        })
    }

    fn near(a: &ComplexMatrix) {
        let (found, exact) = (
            hermitian_eigenvalues(a).unwrap(),
            hermitian_eigen(a).unwrap().values,
        );
        let largest = exact.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        for (found, exact) in found.iter().zip(&exact) {
            assert!(
                (found - exact).abs() <= 4e-15 * largest * (a.rows() as f64).sqrt(),
                "{found} {exact}"
            );
        }
    }

    #[test]
    fn agrees_with_the_full_decomposition_of_dense_low_rank_and_diagonal_matrices() {
        for n in [1, 2, 3, 7, 20, 64] {
            let wave = |i: usize, k: usize| {
                Complex64::from_polar(1.0, ((i + 1) * (k + 2)) as f64 * 0.37 + (i * i) as f64)
            };
            for scale in [1.0, 1e-150, 1e140] {
                near(&made(n, |i, j| {
                    scale * Complex64::new(((i * 7 + j * 3) % 11) as f64, (i * j % 5) as f64)
                }));
                // two modes and otherwise zeros: all values but two are zero
                near(&made(n, |i, j| {
                    scale * (wave(i, 0) * wave(j, 0).conj() + 0.1 * wave(i, 3) * wave(j, 3).conj())
                }));
                near(&made(n, |i, j| {
                    if i == j {
                        Complex64::new(scale * i as f64, 0.0)
                    } else {
                        Complex64::ZERO
                    }
                }));
            }
        }
        assert_eq!(
            hermitian_eigenvalues(&made(4, |_, _| Complex64::ZERO)).unwrap(),
            [0.0; 4]
        );
    }

    #[test]
    fn exact_values_of_a_chain_of_equal_springs() {
        // 2 on the diagonal, i below: 2 - 2 cos kπ/(n + 1)
        let n = 40;
        let found = hermitian_eigenvalues(&made(n, |i, j| match i - j {
            0 => Complex64::new(2.0, 0.0),
            1 => Complex64::I,
            _ => Complex64::ZERO,
        }));
        for (k, found) in found.unwrap().iter().enumerate() {
            let exact = 2.0 - 2.0 * ((k + 1) as f64 * std::f64::consts::PI / (n + 1) as f64).cos();
            assert!((found - exact).abs() < 1e-14, "{k}: {found} {exact}");
        }
    }
}
