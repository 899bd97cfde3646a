//! Natural modes of a chain, and displacements from its rotations.

use super::Chain;
use crate::structure::{NaturalMode, StructureError};
use dolmen_linalg::generalized_symmetric_eigen;

impl Chain {
    /// Undamped natural modes under gravity, ascending; one per link.
    ///
    /// ```text
    /// K φ = ω² M φ,  f = ω / 2π        K, M: n × n;  φ: n link rotations
    /// ```
    ///
    /// # Errors
    /// [`StructureError::Count`] or [`StructureError::NotPositive`] for the stiffnesses; [`StructureError::Linalg`]
    /// if the decomposition fails.
    ///
    /// # Limits
    /// Small amplitudes. If the chain is unstable, its first mode has a negative ω² and frequency 0.
    ///
    /// # Source
    /// Choi (2021) eq. 28. Tested by `choi_2021`.
    ///
    /// # Example
    /// ```
    /// use dolmen::structure::{Chain, Inertia, Link};
    /// let link = Link {
    ///     mass_kg: 1000.0,
    ///     length_m: 3.0,
    ///     centroid_m: 1.5,
    ///     inertia: Inertia::ThinRod,
    ///     bed_width_m: None,
    /// };
    /// let modes = Chain::new(vec![link], 9.81)?.natural_modes(&[1.0e6])?;
    /// // ω² = (k − m g l) / (m L²/3)
    /// let exact = ((1.0e6 - 1000.0 * 9.81 * 1.5) / 3000.0_f64).sqrt() / std::f64::consts::TAU;
    /// assert!((modes[0].frequency_hz - exact).abs() < 1e-12);
    /// # Ok::<(), dolmen::structure::StructureError>(())
    /// ```
    pub fn natural_modes(&self, stiffness_n_m_rad: &[f64]) -> Result<Vec<NaturalMode>, StructureError> {
        let stiffness = self.stiffness_matrix(stiffness_n_m_rad)?;
        let eigen = generalized_symmetric_eigen(&stiffness, &self.mass_matrix())?;
        let modes = eigen.values.iter().enumerate();
        Ok(modes
            .map(|(j, &omega_squared)| self.natural_mode(omega_squared, eigen.vectors.column(j)))
            .collect())
    }

    /// One mode from rotations of any scale.
    fn natural_mode(&self, omega_squared: f64, rotations: &[f64]) -> NaturalMode {
        let tops = self.top_displacements(rotations);
        // scaled to a largest displacement of 1, which occurs at the top of a link because links are straight
        let scale = tops
            .iter()
            .fold(0.0_f64, |most, &u| if u.abs() > most.abs() { u } else { most });
        NaturalMode {
            omega_squared,
            frequency_hz: omega_squared.max(0.0).sqrt() / std::f64::consts::TAU,
            displacement: tops.iter().map(|u| u / scale).collect(),
            coordinates: rotations.iter().map(|theta| theta / scale).collect(),
        }
    }

    /// Lateral displacement of the top of each link from its rotations, lowest first: Σ_{j≤i} L_j θ_j.
    fn top_displacements(&self, rotations: &[f64]) -> Vec<f64> {
        let links = self.links().iter().zip(rotations);
        let climb = |u: &mut f64, (link, theta): (&super::Link, &f64)| {
            *u += link.length_m * theta;
            Some(*u)
        };
        links.scan(0.0, climb).collect()
    }

    /// Lateral displacement u(z) at a height from the rotations of the links; m for rotations in rad.
    ///
    /// # Errors
    /// [`StructureError::Count`] for a wrong number of rotations; [`StructureError::Height`] for a height outside the
    /// chain.
    pub fn displacement_at(&self, rotations_rad: &[f64], height_m: f64) -> Result<f64, StructureError> {
        self.check_count("rotations_rad", rotations_rad.len())?;
        let lever = self.lever_m_rad(height_m)?;
        Ok(lever.iter().zip(rotations_rad).map(|(c, theta)| c * theta).sum())
    }
}
