//! The simplest model of a pole, for a check of other models: one rigid body on one rotational spring (Choi 2021,
//! Fig. 7).

use super::Chain;
use crate::structure::StructureError;

/// A rigid body that rocks on a rotational spring at its foot.
///
/// ```text
/// ω² = (k − m g h) / I        stands if k > m g h
/// ```
///
/// # Source
/// Choi (2021) Fig. 7 and Choi & Cho (2021). Differs from the source: the body has its own moment of inertia (Fig. 7
/// takes a point mass: `inertia_kg_m2` = m h²), and gravity acts. Tested by `chain_laws`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SingleMass {
    /// Mass m, kg.
    pub mass_kg: f64,
    /// Height h of the centre of mass above the spring, m.
    pub height_m: f64,
    /// Moment of inertia I about the spring, kg m².
    pub inertia_kg_m2: f64,
    /// Gravity g, m/s².
    pub gravity_m_s2: f64,
}

impl SingleMass {
    /// Critical stiffness m g h, below which the body is unstable, N m/rad. For a chain this is M_1, the exact limit
    /// of its lowest joint if all other joints are rigid.
    pub fn critical_stiffness_n_m_rad(&self) -> f64 {
        self.mass_kg * self.gravity_m_s2 * self.height_m
    }

    /// Natural frequency with a rotational spring at the foot, Hz; 0 if the body falls.
    ///
    /// For a chain with k_1 at the foot this is an upper bound of the first frequency, because the other joints are
    /// rigid here.
    ///
    /// # Errors
    /// [`StructureError::NotPositive`] if a value is not positive.
    pub fn frequency_hz(&self, stiffness_n_m_rad: f64) -> Result<f64, StructureError> {
        positive("joint", "stiffness_n_m_rad", stiffness_n_m_rad)?;
        let omega_squared = (stiffness_n_m_rad - self.critical_stiffness_n_m_rad()) / self.inertia_kg_m2;
        Ok(omega_squared.max(0.0).sqrt() / std::f64::consts::TAU)
    }

    /// Stiffness of the spring that gives this frequency, N m/rad: k = m g h + I (2πf)².
    ///
    /// For a chain with this first frequency the result is a lower bound of k_1.
    ///
    /// # Errors
    /// [`StructureError::NotPositive`] if a value is not positive.
    pub fn stiffness_n_m_rad(&self, frequency_hz: f64) -> Result<f64, StructureError> {
        positive("mode", "frequency_hz", frequency_hz)?;
        let omega = std::f64::consts::TAU * frequency_hz;
        Ok(self.critical_stiffness_n_m_rad() + self.inertia_kg_m2 * omega * omega)
    }
}

fn positive(part: &'static str, quantity: &'static str, given: f64) -> Result<(), StructureError> {
    if given > 0.0 && given.is_finite() {
        return Ok(());
    }
    Err(StructureError::NotPositive {
        part,
        number: 1,
        quantity,
        given,
    })
}

impl Chain {
    /// The chain with every joint above the lowest rigid, without its side support.
    pub fn as_single_mass(&self) -> SingleMass {
        let mass_kg = self.links().iter().map(|link| link.mass_kg).sum();
        let ones = vec![1.0; self.links().len()];
        SingleMass {
            mass_kg,
            height_m: self.base_influence_kg_m().iter().sum::<f64>() / mass_kg,
            inertia_kg_m2: self.mass_matrix().form(&ones, &ones),
            gravity_m_s2: self.gravity_m_s2(),
        }
    }
}
