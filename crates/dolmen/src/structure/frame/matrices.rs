//! Mass matrix, elastic stiffness, P-delta (geometric) stiffness and natural modes of a frame.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | M | `mass_matrix` | diagonal | kg |
//! | K_E | `elastic_matrix` | springs of the storeys and ties | N/m |
//! | K_G | `geometric_matrix` | reduction of the stiffness by P-delta | N/m |
//! | B | | drifts from displacements: (B Y)_i = Y_i − Y_{i−1}, Y_0 = 0 | – |
//! | e_a | | 1 at level a, 0 elsewhere; all 0 for the ground | – |

use super::storeys::{Convention, Frame, not_negative};
use crate::structure::{NaturalMode, StructureError};
use dolmen_linalg::{Matrix, generalized_symmetric_eigen};

impl Frame {
    /// M, diagonal, kg.
    pub fn mass_matrix(&self) -> Matrix {
        let masses: Vec<f64> = self.storeys().iter().map(|s| s.mass_kg).collect();
        Matrix::from_diagonal(&masses)
    }

    /// Reduction of the stiffness by P-delta, N/m; positive semidefinite, and the same for both conventions.
    ///
    /// ```text
    /// K_G = Bᵀ diag(N_i / l_i) B                                                       n × n
    /// ```
    pub fn geometric_matrix(&self) -> Matrix {
        let mut k = Matrix::zeros(self.storeys().len(), self.storeys().len());
        for (i, geometric) in self.geometric_n_m().into_iter().enumerate() {
            add_spring(&mut k, i, i + 1, geometric);
        }
        k
    }

    /// Stiffness of the storey springs and the ties, without P-delta, N/m; positive semidefinite.
    ///
    /// ```text
    /// drift:      K_E = Bᵀ diag(k) B + Σ k_ab (e_b − e_a)(e_b − e_a)ᵀ                   n × n
    /// grounded:   K_E = diag(k)      + Σ k_ab (e_b − e_a)(e_b − e_a)ᵀ
    /// ```
    ///
    /// # Errors
    /// [`StructureError::Count`] unless there is one stiffness per storey; [`StructureError::Negative`] if a stiffness is negative or not a number.
    pub fn elastic_matrix(&self, stiffness_n_m: &[f64]) -> Result<Matrix, StructureError> {
        self.check_stiffness(stiffness_n_m)?;
        let mut k = Matrix::zeros(self.storeys().len(), self.storeys().len());
        for (i, &stiffness) in stiffness_n_m.iter().enumerate() {
            let lower = match self.convention() {
                Convention::Drift => i,
                Convention::Grounded => 0,
            };
            add_spring(&mut k, lower, i + 1, stiffness);
        }
        for tie in self.ties() {
            add_spring(&mut k, tie.lower, tie.upper, tie.stiffness_n_m);
        }
        Ok(k)
    }

    /// Stiffness with P-delta, N/m.
    ///
    /// ```text
    /// K = K_E − K_G                                                                     n × n
    /// two storeys, grounded (eq. 7):   [k1 − N1/l1 − N2/l2    N2/l2     ]
    ///                                  [N2/l2                 k2 − N2/l2]
    /// ```
    ///
    /// # Errors
    /// As [`Frame::elastic_matrix`].
    ///
    /// # Limits
    /// Small drifts: sin β = β; for a drift of 5 % of the height the error is 0.04 %.
    ///
    /// # Source
    /// Park & Min (2010), eqs 1 to 7, for `Grounded`. Tested by `park_min_2010`. Differs from the source: N_i is the axial force of the storey. Eq.
    /// 7 has P1 + P2 in place of N1, although its printed P1 already includes P2; to reproduce it, give the
    /// [`storey_axial_forces_n`](crate::structure::storey_axial_forces_n) of the printed P.
    pub fn stiffness_matrix(&self, stiffness_n_m: &[f64]) -> Result<Matrix, StructureError> {
        Ok(&self.elastic_matrix(stiffness_n_m)? - &self.geometric_matrix())
    }

    /// Natural modes, lowest first. If ω² < 0, the frame is unstable in this shape.
    ///
    /// ```text
    /// K φ = ω² M φ                                        n modes, n displacements each
    /// ```
    ///
    /// # Errors
    /// As [`Frame::elastic_matrix`]; [`StructureError::Linalg`] if the stiffnesses differ by more than double precision can resolve.
    pub fn natural_modes(&self, stiffness_n_m: &[f64]) -> Result<Vec<NaturalMode>, StructureError> {
        let eigen = generalized_symmetric_eigen(&self.stiffness_matrix(stiffness_n_m)?, &self.mass_matrix())?;
        let modes = eigen.values.iter().enumerate().map(|(j, &omega_squared)| {
            let displacement = scaled_to_one(eigen.vectors.column(j));
            NaturalMode {
                omega_squared,
                frequency_hz: omega_squared.max(0.0).sqrt() / std::f64::consts::TAU,
                coordinates: displacement.clone(),
                displacement,
            }
        });
        Ok(modes.collect())
    }

    pub(crate) fn check_stiffness(&self, stiffness_n_m: &[f64]) -> Result<(), StructureError> {
        if stiffness_n_m.len() != self.storeys().len() {
            return Err(StructureError::Count {
                quantity: "stiffness_n_m",
                given: stiffness_n_m.len(),
                kind: "frame",
                needed: self.storeys().len(),
                parts: "storeys",
            });
        }
        for (i, &stiffness) in stiffness_n_m.iter().enumerate() {
            not_negative("storey", i + 1, "stiffness_n_m", stiffness)?;
        }
        Ok(())
    }
}

