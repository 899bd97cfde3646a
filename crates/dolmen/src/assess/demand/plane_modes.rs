//! Demand of a response spectrum on a structure that moves in one plane: drifts of a frame, moments in the joints of a chain.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | φ, ω | – | a natural mode in the coordinates of the structure | –, rad/s |
//! | L | `influence` | inertia force on each coordinate for a unit acceleration of the ground | kg, kg m |
//! | Γ | – | φᵀL/φᵀMφ | – |
//! | S_a | – | spectral acceleration at the period of the mode | m/s² |
//! | ζ | `damping_ratio` | damping ratio of every mode | – |
//! | ρ | – | correlation coefficient of two modes | – |

use super::SiteDemand;
use crate::assess::AssessError;
use crate::dynamics::correlation_coefficient;
use crate::structure::{Chain, Frame, NaturalMode};
use dolmen_linalg::Matrix;

/// Largest response of every mode under a spectrum.
#[derive(Clone, Debug, PartialEq)]
struct PlaneModes {
    /// Γ S_a/ω² φ of each mode, in the coordinates of the structure.
    responses: Vec<Vec<f64>>,
    /// ρ of each pair of modes.
    correlation: Matrix,
}

impl PlaneModes {
    /// Evaluates the spectrum of a site at every mode; `None` if the structure falls.
    fn new(
        modes: &[NaturalMode],
        mass: &Matrix,
        influence: &[f64],
        site: &SiteDemand,
        zeta: f64,
    ) -> Result<Option<Self>, AssessError> {
        if modes
            .iter()
            .any(|mode| mode.omega_squared.is_nan() || mode.omega_squared <= 0.0)
        {
            return Ok(None);
        }
        let mut responses = Vec::with_capacity(modes.len());
        for mode in modes {
            let phi = &mode.coordinates;
            let drive: f64 = phi.iter().zip(influence).map(|(phi, l)| phi * l).sum();
            let participation = drive / mass.form(phi, phi);
            let spectral_m_s2 = site.spectrum.acceleration_m_s2(1.0 / mode.frequency_hz, zeta)?;
            let amplitude = participation * spectral_m_s2 / mode.omega_squared;
            responses.push(phi.iter().map(|phi| amplitude * phi).collect());
        }
        let n = modes.len();
        let correlation = Matrix::from_fn(n, n, |i, j| match i == j {
            true => 1.0,
            false => correlation_coefficient([modes[i].frequency_hz, zeta], [modes[j].frequency_hz, zeta]),
        });
        Ok(Some(PlaneModes {
            responses,
            correlation,
        }))
    }

    /// The largest value of a response quantity, `row` times the coordinates, by CQC.
    ///
    /// ```text
    /// r = √ΣΣ ρ_in r_i r_n,  r_n = row · φ_n Γ_n S_a(T_n, ζ)/ω_n²
    /// ```
    fn largest(&self, row: &[f64]) -> f64 {
        let of = |response: &Vec<f64>| row.iter().zip(response).map(|(a, b)| a * b).sum();
        let each: Vec<f64> = self.responses.iter().map(of).collect();
        self.correlation.form(&each, &each).max(0.0).sqrt()
    }

    /// The largest difference between each coordinate and the next lower one; for the lowest, relative to the ground.
    fn steps(&self) -> Vec<f64> {
        let n = self.responses.first().map_or(0, Vec::len);
        let step = |i: usize| {
            let mut row = vec![0.0; n];
            row[i] = 1.0;
            if let Some(below) = i.checked_sub(1) {
                row[below] = -1.0;
            }
            self.largest(&row)
        };
        (0..n).map(step).collect()
    }
}

/// Largest elastic drift of each storey of a frame under the spectrum of a site, m, lowest first. All modes have the same damping ratio, and
/// P-delta is included; `None` for a frame that falls.
///
/// # Errors
/// [`AssessError::Structure`] for a wrong stiffness; errors of the spectrum at the period of a mode or at the damping ratio.
///
/// # Limits
/// The frame is elastic. Joints that can slip are either all stuck or all slipping, according to `stiffness_n_m`. The damping ratio of the
/// site is the only damping, also for friction.
///
/// # Source
/// Chopra (2017), chapter 13; CQC by Der Kiureghian (1981).
pub fn frame_drifts_by_spectrum(
    frame: &Frame,
    stiffness_n_m: &[f64],
    site: &SiteDemand,
    damping_ratio: f64,
) -> Result<Option<Vec<f64>>, AssessError> {
    let modes = frame.natural_modes(stiffness_n_m)?;
    let influence: Vec<f64> = frame.storeys().iter().map(|storey| storey.mass_kg).collect();
    let found = PlaneModes::new(&modes, &frame.mass_matrix(), &influence, site, damping_ratio)?;
    Ok(found.map(|modes| modes.steps()))
}

