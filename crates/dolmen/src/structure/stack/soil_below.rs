//! Elastic soil below a stack.

use super::soil_springs::SoilBelow;
use super::{Body, JointMaterial, Stack, StackError};
use crate::structure::soil::{Footing, Soil};

impl Stack {
    /// The stack on an elastic half-space, with a rigid footing on its surface; the footing has the given plan, or that of the lowest bed.
    ///
    /// ```text
    /// k_n = least of K/I over both directions, K the rocking stiffness of the footing ([`Soil`])
    /// k_s = K_h/A,   K_h = 8 G R/(2 − ν), R = √(A/π)       A and I the area of the joint and its second moments
    /// ```
    ///
    /// # Errors
    /// As [`with_soil`](Stack::with_soil).
    ///
    /// # Limits
    /// The springs under the bed have the rotational stiffness of the half-space and carry no tension; vertically they are up to 2.7 times too stiff.
    /// A bed that is not square has the smaller k_n of its two directions, so about the other axis it is softer than its K. Radiation damping is left out; the damping of the joint remains.
    ///
    /// # Source
    /// K: see [`Soil`]. K_h: horizontal load on a rigid disc, R. D. Mindlin (1949) J. Appl. Mech. 16, 259-268; for other plans the disc with the same
    /// area.
    pub fn on_half_space(
        self,
        [shear_modulus_pa, poisson_ratio]: [f64; 2],
        footing: Option<Footing>,
    ) -> Result<Self, StackError> {
        let moments = self.joints[self.ground_joint()?].patch.moments();
        let area_m2 = moments.area_m2;
        // the rectangle with the same second moments
        let side = |axis: usize| (12.0 * moments.second_m4[axis] / area_m2).sqrt();
        let soil = Soil {
            shear_modulus_pa,
            poisson_ratio,
            footing: footing.unwrap_or(Footing::Rectangle {
                along_m: side(0),
                across_m: side(1),
            }),
        };
        let rocking = [soil.rocking_n_m_rad(), soil.across().rocking_n_m_rad()];
        let normal = [0, 1].map(|axis| rocking[axis] / moments.second_m4[axis]);
        let radius_m = (soil.footing.area_m2() / std::f64::consts::PI).sqrt();
        let normal_pa_m = normal[0].min(normal[1]);
        self.with_soil(SoilBelow {
            rocking_stiffness_n_m_rad: normal_pa_m * moments.second_m4[0].min(moments.second_m4[1]),
            normal_stiffness_pa_m: normal_pa_m,
            shear_stiffness_pa_m: 8.0 * shear_modulus_pa * radius_m / (2.0 - poisson_ratio) / area_m2,
        })
    }

    /// The stack on soil: the springs of the soil act in series with the joint on the ground.
    ///
    /// # Errors
    /// [`StackError::SoilUnderSeveral`] for a stack with several blocks on the ground, [`StackError::Dimension`] for a stiffness that is not positive
    /// and finite.
    pub fn with_soil(mut self, soil: SoilBelow) -> Result<Self, StackError> {
        for (quantity, given) in [
            (
                "rocking_stiffness_n_m_rad of the soil",
                soil.rocking_stiffness_n_m_rad,
            ),
            ("normal_stiffness_pa_m of the soil", soil.normal_stiffness_pa_m),
            ("shear_stiffness_pa_m of the soil", soil.shear_stiffness_pa_m),
        ] {
            if !(given > 0.0 && given.is_finite()) {
                return Err(StackError::Dimension {
                    quantity,
                    given,
                    allowed: "a positive number",
                });
            }
        }
        let joint = self.ground_joint()?;
        let bed = self.joints[joint].material;
        let series = |bed: f64, soil: f64| bed * soil / (bed + soil);
        self = self.with_material(
            joint,
            JointMaterial {
                normal_stiffness_pa_m: series(bed.normal_stiffness_pa_m, soil.normal_stiffness_pa_m),
                shear_stiffness_pa_m: series(bed.shear_stiffness_pa_m, soil.shear_stiffness_pa_m),
                ..bed
            },
        )?;
        self.soil = Some(soil);
        Ok(self)
    }

    /// The soil below the stack; `None` for rigid ground.
    pub fn soil(&self) -> Option<&SoilBelow> {
        self.soil.as_ref()
    }

    fn ground_joint(&self) -> Result<usize, StackError> {
        let on_ground = |joint: &usize| self.joints[*joint].lower == Body::Ground;
        let all: Vec<usize> = (0..self.joints.len()).filter(on_ground).collect();
        match all[..] {
            [one] => Ok(one),
            _ => Err(StackError::SoilUnderSeveral { count: all.len() }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::stack::{Block, Placement, Solid};

    fn tower(sizes: &[[f64; 3]], material: JointMaterial) -> Stack {
        let mut z = 0.0;
        let blocks = sizes.iter().enumerate().map(|(i, size)| {
            let place = Placement {
                position_m: [0.0, 0.0, z],
                ..Placement::default()
            };
            z += size[2];
            Block {
                name: i.to_string(),
                solid: Solid::cuboid(size[0], size[1], size[2]).unwrap().placed(&place),
                density_kg_m3: 2600.0,
            }
        });
        Stack::new(blocks.collect(), material, 9.81).unwrap()
    }

    #[test]
    fn holds_the_softer_direction_counts_and_the_bed_is_in_series() {
        let stack = tower(&[[2.0, 1.0, 0.5], [0.8, 0.8, 2.0]], JointMaterial::default());
        let on_soil = stack.clone().on_half_space([30e6, 0.35], None).unwrap();
        let soil = on_soil.soil().unwrap();
        // about the long axis: G b^3/(1 - v) (3.2 L/B + 0.8)
        let about_long: f64 = 30e6 * 0.125 / 0.65 * 7.2;
        let about_short = 30e6 * 0.125 / 0.65 * (3.73 * 2.0_f64.powf(2.4) + 0.27);
        let softest = (about_long / (2.0 / 12.0)).min(about_short / (8.0 / 12.0));
        assert!((soil.normal_stiffness_pa_m / softest - 1.0).abs() < 1e-12);
        // about the long axis the springs that count are softer than the half-space
        let counts = softest * 2.0 / 12.0;
        assert!(counts < 0.7 * about_long);
        assert!((soil.rocking_stiffness_n_m_rad / counts - 1.0).abs() < 1e-12);
        let [bed, both] = [&stack, &on_soil].map(|stack| stack.joints()[0].material.normal_stiffness_pa_m);
        assert!((1.0 / both - 1.0 / bed - 1.0 / softest).abs() < 1e-12 / both);
        assert_eq!(on_soil.joints()[1], stack.joints()[1]);
    }

    #[test]
    fn refuses_soil_under_several_blocks() {
        let at = |name: &str, x: f64| Block {
            name: name.into(),
            solid: Solid::cuboid(0.4, 0.4, 1.0).unwrap().placed(&Placement {
                position_m: [x, 0.0, 0.0],
                ..Placement::default()
            }),
            density_kg_m3: 2600.0,
        };
        let stack = Stack::new(vec![at("a", 0.0), at("b", 2.0)], JointMaterial::default(), 9.81).unwrap();
        let why = stack.on_half_space([30e6, 0.35], None).unwrap_err();
        assert_eq!(why, StackError::SoilUnderSeveral { count: 2 });
        let one = tower(&[[0.4, 0.4, 1.0]], JointMaterial::default());
        assert!(one.on_half_space([f64::NAN, 0.35], None).is_err());
    }
}
