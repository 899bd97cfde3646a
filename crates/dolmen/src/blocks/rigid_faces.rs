//! The rigid law at the points of one contact: unilateral contact with Coulomb's disc.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | ξ = (w, Ω) | `twist` | velocity of S relative to P at the frame's origin, and its spin, in that frame | m/s, rad/s |
//! | u = G ξ | `slip`, `lift` | velocity of a point of S relative to P, along the plane and along its normal | m/s |
//! | s | `offset` | addition to u from the positions, so that h (u + s) is the motion of the point in the step | m/s |
//! | p | `impulse` | impulse on S at a point: two components along the plane, one along the normal | N s |
//! | λ | `held` | impulse stored as multiplier | N s |
//! | ϱ | `weight` | factor from velocity to impulse: ρ a m / A | kg |
//! | κ | `kick_s` | time over which the impulses act; 0 in an impact | s |

use super::bodies::RigidBody;
use super::patch::{LANES, Motion, Patch, Restitution};
use super::rigid_bed::{fit_bed, on_bed};
use super::rigid_point::{ForceTorque, Part, Point};
use glam::{DMat3, DVec3};

/// Ratio ρ of the weights to the mass: ϱ = ρ × the mass of both bodies and of all bodies above, divided by the area. It affects the speed
/// of convergence, not the result. Our choice, by trial.
const HARDNESS: f64 = 1e5;
/// Largest relative difference between the initial bed of a solution and the force of the last step. Our choice.
const HELD_NEAR: f64 = 1e-3;
/// Smallest weight along the plane of a point without pressure, as a fraction of the weight by its area. Our choice.
const SHEAR_LEAST: f64 = 0.1;
/// Smallest fraction of a face's weight for each of its points: slivers from clipping must also carry force. Our choice.
const WEIGHT_LEAST: f64 = 1e-3;

#[derive(Clone, Debug, Default)]
pub(super) struct MassAbove {
    /// Height of each body, from the top, m, and the total mass from the top to it.
    heights: Vec<[f64; 2]>,
}

impl MassAbove {
    pub(super) fn of(bodies: &[RigidBody]) -> Self {
        let movable = bodies.iter().skip(1);
        let mut heights: Vec<[f64; 2]> = movable.map(|body| [body.position.z, body.mass]).collect();
        heights.sort_by(|a, b| b[0].total_cmp(&a[0]));
        let mut sum = 0.0;
        for [_, mass] in &mut heights {
            sum += *mass;
            *mass = sum;
        }
        MassAbove { heights }
    }

    /// Mass above a height, kg.
    fn at(&self, height_m: f64) -> f64 {
        let count = self.heights.partition_point(|[height, _]| *height > height_m);
        count.checked_sub(1).map_or(0.0, |last| self.heights[last][1])
    }
}

/// A patch in one step of the rigid law.
#[derive(Clone, Debug)]
pub(super) struct Face {
    pub(super) pair: usize,
    pub(super) plane_body: usize,
    pub(super) point_body: usize,
    pub(super) to_ground: DMat3,
    /// Vectors from the centroids of P and S to the origin, in the axes of the ground, m.
    pub(super) arms: [DVec3; 2],
    pub(super) points: Vec<Point>,
    /// Twist used for the offsets.
    pub(super) ahead: ForceTorque,
    pub(super) restitution: Restitution,
    /// Whether the stored impulses are those of the last step.
    pub(super) warm: bool,
    /// Whether the last sum used presumed contact states instead of the law for some points.
    pub(super) swung: bool,
    /// Factor σ on the weights.
    pub(super) softness: f64,
    /// ρ × mass.
    pub(super) whole_weight: f64,
}

/// Derivative of the impulses on S with respect to the twist, with negative sign.
pub(super) type Stiffness = [[f64; 6]; 6];

/// G ξ.
#[inline]
pub(super) fn velocity(twist: &ForceTorque, x: f64, y: f64) -> [f64; 3] {
    [
        twist[0] - twist[5] * y,
        twist[1] + twist[5] * x,
        twist[2] + twist[3] * y - twist[4] * x,
    ]
}

/// Gᵀ p, summed.
#[inline]
pub(super) fn add_wrench(sum: &mut ForceTorque, x: f64, y: f64, p: &[f64; 3]) {
    sum[0] += p[0];
    sum[1] += p[1];
    sum[2] += p[2];
    sum[3] += y * p[2];
    sum[4] -= x * p[2];
    sum[5] += x * p[1] - y * p[0];
}

