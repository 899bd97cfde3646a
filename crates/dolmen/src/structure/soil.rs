//! Rocking stiffness of a rigid footing on soil, alone and in series with a joint.

/// Plan shape of a rigid footing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Footing {
    /// A circle.
    Circle {
        /// Diameter, m.
        diameter_m: f64,
    },
    /// A rectangle.
    Rectangle {
        /// Side in the direction of motion, m.
        along_m: f64,
        /// Side across the direction of motion, m.
        across_m: f64,
    },
}

impl Footing {
    /// Plan area, m².
    pub fn area_m2(&self) -> f64 {
        match self {
            Footing::Circle { diameter_m } => 0.25 * std::f64::consts::PI * diameter_m * diameter_m,
            Footing::Rectangle { along_m, across_m } => along_m * across_m,
        }
    }
}

/// A rigid footing on the surface of an elastic half-space, in full contact.
///
/// ```text
/// circle      K = 8 G R³ / (3 (1 − ν))
/// rectangle   about the long axis    K = G b³/(1 − ν) [3.2 L/B + 0.8]
///             about the short axis   K = G b³/(1 − ν) [3.73 (L/B)^2.4 + 0.27]      b: half the short side
/// ```
///
/// SOURCE   the circle: a tilted rigid disc, in closed form; the rectangle: the fit of Pais, A. and Kausel, E. (1988) Soil Dynamics and
///          Earthquake Engineering 7(4), 213-227.
/// ASSUMES  no embedment, no bedrock near the footing, small strain. Strong shaking makes the shear modulus much smaller.
/// CHECKED  `soil::holds_pressures_on_a_half_space_give_the_same_stiffness`, against squares of uniform pressure under the footing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Soil {
    /// Shear modulus G, Pa.
    pub shear_modulus_pa: f64,
    /// Poisson's ratio ν.
    pub poisson_ratio: f64,
    /// The footing.
    pub footing: Footing,
}

impl Soil {
    /// Rocking stiffness K in the direction of motion, N m/rad.
    pub fn rocking_n_m_rad(&self) -> f64 {
        let modulus_pa = self.shear_modulus_pa / (1.0 - self.poisson_ratio);
        match self.footing {
            Footing::Circle { diameter_m } => modulus_pa * diameter_m.powi(3) / 3.0,
            Footing::Rectangle { along_m, across_m } => {
                let half_m = 0.5 * along_m.min(across_m);
                let slenderness = along_m.max(across_m) / along_m.min(across_m);
                let shape = match along_m > across_m {
                    // rocks about the short axis
                    true => 3.73 * slenderness.powf(2.4) + 0.27,
                    false => 3.2 * slenderness + 0.8,
                };
                modulus_pa * half_m.powi(3) * shape
            }
        }
    }

    /// The soil for motion in the other direction: the sides of the footing exchanged.
    pub fn across(&self) -> Soil {
        Soil {
            footing: match self.footing {
                Footing::Circle { .. } => self.footing,
                Footing::Rectangle { along_m, across_m } => Footing::Rectangle {
                    along_m: across_m,
                    across_m: along_m,
                },
            },
            ..*self
        }
    }

    /// Stiffness of a joint in series with the soil, N m/rad: 1/k = 1/k_joint + 1/K.
    pub fn in_series_n_m_rad(&self, joint_n_m_rad: f64) -> f64 {
        let soil = self.rocking_n_m_rad();
        joint_n_m_rad * soil / (joint_n_m_rad + soil)
    }

    /// Joint stiffness that gives `together_n_m_rad` in series with the soil, N m/rad; `None` if the soil alone is not stiffer than that.
    pub fn joint_n_m_rad(&self, together_n_m_rad: f64) -> Option<f64> {
        let soil = self.rocking_n_m_rad();
        (together_n_m_rad < soil).then(|| together_n_m_rad * soil / (soil - together_n_m_rad))
    }
}
