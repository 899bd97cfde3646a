//! Loose stones under their own weight and in an earthquake: their positions of rest, and the stones that leave their places.

use super::after_fall::AfterFall;
use super::contact_law::{ContactLaw, simulate_stack};
use super::error::BlocksError;
use super::fall::least_thickness;
use super::history::{Outcome, Pose, StackHistory};
use super::hulls::Hull;
use super::loose_margin::margin_at_rest_g;
use super::rigid::{Rigid, RigidRunUnder, simulate_rigid_under};
use super::springs::{Springs, simulate_springs_dragged};
use crate::signal::GroundMotion;
use crate::structure::stack::Stack;
use glam::{DMat3, DQuat, DVec3};

/// Energy created by contacts, over the input energy, above which a run is unusable. Our choice, as for springs.
const MADE_MOST: f64 = 1e-2;
/// Created energy below which it counts as rounding, as a height by which it lifts all stones, m. Our choice: a micrometre.
const MADE_LIFT_M: f64 = 1e-6;
/// Time for which stones that have settled are followed without drag, s. Our choice: in this time a stone at an unstable place falls.
const RELEASED_S: f64 = 2.0;

/// State of loose stones at the end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LooseEnding {
    /// All stones are at rest, each near its place at the start.
    Stood,
    /// All stones are at rest, and some left their places.
    Fell,
    /// Stones still moved when the run ended.
    StillMoving {
        /// One of these stones, as an index of the blocks.
        block: usize,
    },
    /// A stone sank into the ground or another stone by more than [`BED_GAP_M`](crate::structure::stack::BED_GAP_M): on soft springs, contacts
    /// of small faces are too soft for its weight.
    Sank {
        /// The stone, as an index of the blocks.
        block: usize,
    },
    /// The run is unusable: it was stopped, diverged, or a step had no solution.
    Unusable,
}

/// Motion of a loose stone in a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LooseStone {
    /// Distance of its centroid from its place at the start, m.
    pub moved_m: f64,
    /// Vertical part of this distance, downwards, m.
    pub dropped_m: f64,
    /// Angle of its rotation, rad.
    pub turned_rad: f64,
    /// Half its least thickness, m: if its centroid moved farther, the stone left its place.
    pub allowed_m: f64,
}

impl LooseStone {
    /// Rotation above which a stone has left its place, rad: 45°, as for a stone on a bed.
    pub const TURN_MOST_RAD: f64 = std::f64::consts::FRAC_PI_4;

    /// Whether it left its place: it moved by more than half its least thickness, or rotated by more than 45°.
    pub fn has_left(&self) -> bool {
        self.moved_m > self.allowed_m || self.turned_rad > LooseStone::TURN_MOST_RAD
    }
}

/// How near to motion loose stones at rest are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LooseMargin {
    /// A stone is only balanced: any push topples it.
    Balanced,
    /// A stone moves at less than [`LooseStones::MARGINAL_BELOW_G`].
    Small,
    /// More.
    Enough,
    /// It is not known, or the stones do not rest near their places.
    Unknown,
}

/// Loose stones after a run.
#[derive(Clone, Debug, PartialEq)]
pub struct LooseStones {
    /// How the run ended.
    pub ending: LooseEnding,
    /// Motion of each stone, in the order of the blocks.
    pub stones: Vec<LooseStone>,
    /// The run.
    pub history: StackHistory,
    /// The stones at their places at the end.
    pub stack: Stack,
    /// Horizontal acceleration, over gravity, at which stones that rest near their places begin to move: 0 for a stone balanced on a point or an
    /// edge, infinite if they are wedged; `None` if they do not rest, or it was not found.
    pub margin_g: Option<f64>,
}

impl LooseStones {
    /// Rate at which velocities decay while stones settle, 1/s. Our choice: about twice the angular frequency at which stones of half a metre rock,
    /// so that they neither swing nor jump.
    pub const DRAG_PER_S: f64 = 10.0;

