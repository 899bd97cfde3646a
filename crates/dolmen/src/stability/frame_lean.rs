//! The rest position of a leaning frame.

use super::{StabilityError, frame_stability};
use crate::structure::Frame;
use dolmen_linalg::{Matrix, solve};

/// Lean of each storey at rest, horizontal over vertical, for a frame with a stress-free lean `tilt`; `None` if it falls.
///
/// ```text
/// K Y = Bᵀ N τ,   lean_i = τ + δ_i/l_i                                     drift without ties: τ k_i/(k_i − N_i/l_i)
/// ```
/// A measured tilt already includes the contribution of gravity: used as τ, it gives a lean that is slightly too large.
///
/// # Errors
/// The errors of [`frame_stability`]; [`StabilityError::Linalg`] if the range of values exceeds the precision of the
/// numbers.
pub fn frame_lean_at_rest(
    frame: &Frame,
    stiffness_n_m: &[f64],
    tilt: f64,
) -> Result<Option<Vec<f64>>, StabilityError> {
    if frame_stability(frame, stiffness_n_m)?.load_factor <= 1.0 {
        return Ok(None);
    }
    let forces = frame.lean_forces_n(tilt);
    let right = Matrix::from_fn(forces.len(), 1, |i, _| forces[i]);
    let y = solve(&frame.stiffness_matrix(stiffness_n_m)?, &right)?;
    let below = |i: usize| i.checked_sub(1).map_or(0.0, |below| y[(below, 0)]);
    let each = frame.storeys().iter().enumerate();
    let leans = each.map(|(i, storey)| tilt + (y[(i, 0)] - below(i)) / storey.height_m);
    Ok(Some(leans.collect()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::{Convention, Storey};

    #[test]
    fn exact_each_storey_leans_by_the_ratio_of_its_springs() {
        let storeys =
            [(290e3, 5.84, 5919e3), (314e3, 7.69, 3077e3)].map(|(mass_kg, height_m, axial_n)| Storey {
                mass_kg,
                height_m,
                axial_n,
            });
        let frame = Frame::new(storeys.to_vec(), Convention::Drift).unwrap();
        let stiffness = [3e6, 1e6];
        let leans = frame_lean_at_rest(&frame, &stiffness, 0.02).unwrap().unwrap();
        for ((lean, k), storey) in leans.iter().zip(stiffness).zip(&storeys) {
            let wanted = 0.02 * k / (k - storey.axial_n / storey.height_m);
            assert!((lean / wanted - 1.0).abs() < 1e-12, "{lean} {wanted}");
        }
        assert_eq!(frame_lean_at_rest(&frame, &[1e6, 1e6], 0.02).unwrap(), None);
    }
}
