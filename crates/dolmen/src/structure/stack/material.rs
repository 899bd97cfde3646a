//! What acts in a joint: friction, bond, springs, damping.

use super::StackError;

/// Friction, bond, springs and damping of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointMaterial {
    /// Static friction coefficient, until a point first slips. Default 0.6, dressed granite.
    pub friction_static: f64,
    /// Kinetic friction coefficient, while a point slips; at most the static one. Default 0.6.
    pub friction_kinetic: f64,
    /// Shear strength of the bond beyond friction, Pa, lost where it fails. Default 0: dry.
    pub cohesion_pa: f64,
    /// Tensile strength of the bond, Pa, lost where it fails. Default 0: dry.
    pub tension_pa: f64,
    /// Compressive strength f of stone or mortar in the joint, Pa: an edge crushes under a block of this stress. Default `None`: it never crushes.
    pub compressive_strength_pa: Option<f64>,
    /// Normal stiffness per area, Pa/m. Default 1e9 (Kim, Koo & Hong 2018, Fig. 17).
    pub normal_stiffness_pa_m: f64,
    /// Shear stiffness per area, Pa/m. Default 4e8 (the same).
    pub shear_stiffness_pa_m: f64,
    /// Dashpots of the springs, as a fraction of the critical damping of the two stones on the springs of the
    /// whole joint; 0 to 20. Default 0.3, chosen here. It does not alone set what is lost when a stone rocks: see `docs/stack-engine.md`.
    pub damping_ratio: f64,
    /// Restitution of the rigid law: mean normal velocity, after an impact, of the points that touch, over that before; 0 to 1. A stone that
    /// falls flat bounces with it, a stone that rocks keeps this part of its angular velocity, but never less than Housner's.
    /// Default 0, plastic: what stones lose at least is theirs by geometry, what more they keep must be measured.
    pub restitution: f64,
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
            restitution: 0.0,
        }
    }
}

impl JointMaterial {
    /// The default with one friction coefficient, static and kinetic.
    pub fn with_friction(friction_coefficient: f64) -> Self {
        JointMaterial {
            friction_static: friction_coefficient,
            friction_kinetic: friction_coefficient,
            ..JointMaterial::default()
        }
    }

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
        if !(0.0..=20.0).contains(&self.damping_ratio) {
            return refuse("damping_ratio", self.damping_ratio, "between 0 and 20");
        }
        if !(0.0..=1.0).contains(&self.restitution) {
            return refuse("restitution", self.restitution, "between 0 and 1");
        }
        Ok(self)
    }
}
