//! The springs law on a contact patch for several runs at once: as [`Patch::wrench`], point by point.

use super::super::outline::Outline;
use super::super::patch::{LANES, Patch, TINY};
use super::bodies::{BodyLanes, Load};
use super::lanes::{Columns, Mask, Real, Vector};
use glam::{DMat3, DVec3};
use pulp::Simd;

/// Repeats an expression for the four points of a group. A closure would not be compiled to vector instructions.
macro_rules! four {
    ($k:ident => $value:expr) => {
        [
            {
                let $k = 0;
                $value
            },
            {
                let $k = 1;
                $value
            },
            {
                let $k = 2;
                $value
            },
            {
                let $k = 3;
                $value
            },
        ]
    };
}

/// The bodies of a patch: index of its pair in the assembly, body of its plane, body of its points, and the available number of
/// groups of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    pub(super) pair: usize,
    pub(super) plane_body: usize,
    pub(super) point_body: usize,
    pub(super) groups: usize,
}

/// A contact point in several runs, with its state.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
struct PointLanes<S: Simd> {
    x: Real<S>,
    y: Real<S>,
    area: Real<S>,
    give: Real<S>,
    anchor_x: Real<S>,
    anchor_y: Real<S>,
    friction: Real<S>,
    held: Real<S>,
}

/// Orientation of the axes of a patch relative to the axes of its two bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Axes {
    /// No patch.
    None,
    /// Equal to both: a level joint in the plane of the stone below.
    Same,
    /// Half a rotation about the first axis: a level joint in the plane of the stone above.
    Turned,
    /// Any orientation.
    Any,
}

/// A patch of the same joint in each lane.
#[derive(Clone, Debug)]
pub(super) struct JointLanes<S: Simd> {
    pub(super) place: Place,
    axes: Vec<Axes>,
    /// Properties common to all lanes.
    all_axes: Axes,
    /// Whether a point in any run is held.
    holds: bool,
    /// Whether static and kinetic friction are equal in all runs.
    one_friction: bool,
    frame: FrameLanes<S>,
    points: Vec<PointLanes<S>>,
}

/// Positions of the plane and of the points on their bodies, contact law, and pose when the patch was clipped.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
struct FrameLanes<S: Simd> {
    plane_origin: Vector<S>,
    plane_axes: Columns<S>,
    point_origin: Vector<S>,
    point_x: Vector<S>,
    point_y: Vector<S>,
    normal_stiffness: Real<S>,
    shear_stiffness: Real<S>,
    normal_damping: Real<S>,
    shear_damping: Real<S>,
    friction_static: Real<S>,
    friction_kinetic: Real<S>,
    /// Shift, y component of the first axis, and z component of both axes when the patch was clipped.
    clipped_shift: Vector<S>,
    clipped_axes: [Real<S>; 3],
    size: Real<S>,
    shift_most: Real<S>,
    lean_most: Real<S>,
    /// 1 if the patch has drifted, otherwise 0.
    drifted: Real<S>,
}

impl<S: Simd> JointLanes<S> {
    /// A patch without effect in every lane.
    pub(super) fn idle(simd: S, place: Place) -> Self {
        let (zero, one) = (Real::all(simd, 0.0), Real::all(simd, 1.0));
        let nowhere = Vector::all(simd, DVec3::ZERO);
        let point = PointLanes {
            x: zero,
            y: zero,
            area: zero,
            give: zero,
            anchor_x: zero,
            anchor_y: zero,
            friction: zero,
            held: zero,
        };
        let frame = FrameLanes {
            plane_origin: nowhere,
            plane_axes: Columns::all(simd, DMat3::IDENTITY),
            point_origin: nowhere,
            point_x: Vector::all(simd, DVec3::X),
            point_y: Vector::all(simd, DVec3::Y),
            normal_stiffness: one,
            shear_stiffness: one,
            normal_damping: zero,
            shear_damping: zero,
            friction_static: zero,
            friction_kinetic: zero,
            clipped_shift: nowhere,
            clipped_axes: [zero; 3],
            size: zero,
            shift_most: Real::all(simd, f64::INFINITY),
            lean_most: Real::all(simd, f64::INFINITY),
            drifted: zero,
        };
        JointLanes {
            place,
            axes: vec![Axes::None; S::F64_LANES],
            all_axes: Axes::None,
            holds: false,
            one_friction: true,
            frame,
            points: vec![point; LANES * place.groups],
        }
    }

