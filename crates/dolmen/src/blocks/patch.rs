//! The springs law on the points of one contact patch.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | P, S | `plane_body`, `point_body` | the body with the contact plane, the body with the contact points | – |
//! | y = A s + b | `Motion` | position of point s in the frame of P's plane, normal last | m |
//! | w, Ω | `twist` | velocity of S relative to P at the frame's origin, and its spin, in that frame | m/s, rad/s |
//! | a | `area` | tributary area of a point | m² |
//! | k_n, k_s | `normal_stiffness`, `shear_stiffness` | springs per area | Pa/m |
//! | c_n, c_s | `normal_damping`, `shear_damping` | dashpots per area | Pa s/m |
//! | u | `y − anchor` | stretch of the shear spring | m |
//! | μ | `friction` | current coefficient: static until a point slips, kinetic while it slips | – |

use super::bodies::RigidBody;
use super::crushing::Strength;
use crate::structure::stack::JointMaterial;
use glam::{DMat3, DVec2, DVec3};
use wide::f64x4;

/// Number of points computed together, so that the compiler uses vector instructions.
pub(super) const LANES: usize = 4;
/// Prevents division by zero in a motionless contact, m. Our choice: far below any penetration.
pub(super) const TINY: f64 = 1e-300;

/// Four points with their state.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Points {
    pub(super) x: [f64; LANES],
    pub(super) y: [f64; LANES],
    pub(super) area: [f64; LANES],
    /// 1 / (a k_s); 0 for points without area.
    pub(super) give: [f64; LANES],
    pub(super) anchor_x: [f64; LANES],
    pub(super) anchor_y: [f64; LANES],
    /// Depth below which a point has no force, m. It is 0 except for points that were added while their faces overlapped, until
    /// they open.
    pub(super) held: [f64; LANES],
    pub(super) friction: [f64; LANES],
    /// 1 while the bond is intact, 0 after it broke or without bond.
    pub(super) bond: [f64; LANES],
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Law {
    pub(super) normal_stiffness: f64,
    pub(super) shear_stiffness: f64,
    pub(super) normal_damping: f64,
    pub(super) shear_damping: f64,
    pub(super) friction_static: f64,
    pub(super) friction_kinetic: f64,
    pub(super) cohesion: f64,
    pub(super) tension: f64,
    pub(super) restitution: Restitution,
    pub(super) strength: Strength,
}

/// Restitution of a joint in an impact.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Restitution {
    /// For faces that were apart before.
    pub(super) falls: f64,
    /// For a stone that rocks from edge to edge; `None`: that of an impact at the edge.
    pub(super) rocks: Option<f64>,
}

impl Law {
    /// The law of a joint, with dashpots from the damping ratio of the two bodies on its springs alone.
    ///
    /// ```text
    /// c = 2 ζ √(k A m) / A,   m = 1 / (1/m_P + 1/m_S)
    /// ```
    pub(super) fn of(material: &JointMaterial, area: f64, inverse_mass: f64) -> Self {
        let damping =
            |stiffness: f64| 2.0 * material.damping_ratio * (stiffness / (area * inverse_mass)).sqrt();
        Law {
            normal_stiffness: material.normal_stiffness_pa_m,
            shear_stiffness: material.shear_stiffness_pa_m,
            normal_damping: damping(material.normal_stiffness_pa_m),
            shear_damping: damping(material.shear_stiffness_pa_m),
            friction_static: material.friction_static,
            friction_kinetic: material.friction_kinetic,
            cohesion: material.cohesion_pa,
            tension: material.tension_pa,
            restitution: Restitution {
                falls: material.normal_restitution,
                rocks: material.rocking_restitution,
            },
            strength: Strength::default(),
        }
    }

    /// The law without bond, for new faces.
    pub(super) fn dry(self) -> Self {
        Law {
            cohesion: 0.0,
            tension: 0.0,
            ..self
        }
    }

    pub(super) fn bonds(&self) -> bool {
        self.cohesion > 0.0 || self.tension > 0.0
    }
}