/// Stiffness in the plane (xx, xy, yy) of a point whose friction acts along a unit vector; `part` is that perpendicular to it.
#[inline(always)]
fn slipping_plane(part: f64, along: [f64; 2]) -> [f64; 3] {
    [
        part * (1.0 - along[0] * along[0]),
        -part * along[0] * along[1],
        part * (1.0 - along[1] * along[1]),
    ]
}

/// Adds Gᵀ K G of a point at x, y to the derivative of its face's impulses: K in the plane (xx, xy, yy), `n` along the normal, and the rates
/// at which friction along x and y `follows` the normal. Only the upper triangle and the asymmetric terms of friction: rows 0, 1 and 5 of
/// columns 2 to 4.
#[inline(always)]
pub(super) fn add_stiffness(
    k: &mut Stiffness,
    [x, y]: [f64; 2],
    [a, b, c]: [f64; 3],
    n: f64,
    follows: Option<[f64; 2]>,
) {
    k[0][0] += a;
    k[0][1] += b;
    k[1][1] += c;
    k[0][5] += b * x - a * y;
    k[1][5] += c * x - b * y;
    k[5][5] += a * y * y - 2.0 * b * x * y + c * x * x;
    k[2][2] += n;
    k[2][3] += n * y;
    k[2][4] -= n * x;
    k[3][3] += n * y * y;
    k[3][4] -= n * x * y;
    k[4][4] += n * x * x;
    if let Some([d, e]) = follows {
        for (row, e) in [(0, d), (1, e), (5, x * e - y * d)] {
            k[row][2] += e;
            k[row][3] += e * y;
            k[row][4] -= e * x;
        }
    }
}

impl Face {
    /// A patch at the current pose of its bodies (`motion`), and at their pose after a step of `h` s with unchanged velocities (`ahead`).
    /// Penetrations are removed within `push_out_s`.
    pub(super) fn of(
        (pair, patch): (usize, &Patch),
        bodies: &[RigidBody],
        motion: &Motion,
        ahead: Option<&Motion>,
        [h, push_out_s]: [f64; 2],
        above: &MassAbove,
    ) -> Face {
        let (p, s) = (&bodies[patch.plane_body], &bodies[patch.point_body]);
        let twist = patch.twist(bodies, motion);
        let twist: ForceTorque = [
            twist.velocity.x,
            twist.velocity.y,
            twist.velocity.z,
            twist.spin.x,
            twist.spin.y,
            twist.spin.z,
        ];
        let mut face = Face {
            pair,
            plane_body: patch.plane_body,
            point_body: patch.point_body,
            to_ground: motion.to_ground,
            arms: [motion.origin - p.position, motion.origin - s.position],
            points: Vec::with_capacity(LANES * patch.points.len()),
            ahead: twist,
            restitution: patch.law.restitution,
            warm: false,
            swung: false,
            softness: 1.0,
            whole_weight: 0.0,
        };
        for (at_group, group) in patch.points.iter().enumerate() {
            for lane in (0..LANES).filter(|&lane| group.area[lane] > 0.0) {
                let at = motion.at(group.x[lane], group.y[lane]);
                let gap = at.z + group.held[lane];
                let mut offset = [0.0, 0.0, gap / if gap < 0.0 { push_out_s } else { h }];
                let mut gap_ahead = gap;
                if let Some(ahead) = ahead {
                    let then = ahead.at(group.x[lane], group.y[lane]);
                    let u = velocity(&twist, at.x, at.y);
                    offset[0] = (then.x - at.x) / h - u[0];
                    offset[1] = (then.y - at.y) / h - u[1];
                    offset[2] += (then.z - at.z) / h - u[2];
                    gap_ahead += then.z - at.z;
                }
                face.points.push(Point {
                    friction: group.friction[lane],
                    gap,
                    gap_ahead,
                    offset,
                    index: LANES * at_group + lane,
                    ..Point::at([at.x, at.y], group.area[lane])
                });
            }
        }
        // the mass above also presses, so that the joint stops more mass than that of its two stones
        let mass = 1.0 / (p.inverse_mass + s.inverse_mass) + above.at(motion.origin.z);
        face.whole_weight = HARDNESS * mass;
        face
    }

    /// Sets the weights of the active points; their sum is the weight of the face.
    pub(super) fn weigh(&mut self) {
        let near = |point: &&mut Point| point.part == Part::Near;
        let area: f64 = self.points.iter_mut().filter(near).map(|point| point.area).sum();
        let whole = self.whole_weight;
        for point in self.points.iter_mut().filter(near) {
            point.weight = whole * (point.area / area).max(WEIGHT_LEAST);
            point.shear_weight = match point.share < 0.0 {
                true => point.weight,
                false => (whole * point.share).max(SHEAR_LEAST * point.weight),
            };
        }
    }