    /// Loads the patch of one run. It is examined again beyond `most`: shift in m, sine of the inclination.
    pub(super) fn load(&mut self, lane: usize, patch: &Patch, outline: &Outline, most: [f64; 2]) {
        let frame = &mut self.frame;
        frame.plane_origin.set(lane, patch.plane_origin);
        frame.plane_axes.set(lane, patch.plane_axes);
        frame.point_origin.set(lane, patch.point_origin);
        frame.point_x.set(lane, patch.point_axes.x_axis);
        frame.point_y.set(lane, patch.point_axes.y_axis);
        frame.normal_stiffness.set(lane, patch.law.normal_stiffness);
        frame.shear_stiffness.set(lane, patch.law.shear_stiffness);
        frame.normal_damping.set(lane, patch.law.normal_damping);
        frame.shear_damping.set(lane, patch.law.shear_damping);
        frame.friction_static.set(lane, patch.law.friction_static);
        frame.friction_kinetic.set(lane, patch.law.friction_kinetic);
        let then = &outline.clipped_at;
        frame.clipped_shift.set(lane, then.shift);
        let axes = [then.along_x.y, then.along_x.z, then.along_y.z];
        for (part, value) in frame.clipped_axes.iter_mut().zip(axes) {
            part.set(lane, value);
        }
        frame.size.set(lane, outline.size);
        frame.shift_most.set(lane, most[0]);
        frame.lean_most.set(lane, most[1]);
        frame.drifted.set(lane, 0.0);
        let same = [DMat3::IDENTITY, DMat3::from_diagonal(DVec3::new(1.0, -1.0, -1.0))]
            .map(|axes| patch.plane_axes == axes && patch.point_axes == axes);
        self.set_axes(
            lane,
            match same {
                [true, _] => Axes::Same,
                [_, true] => Axes::Turned,
                _ => Axes::Any,
            },
        );
        self.holds |= patch.holds;
        let frame = &self.frame;
        let apart = frame.friction_static - frame.friction_kinetic;
        self.one_friction = !apart.abs().above(Real::all(apart.0, 0.0)).any();
        for (index, point) in self.points.iter_mut().enumerate() {
            let (group, at) = (patch.points.get(index / LANES), index % LANES);
            let of = |value: Option<f64>| value.unwrap_or(0.0);
            point.x.set(lane, of(group.map(|g| g.x[at])));
            point.y.set(lane, of(group.map(|g| g.y[at])));
            point.area.set(lane, of(group.map(|g| g.area[at])));
            point.give.set(lane, of(group.map(|g| g.give[at])));
            point.anchor_x.set(lane, of(group.map(|g| g.anchor_x[at])));
            point.anchor_y.set(lane, of(group.map(|g| g.anchor_y[at])));
            point.friction.set(lane, of(group.map(|g| g.friction[at])));
            point.held.set(lane, of(group.map(|g| g.held[at])));
        }
    }

    /// Removes the patch of one run.
    pub(super) fn clear(&mut self, lane: usize) {
        for point in &mut self.points {
            point.area.set(lane, 0.0);
            point.give.set(lane, 0.0);
            point.held.set(lane, 0.0);
        }
        self.frame.shift_most.set(lane, f64::INFINITY);
        self.frame.lean_most.set(lane, f64::INFINITY);
        self.frame.drifted.set(lane, 0.0);
        self.set_axes(lane, Axes::None);
    }

    fn set_axes(&mut self, lane: usize, axes: Axes) {
        self.axes[lane] = axes;
        let both = |one: Axes, other: Axes| match (one, other) {
            (Axes::None, other) => other,
            (one, Axes::None) => one,
            (one, other) if one == other => one,
            _ => Axes::Any,
        };
        self.all_axes = self.axes.iter().copied().fold(Axes::None, both);
    }

    pub(super) fn has_drifted(&self, lane: usize) -> bool {
        self.frame.drifted.get(lane) != 0.0
    }

    /// Writes the state of the points of one run back to its patch.
    pub(super) fn unload(&self, lane: usize, patch: &mut Patch) {
        patch.holds = false;
        for (group, points) in patch.points.iter_mut().zip(self.points.chunks_exact(LANES)) {
            for (at, point) in points.iter().enumerate() {
                group.anchor_x[at] = point.anchor_x.get(lane);
                group.anchor_y[at] = point.anchor_y.get(lane);
                group.friction[at] = point.friction.get(lane);
                group.held[at] = point.held.get(lane);
                patch.holds |= group.held[at] > 0.0;
            }
        }
    }

    /// Adds the contact forces of a step to the loads of the two bodies. Returns the friction loss and the lanes in which the patch
    /// has drifted.
    #[inline(always)]
    pub(super) fn add_contact_forces(
        &mut self,
        bodies: &[BodyLanes<S>],
        loads: &mut [Load<S>],
        half_step: Real<S>,
    ) -> (Real<S>, Mask<S>) {
        let (p, s) = (&bodies[self.place.plane_body], &bodies[self.place.point_body]);
        match self.all_axes {
            Axes::None => {
                let zero = Real::all(half_step.0, 0.0);
                (zero, zero.above(zero))
            }
            Axes::Same => {
                let [x, y, _] = s.rotation.0;
                self.press_along(p.rotation, [x, y], bodies, loads, half_step)
            }
            Axes::Turned => {
                let ([a, b, c], [x, y, _]) = (p.rotation.0, s.rotation.0);
                self.press_along(Columns([a, -b, -c]), [x, -y], bodies, loads, half_step)
            }
            Axes::Any => {
                let frame = &self.frame;
                let along = [s.rotation * frame.point_x, s.rotation * frame.point_y];
                self.press_along(p.rotation * frame.plane_axes, along, bodies, loads, half_step)
            }
        }
    }