/// A plane of one body and points of another in contact with it.
#[derive(Clone, Debug)]
pub(super) struct Patch {
    pub(super) plane_body: usize,
    pub(super) point_body: usize,
    /// Origin of the plane's frame, from the centroid of P, in the axes as drawn.
    pub(super) plane_origin: DVec3,
    /// Frame of the plane in P: two axes in the plane, then the normal out of P.
    pub(super) plane_axes: DMat3,
    /// Origin of the points' frame, from the centroid of S, in the axes as drawn.
    pub(super) point_origin: DVec3,
    /// Frame of the points in S, which lie in the plane of its first two axes.
    pub(super) point_axes: DMat3,
    pub(super) law: Law,
    pub(super) points: Vec<Points>,
    /// Whether any point has a held depth.
    pub(super) holds: bool,
}

/// Energy in the springs of a patch, J.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Stored {
    pub(super) normal: f64,
    pub(super) shear: f64,
}

impl Stored {
    pub(super) fn sum(self) -> f64 {
        self.normal + self.shear
    }
}

/// Pose of the points' frame in the plane's frame, and its motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion {
    /// From the frame of the plane to the axes of the ground.
    pub(super) to_ground: DMat3,
    pub(super) origin: DVec3,
    /// y = along_x s_x + along_y s_y + shift.
    pub(super) along_x: DVec3,
    pub(super) along_y: DVec3,
    pub(super) shift: DVec3,
}

/// Relative velocity at the origin of the plane's frame and relative spin, in that frame.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Twist {
    pub(super) velocity: DVec3,
    pub(super) spin: DVec3,
}

/// Force and torque of a patch on S, in the plane's frame about its origin; P receives the opposite.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Wrench {
    pub(super) force: DVec3,
    pub(super) torque: DVec3,
    /// Energy dissipated by friction and by breaking bonds in the step, J.
    pub(super) friction_loss: f64,
}

impl Motion {
    /// Present position of a point of S in the plane's frame.
    pub(super) fn at(&self, x: f64, y: f64) -> DVec3 {
        self.along_x * x + self.along_y * y + self.shift
    }

    /// Place in the frame of the points of a point of the plane, projected along the normal of the plane.
    pub(super) fn lifted(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (a, b) = (self.along_x, self.along_y);
        let determinant = a.x * b.y - b.x * a.y;
        let (x, y) = (x - self.shift.x, y - self.shift.y);
        [
            (b.y * x - b.x * y) / determinant,
            (a.x * y - a.y * x) / determinant,
        ]
    }
}

impl Patch {
    /// Present pose of S in the frame of P's plane.
    #[inline]
    pub(super) fn motion(&self, bodies: &[RigidBody]) -> Motion {
        self.motion_between(&bodies[self.plane_body], &bodies[self.point_body])
    }

    /// As [`Patch::motion`], from the two bodies themselves.
    #[inline]
    pub(super) fn motion_between(&self, p: &RigidBody, s: &RigidBody) -> Motion {
        let to_ground = p.rotation * self.plane_axes;
        let origin = p.position + p.rotation * self.plane_origin;
        let from_ground = to_ground.transpose();
        Motion {
            to_ground,
            origin,
            along_x: from_ground * (s.rotation * self.point_axes.x_axis),
            along_y: from_ground * (s.rotation * self.point_axes.y_axis),
            shift: from_ground * (s.position + s.rotation * self.point_origin - origin),
        }
    }

    /// Motion of S relative to P.
    #[inline]
    pub(super) fn twist(&self, bodies: &[RigidBody], motion: &Motion) -> Twist {
        let (p, s) = (&bodies[self.plane_body], &bodies[self.point_body]);
        let of_s = s.velocity + s.spin.cross(motion.origin - s.position);
        let of_p = p.velocity + p.spin.cross(motion.origin - p.position);
        let from_ground = motion.to_ground.transpose();
        Twist {
            velocity: from_ground * (of_s - of_p),
            spin: from_ground * (s.spin - p.spin),
        }
    }

    /// Forces of the springs, friction and dashpots over a step of `h` seconds. Updates slips and broken bonds.
    #[inline]
    pub(super) fn wrench(&mut self, motion: &Motion, twist: &Twist, h: f64) -> Wrench {
        if self.holds {
            self.let_go(motion);
        }
        let (points, law) = (&mut self.points, &self.law);
        match (law.bonds(), self.holds) {
            (true, true) => wrench_of_points::<true, true>(points, law, motion, twist, h),
            (true, false) => wrench_of_points::<true, false>(points, law, motion, twist, h),
            (false, true) => wrench_of_points::<false, true>(points, law, motion, twist, h),
            (false, false) => wrench_of_points::<false, false>(points, law, motion, twist, h),
        }
    }

