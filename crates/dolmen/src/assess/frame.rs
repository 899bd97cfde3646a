//! The check of a frame without a time history.

use super::AssessError;
use crate::known::STANDARD_GRAVITY_M_S2;
use crate::stability::{FrameStability, frame_stability};
use crate::structure::{Frame, NaturalMode};
use std::fmt;

/// Plausible range of the load of a level over the weight of its mass; outside it, there is a note. Our choice: roof
/// masses estimated from drawings have errors of about 10 %; axial forces that were summed twice give 2 in a frame of
/// two equal storeys.
const LOAD_RATIO_PLAUSIBLE: std::ops::RangeInclusive<f64> = 0.8..=1.25;

/// A probable mistake in the loads of a frame. `Display` gives an English sentence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FrameNote {
    /// No storey carries an axial force.
    NoAxialForce,
    /// The load that a level adds differs from the weight of its mass.
    LevelLoad {
        /// The level, from 1.
        level: usize,
        /// Ratio of the added load to the weight of its mass.
        ratio: f64,
    },
}

impl fmt::Display for FrameNote {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FrameNote::NoAxialForce => f.write_str(
                "No axial force is given: P-delta is left out, and nothing can be said of stability.",
            ),
            FrameNote::LevelLoad { level, ratio } => write!(
                f,
                "Level {level} loads its storey with {ratio:.2} times the weight of its mass, so P-delta is {}, and the \
                 load factor is not over the weight.",
                if *ratio < 1.0 { "understated" } else { "overstated" }
            ),
        }
    }
}

/// All results for a frame without a time history.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameCheck {
    /// N_i / l_i of each storey, N/m: the smallest stiffness with which a storey of columns stands (drift
    /// convention).
    pub geometric_n_m: Vec<f64>,
    /// Ratio of the load that each level adds to the axial force to the weight of its mass; near 1 if the two agree.
    pub level_load_ratios: Vec<f64>,
    /// Stability with the storeys' stiffness; `None` if it is unknown.
    pub stability: Option<FrameStability>,
    /// Natural modes; empty if the stiffness is unknown.
    pub modes: Vec<NaturalMode>,
    /// Probable mistakes in the input.
    pub notes: Vec<FrameNote>,
}

/// Stability and natural modes of a frame; without stiffness, the results from its loads only.
///
/// # Errors
/// [`AssessError::Structure`] unless there is one stiffness, 0 or positive, a storey.
///
/// # Example
/// ```
/// use dolmen::assess::check_frame;
/// use dolmen::structure::{Convention, Frame, Storey};
/// let storeys = vec![
///     Storey { mass_kg: 290e3, height_m: 5.84, axial_n: 5919e3 },
///     Storey { mass_kg: 314e3, height_m: 7.69, axial_n: 3077e3 },
/// ];
/// let gate = Frame::new(storeys, Convention::Drift)?;
/// assert!((check_frame(&gate, None)?.geometric_n_m[0] - 1.01353e6).abs() < 10.0);
/// assert!((check_frame(&gate, Some(&[32.65e6, 96.14e6]))?.modes[1].frequency_hz - 4.2).abs() < 1e-3);
/// # Ok::<(), dolmen::assess::AssessError>(())
/// ```
pub fn check_frame(frame: &Frame, stiffness_n_m: Option<&[f64]>) -> Result<FrameCheck, AssessError> {
    let level_load_ratios = frame.level_load_ratios(STANDARD_GRAVITY_M_S2);
    let (stability, modes) = match stiffness_n_m {
        None => (None, Vec::new()),
        Some(k) => (Some(frame_stability(frame, k)?), frame.natural_modes(k)?),
    };
    Ok(FrameCheck {
        geometric_n_m: frame.geometric_n_m(),
        notes: load_notes(frame, &level_load_ratios),
        level_load_ratios,
        stability,
        modes,
    })
}

fn load_notes(frame: &Frame, ratios: &[f64]) -> Vec<FrameNote> {
    if frame.storeys().iter().all(|s| s.axial_n == 0.0) {
        return vec![FrameNote::NoAxialForce];
    }
    let unlikely = ratios.iter().enumerate();
    let unlikely = unlikely.filter(|(_, ratio)| !LOAD_RATIO_PLAUSIBLE.contains(*ratio));
    unlikely
        .map(|(i, &ratio)| FrameNote::LevelLoad { level: i + 1, ratio })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::{Convention, Storey, storey_axial_forces_n};

    fn gate(axial_n: [f64; 2]) -> Frame {
        let storeys = [(290e3, 5.84), (314e3, 7.69)].iter().zip(axial_n);
        let storeys = storeys.map(|(&(mass_kg, height_m), axial_n)| Storey {
            mass_kg,
            height_m,
            axial_n,
        });
        Frame::new(storeys.collect(), Convention::Grounded).unwrap()
    }

    #[test]
    fn holds_printed_axial_forces_summed_twice_are_pointed_out() {
        let printed = [5919e3, 3077e3];
        assert!(check_frame(&gate(printed), None).unwrap().notes.is_empty());
        let summed = storey_axial_forces_n(&printed);
        let check = check_frame(&gate([summed[0], summed[1]]), None).unwrap();
        assert_eq!(check.notes.len(), 1);
        assert!(
            check.notes[0]
                .to_string()
                .starts_with("Level 1 loads its storey with 2.08 times"),
            "{}",
            check.notes[0]
        );
    }

    #[test]
    fn holds_without_stiffness_only_loads_are_reported() {
        let check = check_frame(&gate([0.0, 0.0]), None).unwrap();
        assert_eq!((check.stability, check.modes.len()), (None, 0));
        assert_eq!(check.notes, [FrameNote::NoAxialForce]);
    }

    #[test]
    fn refuses_the_wrong_number_of_stiffnesses() {
        let fault = check_frame(&gate([0.0, 0.0]), Some(&[1.0])).unwrap_err();
        assert_eq!(
            fault.to_string(),
            "stiffness_n_m has 1 values, but the frame has 2 storeys"
        );
    }
}
