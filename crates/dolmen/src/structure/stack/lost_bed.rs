//! Beds that lost a part on one side, crushed, spalled or washed out.

use super::{Block, JointMaterial, Solid, Stack, StackError};
use glam::DVec3;

/// Inclination of the foot of the stone outside the remaining bed, 30°. Our choice: far steeper than the tolerance for parallel beds (5°), and a
/// stone that rotates so far has fallen.
const RISE_RAD: f64 = std::f64::consts::FRAC_PI_6;
/// Least vertical component of the normal of a bed: 45°. Our choice; a steeper face is a side.
const UPRIGHT_LEAST: f64 = 0.7;
/// Gravity, used only to find the joints; it has no effect on the result.
const GRAVITY_M_S2: f64 = 9.806_65;

/// Lost part of the bed below a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LostBed {
    /// Index of the block above the bed.
    pub block: usize,
    /// Share of the bed's width that is lost, above 0 and below 1.
    pub share: f64,
    /// Side of the lost part: x and y.
    pub outward: [f64; 2],
}

/// The blocks, of which one has lost the outer part of its bed.
///
/// The foot of the block ends at a line across the bed and rises at 30° outside it, so that the block tips about this line. Weight, centroid and
/// inertia of the block do not change, because the lost part may still be there.
///
/// ```text
/// pivot of a bed of width b towards the lost side:   b/2 − s b from the middle
/// ```
///
/// # Errors
/// [`StackError::Dimension`] for a share out of its range, [`StackError::Direction`] for no side, [`StackError::NoBlock`], [`StackError::NoJoint`] if
/// there is no flat bed below the block, and the errors of [`Stack::new`].
///
/// # Limits
/// For a bed on several stones the share refers to the whole width. The stiffness per area does not change: the remaining bed is taken as sound.
pub fn without_bed(mut blocks: Vec<Block>, lost: &LostBed) -> Result<Vec<Block>, StackError> {
    if !(lost.share > 0.0 && lost.share < 1.0) {
        return Err(StackError::Dimension {
            quantity: "share of a bed",
            given: lost.share,
            allowed: "above 0 and below 1",
        });
    }
    let outward = DVec3::new(lost.outward[0], lost.outward[1], 0.0);
    let Some(outward) = outward.try_normalize() else {
        return Err(StackError::Direction {
            quantity: "the side of a bed",
            given: [lost.outward[0], lost.outward[1], 0.0],
        });
    };
    let stack = Stack::new(blocks.clone(), JointMaterial::default(), GRAVITY_M_S2)?;
    let below: Vec<_> = stack
        .joints()
        .iter()
        .filter(|joint| joint.upper == lost.block && joint.axes[2][2] >= UPRIGHT_LEAST)
        .collect();
    let last = blocks.len() - 1;
    let (Some(first), Some(block)) = (below.first(), blocks.get_mut(lost.block)) else {
        return Err(match lost.block > last {
            true => StackError::NoBlock {
                given: lost.block,
                last,
            },
            false => StackError::NoJoint {
                given: lost.block,
                count: stack.joints().len(),
            },
        });
    };
    let corners = below.iter().flat_map(|joint| {
        let [x, y, _] = joint.axes.map(DVec3::from);
        let origin = DVec3::from(joint.origin_m);
        let each = joint.patch.corners_m.iter();
        each.map(move |[a, b]| outward.dot(origin + x * *a + y * *b))
    });
    let (low, high) = corners.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| {
        (low.min(at), high.max(at))
    });
    let normal = DVec3::from(first.axes[2]);
    let along = (outward - normal * outward.dot(normal)).normalize();
    // on the foot of the block, which may be slightly above the bed
    let origin = DVec3::from(first.origin_m) + normal * first.gap_m;
    let line = high - lost.share * (high - low);
    let on = origin + along * ((line - outward.dot(origin)) / along.dot(outward));
    let across = along * RISE_RAD.sin() - normal * RISE_RAD.cos();
    let whole = &block.solid;
    let mut left = behind(whole, &|corner| across.dot(corner - on))?.with_moments(
        whole.volume_m3(),
        DVec3::from(whole.centroid_m()),
        whole.second_m5(),
    );
    left.openings.clone_from(&whole.openings);
    left.pieces.clone_from(&whole.pieces);
    block.solid = left;
    Ok(blocks)
}

