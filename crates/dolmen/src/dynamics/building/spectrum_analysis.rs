//! Response spectrum analysis: the largest response of each mode, and their combination.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | r_n | | row · φ_n Γ_n S_a(T_n, ζ_n)/ω_n²: the largest response in mode n, with its sign | of the row |
//! | ρ_in | [`correlation_coefficient`] | correlation of modes i and n | – |
//! | β | | ω_i/ω_n | – |
//! | r_x, r_y | | the response to shaking along x and along y | of the row |

use super::vibrating::VibratingBuilding;
use crate::dynamics::DynamicsError;

/// Combination of modes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModalCombination {
    /// Σ |r_n|: an upper bound.
    AbsoluteSum,
    /// √Σ r_n²: for well separated modes.
    Srss,
    /// √ΣΣ ρ_in r_i r_n, the full equation, for unequal damping ratios.
    Cqc,
}

/// Combination of shaking along x and along y.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DirectionalCombination {
    /// Along x alone.
    XAlone,
    /// Along y alone.
    YAlone,
    /// √(r_x² + r_y²).
    Srss,
    /// The larger of r_x + 0.3 r_y and r_y + 0.3 r_x.
    HundredThirty,
}

impl DirectionalCombination {
    /// Combines the responses to shaking along one axis each (0 x, 1 y).
    pub fn of(self, along: impl Fn(usize) -> f64) -> f64 {
        match self {
            DirectionalCombination::XAlone => along(0),
            DirectionalCombination::YAlone => along(1),
            DirectionalCombination::Srss => along(0).hypot(along(1)),
            DirectionalCombination::HundredThirty => {
                let (x, y) = (along(0), along(1));
                (x + 0.3 * y).max(y + 0.3 * x)
            }
        }
    }
}

/// Correlation coefficient of two modes under wide-band shaking.
///
/// ```text
/// ρ = 8 √(ζ_i ζ_n) (β ζ_i + ζ_n) β^(3/2) / [(1 − β²)² + 4 ζ_i ζ_n β (1 + β²) + 4 (ζ_i² + ζ_n²) β²],  β = ω_i/ω_n
/// ```
///
/// # Source
/// Der Kiureghian (1981) Earthquake Engng Struct. Dyn. 9:419-435; Chopra (2017), eq. 13.7.10. Symmetric in the two modes.
///
/// # Example
/// ```
/// // the lower mode with 2 %, the higher with 5 %
/// let rho = dolmen::dynamics::correlation_coefficient([0.8, 0.02], [1.0, 0.05]);
/// assert!((rho - 0.0839749).abs() < 0.5e-7);
/// ```
pub fn correlation_coefficient([omega_i, zeta_i]: [f64; 2], [omega_n, zeta_n]: [f64; 2]) -> f64 {
    let beta = omega_i / omega_n;
    let above = 8.0 * (zeta_i * zeta_n).sqrt() * (beta * zeta_i + zeta_n) * beta.powf(1.5);
    let below = (1.0 - beta * beta).powi(2)
        + 4.0 * zeta_i * zeta_n * beta * (1.0 + beta * beta)
        + 4.0 * (zeta_i * zeta_i + zeta_n * zeta_n) * beta * beta;
    if above == 0.0 && below == 0.0 {
        return 1.0; // equal frequencies, no damping
    }
    above / below
}

/// Response in the least favourable direction of shaking.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeastFavourable {
    /// Largest response, in the unit of the row.
    pub largest: f64,
    /// Direction of the stronger component, degrees from x, in (−90, 90].
    pub direction_degrees: f64,
}

/// One mode and its spectral accelerations.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SpectralMode {
    /// Period, s.
    pub period_s: f64,
    /// Damping ratio.
    pub damping_ratio: f64,
    /// S_a of the spectrum along x and along y, m/s².
    pub acceleration_m_s2: [f64; 2],
}

/// The largest response of every mode, which can be combined for any quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct SpectralAnalysis {
    /// The modes in the spectrum, lowest first.
    pub modes: Vec<SpectralMode>,
    /// Largest Γ_n S_a/ω_n² of each mode, along x and y, m √kg.
    amplitudes: Vec<[f64; 2]>,
    omegas: Vec<f64>,
    shapes: dolmen_linalg::Matrix,
    /// Correlation coefficients ρ_in, computed once.
    correlation: dolmen_linalg::Matrix,
}

