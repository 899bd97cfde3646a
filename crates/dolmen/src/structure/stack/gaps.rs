//! Joints drawn with a gap, closed or left open.

use super::{Block, Body, Joint, Solid, Stack};
use glam::DVec3;

/// Largest gap that is only the roughness of dressed stone, m. Our choice.
pub const GAP_CLOSED_M: f64 = 0.001;
/// The same for scans, in standard deviations of their noise: the scatter of both beds of a joint. Our choice.
const GAP_NOISE: f64 = 3.0;

/// The widest gap of the joints drawn with a gap.
#[derive(Clone, Debug, PartialEq)]
pub struct WidestGap {
    /// Name of the body below the gap, "ground" for the ground.
    pub lower: String,
    /// Name of the block above the gap.
    pub upper: String,
    /// Width of the gap, m.
    pub gap_m: f64,
    /// Number of joints with a gap.
    pub joints: usize,
}

impl Joint {
    /// Whether the faces are drawn apart by more than their roughness, so that it is unknown whether the joint is closed.
    pub fn is_drawn_open(&self) -> bool {
        let roughness_m = self.scanned.map_or(0.0, |scanned| scanned.roughness_m);
        self.gap_m > GAP_CLOSED_M.max(GAP_NOISE * roughness_m)
    }
}

impl Stack {
    /// The joints drawn with a gap but taken as closed, ascending.
    pub fn joints_drawn_open(&self) -> Vec<usize> {
        let all = 0..self.joints().len();
        all.filter(|&joint| self.joints()[joint].is_drawn_open())
            .collect()
    }

    /// The widest gap; `None` if no joint is drawn with one.
    pub fn widest_gap(&self) -> Option<WidestGap> {
        let drawn_open = self.joints_drawn_open();
        let joints = drawn_open.iter().map(|&joint| &self.joints()[joint]);
        let widest = joints.max_by(|a, b| a.gap_m.total_cmp(&b.gap_m))?;
        Some(WidestGap {
            lower: self.name(widest.lower).to_owned(),
            upper: self.name(Body::Block(widest.upper)).to_owned(),
            gap_m: widest.gap_m,
            joints: drawn_open.len(),
        })
    }

    /// The stack without the joints drawn with a gap, except for joints without which a stone would have no support. The
    /// widest gap is opened first. `None` if no joint can be left out.
    pub fn with_gaps_open(&self) -> Option<Stack> {
        let mut open = self.clone();
        let mut by_width = self.joints_drawn_open();
        by_width.sort_by(|&a, &b| self.joints()[b].gap_m.total_cmp(&self.joints()[a].gap_m));
        let mut left_out: Vec<usize> = Vec::new();
        for joint in by_width {
            let without = self.without_joints(&[left_out.as_slice(), &[joint]].concat());
            if without.check_carried().is_ok() {
                left_out.push(joint);
                open = without;
            }
        }
        (!left_out.is_empty()).then_some(open)
    }

    /// The stack without joints across a gap that a third block fills, such as a sheet of lead in a bed.
    pub(super) fn without_joints_through_blocks(mut self) -> Self {
        let blocks = &self.blocks;
        self.joints.retain(|joint| {
            // the origin may be on either face
            let half = DVec3::from(joint.axes[2]) * (0.5 * joint.gap_m);
            let middles = [half, -half].map(|half| DVec3::from(joint.origin_m) + half);
            let fills = |(block, of): (usize, &Block)| {
                let is_third = block != joint.upper && Body::Block(block) != joint.lower;
                is_third && middles.iter().any(|middle| holds(&of.solid, *middle))
            };
            joint.gap_m <= GAP_CLOSED_M || !blocks.iter().enumerate().any(fills)
        });
        self
    }

    /// The stack without some of its joints.
    pub(crate) fn without_joints(&self, left_out: &[usize]) -> Stack {
        let mut without = self.clone();
        let kept = self.joints().iter().enumerate();
        without.joints = kept
            .filter(|(joint, _)| !left_out.contains(joint))
            .map(|(_, joint)| joint.clone())
            .collect();
        without
    }
}

/// Whether a point is inside the hull of a solid.
fn holds(solid: &Solid, point: DVec3) -> bool {
    (0..solid.faces().len()).all(|face| {
        let on = DVec3::from(solid.vertices_m()[solid.faces()[face][0]]);
        solid.normal(face).dot(point - on) <= 0.0
    })
}

#[cfg(test)]
mod tests {
    use super::super::{JointMaterial, Placement};
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

    #[test]
    fn holds_a_gap_opens_unless_a_stone_would_float() {
        // two leaves 4 mm apart, and a stone 4 mm above the first leaf
        let blocks = vec![
            stone("one", [0.2, 3.0, 3.0], [0.0; 3]),
            stone("other", [0.2, 3.0, 3.0], [0.204, 0.0, 0.0]),
            stone("above", [0.2, 3.0, 0.5], [0.0, 0.0, 3.004]),
        ];
        let stack = Stack::new(blocks, JointMaterial::default(), 9.81).unwrap();
        assert_eq!((stack.joints().len(), stack.joints_drawn_open().len()), (4, 2));
        let widest = stack.widest_gap().unwrap();
        assert!((widest.gap_m - 0.004).abs() < 1e-12 && widest.joints == 2);
        let open = stack.with_gaps_open().unwrap();
        let ends: Vec<_> = open
            .joints()
            .iter()
            .map(|joint| (joint.lower, joint.upper))
            .collect();
        assert_eq!(ends, [(Body::Ground, 0), (Body::Ground, 1), (Body::Block(0), 2)]);
        // a sheet of 4 mm between the first leaf and the block above: no joint passes through the sheet
        let sheet = vec![
            stone("one", [0.2, 3.0, 3.0], [0.0; 3]),
            stone("sheet", [0.2, 3.0, 0.004], [0.0, 0.0, 3.0]),
            stone("above", [0.2, 3.0, 0.5], [0.0, 0.0, 3.004]),
        ];
        let sheet = Stack::new(sheet, JointMaterial::default(), 9.81).unwrap();
        let ends: Vec<_> = sheet
            .joints()
            .iter()
            .map(|joint| (joint.lower, joint.upper))
            .collect();
        assert_eq!(
            ends,
            [(Body::Ground, 0), (Body::Block(0), 1), (Body::Block(1), 2)]
        );
        let near = vec![
            stone("one", [0.2, 3.0, 3.0], [0.0; 3]),
            stone("other", [0.2, 3.0, 3.0], [0.2009, 0.0, 0.0]),
        ];
        let near = Stack::new(near, JointMaterial::default(), 9.81).unwrap();
        assert!(near.joints_drawn_open().is_empty() && near.with_gaps_open().is_none());
    }
}