    /// As [`Self::add_contact_forces`], from the axes of the plane and the first two axes of the points, relative to the ground.
    #[inline(always)]
    fn press_along(
        &mut self,
        to_ground: Columns<S>,
        [x, y]: [Vector<S>; 2],
        bodies: &[BodyLanes<S>],
        loads: &mut [Load<S>],
        half_step: Real<S>,
    ) -> (Real<S>, Mask<S>) {
        let (p, s) = (&bodies[self.place.plane_body], &bodies[self.place.point_body]);
        let frame = &mut self.frame;
        let origin = p.position + p.rotation * frame.plane_origin;
        let along_x = to_ground.transposed_times(x);
        let along_y = to_ground.transposed_times(y);
        let shift = to_ground.transposed_times(s.position + s.rotation * frame.point_origin - origin);

        let moved = (shift - frame.clipped_shift).abs();
        let [xy, xz, yz] = frame.clipped_axes;
        let turned = (along_x.y - xy).abs() * frame.size;
        let leaned = (along_x.z - xz).abs().max((along_y.z - yz).abs());
        let far = (moved.x.max(moved.y) + turned).above(frame.shift_most);
        let drifted = far | leaned.above(frame.lean_most);
        frame.drifted = drifted.ones();

        let (arm_s, arm_p) = (origin - s.position, origin - p.position);
        let of_s = s.velocity + s.spin.cross(arm_s);
        let of_p = p.velocity + p.spin.cross(arm_p);
        let velocity = to_ground.transposed_times(of_s - of_p);
        let spin = to_ground.transposed_times(s.spin - p.spin);
        let motion = [along_x, along_y, shift, velocity, spin];
        let sums = if self.holds {
            let sums = self.sum_points::<true>(motion, half_step);
            let zero = Real::all(half_step.0, 0.0);
            let mut most = zero;
            for point in &self.points {
                most = most.max(point.held);
            }
            self.holds = most.above(zero).any();
            sums
        } else {
            self.sum_points::<false>(motion, half_step)
        };
        let [fx, fy, fz, mx, my, mz, rubbed] = sums;
        let force = to_ground * Vector { x: fx, y: fy, z: fz };
        let torque = to_ground * Vector { x: mx, y: my, z: mz };
        let s = &mut loads[self.place.point_body];
        s.force = s.force + force;
        s.torque = s.torque + (torque + arm_s.cross(force));
        let p = &mut loads[self.place.plane_body];
        p.force = p.force - force;
        p.torque = p.torque - (torque + arm_p.cross(force));
        (rubbed, drifted)
    }

    #[inline(always)]
    fn sum_points<const HELD: bool>(&mut self, motion: [Vector<S>; 5], half_step: Real<S>) -> [Real<S>; 7] {
        let one_friction = self.one_friction;
        let (groups, _) = self.points.as_chunks_mut::<LANES>();
        let [tx, ty, normal, about_x, about_y, about_z, rubbed] = if let [group] = groups {
            press_group::<S, HELD>(&self.frame, one_friction, group, motion, half_step)
        } else {
            let mut sums = [[Real::all(half_step.0, 0.0); LANES]; 7];
            for group in groups {
                let of_group = press_group::<S, HELD>(&self.frame, one_friction, group, motion, half_step);
                for (sums, of_group) in sums.iter_mut().zip(of_group) {
                    for (sum, of_point) in sums.iter_mut().zip(of_group) {
                        *sum = *sum + of_point;
                    }
                }
            }
            sums
        };
        [
            -total(tx),
            -total(ty),
            total(normal),
            total(about_x),
            -total(about_y),
            total(about_z),
            total(rubbed),
        ]
    }
}