/// Evaluates a spectrum at every mode: `acceleration_m_s2(period_s, damping_ratio)` gives S_a along x and along y.
///
/// # Errors
/// [`DynamicsError::Argument`] for a building with tuned masses, or for a spectral value that is not a positive number; errors of the spectrum
/// are passed on.
///
/// # Limits
/// Only for a building without tuned masses, which need a time history. All modes are included.
///
/// # Source
/// Chopra (2017), chapter 13.
pub fn spectral_analysis<E: From<DynamicsError>>(
    building: &VibratingBuilding,
    mut acceleration_m_s2: impl FnMut(f64, f64) -> Result<[f64; 2], E>,
) -> Result<SpectralAnalysis, E> {
    if !building.tuned_masses().is_empty() {
        let refused = DynamicsError::Argument {
            argument: "the number of tuned masses",
            given: building.tuned_masses().len() as f64,
            allowed: "0 for response spectra, whose modes are those of the building alone: use a time history",
        };
        return Err(refused.into());
    }
    let mut modes = Vec::new();
    let mut amplitudes = Vec::new();
    for (mode, &damping_ratio) in building.modes().modes.iter().zip(building.damping_ratios()) {
        let period_s = mode.period_s();
        let acceleration = acceleration_m_s2(period_s, damping_ratio)?;
        if let Some(&given) = acceleration.iter().find(|a| !(**a >= 0.0 && a.is_finite())) {
            let refused = DynamicsError::Argument {
                argument: "spectral acceleration",
                given,
                allowed: "0 or a positive number",
            };
            return Err(refused.into());
        }
        let square = mode.omega_rad_s * mode.omega_rad_s;
        amplitudes.push([0, 1].map(|axis| mode.participation[axis] * acceleration[axis] / square));
        modes.push(SpectralMode {
            period_s,
            damping_ratio,
            acceleration_m_s2: acceleration,
        });
    }
    let omegas = building.modes().omegas_rad_s();
    let n = omegas.len();
    let of = |i: usize| [omegas[i], building.damping_ratios()[i]];
    let correlation = dolmen_linalg::Matrix::from_fn(n, n, |i, j| {
        if i == j {
            1.0
        } else {
            correlation_coefficient(of(i), of(j))
        }
    });
    Ok(SpectralAnalysis {
        modes,
        amplitudes,
        omegas,
        shapes: building.modes().shapes.clone(),
        correlation,
    })
}

impl SpectralAnalysis {
    /// Largest response of each mode to shaking along an axis (0 x, 1 y), with its sign, of the quantity `row` times the coordinates.
    pub fn of_modes(&self, row: &[f64], axis: usize) -> Vec<f64> {
        let each = (0..self.omegas.len()).map(|n| {
            let along: f64 = row
                .iter()
                .zip(self.shapes.column(n))
                .map(|(r, phi)| r * phi)
                .sum();
            along * self.amplitudes[n][axis]
        });
        each.collect()
    }

    /// The largest response of the quantity `row` times the coordinates.
    pub fn largest(&self, row: &[f64], modal: ModalCombination, directional: DirectionalCombination) -> f64 {
        directional.of(|axis| self.combined(&self.of_modes(row, axis), modal))
    }

    /// The largest response over all directions of shaking with a weaker perpendicular component, by CQC3.
    ///
    /// ```text
    /// r² = (r_x² + γ² r_y²) cos² θ + (r_y² + γ² r_x²) sin² θ + 2 (1 − γ²) r_xy sin θ cos θ
    /// r_xy = ΣΣ ρ_in r_ix r_ny
    /// ```
    /// γ is `minor_ratio`, the spectrum of the weaker component over that of the stronger, in [0, 1]; 1 gives the root of the sum of squares for
    /// any direction. The spectra along x and y must both be that of the stronger component.
    ///
    /// # Errors
    /// [`DynamicsError::Argument`] for a ratio outside [0, 1].
    ///
    /// # Source
    /// Menun & Der Kiureghian (1998) Earthquake Spectra 14(1):153-163.
    pub fn least_favourable(&self, row: &[f64], minor_ratio: f64) -> Result<LeastFavourable, DynamicsError> {
        if !(0.0..=1.0).contains(&minor_ratio) {
            return Err(DynamicsError::Argument {
                argument: "minor_ratio",
                given: minor_ratio,
                allowed: "0 to 1: the weaker component over the stronger",
            });
        }
        let (x, y) = (self.of_modes(row, 0), self.of_modes(row, 1));
        let square = minor_ratio * minor_ratio;
        let (xx, yy) = (self.correlation.form(&x, &x), self.correlation.form(&y, &y));
        let along_x = xx + square * yy;
        let along_y = yy + square * xx;
        let across = (1.0 - square) * self.correlation.form(&x, &y);
        let half = 0.5 * (along_x - along_y);
        Ok(LeastFavourable {
            largest: (0.5 * (along_x + along_y) + half.hypot(across)).max(0.0).sqrt(),
            direction_degrees: (0.5 * across.atan2(half)).to_degrees() + 0.0,
        })
    }

    fn combined(&self, r: &[f64], modal: ModalCombination) -> f64 {
        match modal {
            ModalCombination::AbsoluteSum => r.iter().map(|r| r.abs()).sum(),
            ModalCombination::Srss => r.iter().map(|r| r * r).sum::<f64>().sqrt(),
            ModalCombination::Cqc => self.correlation.form(r, r).max(0.0).sqrt(),
        }
    }
}
