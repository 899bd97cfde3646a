//! Overlap of two convex solids, by separating axes.

use super::Solid;
use glam::DVec3;

/// Least distance to separate two convex solids, m; 0 or negative if they do not overlap.
pub(crate) fn overlap_depth(a: &Solid, b: &Solid) -> f64 {
    let mut depth = f64::INFINITY;
    let mut axes: Vec<DVec3> = Vec::new();
    for solid in [a, b] {
        axes.extend((0..solid.faces().len()).map(|face| solid.normal(face)));
    }
    for along in edges(a) {
        for other in edges(b) {
            let across = along.cross(other);
            if across.length() > 1e-6 * along.length() * other.length() {
                axes.push(across.normalize()); // parallel edges give no new axis
            }
        }
    }
    for axis in axes {
        let (low_a, high_a) = extent(a, axis);
        let (low_b, high_b) = extent(b, axis);
        depth = depth.min((high_a - low_b).min(high_b - low_a));
        if depth <= 0.0 {
            break;
        }
    }
    depth
}

fn extent(solid: &Solid, axis: DVec3) -> (f64, f64) {
    let along = solid.vertices_m().iter().map(|v| axis.dot(DVec3::from(*v)));
    along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    })
}

/// Each edge once.
fn edges(solid: &Solid) -> Vec<DVec3> {
    let mut found = Vec::new();
    for face in solid.faces() {
        for (&start, &end) in face.iter().zip(face.iter().cycle().skip(1)) {
            if start < end {
                found.push(DVec3::from(solid.vertices_m()[end]) - DVec3::from(solid.vertices_m()[start]));
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::super::{Block, Body, JointMaterial, Placement, Stack, StackError};
    use super::*;

    fn stone(name: &str, size: [f64; 3], position_m: [f64; 3]) -> Block {
        let place = Placement {
            position_m,
            ..Placement::default()
        };
        Block {
            name: name.into(),
            solid: Solid::cuboid(size[0], size[1], size[2]).unwrap().placed(&place),
            density_kg_m3: 2600.0,
        }
    }

    #[test]
    fn refuses_stones_that_share_space_or_float() {
        let make = |z: f64| {
            let blocks = vec![
                stone("low", [1.0, 1.0, 0.5], [0.0; 3]),
                stone("high", [1.0, 1.0, 0.5], [0.1, 0.0, z]),
            ];
            Stack::new(blocks, JointMaterial::default(), 9.81)
        };
        assert_eq!(make(0.5).unwrap().joints().len(), 2);
        let fault = make(0.42).unwrap_err().to_string();
        assert!(
            fault.starts_with("'high' and 'low' overlap by 0.0800 m"),
            "{fault}"
        );
        let fault = make(0.6).unwrap_err().to_string();
        assert!(
            fault.starts_with("'high' floats: it is 0.0000 m along x, 0.0000 m along y and 0.1000 m along z off the top of low, and 0.6000 m above"),
            "{fault}"
        );
    }

    #[test]
    fn refuses_a_stone_that_stands_on_its_edge_and_names_the_wedge() {
        let angle = 1.0_f64.to_radians();
        let mut high = stone("high", [1.0, 1.0, 0.5], [0.0; 3]);
        high.solid = Solid::cuboid(1.0, 1.0, 0.5).unwrap().placed(&Placement {
            tilt: [angle.tan(), 0.0],
            position_m: [0.0, 0.0, 0.5 + 0.5 * angle.sin()],
            ..Placement::default()
        });
        let blocks = vec![stone("low", [1.2, 1.2, 0.5], [0.0; 3]), high];
        let fault = Stack::new(blocks, JointMaterial::default(), 9.81).unwrap_err();
        let StackError::BedsNotParallel {
            lower,
            angle_deg,
            far_m,
            ..
        } = &fault
        else {
            panic!("{fault}");
        };
        assert_eq!(lower, "low");
        assert!(
            (angle_deg - 1.0).abs() < 1e-6 && (far_m - angle.sin()).abs() < 1e-9,
            "{fault}"
        );
    }

    #[test]
    fn exact_patch_of_an_offset_and_turned_stone() {
        let mut high = stone("high", [1.0, 1.0, 0.5], [0.25, 0.0, 0.5]);
        let blocks = vec![stone("low", [1.0, 1.0, 0.5], [0.0; 3]), high.clone()];
        let stack = Stack::new(blocks, JointMaterial::default(), 9.81).unwrap();
        let joint = &stack.joints()[1];
        assert_eq!((joint.lower, joint.upper), (Body::Block(0), 1));
        assert!((joint.patch.moments().area_m2 - 0.75).abs() < 1e-12);
        assert!((joint.origin_m[0] - 0.125).abs() < 1e-12 && (joint.origin_m[2] - 0.5).abs() < 1e-12);
        // rotated by 45°: the intersection of two unit squares is the regular octagon of area 2 (√2 − 1)
        high.solid = Solid::cuboid(1.0, 1.0, 0.5).unwrap().placed(&Placement {
            yaw_rad: std::f64::consts::FRAC_PI_4,
            position_m: [0.0, 0.0, 0.5],
            ..Placement::default()
        });
        let blocks = vec![stone("low", [1.0, 1.0, 0.5], [0.0; 3]), high];
        let stack = Stack::new(blocks, JointMaterial::default(), 9.81).unwrap();
        let area = stack.joints()[1].patch.moments().area_m2;
        assert!((area - 2.0 * (2.0_f64.sqrt() - 1.0)).abs() < 1e-12);
        assert_eq!(stack.joints()[1].patch.corners_m.len(), 8);
    }

    #[test]
    fn holds_stones_side_by_side_share_an_upright_joint() {
        let blocks = vec![
            stone("left", [1.0, 1.0, 0.5], [0.0; 3]),
            stone("right", [1.0, 1.0, 0.5], [1.0, 0.0, 0.0]),
        ];
        let stack = Stack::new(blocks, JointMaterial::default(), 9.81).unwrap();
        let between: Vec<_> = stack
            .joints()
            .iter()
            .filter(|j| j.lower != Body::Ground)
            .collect();
        assert_eq!(between.len(), 1);
        assert!((between[0].axes[2][0] - 1.0).abs() < 1e-12);
    }
}
