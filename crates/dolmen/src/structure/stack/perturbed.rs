//! Varies a stack by small differences that no survey could detect.

use super::{Joint, JointMaterial, Stack, StackError};
use crate::numeric::Random;
use glam::{DMat3, DVec3};

/// Least vertical component of a joint's normal for a bed. Stones between steeper joints must fit each other, so their sizes
/// do not vary.
const BED_RISE_LEAST: f64 = 0.9;

/// Accuracy of the inputs of a stack. Each input varies uniformly about its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SmallDifferences {
    /// Relative standard deviation of the friction of each joint. Default 0.02.
    pub friction_share: f64,
    /// Standard deviation of the edges of each bed, m; used only if all joints are beds. Default 1 mm.
    pub bed_edge_m: f64,
    /// Relative standard deviation of the strength of a motion. Default 0.005.
    pub motion_share: f64,
}

impl Default for SmallDifferences {
    fn default() -> Self {
        SmallDifferences {
            friction_share: 0.02,
            bed_edge_m: 1e-3,
            motion_share: 0.005,
        }
    }
}

impl SmallDifferences {
    /// A uniform value from −1 to 1.
    fn side(random: &mut Random) -> f64 {
        2.0 * random.uniform() - 1.0
    }

    /// A random factor on a motion.
    pub fn motion_factor(&self, random: &mut Random) -> f64 {
        1.0 + self.motion_share * Self::side(random)
    }

    /// The stack with varied friction and, if all joints are beds, slightly wider or narrower stones.
    ///
    /// # Errors
    /// [`StackError`] if the varied stones do not form a stack.
    pub fn applied_to(&self, stack: &Stack, random: &mut Random) -> Result<Stack, StackError> {
        let mut other = match self.moves_edges(stack) {
            true => stack.widened(|| [0, 1].map(|_| self.bed_edge_m * Self::side(random)))?,
            false => stack.clone(),
        };
        for joint in 0..other.joints().len() {
            let factor = 1.0 + self.friction_share * Self::side(random);
            let material = other.joints()[joint].material;
            other = other.with_material(
                joint,
                JointMaterial {
                    friction_static: factor * material.friction_static,
                    friction_kinetic: factor * material.friction_kinetic,
                    ..material
                },
            )?;
        }
        Ok(other)
    }

    /// Whether the edges of beds vary too: not if stones must fit between others, or if they are scans.
    pub fn moves_edges(&self, stack: &Stack) -> bool {
        let beds = stack
            .joints()
            .iter()
            .all(|joint| joint.axes[2][2] > BED_RISE_LEAST);
        let scanned = stack.blocks().iter().any(|block| block.solid.scan().is_some());
        self.bed_edge_m > 0.0 && beds && !scanned
    }
}

impl Stack {
    /// The stack with each stone widened in plan along x and y by the amounts from `farther_m`, m.
    fn widened(&self, mut farther_m: impl FnMut() -> [f64; 2]) -> Result<Stack, StackError> {
        let mut blocks = self.blocks().to_vec();
        for block in &mut blocks {
            let [low, high] = block.solid.bounds_m();
            let farther = farther_m();
            let part = |axis: usize| 1.0 + 2.0 * farther[axis] / (high[axis] - low[axis]);
            let stretch = DMat3::from_diagonal(DVec3::new(part(0), part(1), 1.0));
            let middle = 0.5 * (DVec3::from(low) + DVec3::from(high));
            block.solid = block.solid.stretched(stretch, middle);
        }
        let usual = JointMaterial::default();
        let mut other = Stack::new(blocks, usual, self.gravity_m_s2())?;
        // open gaps stay open
        other.joints.retain(|joint| {
            let is_own = |own: &Joint| own.lower == joint.lower && own.upper == joint.upper;
            !joint.is_drawn_open() || self.joints().iter().any(is_own)
        });
        for index in 0..other.joints().len() {
            let joint = &other.joints()[index];
            let (lower, upper) = (joint.lower, joint.upper);
            let mut own = self.joints().iter();
            if let Some(own) = own.find(|own| own.lower == lower && own.upper == upper) {
                other = other.with_material(index, own.material)?;
            }
        }
        other.soil = self.soil;
        for tie in self.ties() {
            other = other.with_tie(*tie)?;
        }
        for support in self.side_supports() {
            other = other.with_side_support(*support)?;
        }
        for load in self.static_loads() {
            other = other.with_static_load(*load)?;
        }
        Ok(other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::comparisons::p10;

    #[test]
    fn holds_small_differences_are_small_and_those_of_their_seed() {
        let stack = p10(JointMaterial::default(), 9.81).unwrap();
        let spread = SmallDifferences::default();
        let drawn = |stream: u64| spread.applied_to(&stack, &mut Random::new(1, stream)).unwrap();
        assert_eq!(drawn(3), drawn(3));
        assert_ne!(drawn(3), drawn(4));
        for (own, other) in stack.blocks().iter().zip(drawn(3).blocks()) {
            let ([low, high], [other_low, other_high]) = (own.solid.bounds_m(), other.solid.bounds_m());
            for axis in 0..3 {
                let moved = (other_high[axis] - high[axis]).abs();
                assert!(
                    moved <= 1e-3 + 1e-12 && (moved > 0.0) == (axis < 2),
                    "{axis}: {moved}"
                );
                assert!((other_low[axis] + other_high[axis] - low[axis] - high[axis]).abs() < 1e-12);
            }
            // still a box: m (b² + c²)/12
            let [a, b, c] = [0, 1, 2].map(|axis| other_high[axis] - other_low[axis]);
            let volume = other.solid.volume_m3();
            assert!((volume / (a * b * c) - 1.0).abs() < 1e-12);
            let inertia = other.solid.inertia_m5();
            let exact = volume * (b * b + c * c) / 12.0;
            assert!((inertia[0][0] / exact - 1.0).abs() < 1e-12, "{}", inertia[0][0]);
        }
        for joint in drawn(3).joints() {
            let share = joint.material.friction_static / 0.6 - 1.0;
            assert!(share.abs() <= 0.02 && share != 0.0, "{share}");
        }
    }
}
