//! Frequencies of a tapered cantilever: what a pole would have if it were one uncracked stone (Choi 2021, Fig. 8).
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | E, ρ | `elastic_modulus_pa`, `density_kg_m3` | of the material | Pa, kg/m³ |
//! | h, b | `depth_m`, `breadth_m` | section along and across the motion, linear in height | m |
//! | A, I | `area`, `second_moment` | b h, b h³/12 | m², m⁴ |
//! | N | `shapes`, `curvatures` | cubic shapes of an element and their second derivatives | , 1/m² |

use super::StructureError;
use dolmen_linalg::{Matrix, generalized_symmetric_eigen};

/// A rectangular section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// Size in the direction of motion, m.
    pub depth_m: f64,
    /// Size across it, m.
    pub breadth_m: f64,
}

/// A solid pole clamped at its foot whose depth and breadth change linearly with height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaperedCantilever {
    /// Height, m.
    pub height_m: f64,
    /// Section at the foot.
    pub foot: Section,
    /// Section at the top; 0 is a point or an edge.
    pub top: Section,
    /// Young's modulus, Pa.
    pub elastic_modulus_pa: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
}

/// Elements of the beam. With 40 the first three frequencies are within 3e-6 of the exact ones (uniform, wedge, pyramid).
const ELEMENTS: usize = 40;
/// Most frequencies that 40 elements give to 1e-3: the error grows with the fourth power of the wave number.
const MODES_MOST: usize = 10;
/// Gauss–Legendre of five points on [−1, 1], exact to degree 9: the mass of a tapered element has degree 8.
const GAUSS: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

impl TaperedCantilever {
    /// The lowest natural frequencies, Hz, ascending.
    ///
    /// ```text
    /// (E I y'')'' = ω² ρ A y,  y = y' = 0 at the foot, free at the top
    /// f = C √(E I_foot / ρ A_foot) / (2π H²)        uniform: C = 3.516, 22.03, 61.70
    /// ```
    ///
    /// # Errors
    /// [`StructureError::NotPositive`], [`StructureError::Negative`] for a size or property, [`StructureError::Part`]
    /// unless 1 to 10 frequencies are asked, [`StructureError::Linalg`].
    ///
    /// # Limits
    /// Bernoulli–Euler bending: shear and rotary inertia left out lower f by about 1 % in the first mode at a height of
    /// ten depths, more above. A clamped foot, no joints, no cracks: an upper bound of what the chain has. Gravity is
    /// left out (it lowers the first frequency).
    ///
    /// # Source
    /// Choi (2021) Fig. 8, after Downs (1977) J. Appl. Mech. 44:737-742. Differs from the source: cubic finite elements
    /// in place of tables.
    ///
    /// # Example
    /// ```
    /// use dolmen::structure::{Section, TaperedCantilever};
    /// let section = Section { depth_m: 0.5, breadth_m: 0.5 };
    /// let pole = TaperedCantilever {
    ///     height_m: 10.0,
    ///     foot: section,
    ///     top: section,
    ///     elastic_modulus_pa: 40e9,
    ///     density_kg_m3: 2570.0,
    /// };
    /// let exact = 3.516015 * (40e9 * 0.25 / 12.0 / 2570.0_f64).sqrt() / (std::f64::consts::TAU * 100.0);
    /// assert!((pole.frequencies_hz(1)?[0] / exact - 1.0).abs() < 1e-6);
    /// # Ok::<(), dolmen::structure::StructureError>(())
    /// ```
    pub fn frequencies_hz(&self, count: usize) -> Result<Vec<f64>, StructureError> {
        self.check(count)?;
        let (stiffness, mass) = self.matrices();
        // turned round, M φ = (1/ω²) K φ: the lowest frequencies become the largest eigenvalues, free of rounding
        let inverse = generalized_symmetric_eigen(&mass, &stiffness)?.values;
        let lowest = inverse.iter().rev().take(count);
        Ok(lowest.map(|s| 1.0 / (s.sqrt() * std::f64::consts::TAU)).collect())
    }

