//! Range of a storey's stiffness when frequencies are rounded.

use super::from_frequencies::check_ascending;
use super::storeys::{Frame, not_negative};
use crate::structure::inverse::{Sprung, range_of_root};
use crate::structure::{StiffnessRange, StructureError};

/// Range of each stiffness of one root while every frequency stays within `frequencies_hz` ± `half_width_hz`: the
/// effect of rounding alone.
///
/// The function follows the root to the 2ⁿ corners of the box of frequencies and keeps its extremes. A root can meet another
/// root and end inside the box; the range then says so.
///
/// # Input
/// * `frequencies_hz` -- of all n modes, ascending
/// * `half_width_hz` -- of each frequency; 0.05 for one printed with one decimal
/// * `root_n_m` -- the stiffness for these frequencies, for example from
///   [`stiffness_from_frequencies`](super::stiffness_from_frequencies)
///
/// # Errors
/// [`StructureError::Frequencies`], [`StructureError::Mode`], [`StructureError::FrequencyOrder`], [`StructureError::Count`],
/// [`StructureError::Negative`] for a half-width.
///
/// # Limits
/// Extremes between corners are not searched. The result is exact if each stiffness increases or decreases with each
/// frequency throughout the box, which is true unless two roots are near.
///
/// # Example
/// ```
/// use dolmen::structure::{Convention, Frame, Storey, stiffness_from_frequencies, stiffness_range};
/// let storeys = vec![
///     Storey { mass_kg: 290e3, height_m: 5.84, axial_n: 5919e3 + 3077e3 }, // as eq. 7 is printed
///     Storey { mass_kg: 314e3, height_m: 7.69, axial_n: 3077e3 },
/// ];
/// let gate = Frame::new(storeys, Convention::Grounded)?;
/// let root = &stiffness_from_frequencies(&gate, &[1.1, 4.2])?.stiffness[1];
/// let range = stiffness_range(&gate, &[1.1, 4.2], &[0.05, 0.05], root)?;
/// assert!((range.lower[0] / 1e6 - 199.0).abs() < 0.5 && (range.upper[0] / 1e6 - 209.0).abs() < 0.5);
/// # Ok::<(), dolmen::structure::StructureError>(())
/// ```
pub fn stiffness_range(
    frame: &Frame,
    frequencies_hz: &[f64],
    half_width_hz: &[f64],
    root_n_m: &[f64],
) -> Result<StiffnessRange, StructureError> {
    let n = frame.storeys().len();
    frame.check_stiffness(root_n_m)?;
    check_ascending(frequencies_hz)?;
    for given in [frequencies_hz.len(), half_width_hz.len()] {
        if given != n {
            return Err(StructureError::Frequencies { given, needed: n });
        }
    }
    for (j, &half_width) in half_width_hz.iter().enumerate() {
        not_negative("frequency", j + 1, "half_width_hz", half_width)?;
    }
    Ok(range_of_root(
        &frame.model()?,
        frequencies_hz,
        half_width_hz,
        root_n_m,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::{Convention, Storey, stiffness_from_frequencies};

    fn gate() -> Frame {
        let storeys =
            [(290e3, 5.84, 5919e3), (314e3, 7.69, 3077e3)].map(|(mass_kg, height_m, axial_n)| Storey {
                mass_kg,
                height_m,
                axial_n,
            });
        Frame::new(storeys.to_vec(), Convention::Drift).unwrap()
    }

    #[test]
    fn exact_corners_are_roots_of_their_own_frequencies() {
        let frequencies = [1.1, 4.2];
        let roots = stiffness_from_frequencies(&gate(), &frequencies)
            .unwrap()
            .stiffness;
        for (which, root) in roots.iter().enumerate() {
            let range = stiffness_range(&gate(), &frequencies, &[0.05, 0.02], root).unwrap();
            assert!(range.exists_throughout);
            let mut corners = Vec::new();
            for f1 in [1.05, 1.15] {
                for f2 in [4.18, 4.22] {
                    corners.push(
                        stiffness_from_frequencies(&gate(), &[f1, f2]).unwrap().stiffness[which].clone(),
                    );
                }
            }
            for i in 0..2 {
                let least = corners.iter().map(|k| k[i]).fold(f64::INFINITY, f64::min);
                let most = corners.iter().map(|k| k[i]).fold(0.0, f64::max);
                assert!((range.lower[i] / least - 1.0).abs() < 1e-9);
                assert!((range.upper[i] / most - 1.0).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn holds_a_root_that_ends_inside_is_reported() {
        // The two roots meet where r + 1/r = 2√(1 + m2/m1): r = 2.484
        let frequencies = [1.7, 4.25];
        let roots = stiffness_from_frequencies(&gate(), &frequencies)
            .unwrap()
            .stiffness;
        assert_eq!(roots.len(), 2);
        assert!(
            !stiffness_range(&gate(), &frequencies, &[0.05, 0.05], &roots[0])
                .unwrap()
                .exists_throughout
        );
        assert!(
            stiffness_range(&gate(), &frequencies, &[0.0, 0.0], &roots[0])
                .unwrap()
                .exists_throughout
        );
    }

    #[test]
    fn refuses_half_widths_that_do_not_fit() {
        let message = |f: &[f64], h: &[f64]| {
            stiffness_range(&gate(), f, h, &[1.0, 1.0])
                .unwrap_err()
                .to_string()
        };
        assert!(message(&[1.1], &[0.0, 0.0]).starts_with("frequencies_hz has 1 values"));
        assert_eq!(
            message(&[1.1, 4.2], &[0.0, f64::NAN]),
            "frequency 2: half_width_hz is NaN, but must be 0 or a positive number"
        );
    }
}
