//! The stationary covariance of a stable linear system under white noise.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | A | `a` | n × n, stable: ẋ = A x + w |
//! | Q | `q` | n × n, intensity of w: E w(t) w(t')ᵀ = Q δ(t − t') |
//! | P | result | n × n, E x xᵀ: A P + P Aᵀ + Q = 0 |

use dolmen_linalg::{LinalgError, Matrix, solve};

/// Largest number of doublings: 2^40 steps of the equivalent discrete system, far more than any structure needs to
/// reach its steady state.
const DOUBLINGS_MOST: usize = 40;

/// Symmetric solution P of A P + P Aᵀ + Q = 0; `None` if there is no convergence because A is not stable.
///
/// ```text
/// U = (pI − A)⁻¹(pI + A),  P₀ = 2p (pI − A)⁻¹ Q (pI − A)⁻ᵀ:   P ← P + U P Uᵀ,  U ← U²
/// ```
///
/// # Errors
/// As [`solve`].
///
/// # Source
/// Smith, R. A. (1968) SIAM J. Appl. Math. 16(1):198-201, with p = √(largest · smallest |λ|) as given.
pub(crate) fn lyapunov(a: &Matrix, q: &Matrix, shift: f64) -> Result<Option<Matrix>, LinalgError> {
    let n = a.rows();
    let plus = Matrix::from_fn(n, n, |i, j| a[(i, j)] + if i == j { shift } else { 0.0 });
    let minus = Matrix::from_fn(n, n, |i, j| -a[(i, j)] + if i == j { shift } else { 0.0 });
    let mut u = solve(&minus, &plus)?;
    let half = solve(&minus, q)?; // (pI − A)⁻¹ Q
    let mut p = solve(&minus, &half.transpose())?.scaled(2.0 * shift);
    for _ in 0..DOUBLINGS_MOST {
        let added = &(&u * &p) * &u.transpose();
        let (size, change) = (norm(&p), norm(&added));
        if !change.is_finite() {
            return Ok(None);
        }
        p = &p + &added;
        p = Matrix::from_fn(n, n, |i, j| 0.5 * (p[(i, j)] + p[(j, i)]));
        if change <= 1e-17 * size || size == 0.0 {
            return Ok(Some(p));
        }
        u = &u * &u;
    }
    Ok(None)
}

fn norm(a: &Matrix) -> f64 {
    a.as_slice().iter().fold(0.0_f64, |most, x| most.max(x.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_an_oscillator_under_white_noise() {
        // σ_x² = q / 4ζω³, σ_v² = q / 4ζω
        let (omega, zeta, q) = (3.0_f64, 0.01, 0.7);
        let a = Matrix::from_rows(&[[0.0, 1.0], [-omega * omega, -2.0 * zeta * omega]]);
        let p = lyapunov(&a, &Matrix::from_rows(&[[0.0, 0.0], [0.0, q]]), omega)
            .unwrap()
            .unwrap();
        assert!((p[(0, 0)] / (q / (4.0 * zeta * omega.powi(3))) - 1.0).abs() < 1e-13);
        assert!((p[(1, 1)] / (q / (4.0 * zeta * omega)) - 1.0).abs() < 1e-13);
        assert!(p[(0, 1)].abs() < 1e-13 * p[(1, 1)]);
        let unstable = Matrix::from_rows(&[[0.0, 1.0], [-omega * omega, 0.1]]);
        assert_eq!(lyapunov(&unstable, &Matrix::identity(2), omega).unwrap(), None);
    }
}