/// The hull of the part behind a plane: its corners there, and the intersections of edges with the plane. Faces are cut along their own edges, so
/// that each remains one face.
fn behind(solid: &Solid, height: &dyn Fn(DVec3) -> f64) -> Result<Solid, StackError> {
    let corners: Vec<DVec3> = solid.vertices_m().iter().map(|at| DVec3::from(*at)).collect();
    let mut kept: Vec<[f64; 3]> = Vec::new();
    let mut keep = |at: DVec3| {
        let at = at.to_array();
        if !kept.contains(&at) {
            kept.push(at);
        }
    };
    for face in solid.faces() {
        for (at, &first) in face.iter().enumerate() {
            let next = face[(at + 1) % face.len()];
            if height(corners[first]) <= 0.0 {
                keep(corners[first]);
            }
            // both faces of an edge compute its intersection in the same order, so that rounding is the same
            let (a, b) = (corners[first.min(next)], corners[first.max(next)]);
            let (from, to) = (height(a), height(b));
            if from * to < 0.0 {
                keep(a + (b - a) * (from / (from - to)));
            }
        }
    }
    Solid::convex(&kept)
}

#[cfg(test)]
mod tests {
    use super::super::{Body, Placement};
    use super::*;

    fn pier() -> Vec<Block> {
        let block = |name: &str, at: f64| Block {
            name: name.into(),
            solid: Solid::cuboid(1.0, 0.8, 1.0).unwrap().placed(&Placement {
                position_m: [0.0, 0.0, at],
                ..Placement::default()
            }),
            density_kg_m3: 2600.0,
        };
        vec![block("low", 0.0), block("high", 1.0)]
    }

    #[test]
    fn exact_a_fifth_of_a_bed_lost_at_one_side_moves_its_edge_by_a_fifth_of_its_width() {
        for (block, outward, edges) in [
            (0, [1.0, 0.0], [[-0.5, 0.3], [-0.4, 0.4]]),
            (1, [-1.0, 0.0], [[-0.3, 0.5], [-0.4, 0.4]]),
            (1, [0.0, 2.0], [[-0.5, 0.5], [-0.4, 0.24]]),
        ] {
            let lost = LostBed {
                block,
                share: 0.2,
                outward,
            };
            let blocks = without_bed(pier(), &lost).unwrap();
            for (own, before) in blocks.iter().zip(pier()) {
                assert_eq!(own.solid.centroid_m(), before.solid.centroid_m());
                assert_eq!(own.solid.volume_m3(), before.solid.volume_m3());
            }
            let stack = Stack::new(blocks, JointMaterial::default(), 9.81).unwrap();
            let joint = &stack.joints()[block];
            let lower = if block == 0 { Body::Ground } else { Body::Block(0) };
            assert_eq!((joint.lower, joint.upper), (lower, block));
            for (axis, edge) in edges.iter().enumerate() {
                let at = |corner: &[f64; 2]| {
                    joint.origin_m[axis] + joint.axes[0][axis] * corner[0] + joint.axes[1][axis] * corner[1]
                };
                let all: Vec<f64> = joint.patch.corners_m.iter().map(at).collect();
                let low = all.iter().copied().fold(f64::INFINITY, f64::min);
                let high = all.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                assert!(
                    (low - edge[0]).abs() < 1e-12 && (high - edge[1]).abs() < 1e-12,
                    "{outward:?}: {low} {high}"
                );
            }
        }
    }

    #[test]
    fn holds_every_shape_keeps_one_bed_whatever_is_lost_of_it() {
        let shapes = [
            Solid::cuboid(1.0, 0.8, 1.0).unwrap(),
            Solid::tapered_drum(1.0, 0.8, 1.3).unwrap(),
            Solid::prism_frustum(6, 1.1, 0.9, 0.7).unwrap(),
            Solid::frustum([1.2, 0.9], [0.7, 0.6], 0.8).unwrap(),
        ];
        for (number, solid) in shapes.into_iter().enumerate() {
            for step in 1..40 {
                let turn = 0.17 * f64::from(step);
                let lost = LostBed {
                    block: 1,
                    share: 0.02 * f64::from(step),
                    outward: [turn.cos(), turn.sin()],
                };
                let mut blocks = pier();
                blocks[1].solid = solid.placed(&Placement {
                    yaw_rad: 0.3,
                    position_m: [0.013, 0.007, 1.0],
                    ..Placement::default()
                });
                let blocks = without_bed(blocks, &lost).unwrap();
                let stack = Stack::new(blocks, JointMaterial::default(), 9.81)
                    .unwrap_or_else(|why| panic!("{number} {step}: {why}"));
                assert_eq!(stack.joints().len(), 2);
            }
        }
    }

    #[test]
    fn refuses_shares_sides_and_blocks_that_are_none() {
        let of = |block, share, outward| {
            without_bed(
                pier(),
                &LostBed {
                    block,
                    share,
                    outward,
                },
            )
        };
        for wrong in [
            of(0, 0.0, [1.0, 0.0]),
            of(0, 1.0, [1.0, 0.0]),
            of(0, f64::NAN, [1.0, 0.0]),
            of(0, 0.2, [0.0, 0.0]),
            of(2, 0.2, [1.0, 0.0]),
        ] {
            wrong.unwrap_err();
        }
    }
}
