//! Dimensionless measures of shaking that allow comparing stacks of different shape and size.

use super::AssessError;
use crate::stability::stack::{CutLimits, StackLimitStates, rocking_blocks};
use crate::structure::stack::Stack;

/// Component of a direction towards an edge below which the direction is parallel to the edge. Our choice.
const SHARE_LEAST: f64 = 1e-6;

/// The part of a stack that lifts first, as one rocking block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RockingScale {
    /// Acceleration at which it lifts, over g, –: tan α.
    pub tan_slenderness: f64,
    /// Frequency parameter p, rad/s.
    pub frequency_parameter_rad_s: f64,
}

impl RockingScale {
    /// Peak ground acceleration over the acceleration that lifts the block, –.
    ///
    /// ```text
    /// PGA / (g tan α)
    /// ```
    pub fn uplift_ratio(&self, peak_acceleration_m_s2: f64, gravity_m_s2: f64) -> f64 {
        peak_acceleration_m_s2 / (gravity_m_s2 * self.tan_slenderness)
    }

    /// Peak ground velocity over the velocity at which blocks of this shape and size overturn, –.
    ///
    /// ```text
    /// p PGV / (g tan α)
    /// ```
    ///
    /// # Source
    /// Dimitrakopoulos, E. G. and Paraskeva, T. S. (2015) Dimensionless fragility curves for rocking response to near-fault excitations.
    /// Earthq. Eng. Struct. Dyn. 44(12):2015–2033.
    pub fn velocity_ratio(&self, peak_velocity_m_s: f64, gravity_m_s2: f64) -> f64 {
        self.frequency_parameter_rad_s * peak_velocity_m_s / (gravity_m_s2 * self.tan_slenderness)
    }
}

/// The rocking scale of a stack for shaking along a direction in plan, to both sides, or in any direction (`None`). It describes the cut that lifts
/// first, about its edge; `None` if the stack cannot lift.
///
/// ```text
/// tan α = least over the edges of a_edge / (g |d · n|),   d the direction, n the normal of the edge in plan, a_edge the acceleration along n that lifts
/// ```
///
/// # Errors
/// [`AssessError::Stability`] if the limits belong to a different stack.
///
/// # Limits
/// A small stone at the top may lift first; the scale is then valid for this stone only.
pub fn rocking_scale(
    stack: &Stack,
    limits: &StackLimitStates,
    along: Option<[f64; 2]>,
) -> Result<Option<RockingScale>, AssessError> {
    let mut least: Option<(f64, &CutLimits, usize)> = None;
    for cut in limits.cuts.iter().filter(|cut| cut.uplift.is_some()) {
        for (index, edge) in cut.edges.iter().enumerate() {
            let share = along.map_or(1.0, |d| {
                let n = edge.uplift.direction;
                (d[0] * n[0] + d[1] * n[1]).abs() / d[0].hypot(d[1])
            });
            let lifts = edge.uplift.acceleration_g / share;
            if share > SHARE_LEAST && lifts > 0.0 && least.is_none_or(|(before, ..)| lifts < before) {
                least = Some((lifts, cut, index));
            }
        }
    }
    let Some((tan_slenderness, cut, index)) = least else {
        return Ok(None);
    };
    let blocks = rocking_blocks(stack, cut)?;
    let block = blocks.iter().find(|block| block.edge == index);
    Ok(block.map(|block| RockingScale {
        tan_slenderness,
        frequency_parameter_rad_s: block.frequency_parameter_rad_s,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stability::stack::{StackLimits, stack_limits};
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid};

    /// Two blocks: the upper block is more slender, and its p is √(3g/4R) with its own half diagonal.
    #[test]
    fn exact_scale_of_the_block_that_lifts_first() {
        let block = |name: &str, x, z, from_m| Block {
            name: name.into(),
            solid: Solid::cuboid(x, x, z).unwrap().placed(&Placement {
                position_m: [0.0, 0.0, from_m],
                ..Placement::default()
            }),
            density_kg_m3: 2600.0,
        };
        let blocks = vec![block("base", 2.0, 0.5, 0.0), block("post", 0.4, 2.0, 0.5)];
        let stack = Stack::new(blocks, JointMaterial::with_friction(2.0), 9.81).unwrap();
        let limits = stack_limits(&stack, &StackLimits::default()).unwrap();
        let found = rocking_scale(&stack, &limits, None).unwrap().unwrap();
        assert!((found.tan_slenderness - 0.2).abs() < 1e-12, "{found:?}");
        let p = (0.75 * 9.81 / 0.2_f64.hypot(1.0)).sqrt();
        assert!((found.frequency_parameter_rad_s - p).abs() < 1e-12, "{found:?}");
        let skew = rocking_scale(&stack, &limits, Some([1.0, 1.0])).unwrap().unwrap();
        assert!(
            (skew.tan_slenderness - 0.2 * 2.0_f64.sqrt()).abs() < 1e-12,
            "{skew:?}"
        );
        assert!((found.uplift_ratio(0.981, 9.81) - 0.5).abs() < 1e-12);
        assert!((found.velocity_ratio(0.3, 9.81) - 0.3 * p / (9.81 * 0.2)).abs() < 1e-12);
    }

    /// A slab on edge: thin across, wide along.
    #[test]
    fn exact_scale_of_a_slab_is_that_of_the_direction_of_shaking() {
        let slab = Block {
            name: "slab".into(),
            solid: Solid::cuboid(1.0, 0.2, 1.0).unwrap(),
            density_kg_m3: 2600.0,
        };
        let stack = Stack::new(vec![slab], JointMaterial::with_friction(2.0), 9.81).unwrap();
        let limits = stack_limits(&stack, &StackLimits::default()).unwrap();
        let of = |along| rocking_scale(&stack, &limits, along).unwrap().unwrap();
        for (along, tan, half_m) in [
            (None, 0.2, 0.1),
            (Some([0.0, 1.0]), 0.2, 0.1),
            (Some([-1.0, 0.0]), 1.0, 0.5),
        ] {
            let found = of(along);
            assert!((found.tan_slenderness - tan).abs() < 1e-12, "{along:?} {found:?}");
            let p = (0.75 * 9.81 / 0.5_f64.hypot(half_m)).sqrt();
            assert!(
                (found.frequency_parameter_rad_s - p).abs() < 1e-12,
                "{along:?} {found:?}"
            );
        }
    }
}