    /// Current position of a point in the plane's frame, with the effective depth of its spring.
    pub(super) fn place(&self, group: &Points, lane: usize, motion: &Motion) -> DVec3 {
        motion.at(group.x[lane], group.y[lane]) + DVec3::Z * group.held[lane]
    }

    /// Energy stored in the springs.
    pub(super) fn stored(&self, motion: &Motion) -> Stored {
        let mut stored = Stored::default();
        for group in &self.points {
            for lane in 0..LANES {
                let at = self.place(group, lane, motion);
                let (ux, uy) = (at.x - group.anchor_x[lane], at.y - group.anchor_y[lane]);
                if at.z < 0.0 || group.bond[lane] > 0.0 {
                    stored.normal += 0.5 * group.area[lane] * self.law.normal_stiffness * at.z * at.z;
                    stored.shear += 0.5 * group.area[lane] * self.law.shear_stiffness * (ux * ux + uy * uy);
                }
            }
        }
        stored
    }

    /// Force of one point on S at rest, in the plane's frame, N; `at` is the position of the point.
    pub(super) fn force_at_rest(&self, group: &Points, lane: usize, at: DVec3) -> DVec3 {
        let bonded = group.bond[lane] > 0.0;
        if at.z >= 0.0 && !bonded {
            return DVec3::ZERO;
        }
        let area = group.area[lane];
        let normal = area * self.law.normal_stiffness * -at.z;
        let stretch = DVec2::new(at.x - group.anchor_x[lane], at.y - group.anchor_y[lane]);
        let hold = if bonded { area * self.law.cohesion } else { 0.0 };
        let shear = stretch * (area * self.law.shear_stiffness);
        let shear = shear.clamp_length_max(group.friction[lane] * normal.max(0.0) + hold);
        DVec3::new(-shear.x, -shear.y, normal)
    }

    /// Normal force of all points at rest, N.
    pub(super) fn normal_at_rest_n(&self, bodies: &[RigidBody]) -> f64 {
        let motion = self.motion(bodies);
        let groups = self.points.iter();
        let each = groups.flat_map(|group| (0..LANES).map(move |lane| (group, lane)));
        each.map(|(group, lane)| {
            let at = self.place(group, lane, &motion);
            self.force_at_rest(group, lane, at).z
        })
        .sum()
    }

    /// Limits the energy of new points to that of the old ones by reducing depths and stretches. The removed depth has no force
    /// until the point opens, like an error of its position.
    ///
    /// ```text
    /// held = (1 − f) δ,   f² = allowed normal energy / normal energy at depth δ;   the same for the stretch
    /// ```
    pub(super) fn hold_at_most(&mut self, motion: &Motion, most: Stored) {
        for group in &mut self.points {
            group.held = [0.0; LANES];
        }
        self.holds = false;
        let now = self.stored(motion);
        let part = |most: f64, now: f64| if now > most { (most / now).sqrt() } else { 1.0 };
        let (deep, stretched) = (part(most.normal, now.normal), part(most.shear, now.shear));
        for group in &mut self.points {
            for lane in 0..LANES {
                let at = motion.at(group.x[lane], group.y[lane]);
                if deep < 1.0 && at.z < 0.0 && group.bond[lane] == 0.0 {
                    group.held[lane] = (deep - 1.0) * at.z;
                    self.holds = true;
                }
                group.anchor_x[lane] = at.x + stretched * (group.anchor_x[lane] - at.x);
                group.anchor_y[lane] = at.y + stretched * (group.anchor_y[lane] - at.y);
            }
        }
    }

    /// Removes the limit from points that have opened.
    fn let_go(&mut self, motion: &Motion) {
        self.holds = false;
        for group in &mut self.points {
            for lane in 0..LANES {
                if motion.at(group.x[lane], group.y[lane]).z >= 0.0 {
                    group.held[lane] = 0.0;
                }
                self.holds |= group.held[lane] > 0.0;
            }
        }
    }

