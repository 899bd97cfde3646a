//! A chain of flat-bedded blocks in plan: positions, motion, and the load on every bed.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | c_i, θ_i | `centre_m`, `yaw_rad` | centroid in plan and rotation of block i, counted from the bottom | m, rad |
//! | s_i, ψ_i | [`Place`] | position and rotation relative to the block below | m, rad |
//! | w_i | `twist` | velocity of block i at c_i, and its spin, relative to the block below | m/s, rad/s |
//! | k_i | – | ẇ_i | m/s², rad/s² |
//! | W_i | – | force and torque about c_i from the bed on block i | N, N m |

use super::contact_points::{ContactRule, contact_points};
use super::error::BlocksError;
use super::sliding_bed::{Twist, Wrench, turned};
use crate::structure::stack::{Body, Polygon, Stack};
use glam::{DVec2, DVec3};

/// Tolerance within which points of a bed lie in one plane, over the size of the stone. Our choice: rounding of coordinates.
const FLAT: f64 = 1e-9;

/// One block of the chain.
#[derive(Clone, Debug)]
pub(super) struct Stone {
    /// Its index in the stack, and the index of its bed.
    pub(super) block: usize,
    pub(super) joint: usize,
    pub(super) mass: f64,
    /// Moment of inertia about the vertical through its centroid, kg m².
    inertia: f64,
    pub(super) centroid: DVec3,
    bed_z: f64,
    /// Its lower and upper face, relative to its centroid, m.
    bottom: Polygon,
    top: Polygon,
    /// Contact points of the whole lower face.
    points: Vec<(DVec2, f64)>,
    pub(super) friction_static: f64,
    pub(super) friction_kinetic: f64,
    /// Largest extent of its bed, m.
    pub(super) bed_size: f64,
    /// Mass of the block and of all blocks above, kg.
    pub(super) carried: f64,
}

/// Position of a block relative to the block below.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Place {
    pub(super) shift: DVec2,
    pub(super) yaw: f64,
}

/// Positions and velocities of all blocks, and the points of their beds.
#[derive(Clone, Debug, Default)]
pub(super) struct Motion {
    pub(super) centre_m: Vec<DVec2>,
    pub(super) yaw_rad: Vec<f64>,
    pub(super) velocity: Vec<DVec2>,
    pub(super) spin: Vec<f64>,
    /// Points of each bed, relative to the centroid of its upper block.
    pub(super) beds: Vec<Vec<(DVec2, f64)>>,
}

/// Load on every bed for given accelerations.
#[derive(Clone, Debug, Default)]
pub(super) struct Load {
    /// Force and torque about the centroid of the upper block.
    pub(super) wrench: Vec<Wrench>,
    /// Point of application of the normal force, relative to the centroid of the upper block.
    pub(super) resultant: Vec<DVec2>,
}

/// Acceleration of the ground at a time; the vertical component includes gravity.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shaking {
    pub(super) ground: DVec2,
    pub(super) weight: f64,
}

#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub(super) stones: Vec<Stone>,
    rule: ContactRule,
}