    /// Horizontal acceleration, over gravity, below which stones that rest are "marginal": a tilt of the ground of 1.1°, which a survey can miss. Our
    /// choice.
    pub const MARGINAL_BELOW_G: f64 = 0.02;
    /// The same below which a stone is only balanced, a slope of 0.06°. Our choice: no stone lies so in the field.
    pub const BALANCED_BELOW_G: f64 = 0.001;

    /// How near to motion the stones are.
    pub fn margin(&self) -> LooseMargin {
        match self.margin_g {
            Some(margin_g) if margin_g < Self::BALANCED_BELOW_G => LooseMargin::Balanced,
            Some(margin_g) if margin_g < Self::MARGINAL_BELOW_G => LooseMargin::Small,
            Some(_) => LooseMargin::Enough,
            None => LooseMargin::Unknown,
        }
    }

    /// The stone with the largest displacement relative to its allowed one, as an index of the blocks.
    pub fn farthest(&self) -> usize {
        let part = |stone: &LooseStone| stone.moved_m / stone.allowed_m;
        let most = self
            .stones
            .iter()
            .enumerate()
            .max_by(|a, b| part(a.1).total_cmp(&part(b.1)));
        most.map_or(0, |(block, _)| block)
    }

    /// The stones that left their places.
    pub fn left(&self) -> Vec<usize> {
        let each = self.stones.iter().enumerate();
        each.filter(|(_, stone)| stone.has_left())
            .map(|(block, _)| block)
            .collect()
    }

    /// Time of the end of the run, s.
    pub fn end_s(&self) -> f64 {
        self.history.time_s.last().copied().unwrap_or_default()
    }

    /// Energy created by contacts, over the input energy: that of the motion, or of the lost height, –; 0 if it is rounding.
    pub fn energy_made_ratio(&self) -> f64 {
        let rounding_j = MADE_LIFT_M * self.stack.mass_kg() * self.stack.gravity_m_s2();
        match self.history.energy_made_j > rounding_j {
            true => self.history.energy_made_ratio(),
            false => 0.0,
        }
    }
}

