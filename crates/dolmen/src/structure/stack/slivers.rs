//! Slivers: contacts narrower than drawings and surveys are accurate, which may not exist.

use super::{Block, Body, Joint, Polygon, Sliver, Stack};
use glam::DVec3;

/// Least rise of the normal of a joint that a stone stands on. Our choice.
const LEVEL: f64 = 0.5;

impl Stack {
    /// The slivers that are left out because both stones stand on wider beds, in the order of the joints.
    pub fn slivers_left_out(&self) -> &[Sliver] {
        &self.slivers_left_out
    }

    /// The slivers that count as joints because a stone does not stand without them, in the order of the joints.
    pub fn slivers_that_carry(&self) -> Vec<Sliver> {
        let joints = self.joints.iter().filter(|joint| joint.is_sliver);
        joints.map(Sliver::of).collect()
    }

    /// The stack without slivers between stones that stand on wider beds.
    ///
    /// No tension crosses a joint, so a stack with fewer joints never resists more.
    pub(super) fn without_slivers(mut self) -> Self {
        if !self.joints.iter().any(|joint| joint.is_sliver) {
            return self;
        }
        let stands: Vec<bool> = self
            .blocks
            .iter()
            .enumerate()
            .map(|(index, block)| stands_on_wider(&self.joints, index, block))
            .collect();
        let is_needed = |joint: &Joint| {
            let lower = match joint.lower {
                Body::Ground => true,
                Body::Block(lower) => stands[lower],
            };
            !(stands[joint.upper] && lower)
        };
        let (kept, left_out) = std::mem::take(&mut self.joints)
            .into_iter()
            .partition(|joint| !joint.is_sliver || is_needed(joint));
        self.joints = kept;
        let left_out: Vec<Joint> = left_out;
        self.slivers_left_out = left_out.iter().map(Sliver::of).collect();
        self
    }
}

/// Whether the centroid of a stone lies above the outline of the beds that it stands on, without slivers.
fn stands_on_wider(joints: &[Joint], index: usize, block: &Block) -> bool {
    let beds = joints
        .iter()
        .filter(|joint| joint.upper == index && !joint.is_sliver && joint.axes[2][2] > LEVEL);
    let corners = beds.flat_map(|bed| {
        let [first, second, _] = bed.axes.map(DVec3::from);
        bed.patch.corners_m.iter().map(move |corner| {
            let at = DVec3::from(bed.origin_m) + first * corner[0] + second * corner[1];
            [at.x, at.y]
        })
    });
    let outline = Polygon::hull(corners.collect());
    let [x, y, _] = block.solid.centroid_m();
    !outline.corners_m.is_empty() && outline.depth_m([x, y]) > 0.0
}

#[cfg(test)]
mod tests {
    use super::super::{JointMaterial, Placement, Solid, StackError};
    use super::*;

    fn stone(name: &str, size: [f64; 3], position_m: [f64; 3]) -> Block {
        let place = Placement {
            position_m,
            ..Placement::default()
        };
        Block {
            name: name.into(),
            solid: Solid::cuboid(size[0], size[1], size[2]).unwrap().placed(&place),
            density_kg_m3: 2500.0,
        }
    }

    fn stack(blocks: Vec<Block>) -> Result<Stack, StackError> {
        Stack::new(blocks, JointMaterial::default(), 9.81)
    }

    /// Two stones and a pier beside them, drawn further in by `in_m`; the pier's upper stone would lie on the wall's lower one.
    fn wall_and_pier(in_m: f64) -> Stack {
        let y = 0.4 - in_m;
        stack(vec![
            stone("low", [0.4, 0.4, 0.3], [0.0; 3]),
            stone("high", [0.4, 0.4, 0.3], [0.0, 0.0, 0.3]),
            stone("pier low", [0.4, 0.4, 0.3], [0.0, y, 0.0]),
            stone("pier high", [0.4, 0.4, 0.3], [0.0, y, 0.3]),
        ])
        .unwrap()
    }

    #[test]
    fn exact_stones_drawn_into_each_other_have_the_joints_of_stones_that_touch() {
        let ends = |stack: &Stack| -> Vec<_> {
            let joints = stack.joints().iter();
            joints.map(|joint| (joint.lower, joint.upper)).collect()
        };
        let touching = wall_and_pier(0.0);
        assert!(touching.slivers_left_out().is_empty());
        for in_m in [1e-6, 1e-5, 1e-3, 4e-3] {
            let stack = wall_and_pier(in_m);
            assert_eq!(ends(&stack), ends(&touching), "{in_m}");
            let left_out = stack.slivers_left_out();
            let widths: Vec<f64> = left_out.iter().map(|sliver| sliver.width_m).collect();
            assert_eq!(widths.len(), 2, "{left_out:?}");
            assert!(widths.iter().all(|width| (width / in_m - 1.0).abs() < 1e-6));
            assert!(stack.slivers_that_carry().is_empty());
        }
    }

    #[test]
    fn holds_a_beam_keeps_the_narrow_beds_that_it_needs() {
        for (bearing, carry) in [(1e-5, 2), (0.004, 2), (0.006, 0)] {
            let x = 1.2 - bearing;
            let beam = stack(vec![
                stone("left", [0.4, 0.4, 2.0], [-x, 0.0, 0.0]),
                stone("right", [0.4, 0.4, 2.0], [x, 0.0, 0.0]),
                stone("beam", [2.0, 0.4, 0.3], [0.0, 0.0, 2.0]),
            ])
            .unwrap();
            assert_eq!(beam.joints().len(), 4);
            assert!(beam.slivers_left_out().is_empty());
            assert_eq!(beam.slivers_that_carry().len(), carry, "{bearing}");
        }
        // one wide bed is not enough for a stone whose centroid lies beside it
        let one = stack(vec![
            stone("left", [0.4, 0.4, 2.0], [-1.0, 0.0, 0.0]),
            stone("right", [0.4, 0.4, 2.0], [1.199, 0.0, 0.0]),
            stone("beam", [2.0, 0.4, 0.3], [0.0, 0.0, 2.0]),
        ])
        .unwrap();
        let carry = one.slivers_that_carry();
        assert_eq!((carry.len(), carry[0].lower), (1, Body::Block(1)));
        // a model of 40 mm stones knows a bed of 3 mm
        let model = stack(vec![
            stone("left", [0.04, 0.04, 0.2], [-0.037, 0.0, 0.0]),
            stone("right", [0.04, 0.04, 0.2], [0.037, 0.0, 0.0]),
            stone("beam", [0.04, 0.04, 0.03], [0.0, 0.0, 0.2]),
        ])
        .unwrap();
        assert!(model.slivers_that_carry().is_empty() && model.slivers_left_out().is_empty());
    }
}
