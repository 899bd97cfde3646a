//! Natural modes of a building: frequencies, shapes, participation, effective mass, mode centres.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | φ_j | `shape` | shape of mode j, φᵀ M φ = 1 | kg^−½, rad kg^−½ m^−1 |
//! | ω_j | `omega_rad_s` | circular frequency | rad/s |
//! | ι | | unit displacement of the building along x or y, or unit rotation about its centre of mass | – |
//! | Γ | `participation` | φᵀ M ι, participation factor | √kg, √kg m |
//! | r_x, r_y | `r_x_m`, `r_y_m` | mode centre relative to the centre of mass of the floor | m |

use super::building_of_floors::Building;
use super::error::BuildingError;
use super::plan_direction::PlanDirection;
use dolmen_linalg::{Matrix, symmetric_eigen};
use std::f64::consts::TAU;

/// A floor does not rotate if the ratio of rotation times radius of gyration to displacement is below this limit: its mode centre would be a
/// million radii away. Our choice.
const WITHOUT_TURNING: f64 = 1e-6;
/// A floor whose motion is below this fraction of the largest floor motion has no mode centre. Our choice.
const AT_REST: f64 = 1e-9;
/// Relative difference below which two frequencies are repeated: any combination of their shapes is then a mode. Our choice.
const REPEATED: f64 = 1e-6;

/// The point about which a floor rotates in a mode.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ModeCentre {
    /// Position along x relative to the centre of mass of the floor, m: −φ_y/φ_θ.
    pub r_x_m: f64,
    /// Position along y relative to the centre of mass of the floor, m: φ_x/φ_θ.
    pub r_y_m: f64,
    /// x in plan, m.
    pub x_m: f64,
    /// y in plan, m.
    pub y_m: f64,
}

/// One natural mode.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct BuildingMode {
    /// Circular frequency ω, rad/s.
    pub omega_rad_s: f64,
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Shape, φᵀ M φ = 1: u, v, θ of each floor, lowest first. The largest of u, v, ρθ is positive.
    pub shape: Vec<f64>,
    /// Participation factors for shaking along x and y, √kg, and for rotation about the centre of mass, √kg m.
    pub participation: [f64; 3],
    /// Effective mass along x and y, kg, and effective moment of inertia, kg·m². Their sums over all modes are the totals of the building.
    pub effective_mass: [f64; 3],
    /// Fractions of the kinetic energy in u, v and θ of the centres of mass; their sum is 1.
    pub energy_shares: [f64; 3],
    /// Coupling of sway and twist: twice the smaller of the energy fractions in translation and in rotation. 0 for pure sway or twist, 1 for
    /// equal fractions.
    pub coupling: f64,
    /// Mode centre of each floor, lowest first; `None` for a floor without rotation or without motion.
    pub centres: Vec<Option<ModeCentre>>,
    /// Whether another mode has the same frequency within 1e-6: the shape is then not unique.
    pub repeated: bool,
}

impl BuildingMode {
    /// Period, s.
    pub fn period_s(&self) -> f64 {
        1.0 / self.frequency_hz
    }
}

/// All natural modes, lowest first.
#[derive(Clone, Debug, PartialEq)]
pub struct BuildingModes {
    /// The modes, 3 for each floor.
    pub modes: Vec<BuildingMode>,
    /// Sums of the effective masses: the total mass along x and along y, kg, and the moment of inertia about the centre of mass, kg·m².
    pub total_mass: [f64; 3],
    /// Shapes as columns, 3N × 3N.
    pub shapes: Matrix,
}

