//! Stiffness from one mode measured at every level.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | φ | `displacement` | shape, Y of each level, any scale | – |
//! | q | `force` | ω² M φ + K_G φ − K_ties φ: forces in the storey springs | N/m × unit of φ |
//! | e_i | `extension` | drift of storey i (or its displacement, if grounded) | unit of φ |
//! | k_i | result | stiffness of storey i | N/m |
//! | κ_i | | stiffness of storey i if no axial force acted | N/m |
//! | m_j | `mass_kg` | mass of level j | kg |
//! | N_i | `axial_n` | axial force of storey i | N |
//! | l_i | `height_m` | height of storey i | m |

use super::storeys::{Convention, Frame};
use crate::structure::StructureError;
use dolmen_linalg::Matrix;

/// Least extension of a spring, relative to the largest displacement. Measured shapes of ambient vibration are rarely
/// better than 1 %, so a smaller extension gives only noise.
const EXTENSION_LEAST: f64 = 1e-3;

/// Stiffness for which this frequency and shape are an exact mode of the frame; no other mode is needed.
///
/// ```text
/// q = ω² M φ + K_G φ − K_ties φ                                                       n values
/// drift:     k_i = Σ_{j≥i} q_j / (φ_i − φ_{i−1})        = κ_i + N_i/l_i,  κ_i = ω² Σ_{j≥i} m_j φ_j / (φ_i − φ_{i−1})
/// grounded:  k_i = q_i / φ_i
/// ```
///
/// A negative stiffness means that frequency, shape and masses contradict each other.
///
/// # Input
/// * `frequency_hz` -- of the mode
/// * `displacement` -- of each level, lowest first; any scale and sign
///
/// # Errors
/// [`StructureError::Mode`]; [`StructureError::Count`] unless there is one displacement for each storey;
/// [`StructureError::Invisible`] if the spring of a storey does not deform, so that any stiffness fits.
///
/// # Limits
/// Errors of the shape are amplified by 1/|φ_i − φ_{i−1}|: with an error of 1 % of the largest displacement and a drift
/// of 5 % of it, k_i is wrong by 20 to 30 %.
///
/// # Example
/// ```
/// use dolmen::structure::{Convention, Frame, Storey, stiffness_from_shape};
/// let storeys = vec![
///     Storey { mass_kg: 290e3, height_m: 5.84, axial_n: 5919e3 },
///     Storey { mass_kg: 314e3, height_m: 7.69, axial_n: 3077e3 },
/// ];
/// let gate = Frame::new(storeys, Convention::Drift)?;
/// let k = stiffness_from_shape(&gate, 1.1, &[0.843, 1.0])?;
/// assert!((k[0] / 32.65e6 - 1.0).abs() < 1e-3 && (k[1] / 96.14e6 - 1.0).abs() < 5e-3);
/// # Ok::<(), dolmen::structure::StructureError>(())
/// ```
pub fn stiffness_from_shape(
    frame: &Frame,
    frequency_hz: f64,
    displacement: &[f64],
) -> Result<Vec<f64>, StructureError> {
    let n = frame.storeys().len();
    super::from_frequencies::check_ascending(&[frequency_hz])?;
    if displacement.len() != n {
        return Err(StructureError::Count {
            quantity: "displacement",
            given: displacement.len(),
            kind: "frame",
            needed: n,
            parts: "storeys",
        });
    }
    let largest = displacement.iter().fold(0.0_f64, |most, y| most.max(y.abs()));
    let omega = std::f64::consts::TAU * frequency_hz;
    // the stiffness without the storey springs is K_ties − K_G
    let other: Matrix = frame.stiffness_matrix(&vec![0.0; n])?;
    let inertia = frame.storeys().iter().zip(displacement);
    let inertia = inertia.map(|(s, y)| omega * omega * s.mass_kg * y);
    let force: Vec<f64> = inertia
        .zip(other.times(displacement))
        .map(|(a, b)| a - b)
        .collect();
    let mut stiffness = vec![0.0; n];
    let mut above = 0.0;
    for i in (0..n).rev() {
        above += force[i];
        let held = match frame.convention() {
            Convention::Drift => above,
            Convention::Grounded => force[i],
        };
        let e = extension(frame, displacement, i);
        if !(e.is_finite() && e.abs() > EXTENSION_LEAST * largest) {
            return Err(StructureError::Invisible {
                storey: i + 1,
                extension: e,
                largest,
            });
        }
        stiffness[i] = held / e;
    }
    Ok(stiffness)
}

/// Deformation of the spring of storey i: its drift, or its displacement.
fn extension(frame: &Frame, displacement: &[f64], i: usize) -> f64 {
    match frame.convention() {
        Convention::Grounded => displacement[i],
        Convention::Drift if i == 0 => displacement[0],
        Convention::Drift => displacement[i] - displacement[i - 1],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::{Storey, Tie};

    fn frame(convention: Convention) -> Frame {
        let storeys =
            [(3e5, 5.0, 9e6), (2e5, 4.0, 6e6), (4e5, 3.0, 4e6)].map(|(mass_kg, height_m, axial_n)| Storey {
                mass_kg,
                height_m,
                axial_n,
            });
        Frame::new(storeys.to_vec(), convention).unwrap()
    }

    #[test]
    fn exact_any_one_mode_gives_the_stiffness_back() {
        let k = [8e7, 5e7, 7e7];
        for convention in [Convention::Drift, Convention::Grounded] {
            let ties = vec![Tie {
                lower: 0,
                upper: 2,
                stiffness_n_m: 6e6,
            }];
            for frame in [frame(convention), frame(convention).with_ties(ties).unwrap()] {
                for mode in frame.natural_modes(&k).unwrap() {
                    let scaled: Vec<f64> = mode.displacement.iter().map(|y| -3.7 * y).collect();
                    let found = stiffness_from_shape(&frame, mode.frequency_hz, &scaled).unwrap();
                    for (found, k) in found.iter().zip(&k) {
                        assert!((found / k - 1.0).abs() < 1e-10, "{convention:?}: {found} {k}");
                    }
                }
            }
        }
    }

    #[test]
    fn refuses_a_shape_that_leaves_a_storey_unseen() {
        let message = |convention, shape: &[f64]| {
            stiffness_from_shape(&frame(convention), 1.0, shape)
                .unwrap_err()
                .to_string()
        };
        assert_eq!(
            message(Convention::Drift, &[0.5, 0.5, 1.0]),
            "storey 2 does not move in this shape (0 of 1): its stiffness cannot be seen; give another mode, or more \
             than one"
        );
        assert!(
            message(Convention::Grounded, &[0.0, 0.5, 1.0])
                .starts_with("storey 1 does not move in this shape")
        );
        assert!(message(Convention::Drift, &[0.1, f64::NAN, 1.0]).contains("(NaN of 1)"));
        assert!(
            message(Convention::Drift, &[1.0]).starts_with("displacement has 1 values, but the frame has 3")
        );
        let fault = stiffness_from_shape(&frame(Convention::Drift), -1.0, &[0.1, 0.5, 1.0]).unwrap_err();
        assert!(
            fault
                .to_string()
                .starts_with("mode 1: frequency_hz is -1, but must be a positive number")
        );
    }
}