    /// Twist of S relative to P at velocities of the bodies (ground: zeros), linear and angular.
    #[inline]
    pub(super) fn twist(&self, p: Option<&ForceTorque>, s: Option<&ForceTorque>) -> ForceTorque {
        let at = |velocity: Option<&ForceTorque>, arm: DVec3| {
            velocity.map_or((DVec3::ZERO, DVec3::ZERO), |v| {
                let spin = DVec3::new(v[3], v[4], v[5]);
                (DVec3::new(v[0], v[1], v[2]) + spin.cross(arm), spin)
            })
        };
        let ((v_p, spin_p), (v_s, spin_s)) = (at(p, self.arms[0]), at(s, self.arms[1]));
        let from_ground = self.to_ground.transpose();
        let (w, spin) = (from_ground * (v_s - v_p), from_ground * (spin_s - spin_p));
        [w.x, w.y, w.z, spin.x, spin.y, spin.z]
    }

    /// Twist of S relative to P at the velocities of all bodies.
    pub(super) fn twist_of(&self, velocity: &[ForceTorque]) -> ForceTorque {
        let at = |body: usize| (body > 0).then(|| &velocity[body]);
        self.twist(at(self.plane_body), at(self.point_body))
    }

    /// Impulses of the law at a twist, their sum on S, and their derivative.
    ///
    /// ```text
    /// p_n = max(λ_n − ϱ (u_n + s_n), 0),   p_t = λ_t − ϱ (u_t + s_t), limited to the disc of radius μ p_n
    /// ```
    ///
    /// `presume`: keep the points that pressed and slipped instead of evaluating the law, at the start of a solution.
    ///
    /// A point that would slip in alternating directions is stuck in the next Newton step. `swung` marks such a case, in which the sum is
    /// not that of the law.
    pub(super) fn contact_force(
        &mut self,
        twist: &ForceTorque,
        presume: bool,
        stiffness: Option<&mut Stiffness>,
    ) -> ForceTorque {
        let presume = presume && self.warm;
        self.swung = presume;
        let softness = self.softness;
        let wanted = stiffness.is_some();
        let (mut sum, mut k) = ([0.0; 6], [[0.0; 6]; 6]);
        for point in &mut self.points {
            if point.part == Part::Away {
                continue;
            }
            let (x, y, r, r_t) = (
                point.x,
                point.y,
                softness * point.weight,
                softness * point.shear_weight,
            );
            let u = velocity(twist, x, y);
            let way = [
                u[0] + point.offset[0],
                u[1] + point.offset[1],
                u[2] + point.offset[2],
            ];
            let trial = [
                point.held[0] - r_t * way[0],
                point.held[1] - r_t * way[1],
                point.held[2] - r * way[2],
            ];
            let presses = if presume {
                point.held[2] > 0.0
            } else {
                trial[2] > 0.0
            };
            let normal = if presses { trial[2] } else { 0.0 };
            let size = (trial[0] * trial[0] + trial[1] * trial[1]).sqrt();
            let limit = point.friction * normal.max(0.0);
            let slips = if presume { point.slid } else { size > limit };
            let along = if size > 0.0 {
                [trial[0] / size, trial[1] / size]
            } else {
                [0.0; 2]
            };
            let swings = wanted && slips && along[0] * point.along[0] + along[1] * point.along[1] < 0.0;
            let slips = slips && !swings;
            self.swung |= swings;
            if wanted {
                point.along = if slips { along } else { [0.0; 2] };
            }
            point.slips = slips;
            if !presses {
                point.impulse = [0.0; 3];
                continue;
            }
            // with presumed states, the radius of the disc is that of the stored impulse
            let radius = if presume {
                point.friction * point.held[2].max(0.0)
            } else {
                limit
            };
            point.impulse = match slips {
                true => {
                    let pull = if presume { point.friction * normal } else { limit };
                    [pull * along[0], pull * along[1], normal]
                }
                false => [trial[0], trial[1], normal],
            };
            add_wrench(&mut sum, x, y, &point.impulse);
            if !wanted {
                continue;
            }
            let (plane, follows) = match slips {
                true => {
                    let friction = if normal > 0.0 { point.friction } else { 0.0 };
                    let follows = [r * friction * along[0], r * friction * along[1]];
                    (slipping_plane(r_t * radius / size, along), Some(follows))
                }
                false => ([r_t, 0.0, r_t], None),
            };
            add_stiffness(&mut k, [x, y], plane, r, follows);
        }
        if let Some(stiffness) = stiffness {
            k[1][0] = k[0][1];
            k[5][0] = k[0][5];
            k[5][1] = k[1][5];
            k[3][2] = k[2][3];
            k[4][2] = k[2][4];
            k[4][3] = k[3][4];
            *stiffness = k;
        }
        sum
    }