    /// Sets every anchor to the present position of its point, so that shear springs have no stretch.
    pub(super) fn unstretch(&mut self, motion: &Motion) {
        for group in &mut self.points {
            for lane in 0..LANES {
                let at = motion.at(group.x[lane], group.y[lane]);
                group.anchor_x[lane] = at.x;
                group.anchor_y[lane] = at.y;
            }
        }
    }
}

/// The law for each point.
///
/// ```text
/// penetration   δ = −y_z (0 as drawn),   its mean over the step at velocity v: δ̄ = ∫ max(δ + v τ, 0) dτ / h, and the
///               fraction φ of the step in contact: the moment of impact is located inside the step; τ from −h/2 to h/2
/// pressure      N = a (k_n δ̄ + φ c_n v), not below 0, or −a × tension while bonded
/// spring        E = a k_s u in contact, limited to the disc |E| ≤ μN (+ a × cohesion while bonded); if it is limited, its
///               anchor moves, and the energy lost by the spring is the work of friction
/// shear         T = −(E + a c_s v_t), limited to the same disc
/// ```
fn wrench_of_points<const BOND: bool, const HELD: bool>(
    points: &mut [Points],
    law: &Law,
    motion: &Motion,
    twist: &Twist,
    h: f64,
) -> Wrench {
    let all = f64x4::splat;
    let [ax, ay, az] = in_all_lanes(motion.along_x);
    let [bx, by, bz] = in_all_lanes(motion.along_y);
    let [cx, cy, cz] = in_all_lanes(motion.shift);
    let [wx, wy, wz] = in_all_lanes(twist.velocity);
    let [ox, oy, oz] = in_all_lanes(twist.spin);
    let half_step = all(0.5 * h);
    let mut sums = [f64x4::ZERO; 7];
    for group in points {
        let (sx, sy, area) = (f64x4::new(group.x), f64x4::new(group.y), f64x4::new(group.area));
        let x = ax * sx + bx * sy + cx;
        let y = ay * sx + by * sy + cy;
        let z = az * sx + bz * sy + cz;
        let closing = -(wz + (ox * y - oy * x));
        let depth = if HELD { -(z + f64x4::new(group.held)) } else { -z };
        let Some(pressed) = press::<BOND>(law, group, depth, closing, half_step) else {
            (group.anchor_x, group.anchor_y) = (x.to_array(), y.to_array()); // all points are open
            group.friction = [law.friction_static; LANES];
            continue;
        };
        let normal = pressed.normal;
        let across = [wx + (oy * z - oz * y), wy + (oz * x - ox * z)];
        let rubbed = rub::<BOND>(law, group, &pressed, [x, y], across);
        let [tx, ty] = rubbed.force;
        if BOND {
            let bonded = f64x4::new(group.bond).simd_gt(f64x4::ZERO);
            let stays = pressed.holds & !rubbed.slips;
            let broken = bonded & !stays;
            group.bond = (stays & f64x4::ONE).to_array();
            let kn = all(law.normal_stiffness);
            sums[6] += broken & z.simd_gt(f64x4::ZERO) & (all(0.5) * area * kn * z * z);
        }
        sums[0] -= tx;
        sums[1] -= ty;
        sums[2] += normal;
        sums[3] += y * normal + z * ty;
        sums[4] -= z * tx + x * normal;
        sums[5] += y * tx - x * ty;
        sums[6] += rubbed.work;
    }
    // always in this order, for equal bits on every machine
    let [fx, fy, fz, mx, my, mz, rubbed] = sums.map(|lanes| {
        let [a, b, c, d] = lanes.to_array();
        (a + b) + (c + d)
    });
    Wrench {
        force: DVec3::new(fx, fy, fz),
        torque: DVec3::new(mx, my, mz),
        friction_loss: rubbed,
    }
}

#[inline(always)]
fn in_all_lanes(vector: DVec3) -> [f64x4; 3] {
    [
        f64x4::splat(vector.x),
        f64x4::splat(vector.y),
        f64x4::splat(vector.z),
    ]
}

/// Contact of four points normal to the plane; masks have all bits of a lane set.
struct Pressed {
    /// Mask: the point is in contact in some part of the step, or bonded.
    touches: f64x4,
    /// Mask: its bond holds this pressure.
    holds: f64x4,
    /// Normal force, N.
    normal: f64x4,
}

