//! Solves small systems of complex equations.

use num_complex::Complex64;

/// Solves A x = b by elimination with row pivoting; A is given row by row and overwritten. Returns `false` if A
/// is singular.
pub(crate) fn complex_solve(a: &mut [Vec<Complex64>], b: &mut [Complex64]) -> bool {
    complex_solve_all(a, &mut [b])
}

/// Solves the system for several right sides b.
pub(crate) fn complex_solve_all(a: &mut [Vec<Complex64>], right: &mut [&mut [Complex64]]) -> bool {
    let n = a.len();
    for j in 0..n {
        let Some(pivot) = (j..n).reduce(|best, i| match a[i][j].norm_sqr() > a[best][j].norm_sqr() {
            true => i,
            false => best,
        }) else {
            return false;
        };
        a.swap(j, pivot);
        right.iter_mut().for_each(|b| b.swap(j, pivot));
        if a[j][j] == Complex64::ZERO || !a[j][j].is_finite() {
            return false;
        }
        for i in j + 1..n {
            let factor = a[i][j] / a[j][j];
            let (above, below) = a.split_at_mut(i);
            for (target, source) in below[0][j..].iter_mut().zip(&above[j][j..]) {
                *target -= factor * source;
            }
            for b in &mut *right {
                let known = b[j];
                b[i] -= factor * known;
            }
        }
    }
    for b in right {
        for i in (0..n).rev() {
            let known: Complex64 = a[i][i + 1..].iter().zip(&b[i + 1..]).map(|(a, x)| a * x).sum();
            b[i] = (b[i] - known) / a[i][i];
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_two_equations() {
        let i = Complex64::I;
        let one = Complex64::ONE;
        let mut a = vec![vec![Complex64::ZERO, one], vec![2.0 * i, i]];
        let (mut b, mut twice) = ([one, 3.0 * i], [2.0 * one, 6.0 * i]);
        assert!(complex_solve_all(&mut a, &mut [&mut b, &mut twice]));
        for (x, exact) in [(b, one), (twice, 2.0 * one)] {
            assert!((x[0] - exact).norm() < 1e-15 && (x[1] - exact).norm() < 1e-15);
        }
        assert!(!complex_solve(&mut [vec![Complex64::ZERO]], &mut [one]));
    }
}