impl Building {
    /// Natural modes of the building.
    ///
    /// ```text
    /// K φ = ω² M φ,  φᵀ M φ = 1                                                    3N modes of 3N values
    /// Γ = φᵀ M ι      effective mass Γ²      r_x = −φ_y/φ_θ      r_y = φ_x/φ_θ
    /// ```
    /// For one floor whose rotation is coupled only with y, r_x of the two coupled modes satisfy r_1 r_3 = −ρ².
    ///
    /// # Errors
    /// [`BuildingError::Linalg`] if the input values differ by more than the precision of the computation.
    ///
    /// # Source
    /// Hwang, Min & Hong, eq. 12: mode centre relative to the centre of mass, which is their reference point. Tested by `building_modes`.
    pub fn modes(&self) -> Result<BuildingModes, BuildingError> {
        let masses = self.masses();
        let root: Vec<f64> = masses.iter().map(|m| m.sqrt()).collect();
        let n = masses.len();
        let mut scaled = self.stiffness_matrix();
        for j in 0..n {
            for (entry, row) in scaled.column_mut(j).iter_mut().zip(&root) {
                *entry /= row * root[j];
            }
        }
        let eigen = symmetric_eigen(&scaled)?;
        let centre = self.centre_of_mass_m();
        let shakes = [
            self.ground_column(PlanDirection::X),
            self.ground_column(PlanDirection::Y),
            self.turn_column(centre),
        ];
        let total = |shake: &[f64]| -> f64 { shake.iter().zip(&masses).map(|(x, m)| m * x * x).sum() };
        let mut modes = Vec::with_capacity(n);
        let mut shapes = Matrix::zeros(n, n);
        for (j, &omega_squared) in eigen.values.iter().enumerate() {
            let mut shares = [0.0; 3];
            let (mut largest, vector) = (0.0_f64, eigen.vectors.column(j));
            for (i, &y) in vector.iter().enumerate() {
                shares[i % 3] += y * y;
                let displacement = y / root[i - i % 3]; // u, v, ρθ
                if displacement.abs() > largest.abs() * (1.0 + 1e-9) {
                    largest = displacement;
                }
            }
            let shape = shapes.column_mut(j);
            for ((value, y), root) in shape.iter_mut().zip(vector).zip(&root) {
                *value = largest.signum() * y / root;
            }
            let shape = shape.to_vec();
            let participation = shakes.each_ref().map(|shake| -> f64 {
                shape
                    .iter()
                    .zip(&masses)
                    .zip(shake)
                    .map(|((p, m), s)| p * m * s)
                    .sum()
            });
            let omega_rad_s = omega_squared.max(0.0).sqrt();
            let turning = shares[2].clamp(0.0, 1.0);
            modes.push(BuildingMode {
                omega_rad_s,
                frequency_hz: omega_rad_s / TAU,
                effective_mass: participation.map(|gamma| gamma * gamma),
                participation,
                energy_shares: shares,
                coupling: 2.0 * turning.min(1.0 - turning),
                centres: self.centres(&shape, largest.abs()),
                shape,
                repeated: false,
            });
        }
        for j in 1..n {
            let (before, own) = (modes[j - 1].omega_rad_s, modes[j].omega_rad_s);
            if own - before <= REPEATED * own {
                modes[j - 1].repeated = true;
                modes[j].repeated = true;
            }
        }
        Ok(BuildingModes {
            modes,
            total_mass: shakes.each_ref().map(|shake| total(shake)),
            shapes,
        })
    }

    fn centres(&self, shape: &[f64], largest: f64) -> Vec<Option<ModeCentre>> {
        let each = self.floors().iter().enumerate().map(|(i, floor)| {
            let [u, v, theta] = [shape[3 * i], shape[3 * i + 1], shape[3 * i + 2]];
            let turning = floor.gyration_m * theta.abs();
            if turning <= WITHOUT_TURNING * u.hypot(v) || turning.max(u.hypot(v)) <= AT_REST * largest {
                return None;
            }
            // adding 0 avoids −0 in the output
            let (r_x_m, r_y_m) = (-v / theta + 0.0, u / theta + 0.0);
            Some(ModeCentre {
                r_x_m,
                r_y_m,
                x_m: floor.centre_m[0] + r_x_m,
                y_m: floor.centre_m[1] + r_y_m,
            })
        });
        each.collect()
    }
}

impl BuildingModes {
    /// ω of every mode, rad/s.
    pub fn omegas_rad_s(&self) -> Vec<f64> {
        self.modes.iter().map(|mode| mode.omega_rad_s).collect()
    }
}