/// The law at four points: shear along the two axes, pressure, moments about the three axes (the second with the opposite sign),
/// and friction loss.
///
/// The four points are processed stage by stage: while one point waits for its operands, the processor continues with another.
#[inline(always)]
fn press_group<S: Simd, const HELD: bool>(
    frame: &FrameLanes<S>,
    one_friction: bool,
    points: &mut [PointLanes<S>; LANES],
    [a, b, c, w, o]: [Vector<S>; 5],
    half_step: Real<S>,
) -> [[Real<S>; LANES]; 7] {
    let all = |value: f64| Real::all(half_step.0, value);
    let (zero, one, tiny) = (all(0.0), all(1.0), all(TINY));
    let (kn, cn) = (frame.normal_stiffness, frame.normal_damping);
    let (ks, cs) = (frame.shear_stiffness, frame.shear_damping);
    let (friction_static, friction_kinetic) = (frame.friction_static, frame.friction_kinetic);
    let x = four!(k => a.x * points[k].x + b.x * points[k].y + c.x);
    let y = four!(k => a.y * points[k].x + b.y * points[k].y + c.y);
    let z = four!(k => a.z * points[k].x + b.z * points[k].y + c.z);
    let depth = four!(k => {
        if HELD {
            points[k].held = z[k].at_least(zero).select(zero, points[k].held);
            -(z[k] + points[k].held)
        } else {
            -z[k]
        }
    });
    let closing = four!(k => (o.y * x[k] - o.x * y[k]) - w.z);
    let half = four!(k => closing[k].abs() * half_step);
    let deepest = four!(k => depth[k] + half[k]);
    let touches = four!(k => deepest[k].above(zero));
    let whole = four!(k => depth[k].at_least(half[k]));
    let mut mean = four!(k => whole[k].select(depth[k], zero));
    let mut part = four!(k => whole[k].select(one, zero));
    let meets = four!(k => touches[k].and(!whole[k]));
    for k in 0..LANES {
        if meets[k].any() {
            let (into, way) = (deepest[k].max(zero), half[k] + half[k] + tiny);
            let inside = into / way;
            mean[k] = meets[k].select(all(0.5) * into * inside, mean[k]);
            part[k] = meets[k].select(inside, part[k]);
        }
    }
    let normal = four!(k => {
        let pressed = kn * mean[k] + part[k] * cn * closing[k];
        points[k].area * pressed.max(zero)
    });

    let vx = four!(k => w.x + (o.y * z[k] - o.z * y[k]));
    let vy = four!(k => w.y + (o.z * x[k] - o.x * z[k]));
    let stiff = four!(k => touches[k].select(points[k].area * ks, zero));
    let mut fx = four!(k => stiff[k] * (x[k] - points[k].anchor_x));
    let mut fy = four!(k => stiff[k] * (y[k] - points[k].anchor_y));
    let friction = match one_friction {
        true => [friction_static; LANES],
        false => four!(k => points[k].friction),
    };
    let limit = four!(k => friction[k] * normal[k]);
    let square = four!(k => limit[k] * limit[k]);
    let size = four!(k => fx[k] * fx[k] + fy[k] * fy[k]);
    let slips = four!(k => size[k].above(square[k]));
    for k in 0..LANES {
        if slips[k].any() {
            let keep = slips[k].select(limit[k] / size[k].sqrt(), one);
            (fx[k], fy[k]) = (fx[k] * keep, fy[k] * keep);
        }
    }
    let mut rubbed = [zero; LANES];
    let moves = four!(k => slips[k] | !touches[k]);
    for k in 0..LANES {
        if moves[k].any() {
            let (before_x, before_y) = (points[k].anchor_x, points[k].anchor_y);
            let anchor_x = moves[k].select(x[k] - fx[k] * points[k].give, before_x);
            let anchor_y = moves[k].select(y[k] - fy[k] * points[k].give, before_y);
            rubbed[k] = fx[k] * (anchor_x - before_x) + fy[k] * (anchor_y - before_y);
            (points[k].anchor_x, points[k].anchor_y) = (anchor_x, anchor_y);
        }
    }
    if !one_friction {
        for k in 0..LANES {
            points[k].friction = slips[k].select(friction_kinetic, friction_static);
        }
    }
    let drag = four!(k => touches[k].select(points[k].area * cs, zero));
    let mut tx = four!(k => fx[k] + drag[k] * vx[k]);
    let mut ty = four!(k => fy[k] + drag[k] * vy[k]);
    let size = four!(k => tx[k] * tx[k] + ty[k] * ty[k]);
    let over = four!(k => size[k].above(square[k]));
    for k in 0..LANES {
        if over[k].any() {
            let keep = over[k].select(limit[k] / size[k].sqrt(), one);
            (tx[k], ty[k]) = (tx[k] * keep, ty[k] * keep);
        }
    }
    [
        tx,
        ty,
        normal,
        four!(k => y[k] * normal[k] + z[k] * ty[k]),
        four!(k => z[k] * tx[k] + x[k] * normal[k]),
        four!(k => y[k] * tx[k] - x[k] * ty[k]),
        rubbed,
    ]
}

/// Sums in the same order as a single run.
#[inline(always)]
fn total<S: Simd>([a, b, c, d]: [Real<S>; LANES]) -> Real<S> {
    (a + b) + (c + d)
}