    /// Deletes the stored directions of slip.
    pub(super) fn forget(&mut self) {
        for point in &mut self.points {
            point.along = [0.0; 2];
        }
    }

    /// Largest residual of the law at a point as a velocity, m/s: the change of the impulses by another update, over ϱ.
    pub(super) fn residual(&self) -> f64 {
        let near = self.points.iter().filter(|point| point.part == Part::Near);
        near.map(|point| {
            let change = |axis: usize| {
                let weight = if axis == 2 {
                    point.weight
                } else {
                    point.shear_weight
                };
                (point.impulse[axis] - point.held[axis]) / (self.softness * weight)
            };
            change(2).abs().max(change(0).hypot(change(1)))
        })
        .fold(0.0, f64::max)
    }

    /// Sum of the impulses on S.
    pub(super) fn wrench(&self) -> ForceTorque {
        let mut sum = [0.0; 6];
        for point in &self.points {
            add_wrench(&mut sum, point.x, point.y, &point.impulse);
        }
        sum
    }

    /// Replaces the offsets along the plane by the nearest rigid motion, weighted by the pressure. A rotation shortens the projection of a
    /// face, and sticking points would otherwise contradict each other.
    pub(super) fn rigid_offsets(&mut self) {
        let weight = |point: &Point| match (self.warm, point.part) {
            (true, _) => point.held[2],
            (false, Part::Near) => point.area,
            (false, Part::Away) => 0.0,
        };
        let (mut sum, mut mean) = (0.0, [0.0; 4]);
        for point in &self.points {
            let w = weight(point);
            sum += w;
            for (mean, value) in mean
                .iter_mut()
                .zip([point.x, point.y, point.offset[0], point.offset[1]])
            {
                *mean += w * value;
            }
        }
        if sum <= 0.0 {
            return;
        }
        let [x, y, along_x, along_y] = mean.map(|mean| mean / sum);
        let (mut turn, mut around) = (0.0, 0.0);
        for point in &self.points {
            let (w, dx, dy) = (weight(point), point.x - x, point.y - y);
            turn += w * (dx * (point.offset[1] - along_y) - dy * (point.offset[0] - along_x));
            around += w * (dx * dx + dy * dy);
        }
        let turn = if around > 0.0 { turn / around } else { 0.0 };
        for point in &mut self.points {
            point.offset[0] = along_x - turn * (point.y - y);
            point.offset[1] = along_y + turn * (point.x - x);
        }
    }

    /// Distributes an impulse on S over the near points: pressure as on a bed, and friction proportional to it.
    pub(super) fn hold(&mut self, wrench: &ForceTorque, bed: &mut [f64; 3]) {
        let near = |point: &&mut Point| point.part == Part::Near;
        if !fit_bed(&self.points, wrench, bed, HELD_NEAR) {
            return;
        }
        let (mut sum, mut at) = (0.0, [0.0; 2]);
        for point in self.points.iter_mut().filter(near) {
            point.held[2] = point.area * on_bed(bed, point);
            sum += point.held[2];
            at[0] += point.held[2] * point.x;
            at[1] += point.held[2] * point.y;
        }
        if sum <= 0.0 {
            return;
        }
        for point in self.points.iter_mut().filter(near) {
            point.share = point.held[2] / sum;
        }
        let at = at.map(|moment| moment / sum);
        let around: f64 = self
            .points
            .iter()
            .map(|point| point.held[2] * ((point.x - at[0]).powi(2) + (point.y - at[1]).powi(2)))
            .sum();
        let twist = wrench[5] - (at[0] * wrench[1] - at[1] * wrench[0]);
        let turn = if around > 0.0 { twist / around } else { 0.0 };
        for point in self.points.iter_mut().filter(near) {
            let part = [
                wrench[0] / sum - turn * (point.y - at[1]),
                wrench[1] / sum + turn * (point.x - at[0]),
            ];
            let size = part[0].hypot(part[1]);
            let keep = if size > point.friction {
                point.friction / size
            } else {
                1.0
            };
            point.held[0] = keep * part[0] * point.held[2];
            point.held[1] = keep * part[1] * point.held[2];
        }
        self.warm = true;
    }
}