/// Adds k (e_b − e_a)(e_b − e_a)ᵀ. Level 0 is the ground and has no row.
fn add_spring(matrix: &mut Matrix, a: usize, b: usize, stiffness: f64) {
    for level in [a, b] {
        if level > 0 {
            matrix[(level - 1, level - 1)] += stiffness;
        }
    }
    if a > 0 && b > 0 {
        matrix[(a - 1, b - 1)] -= stiffness;
        matrix[(b - 1, a - 1)] -= stiffness;
    }
}

/// The shape divided by its component of largest magnitude; if several are equal, by the lowest level's.
fn scaled_to_one(shape: &[f64]) -> Vec<f64> {
    let largest = shape
        .iter()
        .fold(0.0_f64, |most, &x| if x.abs() > most.abs() { x } else { most });
    shape.iter().map(|x| x / largest).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::{Storey, Tie};

    fn gate(convention: Convention, axial_n: [f64; 2]) -> Frame {
        let storeys = [(290e3, 5.84), (314e3, 7.69)].iter().zip(axial_n);
        let storeys = storeys.map(|(&(mass_kg, height_m), axial_n)| Storey {
            mass_kg,
            height_m,
            axial_n,
        });
        Frame::new(storeys.collect(), convention).unwrap()
    }

    #[test]
    fn exact_matrices_of_two_storeys_written_out() {
        let [n1, n2, l1, l2, k1, k2] = [5919e3, 3077e3, 5.84, 7.69, 200e6, 15e6];
        let (g1, g2) = (n1 / l1, n2 / l2);
        let grounded = gate(Convention::Grounded, [n1, n2])
            .stiffness_matrix(&[k1, k2])
            .unwrap();
        assert_eq!(
            grounded,
            Matrix::from_rows(&[[k1 - (g1 + g2), g2], [g2, k2 - g2]])
        );
        let drift = gate(Convention::Drift, [n1, n2])
            .stiffness_matrix(&[k1, k2])
            .unwrap();
        let expected = Matrix::from_rows(&[[k1 + k2 - (g1 + g2), -(k2 - g2)], [-(k2 - g2), k2 - g2]]);
        assert_eq!(drift, expected);
    }

    #[test]
    fn exact_a_tie_to_the_ground_is_a_grounded_spring() {
        // A drift frame with k_2 = 0 and a tie from the ground to level 2 equals a grounded frame.
        let ties = vec![Tie {
            lower: 0,
            upper: 2,
            stiffness_n_m: 15e6,
        }];
        let tied = gate(Convention::Drift, [5919e3, 3077e3]).with_ties(ties).unwrap();
        let grounded = gate(Convention::Grounded, [5919e3, 3077e3]);
        assert_eq!(
            tied.stiffness_matrix(&[200e6, 0.0]).unwrap(),
            grounded.stiffness_matrix(&[200e6, 15e6]).unwrap()
        );
    }

    #[test]
    fn exact_shear_building_of_equal_storeys() {
        // ω_j = 2 √(k/m) sin((2j − 1) π / (4n + 2)) without P-delta
        let n = 7;
        let (mass_kg, stiffness) = (2e4, 3e7);
        let storeys = vec![
            Storey {
                mass_kg,
                height_m: 3.0,
                axial_n: 0.0
            };
            n
        ];
        let frame = Frame::new(storeys, Convention::Drift).unwrap();
        for (j, mode) in frame
            .natural_modes(&vec![stiffness; n])
            .unwrap()
            .iter()
            .enumerate()
        {
            let angle = (2 * j + 1) as f64 * std::f64::consts::PI / (4 * n + 2) as f64;
            let omega = 2.0 * (stiffness / mass_kg).sqrt() * angle.sin();
            assert!(
                (mode.omega_squared / omega.powi(2) - 1.0).abs() < 1e-12,
                "mode {}",
                j + 1
            );
            assert!((mode.frequency_hz * std::f64::consts::TAU / omega - 1.0).abs() < 1e-12);
            let largest = mode.displacement.iter().fold(f64::MIN, |a, &b| a.max(b));
            assert_eq!(largest, 1.0);
            assert!(mode.displacement.iter().all(|x| x.abs() <= 1.0));
        }
    }

    #[test]
    fn exact_a_storey_below_its_geometric_stiffness_falls() {
        // One storey: ω² = (k − N/l)/m
        let storey = Storey {
            mass_kg: 1e3,
            height_m: 4.0,
            axial_n: 8e3,
        };
        let frame = Frame::new(vec![storey], Convention::Drift).unwrap();
        let mode = &frame.natural_modes(&[1.5e3]).unwrap()[0];
        assert!((mode.omega_squared + 0.5).abs() < 1e-15);
        assert_eq!(mode.frequency_hz, 0.0);
    }

    #[test]
    fn refuses_stiffnesses_that_do_not_fit() {
        let gate = gate(Convention::Drift, [0.0, 0.0]);
        let message = |k: &[f64]| gate.stiffness_matrix(k).unwrap_err().to_string();
        assert_eq!(
            message(&[1.0]),
            "stiffness_n_m has 1 values, but the frame has 2 storeys"
        );
        assert_eq!(
            message(&[1.0, f64::NAN]),
            "storey 2: stiffness_n_m is NaN, but must be 0 or a positive number"
        );
    }
}
