//! Storeys, ties and axial forces of a frame.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | m_i | `mass_kg` | mass of storey i; i = 1 is the lowest | kg |
//! | l_i | `height_m` | column height of storey i | m |
//! | N_i | `axial_n` | gravity load that storey i carries: from its own level and all levels above | N |
//! | P_i | `level_loads_n` | gravity load that acts at level i alone | N |
//! | k_i | stiffness | lateral stiffness of storey i, by [`Convention`] | N/m |
//! | Y_i | | lateral displacement of level i relative to the ground | m |

use crate::structure::StructureError;

/// The displacement that the spring k_i acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Convention {
    /// The storey drift Y_i − Y_{i−1}: a storey of columns.
    Drift,
    /// The displacement relative to the ground Y_i, as eq. 7 of the source is printed.
    Grounded,
}

/// One storey.
#[derive(Clone, Debug, PartialEq)]
pub struct Storey {
    /// Mass at its top, kg.
    pub mass_kg: f64,
    /// Column height, m.
    pub height_m: f64,
    /// Axial force in the storey, N: the gravity loads of its top level and of all levels above. With 0 there is no
    /// P-delta.
    pub axial_n: f64,
}

/// A spring between two levels in addition to the storey springs, such as a buttress, a rampart or a cable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tie {
    /// One level, from 1; 0 is the ground.
    pub lower: usize,
    /// The other level.
    pub upper: usize,
    /// Lateral stiffness of the tie, N/m.
    pub stiffness_n_m: f64,
}

/// A frame of rigid storeys in one direction, lowest first. [`Frame::new`] checks the data, so every `Frame` is
/// valid. The stiffness of the storeys is not included, because it is the unknown of the identification.
///
/// Each direction of a building is a separate frame. Torsional modes belong to neither.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    storeys: Vec<Storey>,
    convention: Convention,
    ties: Vec<Tie>,
}

impl Frame {
    /// A frame of storeys, lowest first.
    ///
    /// # Errors
    /// [`StructureError::Empty`] without storeys; [`StructureError::NotPositive`] for a mass or height;
    /// [`StructureError::Negative`] for an axial force; [`StructureError::AxialOrder`] if a storey carries less than
    /// the storey above it.
    ///
    /// # Example
    /// ```
    /// use dolmen::structure::{Convention, Frame, Storey};
    /// let storeys = vec![
    ///     Storey { mass_kg: 290e3, height_m: 5.84, axial_n: 5919e3 },
    ///     Storey { mass_kg: 314e3, height_m: 7.69, axial_n: 3077e3 },
    /// ];
    /// let gate = Frame::new(storeys, Convention::Drift)?;
    /// let modes = gate.natural_modes(&[32.65e6, 96.14e6])?;
    /// assert!((modes[0].frequency_hz - 1.1).abs() < 1e-3);
    /// # Ok::<(), dolmen::structure::StructureError>(())
    /// ```
    pub fn new(storeys: Vec<Storey>, convention: Convention) -> Result<Self, StructureError> {
        if storeys.is_empty() {
            return Err(StructureError::Empty {
                kind: "frame",
                parts: "storeys",
            });
        }
        for (i, storey) in storeys.iter().enumerate() {
            let (part, number) = ("storey", i + 1);
            for (quantity, given) in [("mass_kg", storey.mass_kg), ("height_m", storey.height_m)] {
                if !(given > 0.0 && given.is_finite()) {
                    return Err(StructureError::NotPositive {
                        part,
                        number,
                        quantity,
                        given,
                    });
                }
            }
            not_negative(part, number, "axial_n", storey.axial_n)?;
        }
        for (i, pair) in storeys.windows(2).enumerate() {
            if pair[0].axial_n < pair[1].axial_n {
                return Err(StructureError::AxialOrder {
                    storey: i + 1,
                    given: pair[0].axial_n,
                    above: pair[1].axial_n,
                });
            }
        }
        Ok(Frame {
            storeys,
            convention,
            ties: Vec::new(),
        })
    }

    /// Replaces the ties of the frame: springs between its levels or to the ground.
    ///
    /// # Errors
    /// [`StructureError::Tie`] if a tie does not connect two different levels; [`StructureError::Negative`] if its
    /// stiffness is negative or not a number.
    pub fn with_ties(self, ties: Vec<Tie>) -> Result<Self, StructureError> {
        let most = self.storeys.len();
        for (i, tie) in ties.iter().enumerate() {
            let Tie { lower, upper, .. } = *tie;
            if lower == upper || lower.max(upper) > most {
                return Err(StructureError::Tie {
                    tie: i + 1,
                    lower,
                    upper,
                    most,
                });
            }
            not_negative("tie", i + 1, "stiffness_n_m", tie.stiffness_n_m)?;
        }
        Ok(Frame { ties, ..self })
    }

    /// The storeys, lowest first.
    pub fn storeys(&self) -> &[Storey] {
        &self.storeys
    }

    /// The displacements that the springs act on.
    pub fn convention(&self) -> Convention {
        self.convention
    }

    /// Springs in addition to those of the storeys.
    pub fn ties(&self) -> &[Tie] {
        &self.ties
    }

