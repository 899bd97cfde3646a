//! Natural frequencies of a stack as functions of factors on the springs of its joints.

use super::super::contact_points::ContactRule;
use super::error::JointFactorsError;
use super::families::{Family, families};
use super::stack_motion::StackMotion;
use super::unknowns::unknowns;
use crate::structure::stack::Stack;
use std::f64::consts::TAU;

/// A stack at rest whose joint stiffnesses can be reduced by factors.
pub struct LooseningStack {
    families: Vec<Family>,
    groups: Vec<Vec<usize>>,
}

impl LooseningStack {
    /// Prepares a stack as drawn: one factor per joint, or one per bed if more than `joints_most` joints have springs.
    ///
    /// ```text
    /// K(c) = K_o + Σ c_g K_g        o: dowels, clamps and side supports
    /// ```
    ///
    /// # Errors
    /// [`JointFactorsError`] for a stack without a rest position, or a decomposition that fails.
    ///
    /// # Limits
    /// Small motion about the rest position as drawn: closed joints stay closed, and K_s/K_n does not change.
    ///
    /// # Example
    /// ```
    /// use dolmen::blocks::{ContactRule, LooseningStack, StackMotion};
    /// use dolmen::structure::stack::JointMaterial;
    /// let stack = dolmen::comparisons::p10(JointMaterial::default(), 9.81)?;
    /// let loosening = LooseningStack::new(&stack, ContactRule::Four, 24)?;
    /// let first = |factor: f64| -> Option<f64> {
    ///     let factors = vec![factor; loosening.joints().len()];
    ///     loosening.frequencies_hz(StackMotion::X, &factors)?.first().copied()
    /// };
    /// // every frequency is proportional to the square root of a common factor
    /// assert!((first(1.0).unwrap() - 4.7043).abs() < 1e-3);
    /// assert!((first(0.25).unwrap() - 0.5 * 4.7043).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(stack: &Stack, rule: ContactRule, joints_most: usize) -> Result<Self, JointFactorsError> {
        let unknowns = unknowns(stack, rule, joints_most)?;
        Ok(LooseningStack {
            families: families(&unknowns)?,
            groups: unknowns.groups.into_iter().map(|group| group.joints).collect(),
        })
    }

    /// Indices of the joints that each factor multiplies.
    pub fn joints(&self) -> &[Vec<usize>] {
        &self.groups
    }

    /// Frequencies of the modes in which `motion` predominates, Hz, ascending, for one factor per entry of [`Self::joints`]; `None` if a
    /// decomposition fails.
    pub fn frequencies_hz(&self, motion: StackMotion, factors: &[f64]) -> Option<Vec<f64>> {
        let mut all = Vec::new();
        for family in &self.families {
            let modes = family.modes(factors).ok()?;
            let own = family.orders_of(&modes, motion).into_iter();
            all.extend(own.map(|order| modes.values[order].max(0.0).sqrt() / TAU));
        }
        all.sort_by(f64::total_cmp);
        Some(all)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::{StackMode, stack_modes};
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid};

    /// A pile of stones; the upper ones have an eccentricity of `off_m`. Gravity is a thousandth of its value, so that the larger settlement on
    /// softer springs, which moves the beds, does not affect the comparison.
    fn tower(off_m: f64) -> Stack {
        let sizes = [[1.2, 1.0, 0.6], [0.9, 0.8, 0.9], [1.1, 0.9, 0.3], [0.6, 0.5, 0.8]];
        let mut z = 0.0;
        let blocks = sizes.iter().enumerate().map(|(i, [width, depth, height])| {
            let off = if i > 1 { off_m } else { 0.0 };
            let place = Placement {
                position_m: [off, -0.5 * off, z],
                ..Placement::default()
            };
            z += height;
            Block {
                name: format!("stone {i}"),
                solid: Solid::cuboid(*width, *depth, *height).unwrap().placed(&place),
                density_kg_m3: 2600.0,
            }
        });
        Stack::new(blocks.collect(), JointMaterial::default(), 9.81e-3).unwrap()
    }

    /// Whether most of the energy is motion along x of the centroids and rocking. In a symmetric tower, motion along x alone is not sufficient.
    fn sways_along_x(mode: &StackMode) -> bool {
        mode.kinetic_energy_ratio[0] > 1e-6
    }

    #[test]
    fn agrees_loosened_joints_with_a_stack_of_softer_joints() {
        let stack = tower(0.0);
        let loosening = LooseningStack::new(&stack, ContactRule::Four, 24).unwrap();
        for (joint, factor) in [(0, 0.4), (2, 0.7), (3, 0.1)] {
            let mut softer = stack.joints()[joint].material;
            softer.normal_stiffness_pa_m *= factor;
            softer.shear_stiffness_pa_m *= factor;
            let softer = stack.clone().with_material(joint, softer).unwrap();
            let anew = stack_modes(&softer, ContactRule::Four).unwrap();
            let anew = anew
                .iter()
                .filter(|mode| sways_along_x(mode))
                .map(|mode| mode.frequency_hz);
            let factors: Vec<f64> = loosening
                .joints()
                .iter()
                .map(|of| if of.contains(&joint) { factor } else { 1.0 })
                .collect();
            let found = loosening.frequencies_hz(StackMotion::X, &factors).unwrap();
            assert_eq!(found.len(), 8);
            for (found, anew) in found.iter().zip(anew) {
                assert!((found / anew - 1.0).abs() < 1e-6, "{joint}: {found} {anew}");
            }
        }
    }

    #[test]
    fn holds_a_softer_joint_raises_no_frequency_where_motions_couple() {
        let loosening = LooseningStack::new(&tower(0.05), ContactRule::Four, 24).unwrap();
        let first = |motion, factors: &[f64]| loosening.frequencies_hz(motion, factors).unwrap()[0];
        let whole = vec![1.0; loosening.joints().len()];
        for motion in [StackMotion::X, StackMotion::Y, StackMotion::Torsion] {
            for at in 0..whole.len() {
                let mut soft = whole.clone();
                soft[at] = 0.5;
                assert!(first(motion, &soft) < first(motion, &whole), "{motion:?} {at}");
            }
        }
    }
}
