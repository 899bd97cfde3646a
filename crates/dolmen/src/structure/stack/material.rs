//! Material of a joint: friction, bond, springs, damping.

use super::StackError;

/// Friction, bond, springs and damping of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointMaterial {
    /// Static friction coefficient, valid until a point first slips. Default 0.6, dressed granite.
    pub friction_static: f64,
    /// Kinetic friction coefficient, while a point slips; at most the static one. Default 0.6.
    pub friction_kinetic: f64,
    /// Shear strength of the bond in addition to friction, Pa; lost at points that fail. Default 0: dry.
    pub cohesion_pa: f64,
    /// Tensile strength of the bond, Pa; lost at points that fail. Default 0: dry.
    pub tension_pa: f64,
    /// Compressive strength f of stone or mortar in the joint, Pa: an edge crushes under a stress block of this value. Default `None`: no
    /// crushing.
    pub compressive_strength_pa: Option<f64>,
    /// Normal stiffness per area, Pa/m. Default 1e9 (Kim, Koo & Hong 2018, Fig. 17).
    pub normal_stiffness_pa_m: f64,
    /// Shear stiffness per area, Pa/m. Default 4e8 (same source).
    pub shear_stiffness_pa_m: f64,
    /// Damping of the contact springs, as a fraction of the critical damping of the two stones on the springs of the whole joint; 0 to 20. Default
    /// 0.3, our choice. The energy loss of a rocking stone depends on more than this: see `docs/stack-engine.md`.
    pub damping_ratio: f64,
    /// Restitution of falls with the rigid law, for faces that were apart: mean normal velocity of the contact points after an impact, over that
    /// before; 0 to 1. Default 0, plastic. With contact springs, `damping_ratio` determines the rebound: see
    /// [`damping_ratio_of`](Self::damping_ratio_of).
    pub normal_restitution: f64,
    /// Restitution of rocking with the rigid law: the fraction of its angular velocity that a rocking stone keeps when its weight passes from one
    /// edge to the other; above 0, to 1. Default `None`: the impact at the far edge determines it, which for one block is Housner's 1 − 1.5 sin²α.
    pub rocking_restitution: Option<f64>,
}

impl Default for JointMaterial {
    fn default() -> Self {
        JointMaterial {
            friction_static: 0.6,
            friction_kinetic: 0.6,
            cohesion_pa: 0.0,
            tension_pa: 0.0,
            compressive_strength_pa: None,
            normal_stiffness_pa_m: 1e9,
            shear_stiffness_pa_m: 4e8,
            damping_ratio: 0.3,
            normal_restitution: 0.0,
            rocking_restitution: None,
        }
    }
}

impl JointMaterial {
    /// The default material with equal static and kinetic friction coefficients.
    pub fn with_friction(friction_coefficient: f64) -> Self {
        JointMaterial {
            friction_static: friction_coefficient,
            friction_kinetic: friction_coefficient,
            ..JointMaterial::default()
        }
    }

    /// Restitution of a stone that falls flat on contact springs with this damping ratio; its weight is neglected against the impact force.
    ///
    /// ```text
    /// e = exp(−ζ/√(1−ζ²) [π − atan2(2ζ√(1−ζ²), 1−2ζ²)])      ζ < 1;    e = exp(−2) at ζ = 1
    /// e = exp(−ζ/√(ζ²−1) atanh(2ζ√(ζ²−1)/(2ζ²−1)))           ζ > 1
    /// ```
    ///
    /// SOURCE   Schwager, T. and Pöschel, T. (2007) Granular Matter 9(6), 465-469: spring and dashpot that separate when the force is 0.
    /// CHECKED  `exact_rebound_of_springs_and_dashpots`, by time stepping and by a falling stone in `simulate`.
    pub fn restitution_of(damping_ratio: f64) -> f64 {
        let z = damping_ratio;
        if (z - 1.0).abs() < 1e-6 {
            return (-2.0_f64).exp();
        }
        let root = (1.0 - z * z).abs().sqrt();
        let turn = match z < 1.0 {
            true => std::f64::consts::PI - (2.0 * z * root).atan2(1.0 - 2.0 * z * z),
            false => (2.0 * z * root / (2.0 * z * z - 1.0)).atanh(),
        };
        (-z / root * turn).exp()
    }

    /// Damping ratio of the contact springs for this restitution of a stone that falls flat, by bisection; at most
    /// [`DAMPING_RATIO_MOST`](Self::DAMPING_RATIO_MOST), which gives a restitution of 0.0006.
    pub fn damping_ratio_of(normal_restitution: f64) -> f64 {
        let (mut low, mut high) = (0.0, Self::DAMPING_RATIO_MOST);
        if normal_restitution <= Self::restitution_of(high) {
            return high;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            match Self::restitution_of(middle) > normal_restitution {
                true => low = middle,
                false => high = middle,
            }
        }
        0.5 * (low + high)
    }

    /// Largest damping ratio of the springs.
    pub const DAMPING_RATIO_MOST: f64 = 20.0;

    /// # Errors
    /// [`StackError::Material`] for the first value out of its range.
    pub(crate) fn checked(self) -> Result<Self, StackError> {
        let refuse = |quantity, given, allowed| {
            Err(StackError::Material {
                quantity,
                given,
                allowed,
            })
        };
        let not_negative = [
            ("friction_static", self.friction_static),
            ("friction_kinetic", self.friction_kinetic),
            ("cohesion_pa", self.cohesion_pa),
            ("tension_pa", self.tension_pa),
        ];
        for (quantity, given) in not_negative {
            if !(given >= 0.0 && given.is_finite()) {
                return refuse(quantity, given, "0 or a positive number");
            }
        }
        let positive = [
            ("normal_stiffness_pa_m", self.normal_stiffness_pa_m),
            ("shear_stiffness_pa_m", self.shear_stiffness_pa_m),
        ];
        let strength = self
            .compressive_strength_pa
            .map(|given| ("compressive_strength_pa", given));
        for (quantity, given) in positive.into_iter().chain(strength) {
            if !(given > 0.0 && given.is_finite()) {
                return refuse(quantity, given, "a positive number");
            }
        }
        if self.friction_kinetic > self.friction_static {
            return refuse(
                "friction_kinetic",
                self.friction_kinetic,
                "at most friction_static",
            );
        }
        if !(0.0..=Self::DAMPING_RATIO_MOST).contains(&self.damping_ratio) {
            return refuse("damping_ratio", self.damping_ratio, "between 0 and 20");
        }
        if !(0.0..=1.0).contains(&self.normal_restitution) {
            return refuse("normal_restitution", self.normal_restitution, "between 0 and 1");
        }
        if let Some(given) = self.rocking_restitution
            && !(given > 0.0 && given <= 1.0)
        {
            return refuse("rocking_restitution", given, "above 0 and at most 1");
        }
        Ok(self)
    }
}
