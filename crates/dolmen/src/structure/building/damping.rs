//! Damping of a building. No form of damping couples the modes.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | ζ_j | | damping ratio of mode j | – |
//! | a_0, a_1 | | Rayleigh coefficients of mass and stiffness: ζ = a_0/(2ω) + a_1 ω/2 | 1/s, s |
//! | a_k | | coefficients of Caughey's series: ζ = ½ Σ a_k ω^(2k − 1) | |

use super::building_of_floors::Building;
use super::error::BuildingError;
use super::modes::BuildingModes;
use dolmen_linalg::{Matrix, solve};
use std::f64::consts::TAU;

/// Largest damping ratio allowed: a mode at 1 does not oscillate. Our choice.
const RATIO_MOST: f64 = 0.95;

/// A frequency and the damping ratio at this frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampingAnchor {
    /// The frequency, Hz.
    pub frequency_hz: f64,
    /// Damping ratio there.
    pub damping_ratio: f64,
}

/// The damping of a building.
#[derive(Clone, Debug, PartialEq)]
pub enum BuildingDamping {
    /// A ratio for each mode, lowest first; the last also applies to all higher modes.
    Modal(Vec<f64>),
    /// C = a_0 M + a_1 K with the damping ratios at two frequencies.
    Rayleigh([DampingAnchor; 2]),
    /// Caughey's series with the given ratios of the lowest modes: C = M Σ a_k (M⁻¹K)^k, k = 0 … ratios − 1.
    Caughey(Vec<f64>),
}

impl BuildingModes {
    /// Damping ratio of every mode, lowest first.
    ///
    /// ```text
    /// Rayleigh   ζ = a_0/(2ω) + a_1 ω/2          Caughey   ζ = ½ Σ a_k ω^(2k − 1)                  3N values
    /// ```
    ///
    /// # Errors
    /// [`BuildingError::Argument`] for a ratio outside 0 to 0.95, no ratio, more ratios than modes, or two anchors at one frequency;
    /// [`BuildingError::Damping`] if a mode would gain energy or would not oscillate. With Caughey's series this may happen between and
    /// above its modes.
    pub fn damping_ratios(&self, damping: &BuildingDamping) -> Result<Vec<f64>, BuildingError> {
        let omegas = self.omegas_rad_s();
        let (ratios, why) = match damping {
            BuildingDamping::Modal(given) => {
                let last = checked(given, omegas.len())?;
                let each = (0..omegas.len()).map(|j| given.get(j).copied().unwrap_or(last));
                (each.collect::<Vec<f64>>(), "")
            }
            BuildingDamping::Rayleigh([low, high]) => {
                checked(&[low.damping_ratio, high.damping_ratio], 2)?;
                for anchor in [low, high] {
                    if !(anchor.frequency_hz > 0.0 && anchor.frequency_hz.is_finite()) {
                        return Err(BuildingError::Argument {
                            argument: "frequency_hz",
                            given: anchor.frequency_hz,
                            allowed: "a positive number",
                        });
                    }
                }
                let (w, v) = (TAU * low.frequency_hz, TAU * high.frequency_hz);
                if (w - v).abs() <= 1e-9 * w {
                    return Err(BuildingError::Argument {
                        argument: "frequency_hz",
                        given: high.frequency_hz,
                        allowed: "another than that of the first anchor",
                    });
                }
                let stiff = 2.0 * (high.damping_ratio * v - low.damping_ratio * w) / (v * v - w * w);
                let mass = 2.0 * low.damping_ratio * w - stiff * w * w;
                let each = omegas.iter().map(|w| 0.5 * (mass / w + stiff * w));
                let why = "the line through its two anchors gives that; move the anchors to the lowest and highest \
                           frequency that matter";
                (each.collect(), why)
            }
            BuildingDamping::Caughey(given) => {
                checked(given, omegas.len())?;
                // in powers of (ω/ω_1)², which keeps the numbers near 1
                let first = omegas[0];
                let square = |j: usize| (omegas[j] / first).powi(2);
                let n = given.len();
                let powers = Matrix::from_fn(n, n, |j, k| square(j).powi(k as i32));
                let right: Vec<f64> = (0..n).map(|j| 2.0 * given[j] * omegas[j] / first).collect();
                let a = solve(&powers, &Matrix::from_column(&right))?;
                let each = (0..omegas.len()).map(|j| {
                    let series = a.column(0).iter().rev().fold(0.0, |sum, a| sum * square(j) + a);
                    match given.get(j) {
                        Some(&own) => own,
                        None => 0.5 * series * first / omegas[j],
                    }
                });
                let why = "Caughey's series runs away beyond the modes it is given for; give ratios of more modes, or modal damping";
                (each.collect(), why)
            }
        };
        for (j, (&ratio, omega)) in ratios.iter().zip(&omegas).enumerate() {
            if !(0.0..=RATIO_MOST).contains(&ratio) {
                return Err(BuildingError::Damping {
                    mode: j + 1,
                    frequency_hz: omega / TAU,
                    damping_ratio: ratio,
                    why,
                });
            }
        }
        Ok(ratios)
    }
}

impl Building {
    /// The damping matrix C, 3N × 3N, for these damping ratios without coupling of the modes.
    ///
    /// ```text
    /// C = M Φ diag(2 ζ_j ω_j) Φᵀ M
    /// ```
    ///
    /// # Errors
    /// As [`BuildingModes::damping_ratios`] and [`Building::modes`].
    pub fn damping_matrix(&self, damping: &BuildingDamping) -> Result<Matrix, BuildingError> {
        let modes = self.modes()?;
        let ratios = modes.damping_ratios(damping)?;
        let masses = self.masses();
        let n = masses.len();
        let moved = Matrix::from_fn(n, n, |i, j| {
            let mode = &modes.modes[j];
            (2.0 * ratios[j] * mode.omega_rad_s).sqrt() * masses[i] * mode.shape[i]
        });
        Ok(&moved * &moved.transpose())
    }
}

/// Checks all damping ratios; returns the last.
fn checked(given: &[f64], most: usize) -> Result<f64, BuildingError> {
    let refuse = |argument, given, allowed| {
        Err(BuildingError::Argument {
            argument,
            given,
            allowed,
        })
    };
    if let Some(&ratio) = given.iter().find(|ratio| !(0.0..=RATIO_MOST).contains(*ratio)) {
        return refuse("damping_ratio", ratio, "0 to 0.95: is it in percent?");
    }
    match given.last() {
        None => refuse("the number of damping ratios", 0.0, "at least 1"),
        Some(_) if given.len() > most => refuse(
            "the number of damping ratios",
            given.len() as f64,
            "at most that of the modes, 3 a floor",
        ),
        Some(&last) => Ok(last),
    }
}
