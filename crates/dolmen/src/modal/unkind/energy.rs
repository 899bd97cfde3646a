//! How clearly a record can show a mode, from the densities of its simulation, independent of any method of
//! identification.

use crate::modal::{MadeMode, ModalError};
use dolmen_linalg::{Matrix, solve};

/// Density of mode `j` over that of all other motion at its frequency, in the best combination of channels.
///
/// ```text
/// S = Σ_(k≠j) P_k φ_k φ_kᵀ + diag(noise),   max_w  P_j (wᵀφ_j)² / wᵀSw  =  P_j φ_jᵀ S⁻¹ φ_j
/// ```
///
/// # Errors
/// [`ModalError::Linalg`] without noise.
pub(super) fn signal_over_rest(
    modes: &[MadeMode],
    j: usize,
    density: &[f64],
    noise: &[f64],
) -> Result<f64, ModalError> {
    let l = noise.len();
    let rest = Matrix::from_fn(l, l, |a, b| {
        let others = modes.iter().zip(density).enumerate().filter(|(k, _)| *k != j);
        let motion: f64 = others
            .map(|(_, (mode, p))| p * mode.shape[a] * mode.shape[b])
            .sum();
        motion + if a == b { noise[a] } else { 0.0 }
    });
    let phi = &modes[j].shape;
    let weights = solve(&rest, &Matrix::from_column(phi))?;
    let along: f64 = weights.column(0).iter().zip(phi).map(|(w, x)| w * x).sum();
    Ok(density[j] * along)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_a_lone_mode_over_white_noise_and_two_like_modes() {
        let mode = |shape: [f64; 2]| MadeMode {
            frequency_hz: 1.0,
            damping_ratio: 0.01,
            shape: shape.to_vec(),
        };
        // P |φ|²/n
        let alone = signal_over_rest(&[mode([3.0, 4.0])], 0, &[2.0], &[0.5, 0.5]).unwrap();
        assert!((alone - 2.0 * 25.0 / 0.5).abs() < 1e-9);
        // a mode with the same shape counts as noise with its power; a mode with an orthogonal shape does not count
        let like = [mode([1.0, 0.0]), mode([1.0, 0.0])];
        let of = signal_over_rest(&like, 0, &[6.0, 2.0], &[1.0, 1.0]).unwrap();
        assert!((of - 6.0 / 3.0).abs() < 1e-9);
        let across = [mode([1.0, 0.0]), mode([0.0, 1.0])];
        assert!((signal_over_rest(&across, 0, &[6.0, 2.0], &[1.0, 1.0]).unwrap() - 6.0).abs() < 1e-9);
    }
}