/// Largest moment of each joint of a chain under the spectrum of a site, N m, lowest first. All modes have the same damping ratio, and
/// gravity is included; `None` for a chain that falls.
///
/// ```text
/// τ_i = k_i |θ_i − θ_{i−1}|
/// ```
///
/// # Errors
/// [`AssessError::Structure`] for a wrong stiffness; errors of the spectrum at the period of a mode or at the damping ratio.
///
/// # Limits
/// Elastic: a bed that opens is softer, and its moment does not exceed N b/2.
///
/// # Source
/// Chopra (2017), chapter 13; CQC by Der Kiureghian (1981).
pub fn chain_moments_by_spectrum(
    chain: &Chain,
    stiffness_n_m_rad: &[f64],
    site: &SiteDemand,
    damping_ratio: f64,
) -> Result<Option<Vec<f64>>, AssessError> {
    let modes = chain.natural_modes(stiffness_n_m_rad)?;
    let influence = chain.base_influence_kg_m();
    let found = PlaneModes::new(&modes, &chain.mass_matrix(), &influence, site, damping_ratio)?;
    Ok(found.map(|modes| {
        let rotations = modes.steps();
        rotations
            .iter()
            .zip(stiffness_n_m_rad)
            .map(|(phi, k)| phi * k)
            .collect()
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assess::demand::{KoreanSite, Site, site_demand};
    use crate::structure::{Convention, Inertia, Link, Storey};

    fn site() -> SiteDemand {
        let site = Site::Kds17 {
            zone_factor_g: 0.11,
            return_period_years: 2400,
            soil: KoreanSite::S4,
        };
        site_demand(&site, 0.05, None).unwrap()
    }

    fn close(computed: f64, exact: f64) {
        assert!((computed / exact - 1.0).abs() < 1e-12, "{computed} {exact}");
    }

    #[test]
    fn exact_one_storey_and_one_link_follow_the_spectrum() {
        let (mass_kg, height_m, axial_n, k) = (2e4, 4.0, 2e5, 5e6);
        let storey = Storey {
            mass_kg,
            height_m,
            axial_n,
        };
        let frame = Frame::new(vec![storey], Convention::Drift).unwrap();
        let omega_squared = (k - axial_n / height_m) / mass_kg;
        let at = |omega_squared: f64| {
            let period_s = std::f64::consts::TAU / omega_squared.sqrt();
            site().spectrum.acceleration_m_s2(period_s, 0.05).unwrap()
        };
        let drift = frame_drifts_by_spectrum(&frame, &[k], &site(), 0.05)
            .unwrap()
            .unwrap();
        close(drift[0], at(omega_squared) / omega_squared);
        let (m, l, length_m, g, k) = (1000.0, 1.5, 3.0, 9.8, 1e6);
        let link = Link {
            mass_kg: m,
            length_m,
            centroid_m: l,
            inertia: Inertia::ThinRod,
            bed_width_m: None,
        };
        let chain = Chain::new(vec![link], g).unwrap();
        let inertia = m * l * l + m * length_m * length_m / 12.0;
        let moment = chain_moments_by_spectrum(&chain, &[k], &site(), 0.05)
            .unwrap()
            .unwrap();
        let stiffness = k - m * g * l;
        close(moment[0], k * m * l * at(stiffness / inertia) / stiffness);
        // with one mode, another damping ratio only changes the spectrum
        let period_s = std::f64::consts::TAU / (stiffness / inertia).sqrt();
        let read = |zeta: f64| site().spectrum.acceleration_m_s2(period_s, zeta).unwrap();
        let damped = chain_moments_by_spectrum(&chain, &[k], &site(), 0.01)
            .unwrap()
            .unwrap();
        assert!(read(0.01) > 1.2 * read(0.05));
        close(damped[0] / moment[0], read(0.01) / read(0.05));
    }

    #[test]
    fn exact_two_equal_storeys_by_the_golden_ratio() {
        // M = m I, K = k [2 −1; −1 1]: ω² = k/m (3 ∓ √5)/2, φ = (1, g) and (g, −1) with g the golden ratio
        let (m, k) = (1e4, 4e6);
        let storey = Storey {
            mass_kg: m,
            height_m: 3.0,
            axial_n: 0.0,
        };
        let frame = Frame::new(vec![storey.clone(), storey], Convention::Drift).unwrap();
        let drifts = frame_drifts_by_spectrum(&frame, &[k, k], &site(), 0.05)
            .unwrap()
            .unwrap();
        let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
        let modes = [
            ([1.0, golden], (3.0 - 5.0_f64.sqrt()) / 2.0),
            ([golden, -1.0], (3.0 + 5.0_f64.sqrt()) / 2.0),
        ];
        let parts = modes.map(|(phi, factor)| {
            let omega = (factor * k / m).sqrt();
            let sa = site()
                .spectrum
                .acceleration_m_s2(std::f64::consts::TAU / omega, 0.05)
                .unwrap();
            let gamma = (phi[0] + phi[1]) / (phi[0] * phi[0] + phi[1] * phi[1]);
            let amplitude = gamma * sa / (omega * omega);
            (omega, [amplitude * phi[0], amplitude * (phi[1] - phi[0])])
        });
        // Chopra (2017), eq. 13.7.10 for equal damping
        let beta: f64 = parts[0].0 / parts[1].0;
        let z2 = 0.05_f64.powi(2);
        let rho = 8.0 * z2 * (1.0 + beta) * beta.powf(1.5)
            / ((1.0 - beta * beta).powi(2) + 4.0 * z2 * beta * (1.0 + beta).powi(2));
        for (storey, drift) in drifts.iter().enumerate() {
            let (a, b) = (parts[0].1[storey], parts[1].1[storey]);
            close(*drift, (a * a + b * b + 2.0 * rho * a * b).sqrt());
        }
    }

    #[test]
    fn holds_a_frame_that_falls_has_no_drifts() {
        let storey = Storey {
            mass_kg: 1e4,
            height_m: 4.0,
            axial_n: 1e5,
        };
        let frame = Frame::new(vec![storey], Convention::Drift).unwrap();
        assert_eq!(
            frame_drifts_by_spectrum(&frame, &[2e4], &site(), 0.05).unwrap(),
            None
        );
    }
}