impl Chain {
    /// # Errors
    /// [`BlocksError::NotAPile`] unless each block lies with a level bed on one other block or on the ground, without ties, side
    /// supports and bonds.
    pub(super) fn of(stack: &Stack, rule: ContactRule) -> Result<Chain, BlocksError> {
        let refuse = |block: usize, reason| {
            Err(BlocksError::NotAPile {
                block: stack.blocks()[block].name.clone(),
                reason,
            })
        };
        if let Some(tie) = stack.ties().first() {
            return refuse(tie.upper, "it is held by a tie");
        }
        if let Some(support) = stack.side_supports().first() {
            return refuse(support.block, "it has a side support");
        }
        if let Some(load) = stack.static_loads().first() {
            return refuse(load.block, "it carries a static load");
        }
        let mut stones: Vec<Stone> = Vec::new();
        let mut below = Body::Ground;
        while stones.len() < stack.blocks().len() {
            let mut on_it = stack
                .joints()
                .iter()
                .enumerate()
                .filter(|(_, joint)| joint.lower == below);
            let (Some((number, joint)), None) = (on_it.next(), on_it.next()) else {
                let beside = (0..stack.blocks().len())
                    .find(|index| stones.iter().all(|stone| stone.block != *index))
                    .unwrap_or(0);
                return refuse(
                    beside,
                    "it is not one of a single pile, each block on the one below",
                );
            };
            let index = joint.upper;
            if stack.joints().iter().filter(|other| other.upper == index).count() != 1 {
                return refuse(index, "it lies on several blocks");
            }
            if joint.material.cohesion_pa > 0.0 || joint.material.tension_pa > 0.0 {
                return refuse(index, "its bed is bonded");
            }
            let block = &stack.blocks()[index];
            let [low, high] = block.solid.bounds_m();
            let size = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max);
            let level = joint.axes[2][2] > 1.0 - FLAT && (joint.origin_m[2] - low[2]).abs() <= FLAT * size;
            let below_top = match below {
                Body::Ground => 0.0,
                Body::Block(lower) => stack.blocks()[lower].solid.bounds_m()[1][2],
            };
            if !level || (joint.origin_m[2] - below_top).abs() > 1e-6 * size {
                return refuse(
                    index,
                    "its bed is not its level lowest face on the level top below",
                );
            }
            let centroid = DVec3::from(block.solid.centroid_m());
            let face = |z: f64| {
                let corners = block
                    .solid
                    .vertices_m()
                    .iter()
                    .filter(|v| (v[2] - z).abs() <= FLAT * size);
                let corners: Vec<[f64; 2]> =
                    corners.map(|v| [v[0] - centroid.x, v[1] - centroid.y]).collect();
                Polygon::hull(corners)
            };
            let bottom = face(low[2]);
            let inertia = block.solid.inertia_m5();
            stones.push(Stone {
                block: index,
                joint: number,
                mass: block.mass_kg(),
                inertia: block.density_kg_m3 * inertia[2][2],
                centroid,
                bed_z: low[2],
                bed_size: bottom.size_m(),
                points: spread(&bottom, rule),
                bottom,
                top: face(high[2]),
                friction_static: joint.material.friction_static,
                friction_kinetic: joint.material.friction_kinetic,
                carried: 0.0,
            });
            below = Body::Block(index);
        }
        let mut carried = 0.0;
        for stone in stones.iter_mut().rev() {
            carried += stone.mass;
            stone.carried = carried;
        }
        Ok(Chain { stones, rule })
    }

    /// Positions of the blocks as drawn.
    pub(super) fn drawn(&self) -> Vec<Place> {
        let mut below = DVec2::ZERO;
        let place = |stone: &Stone| {
            let centre = stone.centroid.truncate();
            let shift = centre - std::mem::replace(&mut below, centre);
            Place { shift, yaw: 0.0 }
        };
        self.stones.iter().map(place).collect()
    }

    /// Rates of the relative positions: ds_i/dt = R(−θ_{i−1}) times the sliding velocity.
    pub(super) fn rates(&self, motion: &Motion, twists: &[Twist]) -> Vec<Place> {
        let below = std::iter::once(0.0).chain(motion.yaw_rad.iter().copied());
        let rate = |(twist, below): (&Twist, f64)| Place {
            shift: DVec2::from_angle(-below).rotate(twist.truncate()),
            yaw: twist.z,
        };
        twists.iter().zip(below).map(rate).collect()
    }

    /// Positions and velocities in the frame of the ground, from those relative to the block below.
    pub(super) fn motion(&self, places: &[Place], twists: &[Twist]) -> Motion {
        let n = self.stones.len();
        let mut motion = Motion::default();
        let (mut centre, mut yaw, mut velocity, mut spin) = (DVec2::ZERO, 0.0, DVec2::ZERO, 0.0);
        for i in 0..n {
            let arm = DVec2::from_angle(yaw).rotate(places[i].shift);
            velocity += twists[i].truncate() + spin * turned(arm);
            centre += arm;
            let lower_yaw = yaw;
            yaw += places[i].yaw;
            spin += twists[i].z;
            motion.beds.push(self.bed(i, lower_yaw, yaw, arm));
            motion.centre_m.push(centre);
            motion.yaw_rad.push(yaw);
            motion.velocity.push(velocity);
            motion.spin.push(spin);
        }
        motion
    }

    /// Points of a bed relative to the centroid of its upper block: of the whole face, or of the part that lies on the block below.
    fn bed(&self, i: usize, lower_yaw: f64, yaw: f64, arm: DVec2) -> Vec<(DVec2, f64)> {
        let stone = &self.stones[i];
        let own = DVec2::from_angle(yaw);
        if i > 0 {
            // corners of the lower face in the frame of the block below
            let seen = DVec2::from_angle(yaw - lower_yaw);
            let shift = DVec2::from_angle(-lower_yaw).rotate(arm);
            let top = &self.stones[i - 1].top;
            let corners = stone.bottom.corners_m.iter();
            let corners_m: Vec<[f64; 2]> = corners
                .map(|corner| (shift + seen.rotate(DVec2::from(*corner))).into())
                .collect();
            let whole = corners_m.iter().all(|corner| top.depth_m(*corner) >= 0.0);
            if !whole {
                let common = Polygon { corners_m }.clipped(top);
                let back = DVec2::from_angle(lower_yaw);
                let from_centroid = |(place, area): (DVec2, f64)| (back.rotate(place - shift), area);
                return spread(&common, self.rule)
                    .into_iter()
                    .map(from_centroid)
                    .collect();
            }
        }
        stone
            .points
            .iter()
            .map(|&(place, area)| (own.rotate(place), area))
            .collect()
    }

    /// Forces of the beds for the accelerations `k` of each block relative to the one below.
    ///
    /// ```text
    /// v̇_i = k_i + v̇_{i−1} + ω̇_{i−1} × d + ω_{i−1} × (v_i − v_{i−1})              d = c_i − c_{i−1}
    /// W_i = Σ_{j ≥ i} m_j (v̇_j + a_g),   N_i X_i = Σ_{j ≥ i} m_j ((g + a_z) c_j − (z_j − z) (v̇_j + a_g))
    /// ```
    pub(super) fn load(&self, motion: &Motion, k: &[Twist], shaking: Shaking) -> Load {
        let n = self.stones.len();
        let mut accelerations = Vec::with_capacity(n);
        let (mut linear, mut turning) = (DVec2::ZERO, 0.0);
        for (i, k) in k.iter().enumerate() {
            if i > 0 {
                let arm = motion.centre_m[i] - motion.centre_m[i - 1];
                linear += turning * turned(arm)
                    + motion.spin[i - 1] * turned(motion.velocity[i] - motion.velocity[i - 1]);
            }
            linear += k.truncate();
            turning += k.z;
            accelerations.push((linear, turning));
        }
        let mut load = Load {
            wrench: vec![DVec3::ZERO; n],
            resultant: vec![DVec2::ZERO; n],
        };
        let (mut force, mut torque) = (DVec2::ZERO, 0.0); // on block i from its bed
        let (mut weights, mut heights) = (DVec2::ZERO, DVec2::ZERO); // Σ m c, Σ m z (v̇ + a_g)
        for i in (0..n).rev() {
            let stone = &self.stones[i];
            if i + 1 < n {
                // the reaction of the block above, about the centroid of this block
                torque += (motion.centre_m[i + 1] - motion.centre_m[i]).perp_dot(force);
            }
            let inertia = stone.mass * (accelerations[i].0 + shaking.ground);
            force += inertia;
            torque += stone.inertia * accelerations[i].1;
            weights += stone.mass * motion.centre_m[i];
            heights += stone.centroid.z * inertia;
            load.wrench[i] = force.extend(torque);
            let overturning = heights - stone.bed_z * force;
            load.resultant[i] = (weights - overturning / shaking.weight) / stone.carried - motion.centre_m[i];
        }
        load
    }

    /// Kinetic energy, J, in the frame of the ground.
    pub(super) fn kinetic(&self, motion: &Motion) -> f64 {
        let of = |(i, stone): (usize, &Stone)| {
            0.5 * (stone.mass * motion.velocity[i].length_squared()
                + stone.inertia * motion.spin[i] * motion.spin[i])
        };
        self.stones.iter().enumerate().map(of).sum()
    }

    /// Power of the inertia forces of the moving ground, W.
    pub(super) fn power(&self, motion: &Motion, shaking: Shaking) -> f64 {
        let of = |(stone, velocity): (&Stone, &DVec2)| -stone.mass * shaking.ground.dot(*velocity);
        self.stones.iter().zip(&motion.velocity).map(of).sum()
    }
}

/// Points of a polygon and their tributary areas.
fn spread(polygon: &Polygon, rule: ContactRule) -> Vec<(DVec2, f64)> {
    let points = contact_points(polygon, rule).into_iter();
    points
        .map(|point| (DVec2::from(point.place_m), point.area_m2))
        .collect()
}
