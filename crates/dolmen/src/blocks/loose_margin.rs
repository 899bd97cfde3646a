//! How far loose stones at rest are from motion: a limit analysis of their contacts as they lie.

use super::assembly::Assembly;
use super::contact_points::ContactRule;
use super::patch::{LANES, Patch};
use crate::stability::stack::{LimitAnalysis, LimitAnalysisStatus, limit_analysis};
use crate::structure::stack::{Body, Joint, JointMaterial, Polygon, Stack};

/// Largest gap of a point in contact at rest, m. Our choice: positions of rest are more accurate, and the faces of stones are not.
const TOUCHES_M: f64 = 1e-5;

/// Horizontal acceleration, over gravity, up to which forces in the contacts of loose stones at rest balance their weight in every direction: 0 for a
/// stone balanced on a point or an edge, infinite if stones are wedged. `None` if the limit analysis fails, or stones have joints.
///
/// # Limits
/// As for [`limit_analysis`]: friction is associated. The contacts are those at rest, points within 10 µm.
pub(super) fn margin_at_rest_g(at_rest: &Stack) -> Option<f64> {
    let material = at_rest.loose_material()?;
    let mut assembly = Assembly::of(at_rest, ContactRule::Four);
    assembly.look();
    let joints = assembly
        .patches()
        .filter_map(|patch| contact(&assembly, patch, material));
    let lying = at_rest.with_contacts(joints.collect());
    let found = limit_analysis(&lying, &LimitAnalysis::default()).ok()?;
    Some(match found.status {
        LimitAnalysisStatus::DoesNotStand => 0.0,
        LimitAnalysisStatus::Unlimited => f64::INFINITY,
        LimitAnalysisStatus::Limited(_) => found.at_least_g,
    })
}

/// The points of a patch that touch, as a joint; `None` if there are none.
fn contact(assembly: &Assembly, patch: &Patch, material: &JointMaterial) -> Option<Joint> {
    let motion = patch.motion(&assembly.bodies);
    let mut corners_m = Vec::new();
    for group in &patch.points {
        for lane in 0..LANES {
            let at = patch.place(group, lane, &motion);
            if group.area[lane] > 0.0 && at.z <= TOUCHES_M {
                corners_m.push([at.x, at.y]);
            }
        }
    }
    let hull = Polygon::hull(corners_m.clone());
    // an edge or a corner has no area
    if !hull.corners_m.is_empty() {
        corners_m = hull.corners_m;
    }
    let (p, s) = (patch.plane_body, patch.point_body);
    let [first, second, normal] = [
        motion.to_ground.x_axis,
        motion.to_ground.y_axis,
        motion.to_ground.z_axis,
    ];
    let turned = s == 0 || (p != 0 && normal.z < 0.0);
    let (lower, upper, axes) = match turned {
        true => (s, p, [first, -second, -normal]),
        false => (p, s, [first, second, normal]),
    };
    if turned {
        corners_m = corners_m.iter().rev().map(|[x, y]| [*x, -y]).collect();
    }
    (!corners_m.is_empty()).then(|| Joint {
        lower: lower.checked_sub(1).map_or(Body::Ground, Body::Block),
        upper: upper - 1,
        origin_m: motion.origin.into(),
        axes: axes.map(<[f64; 3]>::from),
        patch: Polygon { corners_m },
        material: *material,
        gap_m: 0.0,
        scanned: None,
        is_sliver: false,
        only_corners: false,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::stack::{Block, Placement, Solid};
    use glam::{DQuat, DVec3};

    fn heap(solids: Vec<Solid>) -> Stack {
        let blocks = solids.into_iter().enumerate().map(|(i, solid)| Block {
            name: format!("stone {i}"),
            solid,
            density_kg_m3: 2600.0,
        });
        Stack::loose(blocks.collect(), JointMaterial::default(), 9.81).unwrap()
    }

    fn at(solid: &Solid, position_m: [f64; 3]) -> Solid {
        solid.placed(&Placement {
            position_m,
            ..Placement::default()
        })
    }

    /// A cube of 0.6 m with this direction of it downwards.
    fn cube_on(down: DVec3) -> Solid {
        let turn = DQuat::from_rotation_arc(down.normalize(), -DVec3::Z);
        let half = |bit: usize| if bit == 0 { -0.3 } else { 0.3 };
        let turned: Vec<DVec3> = (0..8)
            .map(|k| turn * DVec3::new(half(k & 1), half(k & 2), half(k & 4)))
            .collect();
        let low = turned.iter().map(|corner| corner.z).fold(f64::INFINITY, f64::min);
        let points: Vec<[f64; 3]> = turned
            .iter()
            .map(|corner| (*corner - DVec3::Z * low).into())
            .collect();
        Solid::convex(&points).unwrap()
    }

    #[test]
    fn exact_stones_that_lie_tip_at_their_slenderness() {
        let slab = Solid::cuboid(0.4, 0.4, 2.0).unwrap();
        let margin = margin_at_rest_g(&heap(vec![slab])).unwrap();
        assert!((margin - 0.2).abs() < 1e-7, "{margin}");
        // 1 mm from the edge of the stone below, 0.15 m up
        let box_ = Solid::cuboid(0.5, 0.5, 0.3).unwrap();
        let margin = margin_at_rest_g(&heap(vec![box_.clone(), at(&box_, [0.249, 0.0, 0.3])])).unwrap();
        assert!((margin - 0.001 / 0.15).abs() < 1e-6, "{margin}");
    }

    #[test]
    fn exact_a_cube_on_its_edge_or_corner_is_only_balanced() {
        for down in [DVec3::new(1.0, 0.0, -1.0), DVec3::new(1.0, 1.0, -1.0)] {
            let margin = margin_at_rest_g(&heap(vec![cube_on(down)])).unwrap();
            assert!(margin < 1e-4, "{down}: {margin}");
        }
        let margin = margin_at_rest_g(&heap(vec![cube_on(-DVec3::Z)])).unwrap();
        // where it slides the region is round, and the lower bound up to 2 % too low
        assert!((0.588..0.6 + 1e-6).contains(&margin), "friction: {margin}");
    }
}