    /// K and M, each node above the foot having a displacement and a rotation.
    fn matrices(&self) -> (Matrix, Matrix) {
        let size = 2 * ELEMENTS;
        let (mut stiffness, mut mass) = (Matrix::zeros(size, size), Matrix::zeros(size, size));
        let length = self.height_m / ELEMENTS as f64;
        for element in 0..ELEMENTS {
            for (place, weight) in GAUSS {
                let t = 0.5 * (1.0 + place); // 0 at the lower, 1 at the upper node
                let along = (element as f64 + t) / ELEMENTS as f64;
                let (depth, breadth) = (
                    self.foot.depth_m + along * (self.top.depth_m - self.foot.depth_m),
                    self.foot.breadth_m + along * (self.top.breadth_m - self.foot.breadth_m),
                );
                let second_moment = breadth * depth.powi(3) / 12.0;
                let share = 0.5 * weight * length;
                let bending = share * self.elastic_modulus_pa * second_moment;
                let inertia = share * self.density_kg_m3 * breadth * depth;
                let (shapes, curvatures) = (shapes(t, length), curvatures(t, length));
                // the two unknowns of the clamped foot have negative numbers and are left out
                for i in 0..4 {
                    for j in 0..4 {
                        let (row, column) = (2 * element + i, 2 * element + j);
                        if row >= 2 && column >= 2 {
                            stiffness[(row - 2, column - 2)] += bending * curvatures[i] * curvatures[j];
                            mass[(row - 2, column - 2)] += inertia * shapes[i] * shapes[j];
                        }
                    }
                }
            }
        }
        (stiffness, mass)
    }

    fn check(&self, count: usize) -> Result<(), StructureError> {
        for (quantity, given) in [
            ("height_m", self.height_m),
            ("depth_m of the foot", self.foot.depth_m),
            ("breadth_m of the foot", self.foot.breadth_m),
            ("elastic_modulus_pa", self.elastic_modulus_pa),
            ("density_kg_m3", self.density_kg_m3),
        ] {
            if !(given > 0.0 && given.is_finite()) {
                return Err(StructureError::NotPositive {
                    part: "tapered cantilever",
                    number: 1,
                    quantity,
                    given,
                });
            }
        }
        for (quantity, given) in [
            ("depth_m of the top", self.top.depth_m),
            ("breadth_m of the top", self.top.breadth_m),
        ] {
            if !(given >= 0.0 && given.is_finite()) {
                return Err(StructureError::Negative {
                    part: "tapered cantilever",
                    number: 1,
                    quantity,
                    given,
                });
            }
        }
        if !(1..=MODES_MOST).contains(&count) {
            return Err(StructureError::Part {
                part: "mode",
                given: count,
                most: MODES_MOST,
            });
        }
        Ok(())
    }
}

/// Cubic Hermite shapes: displacement and rotation of the lower node, then of the upper.
fn shapes(t: f64, length: f64) -> [f64; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [
        1.0 - 3.0 * t2 + 2.0 * t3,
        length * (t - 2.0 * t2 + t3),
        3.0 * t2 - 2.0 * t3,
        length * (t3 - t2),
    ]
}

/// Their second derivatives.
fn curvatures(t: f64, length: f64) -> [f64; 4] {
    let square = length * length;
    [
        (12.0 * t - 6.0) / square,
        (6.0 * t - 4.0) / length,
        (6.0 - 12.0 * t) / square,
        (6.0 * t - 2.0) / length,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_tenth_frequency_of_a_uniform_cantilever() {
        // cos β cosh β = −1 has β = (n − ½) π but for a share of e^−β
        let section = Section {
            depth_m: 1.0,
            breadth_m: 1.0,
        };
        let pole = TaperedCantilever {
            height_m: 1.0,
            foot: section,
            top: section,
            elastic_modulus_pa: 12.0,
            density_kg_m3: 1.0,
        };
        let exact = (9.5 * std::f64::consts::PI).powi(2) / std::f64::consts::TAU;
        let error = pole.frequencies_hz(10).unwrap()[9] / exact - 1.0;
        assert!(error > 0.0 && error < 1e-3, "{error}");
    }

    #[test]
    fn refuses_sizes_that_are_not_positive() {
        let section = Section {
            depth_m: 0.5,
            breadth_m: 0.5,
        };
        let pole = TaperedCantilever {
            height_m: 10.0,
            foot: section,
            top: section,
            elastic_modulus_pa: 40e9,
            density_kg_m3: 2570.0,
        };
        let refused = |pole: TaperedCantilever, count| pole.frequencies_hz(count).unwrap_err().to_string();
        assert_eq!(
            refused(
                TaperedCantilever {
                    height_m: f64::NAN,
                    ..pole
                },
                1
            ),
            "tapered cantilever 1: height_m is NaN, but must be a positive number"
        );
        let top = Section {
            depth_m: -0.1,
            ..section
        };
        assert_eq!(
            refused(TaperedCantilever { top, ..pole }, 1),
            "tapered cantilever 1: depth_m of the top is -0.1, but must be 0 or a positive number"
        );
        assert_eq!(
            refused(pole, 11),
            "mode 11 was asked for, but they are numbered from 1 at the bottom to 10"
        );
    }
}
