//! Why no joint carries a stone: it floats, stands on an edge, or lies on the crown of a boulder.

use super::beds::{BED_GAP_M, rounded};
use super::wedge::wedge;
use super::{Block, Solid, Stack, StackError};
use glam::DVec3;

impl Solid {
    /// Distances from another solid to this one along x, y and z, between their bounds, m: 0 where they overlap, otherwise positive if this solid lies on
    /// the positive side.
    pub fn apart_m(&self, other: &Solid) -> [f64; 3] {
        let ([low, high], [other_low, other_high]) = (self.bounds_m(), other.bounds_m());
        [0, 1, 2].map(|axis| {
            let after = low[axis] - other_high[axis];
            let before = high[axis] - other_low[axis];
            if after > 0.0 { after } else { before.min(0.0) }
        })
    }

    /// As [`Solid::apart_m`], for a solid that is to stand on another one (the ground if `None`): along z from the top of that one to the bottom of this
    /// one.
    pub fn above_m(&self, below: Option<&Solid>) -> [f64; 3] {
        let bottom_m = self.bounds_m()[0][2];
        match below {
            None => [0.0, 0.0, bottom_m],
            Some(below) => {
                let [x, y, _] = self.apart_m(below);
                [x, y, bottom_m - below.bounds_m()[1][2]]
            }
        }
    }
}

impl Stack {
    /// Why a stone that no joint carries does not stand; `carried` tells which stones joints connect to the ground.
    pub(super) fn uncarried(&self, block: usize, carried: &[bool]) -> StackError {
        let own = &self.blocks[block];
        let others = self.blocks.iter().zip(carried).filter(|(_, carried)| **carried);
        let stones = others.map(|(other, _)| (other.name.as_str(), own.solid.above_m(Some(&other.solid))));
        let mut all = vec![("the ground", own.solid.above_m(None))];
        all.extend(stones);
        if let Some(radius_m) = own.solid.rounded_below_m() {
            // the plane fitted to a crown lies within the body below
            let is_near = |apart_m: &[f64; 3]| {
                apart_m[0] == 0.0 && apart_m[1] == 0.0 && apart_m[2].abs() <= 2.0 * BED_GAP_M
            };
            if let Some((below, _)) = all.iter().find(|(_, apart_m)| is_near(apart_m)) {
                return rounded(&own.name, below, &own.name, radius_m);
            }
        }
        if let Some(why) = self.not_parallel(own) {
            return why;
        }
        // the stone for which the fewest numbers are wrong, and of those the nearest
        let wrong = |apart_m: &[f64; 3]| {
            let axes = apart_m.iter().filter(|along| along.abs() > BED_GAP_M).count();
            (axes, DVec3::from(*apart_m).length())
        };
        let nearest = all[1..].iter().min_by(|(_, a), (_, b)| {
            let (a, b) = (wrong(a), wrong(b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
        StackError::Floating {
            block: own.name.clone(),
            nearest: nearest.map(|(name, _)| (*name).to_owned()),
            apart_m: nearest.map_or([0.0; 3], |(_, apart_m)| *apart_m),
            above_ground_m: all[0].1[2],
            allowed_m: BED_GAP_M,
        }
    }

    /// The stone below a floating block, or the ground, that it meets at an edge.
    fn not_parallel(&self, own: &Block) -> Option<StackError> {
        let [low, high] = own.solid.bounds_m();
        let under = |other: &&Block| {
            let [other_low, other_high] = other.solid.bounds_m();
            other.name != own.name
                && other_low[2] < low[2]
                && (0..2).all(|axis| other_low[axis] < high[axis] && low[axis] < other_high[axis])
        };
        let stones = self.blocks.iter().filter(under);
        let stones = stones.map(|other| (other.name.clone(), wedge(Some(&other.solid), &own.solid)));
        let ground = ("the ground".to_owned(), wedge(None, &own.solid));
        let (lower, found) = stones.chain([ground]).find(|(_, found)| found.is_some())?;
        let found = found?;
        Some(StackError::BedsNotParallel {
            block: own.name.clone(),
            lower,
            angle_deg: found.angle_deg,
            far_m: found.far_m,
            allowed_m: BED_GAP_M,
        })
    }
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
            density_kg_m3: 2600.0,
        }
    }

    /// A base, and a stone with one on top of it, which one number of its place keeps off the base.
    #[test]
    fn exact_a_floating_stone_is_so_far_from_the_nearest_along_each_axis() {
        for (place, apart) in [
            ([0.0, 0.0, 0.6], [0.0, 0.0, 0.1]),
            ([1.3, 0.0, 0.5], [0.3, 0.0, 0.0]),
            ([0.0, -1.25, 0.51], [0.0, -0.25, 0.01]),
            ([-5.0, 0.0, 0.5], [-4.0, 0.0, 0.0]),
        ] {
            let [x, y, z] = place;
            // a low stone beside the base, which is nearer than the base in the last case
            let blocks = vec![
                stone("low", [1.0, 1.0, 0.3], [-3.0, 0.0, 0.0]),
                stone("top", [1.0, 1.0, 0.2], [x, y, z + 0.2]),
                stone("body", [1.0, 1.0, 0.2], place),
                stone("base", [1.0, 1.0, 0.5], [0.0; 3]),
            ];
            let fault = Stack::new(blocks, JointMaterial::default(), 9.81).unwrap_err();
            let StackError::Floating {
                block,
                nearest,
                apart_m,
                above_ground_m,
                ..
            } = &fault
            else {
                panic!("{fault}")
            };
            assert_eq!((block.as_str(), nearest.as_deref()), ("body", Some("base")));
            assert_eq!(*above_ground_m, z);
            for (found, known) in apart_m.iter().zip(apart) {
                assert!((found - known).abs() < 1e-12, "{place:?}: {apart_m:?}");
            }
        }
    }
}