/// Normal forces; `None` if all four points are open, without bond.
#[inline(always)]
fn press<const BOND: bool>(
    law: &Law,
    group: &Points,
    depth: f64x4,
    closing: f64x4,
    half_step: f64x4,
) -> Option<Pressed> {
    let all = f64x4::splat;
    let (zero, one, tiny) = (f64x4::ZERO, f64x4::ONE, all(TINY));
    let (kn, cn) = (all(law.normal_stiffness), all(law.normal_damping));
    let half = closing.abs() * half_step;
    let deepest = depth + half;
    let mut touches = deepest.simd_gt(zero);
    if !BOND && !touches.any() {
        return None;
    }
    let whole = depth.simd_ge(half);
    let (mut mean, mut part) = (whole & depth, whole & one);
    let meets = touches & !whole;
    if meets.any() {
        let (into, way) = (deepest.fast_max(zero), half + half + tiny);
        let inside = into / way;
        mean = meets.select(all(0.5) * into * inside, mean);
        part = meets.select(inside, part);
    }
    let bonded = f64x4::new(group.bond).simd_gt(zero);
    let mut holds = zero;
    if BOND {
        mean = bonded.select(depth, mean);
        part = bonded.select(one, part);
        touches |= bonded;
        holds = bonded & (kn * depth).simd_ge(all(-law.tension));
    }
    let pressed = kn * mean + part * cn * closing;
    let mut pressure = pressed.fast_max(zero);
    if BOND {
        let lost = bonded & !holds;
        pressure = holds.select(pressed.fast_max(all(-law.tension)), pressure);
        pressure = lost.select(zero, pressure);
    }
    Some(Pressed {
        touches,
        holds,
        normal: f64x4::new(group.area) * pressure,
    })
}

/// Friction of four points in the plane.
struct Rubbed {
    /// Force of shear spring and dashpot, N.
    force: [f64x4; 2],
    /// Mask: the spring was limited to the disc.
    slips: f64x4,
    work: f64x4,
}

/// Shear forces of four points at a position with a velocity in the plane. Updates their anchors and friction.
#[inline(always)]
fn rub<const BOND: bool>(
    law: &Law,
    group: &mut Points,
    pressed: &Pressed,
    [x, y]: [f64x4; 2],
    [vx, vy]: [f64x4; 2],
) -> Rubbed {
    let all = f64x4::splat;
    let (zero, one, area) = (f64x4::ZERO, f64x4::ONE, f64x4::new(group.area));
    let touches = pressed.touches;
    let (before_x, before_y) = (f64x4::new(group.anchor_x), f64x4::new(group.anchor_y));
    let stiff = touches & (area * all(law.shear_stiffness));
    let (ex, ey) = (stiff * (x - before_x), stiff * (y - before_y));
    let mut limit = f64x4::new(group.friction) * pressed.normal.fast_max(zero);
    if BOND {
        limit += pressed.holds & (area * all(law.cohesion));
    }
    let square = limit * limit;
    let size = ex * ex + ey * ey;
    let slips = size.simd_gt(square);
    let (mut fx, mut fy) = (ex, ey);
    if slips.any() {
        let keep = slips.select(limit / size.sqrt(), one);
        (fx, fy) = (ex * keep, ey * keep);
    }
    let give = f64x4::new(group.give);
    let moves = slips | !touches;
    let anchor_x = moves.select(x - fx * give, before_x);
    let anchor_y = moves.select(y - fy * give, before_y);
    // work of the limited force: the excess in the step never acts on the stones
    let work = fx * (anchor_x - before_x) + fy * (anchor_y - before_y);
    let drag = touches & (area * all(law.shear_damping));
    let (mut tx, mut ty) = (fx + drag * vx, fy + drag * vy);
    let size = tx * tx + ty * ty;
    let over = size.simd_gt(square);
    if over.any() {
        let keep = over.select(limit / size.sqrt(), one);
        (tx, ty) = (tx * keep, ty * keep);
    }
    (group.anchor_x, group.anchor_y) = (anchor_x.to_array(), anchor_y.to_array());
    group.friction = slips
        .select(all(law.friction_kinetic), all(law.friction_static))
        .to_array();
    Rubbed {
        force: [tx, ty],
        slips,
        work,
    }
}