    /// Height of each level above the ground, m, lowest first.
    pub fn level_heights_m(&self) -> Vec<f64> {
        let heights = self.storeys.iter().scan(0.0, |above_ground, storey| {
            *above_ground += storey.height_m;
            Some(*above_ground)
        });
        heights.collect()
    }

    /// N_i / l_i of each storey, N/m: reduction of the drift stiffness by P-delta.
    pub fn geometric_n_m(&self) -> Vec<f64> {
        self.storeys.iter().map(|s| s.axial_n / s.height_m).collect()
    }

    /// Load that each level adds to the axial force, divided by the weight of its mass. The ratio is near 1 if masses
    /// and axial forces agree, and 0 at every level if P-delta is left out.
    ///
    /// ```text
    /// (N_i − N_{i+1}) / (m_i g)                                                     n values
    /// ```
    pub fn level_load_ratios(&self, gravity_m_s2: f64) -> Vec<f64> {
        let above = self.storeys.iter().skip(1).map(|s| s.axial_n).chain([0.0]);
        let pairs = self.storeys.iter().zip(above);
        pairs
            .map(|(s, above)| (s.axial_n - above) / (s.mass_kg * gravity_m_s2))
            .collect()
    }
}

/// Axial force in each storey, N, from the gravity load of each level alone, N, lowest first.
///
/// ```text
/// N_i = Σ_{j≥i} P_j                                                                 n values
/// ```
///
/// # Source
/// Park & Min (2010), eq. 7: its P1 − P2 = 2842 kN is the weight of its 290 t, so the printed P are already sums.
/// With these P as input, the function counts P2 twice, as eq. 7 does.
pub fn storey_axial_forces_n(level_loads_n: &[f64]) -> Vec<f64> {
    let mut forces: Vec<f64> = level_loads_n
        .iter()
        .rev()
        .scan(0.0, |sum, load| {
            *sum += load;
            Some(*sum)
        })
        .collect();
    forces.reverse();
    forces
}

pub(super) fn not_negative(
    part: &'static str,
    number: usize,
    quantity: &'static str,
    given: f64,
) -> Result<(), StructureError> {
    if given >= 0.0 && given.is_finite() {
        return Ok(());
    }
    Err(StructureError::Negative {
        part,
        number,
        quantity,
        given,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn storeys() -> Vec<Storey> {
        [(290e3, 5.84, 5919e3), (314e3, 7.69, 3077e3)]
            .map(|(mass_kg, height_m, axial_n)| Storey {
                mass_kg,
                height_m,
                axial_n,
            })
            .to_vec()
    }

    #[test]
    fn exact_level_loads_sum_from_the_top() {
        assert_eq!(storey_axial_forces_n(&[1.0, 2.0, 4.0]), [7.0, 6.0, 4.0]);
        assert_eq!(storey_axial_forces_n(&[]), []);
    }

    #[test]
    fn published_axial_forces_are_already_sums() {
        // 5919 − 3077 = 2842 kN = 290 t × 9.80 m/s²; 3077 kN = 314 t × 9.80 m/s²
        let gate = Frame::new(storeys(), Convention::Drift).unwrap();
        for ratio in gate.level_load_ratios(9.80) {
            assert!((ratio - 1.0).abs() < 1e-4, "{ratio}");
        }
        assert_eq!(gate.level_heights_m(), [5.84, 5.84 + 7.69]);
    }

    #[test]
    fn refuses_what_cannot_be_a_frame() {
        let message = |change: fn(&mut Vec<Storey>)| {
            let mut s = storeys();
            change(&mut s);
            Frame::new(s, Convention::Drift).unwrap_err().to_string()
        };
        assert_eq!(
            message(|s| s.clear()),
            "the frame has no storeys, but needs at least 1"
        );
        assert_eq!(
            message(|s| s[1].mass_kg = f64::NAN),
            "storey 2: mass_kg is NaN, but must be a positive number"
        );
        assert_eq!(
            message(|s| s[0].height_m = 0.0),
            "storey 1: height_m is 0, but must be a positive number"
        );
        assert_eq!(
            message(|s| s[1].axial_n = -1.0),
            "storey 2: axial_n is -1, but must be 0 or a positive number"
        );
        assert!(message(|s| s[0].axial_n = 2842e3).starts_with(
            "storey 1: its axial force is 2842000 N, less than the 3077000 N of the storey above it"
        ));
    }

    #[test]
    fn refuses_a_tie_that_joins_nothing() {
        let tie = |lower, upper, stiffness_n_m| {
            let ties = vec![Tie {
                lower,
                upper,
                stiffness_n_m,
            }];
            let gate = Frame::new(storeys(), Convention::Drift).unwrap();
            gate.with_ties(ties).map(|_| ()).map_err(|e| e.to_string())
        };
        assert_eq!(tie(0, 2, 1.0), Ok(()));
        for (lower, upper) in [(1, 1), (0, 3)] {
            assert_eq!(
                tie(lower, upper, 1.0),
                Err(format!(
                    "tie 1 joins levels {lower} and {upper}, but must join two different levels between 0 (ground) \
                     and 2"
                ))
            );
        }
        assert_eq!(
            tie(0, 1, f64::NAN),
            Err("tie 1: stiffness_n_m is NaN, but must be 0 or a positive number".to_string())
        );
    }
}