/// Lets loose stones settle from their drawn places until they are at rest, by either contact law; durations of the law do not apply.
///
/// First every velocity decays at [`LooseStones::DRAG_PER_S`], so that the stones go down the small way to rest instead of bouncing and rolling.
/// Once they are at rest, they move freely for at least 2 s, which shows whether they stay there.
///
/// # Errors
/// [`BlocksError`] of the law; [`BlocksError::Option`] for a stack with joints.
///
/// # Limits
/// Contact is between convex hulls, with one patch for two stones. Stones start at rest in their drawn places; drawn overlaps are not pushed
/// apart. Tested by `loose_stones`.
pub fn settle_loose(
    stack: &Stack,
    law: &ContactLaw,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<LooseStones, BlocksError> {
    refuse_joints(stack)?;
    let law = &until_rest(law);
    let drag_per_s = LooseStones::DRAG_PER_S;
    let history = match law {
        ContactLaw::Springs(springs) => simulate_springs_dragged(stack, drag_per_s, springs, progress)?,
        ContactLaw::Rigid(rigid) => {
            let under = RigidRunUnder {
                drag_per_s,
                ..RigidRunUnder::default()
            };
            simulate_rigid_under(stack, under, rigid, progress)?
        }
    };
    Ok(after(stack, history))
}

/// Loose stones under a ground motion, from rest.
///
/// # Errors
/// As [`settle_loose`].
///
/// # Limits
/// Once a stone of a heap rolls, its position of rest is chaotic.
pub fn shake_loose(
    settled: &Stack,
    motion: &GroundMotion,
    law: &ContactLaw,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<LooseStones, BlocksError> {
    refuse_joints(settled)?;
    let history = simulate_stack(settled, Some(motion), law, progress)?;
    Ok(after(settled, history))
}

fn refuse_joints(stack: &Stack) -> Result<(), BlocksError> {
    match stack.loose_material() {
        Some(_) => Ok(()),
        None => Err(BlocksError::Option {
            option: "joints of the stack",
            given: stack.joints().len() as f64,
            allowed: "none: the stones must be loose",
        }),
    }
}

/// The law with a run that ends when the stones are at rest.
fn until_rest(law: &ContactLaw) -> ContactLaw {
    match law {
        ContactLaw::Springs(springs) => ContactLaw::Springs(Springs {
            duration_s: None,
            rest_s: RELEASED_S,
            after_fall: AfterFall::Continue,
            ..springs.clone()
        }),
        ContactLaw::Rigid(rigid) => ContactLaw::Rigid(Rigid {
            duration_s: None,
            rest_s: RELEASED_S,
            after_fall: AfterFall::Continue,
            ..rigid.clone()
        }),
    }
}

/// The stones after a run that began with `stack`.
fn after(stack: &Stack, history: StackHistory) -> LooseStones {
    let moved = at_the_end(stack, &history);
    let both = stack.blocks().iter().zip(moved.blocks()).enumerate();
    let stones = both.map(|(block, (start, now))| {
        let way = DVec3::from(now.solid.centroid_m()) - DVec3::from(start.solid.centroid_m());
        let turn = turn_at_end(&history, block);
        LooseStone {
            moved_m: way.length(),
            dropped_m: -way.z,
            turned_rad: turn.to_scaled_axis().length(),
            allowed_m: 0.5 * least_thickness(&Hull::of(&start.solid)),
        }
    });
    let mut found = LooseStones {
        ending: LooseEnding::Unusable,
        stones: stones.collect(),
        history,
        stack: moved,
        margin_g: None,
    };
    found.ending = match found.history.outcome {
        _ if found.energy_made_ratio() > MADE_MOST => LooseEnding::Unusable,
        Outcome::StillMoving { block, .. } => LooseEnding::StillMoving { block },
        Outcome::Stopped { .. } | Outcome::NotConverged { .. } | Outcome::Diverged { .. } => {
            LooseEnding::Unusable
        }
        _ if found.stones.iter().any(LooseStone::has_left) => LooseEnding::Fell,
        _ => LooseEnding::Stood,
    };
    let sunk = found.stack.first_sunk();
    if let Some(block) = sunk.filter(|_| found.ending != LooseEnding::Unusable) {
        found.ending = LooseEnding::Sank { block };
    }
    if found.ending == LooseEnding::Stood {
        found.margin_g = margin_at_rest_g(&found.stack);
    }
    found
}

fn pose_at_end(history: &StackHistory, block: usize) -> Pose {
    history.pose(history.time_s.len().saturating_sub(1), block)
}

fn turn_at_end(history: &StackHistory, block: usize) -> DQuat {
    let [w, x, y, z] = pose_at_end(history, block).rotation;
    let turn = DQuat::from_xyzw(x, y, z, w).normalize();
    if w < 0.0 { -turn } else { turn }
}

/// The stones at their places at the end of a run.
fn at_the_end(stack: &Stack, history: &StackHistory) -> Stack {
    let places = (0..stack.blocks().len()).map(|block| {
        let rotation = DMat3::from_quat(turn_at_end(history, block));
        (rotation, pose_at_end(history, block).centroid_m.into())
    });
    stack.at_places(places)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid};

    const STIFFNESS_PA_M: f64 = 1e10;
    const DENSITY_KG_M3: f64 = 2600.0;
    const GRAVITY_M_S2: f64 = 9.81;

    fn laws() -> [ContactLaw; 2] {
        [
            ContactLaw::Springs(Springs::default()),
            ContactLaw::Rigid(Rigid::default()),
        ]
    }

    fn heap(solids: Vec<Solid>) -> Stack {
        let blocks = solids.into_iter().enumerate().map(|(i, solid)| Block {
            name: format!("stone {i}"),
            solid,
            density_kg_m3: DENSITY_KG_M3,
        });
        let material = JointMaterial {
            normal_stiffness_pa_m: STIFFNESS_PA_M,
            shear_stiffness_pa_m: 0.4 * STIFFNESS_PA_M,
            ..JointMaterial::default()
        };
        Stack::loose(blocks.collect(), material, GRAVITY_M_S2).unwrap()
    }

    fn at(solid: &Solid, position_m: [f64; 3]) -> Solid {
        solid.placed(&Placement {
            position_m,
            ..Placement::default()
        })
    }

    /// Kinetic, potential and stored energy at each sample, J.
    fn mechanical_j(found: &LooseStones) -> Vec<f64> {
        let each = found.history.energy.iter();
        each.map(|e| e.kinetic_j + e.potential_j + e.stored_j).collect()
    }

    #[test]
    fn exact_a_block_1_mm_above_the_ground_lands_flat() {
        let block = Solid::cuboid(0.3, 0.2, 0.1).unwrap();
        let stack = heap(vec![at(&block, [0.0, 0.0, 1e-3])]);
        // on springs it also sinks by its weight: ρ g h/k_n
        let sinks_m = DENSITY_KG_M3 * GRAVITY_M_S2 * 0.1 / STIFFNESS_PA_M;
        for (law, exact_m) in laws().iter().zip([1e-3 + sinks_m, 1e-3]) {
            let found = settle_loose(&stack, law, &mut |_| true).unwrap();
            let stone = found.stones[0];
            assert_eq!(found.ending, LooseEnding::Stood, "{}", law.name());
            assert!(
                (stone.dropped_m - exact_m).abs() < 1e-8,
                "{}: {stone:?}",
                law.name()
            );
            assert!((stone.moved_m - stone.dropped_m).abs() < 1e-8, "{stone:?}");
            assert!(stone.turned_rad < 1e-6, "{stone:?}");
        }
    }

    /// A regular icosahedron of edge 2 s whose lowest face is level: a threefold axis stands upright.
    fn icosahedron(s: f64) -> Solid {
        let g = f64::midpoint(1.0, 5.0_f64.sqrt());
        let mut corners: Vec<DVec3> = Vec::new();
        for a in [-1.0, 1.0] {
            for b in [-g, g] {
                corners.extend([
                    DVec3::new(0.0, a, b),
                    DVec3::new(a, b, 0.0),
                    DVec3::new(b, 0.0, a),
                ]);
            }
        }
        let turn = DQuat::from_rotation_arc(DVec3::ONE.normalize(), DVec3::Z);
        let points: Vec<[f64; 3]> = corners.iter().map(|at| (turn * (*at * s)).into()).collect();
        Solid::convex(&points).unwrap()
    }

    #[test]
    fn exact_an_icosahedron_in_a_cradle_of_three_rests_on_its_inscribed_sphere() {
        // the three faces beside the lowest rise by θ, cos θ = √5/3; each lies on a wedge whose face rises by θ from a point O: the centre then
        // rests at r/cos θ above O, with r the radius of the inscribed sphere
        let stone = icosahedron(0.1);
        let cos = 5.0_f64.sqrt() / 3.0;
        let (sin, r) = (
            (1.0 - cos * cos).sqrt(),
            0.1 * 3.0_f64.sqrt() * f64::midpoint(3.0, 5.0_f64.sqrt()) / 3.0,
        );
        let lowest = stone.faces().iter().enumerate().filter_map(|(face, _)| {
            let normal = stone.normal(face);
            ((normal.z + cos).abs() < 1e-6).then_some(normal)
        });
        let outward: Vec<DVec3> = lowest.map(|n| DVec3::new(n.x, n.y, 0.0).normalize()).collect();
        assert_eq!(outward.len(), 3);
        let apex_m = 0.1;
        let wedges = outward.iter().map(|out| {
            let across = DVec3::Z.cross(*out);
            let rise = |way: f64| apex_m + way * sin / cos;
            let points: Vec<[f64; 3]> = [(0.06, -0.05), (0.06, 0.05), (0.3, -0.3), (0.3, 0.3)]
                .iter()
                .flat_map(|&(way, side)| {
                    let foot = *out * way + across * side;
                    [foot, foot + DVec3::Z * rise(way)].map(<[f64; 3]>::from)
                })
                .collect();
            Solid::convex(&points).unwrap()
        });
        let mut solids: Vec<Solid> = wedges.collect();
        let exact_m = apex_m + r / cos;
        solids.push(at(&stone, [0.0, 0.0, exact_m + 1e-3]));
        let stack = heap(solids);
        for (law, within_m) in laws().iter().zip([1e-5, 1e-7]) {
            let found = settle_loose(&stack, law, &mut |_| true).unwrap();
            assert_eq!(found.ending, LooseEnding::Stood, "{}", law.name());
            let [x, y, z] = found.stack.blocks()[3].solid.centroid_m();
            let off = [x, y, z - exact_m];
            assert!(
                off.iter().all(|part| part.abs() < within_m),
                "{}: {off:?}",
                law.name()
            );
            assert!(found.stones[3].turned_rad < 1e-4, "{:?}", found.stones[3]);
        }
    }

    #[test]
    fn holds_cubes_that_overlap_as_drawn_are_not_pushed_apart() {
        let cube = Solid::cuboid(0.2, 0.2, 0.2).unwrap();
        let stack = heap(vec![cube.clone(), at(&cube, [0.196, 0.0, 0.0])]);
        for law in laws() {
            let found = settle_loose(&stack, &law, &mut |_| true).unwrap();
            assert_eq!(found.ending, LooseEnding::Stood, "{}", law.name());
            let sideways = found.stones.iter().map(|of| of.moved_m - of.dropped_m);
            assert!(
                sideways.fold(0.0, f64::max) < 1e-6,
                "{}: {:?}",
                law.name(),
                found.stones
            );
        }
    }

    #[test]
    fn holds_energy_falls_while_stones_settle() {
        let (stone, block) = (icosahedron(0.1), Solid::cuboid(0.4, 0.3, 0.2).unwrap());
        let low_m = -stone.bounds_m()[0][2];
        let stack = heap(vec![
            at(&block, [0.0, 0.0, 2e-3]),
            at(&stone, [0.1, 0.02, 0.2 + low_m + 4e-3]),
        ]);
        for law in laws() {
            let found = settle_loose(&stack, &law, &mut |_| true).unwrap();
            let energies_j = mechanical_j(&found);
            let fallen_j = energies_j[0] - energies_j[energies_j.len() - 1];
            assert!(fallen_j > 0.0);
            for pair in energies_j.windows(2) {
                assert!(pair[1] <= pair[0] + 1e-4 * fallen_j, "{}: {pair:?}", law.name());
            }
        }
    }

    #[test]
    fn holds_a_slab_that_nothing_carries_leaves_its_place() {
        let (block, slab) = (
            Solid::cuboid(0.4, 0.4, 0.4).unwrap(),
            Solid::cuboid(1.0, 0.3, 0.1).unwrap(),
        );
        let over = |way: f64| heap(vec![block.clone(), at(&slab, [way, 0.0, 0.401])]);
        for law in laws() {
            // its centroid is inside the block, then 50 mm outside
            let stays = settle_loose(&over(0.15), &law, &mut |_| true).unwrap();
            assert_eq!(stays.ending, LooseEnding::Stood, "{}", law.name());
            let falls = settle_loose(&over(0.25), &law, &mut |_| true).unwrap();
            assert_eq!(falls.left(), [1], "{}: {:?}", law.name(), falls.ending);
        }
    }
}
