//! Stacks whose beds are a little off: edges moved inwards, beds inclined.

use super::{Polygon, Stack};
use glam::{DQuat, DVec3};

impl Stack {
    /// The joints whose bed a mesh shows by its corners alone, ascending.
    pub fn joints_of_only_corners(&self) -> Vec<usize> {
        let joints = self.joints().iter().enumerate();
        joints
            .filter(|(_, joint)| joint.only_corners)
            .map(|(joint, _)| joint)
            .collect()
    }

    /// The stack with the edges of some joints moved inwards. `None` if that leaves nothing of a joint.
    pub(crate) fn with_edges_inside(&self, joints: &[usize], by_m: f64) -> Option<Stack> {
        let mut other = self.clone();
        for &joint in joints {
            let patch = &mut other.joints[joint].patch;
            *patch = patch.inset(by_m);
            if patch.corners_m.is_empty() {
                return None;
            }
        }
        Some(other)
    }

    /// The stack with some beds inclined: along `direction` (a unit vector in plan), the far end of each is lower by `by_m` and the near end higher.
    pub(crate) fn with_beds_inclined(&self, joints: &[usize], direction: [f64; 2], by_m: f64) -> Stack {
        let mut other = self.clone();
        for &number in joints {
            let joint = &mut other.joints[number];
            let [first, second, normal] = joint.axes.map(DVec3::from);
            let down = DVec3::new(direction[0], direction[1], 0.0);
            let Some(along) = (down - normal * normal.dot(down)).try_normalize() else {
                continue; // an upright joint along the direction
            };
            let at = [along.dot(first), along.dot(second)];
            let middle = joint.patch.moments().centroid_m;
            let length_m =
                joint.patch.reach_m(middle, at) + joint.patch.reach_m(middle, at.map(|part| -part));
            let turn = DQuat::from_axis_angle(normal.cross(along), 2.0 * by_m / length_m);
            joint.axes = [first, second, normal].map(|axis| (turn * axis).into());
        }
        other
    }
}

impl Polygon {
    /// The polygon with every edge moved inwards; empty if nothing is left.
    fn inset(&self, by_m: f64) -> Polygon {
        let edges = self.corners_m.iter().zip(self.corners_m.iter().cycle().skip(1));
        let mut left = self.clone();
        for (start, end) in edges {
            let along = [end[0] - start[0], end[1] - start[1]];
            let length_m = along[0].hypot(along[1]);
            let inwards = [-along[1] * by_m / length_m, along[0] * by_m / length_m];
            let moved = |at: &[f64; 2]| [at[0] + inwards[0], at[1] + inwards[1]];
            left = left.left_of(moved(start), moved(end));
        }
        left
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Block, JointMaterial, Placement, Solid};
    use super::*;

    /// A box as a mesh: each side n × n squares.
    fn boxed(size: [f64; 3], n: usize) -> Solid {
        let mut numbers = std::collections::BTreeMap::new();
        let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
        for (axis, end) in (0..3).flat_map(|axis| [(axis, 0), (axis, n)]) {
            for (i, j) in (0..n * n).map(|k| (k / n, k % n)) {
                let mut corner = |a: usize, b: usize| {
                    let mut key = [0; 3];
                    (key[axis], key[(axis + 1) % 3], key[(axis + 2) % 3]) = (end, a, b);
                    *numbers.entry(key).or_insert_with(|| {
                        let part = |k: usize| size[k] * (key[k] as f64 / n as f64);
                        vertices.push([part(0) - 0.5 * size[0], part(1) - 0.5 * size[1], part(2)]);
                        vertices.len() - 1
                    })
                };
                let [a, b, c, d] =
                    [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(a, b)| corner(a, b));
                let two = [[a, b, c], [a, c, d]];
                triangles.extend(two.map(|t| if end == 0 { [t[0], t[2], t[1]] } else { t }));
            }
        }
        Solid::mesh(&vertices, &triangles).unwrap()
    }

    fn stack(solids: Vec<Solid>) -> Stack {
        let mut z = 0.0;
        let blocks = solids.into_iter().enumerate().map(|(number, solid)| {
            let place = Placement {
                position_m: [0.0, 0.0, z],
                ..Placement::default()
            };
            z += solid.bounds_m()[1][2];
            Block {
                name: format!("stone {number}"),
                solid: solid.placed(&place),
                density_kg_m3: 2600.0,
            }
        });
        Stack::new(blocks.collect(), JointMaterial::default(), 9.81).unwrap()
    }

    #[test]
    fn holds_only_the_mesh_whose_corners_bound_a_joint_counts() {
        let (coarse, fine) = (|b: f64| boxed([b, b, 0.5], 1), |b: f64| boxed([b, b, 0.5], 4));
        let drawn = |b: f64| Solid::cuboid(b, b, 0.5).unwrap();
        let found = |solids: Vec<Solid>| stack(solids).joints_of_only_corners();
        assert_eq!(found(vec![coarse(0.8), coarse(0.6)]), [0, 1]);
        assert_eq!(found(vec![fine(0.8), fine(0.6)]), [] as [usize; 0]);
        assert_eq!(found(vec![drawn(0.8), drawn(0.6)]), [] as [usize; 0]);
        // a fine stone on a wider coarse one: the fine one bounds their joint
        assert_eq!(found(vec![coarse(0.8), fine(0.6)]), [0]);
        assert_eq!(found(vec![fine(0.6), coarse(0.8)]), [] as [usize; 0]);
        assert_eq!(found(vec![fine(0.8), coarse(0.6)]), [1]);
    }

    #[test]
    fn exact_edges_move_in_and_beds_incline() {
        let whole = stack(vec![Solid::frustum([0.6, 0.4], [0.6, 0.4], 1.0).unwrap()]);
        let inside = whole.with_edges_inside(&[0], 0.01).unwrap();
        let area_m2 = inside.joints()[0].patch.moments().area_m2;
        assert!((area_m2 - 0.58 * 0.38).abs() < 1e-12);
        assert!(whole.with_edges_inside(&[0], 0.21).is_none());
        let inclined = whole.with_beds_inclined(&[0], [0.0, 1.0], 0.01);
        let normal = inclined.joints()[0].axes[2];
        assert!((normal[1] - (0.02_f64 / 0.4).sin()).abs() < 1e-12 && normal[0].abs() < 1e-15);
    }
}
