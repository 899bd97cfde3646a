//! The springs law on a contact patch for several runs at once: as [`Patch::press`], point by point.

use super::super::outline::Outline;
use super::super::patch::{LANES, Patch, TINY};
use super::bodies::BodyLanes;
use super::lanes::{Columns, Mask, Real, Vector};
use glam::{DMat3, DVec3};
use pulp::Simd;

/// Which bodies a patch joins: its place among the pairs of the assembly, the body of its plane, that of its points, and
/// how many groups of points there is room for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    pub(super) pair: usize,
    pub(super) plane_body: usize,
    pub(super) point_body: usize,
    pub(super) groups: usize,
}

/// A point of several runs, with its memory.
#[derive(Clone, Copy, Debug)]
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

/// The same patch of several runs.
#[derive(Clone, Debug)]
pub(super) struct JointLanes<S: Simd> {
    pub(super) place: Place,
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
    /// Shift, y of the first axis, z of both, when the patch was clipped.
    clipped_shift: Vector<S>,
    clipped_axes: [Real<S>; 3],
    size: Real<S>,
    shift_most: Real<S>,
    lean_most: Real<S>,
    /// 1 where the patch has drifted, else 0.
    pub(super) drifted: Real<S>,
    /// Whether a point of any run is held.
    holds: bool,
    points: Vec<PointLanes<S>>,
}

impl<S: Simd> JointLanes<S> {
    /// Without effect in every lane.
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
        JointLanes {
            place,
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
            holds: false,
            points: vec![point; LANES * place.groups],
        }
    }

    /// The patch of one run; it looks again beyond `most`, shift in m and lean as sine.
    pub(super) fn load(&mut self, lane: usize, patch: &Patch, outline: &Outline, most: [f64; 2]) {
        self.plane_origin.set(lane, patch.plane_origin);
        self.plane_axes.set(lane, patch.plane_axes);
        self.point_origin.set(lane, patch.point_origin);
        self.point_x.set(lane, patch.point_axes.x_axis);
        self.point_y.set(lane, patch.point_axes.y_axis);
        self.normal_stiffness.set(lane, patch.law.normal_stiffness);
        self.shear_stiffness.set(lane, patch.law.shear_stiffness);
        self.normal_damping.set(lane, patch.law.normal_damping);
        self.shear_damping.set(lane, patch.law.shear_damping);
        self.friction_static.set(lane, patch.law.friction_static);
        self.friction_kinetic.set(lane, patch.law.friction_kinetic);
        let then = &outline.clipped_at;
        self.clipped_shift.set(lane, then.shift);
        let axes = [then.along_x.y, then.along_x.z, then.along_y.z];
        for (part, value) in self.clipped_axes.iter_mut().zip(axes) {
            part.set(lane, value);
        }
        self.size.set(lane, outline.size);
        self.shift_most.set(lane, most[0]);
        self.lean_most.set(lane, most[1]);
        self.holds |= patch.holds;
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

    /// Takes the patch of one run away.
    pub(super) fn clear(&mut self, lane: usize) {
        for point in &mut self.points {
            point.area.set(lane, 0.0);
            point.give.set(lane, 0.0);
            point.held.set(lane, 0.0);
        }
        self.shift_most.set(lane, f64::INFINITY);
        self.lean_most.set(lane, f64::INFINITY);
        self.drifted.set(lane, 0.0);
    }

    /// What the points of one run remember.
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

    /// Adds the forces of a step to the two bodies; what friction took, and where the patch has drifted.
    #[inline(always)]
    pub(super) fn press(&mut self, bodies: &mut [BodyLanes<S>], half_step: Real<S>) -> (Real<S>, Mask<S>) {
        let (p, s) = (&bodies[self.place.plane_body], &bodies[self.place.point_body]);
        let to_ground = p.rotation * self.plane_axes;
        let origin = p.position + p.rotation * self.plane_origin;
        let along_x = to_ground.transposed_times(s.rotation * self.point_x);
        let along_y = to_ground.transposed_times(s.rotation * self.point_y);
        let shift = to_ground.transposed_times(s.position + s.rotation * self.point_origin - origin);

        let moved = (shift - self.clipped_shift).abs();
        let [xy, xz, yz] = self.clipped_axes;
        let turned = (along_x.y - xy).abs() * self.size;
        let leaned = (along_x.z - xz).abs().max((along_y.z - yz).abs());
        let far = (moved.x.max(moved.y) + turned).above(self.shift_most);
        let drifted = far | leaned.above(self.lean_most);
        self.drifted = drifted.ones();

        let (arm_s, arm_p) = (origin - s.position, origin - p.position);
        let of_s = s.velocity + s.spin.cross(arm_s);
        let of_p = p.velocity + p.spin.cross(arm_p);
        let velocity = to_ground.transposed_times(of_s - of_p);
        let spin = to_ground.transposed_times(s.spin - p.spin);
        let motion = [along_x, along_y, shift, velocity, spin];
        let sums = if self.holds {
            let sums = self.sum_points::<true>(motion, half_step);
            self.holds = self.points.iter().any(|point| point.held.lanes().iter().any(|held| *held > 0.0));
            sums
        } else {
            self.sum_points::<false>(motion, half_step)
        };
        let [fx, fy, fz, mx, my, mz, rubbed] = sums;
        let force = to_ground * Vector { x: fx, y: fy, z: fz };
        let torque = to_ground * Vector { x: mx, y: my, z: mz };
        let s = &mut bodies[self.place.point_body];
        s.force = s.force + force;
        s.torque = s.torque + (torque + arm_s.cross(force));
        let p = &mut bodies[self.place.plane_body];
        p.force = p.force - force;
        p.torque = p.torque - (torque + arm_p.cross(force));
        (rubbed, drifted)
    }

    #[inline(always)]
    fn sum_points<const HELD: bool>(&mut self, motion: [Vector<S>; 5], half_step: Real<S>) -> [Real<S>; 7] {
        let [a, b, c, w, o] = motion;
        let all = |value: f64| Real::all(half_step.0, value);
        let (zero, one, tiny) = (all(0.0), all(1.0), all(TINY));
        let (kn, cn) = (self.normal_stiffness, self.normal_damping);
        let (ks, cs) = (self.shear_stiffness, self.shear_damping);
        let mut sums = [[zero; 7]; LANES];
        for group in self.points.chunks_exact_mut(LANES) {
            for (point, sum) in group.iter_mut().zip(&mut sums) {
                let x = a.x * point.x + b.x * point.y + c.x;
                let y = a.y * point.x + b.y * point.y + c.y;
                let z = a.z * point.x + b.z * point.y + c.z;
                let closing = -(w.z + (o.x * y - o.y * x));
                let depth = if HELD {
                    point.held = z.at_least(zero).select(zero, point.held);
                    -(z + point.held)
                } else {
                    -z
                };
                let half = closing.abs() * half_step;
                let deepest = depth + half;
                let touches = deepest.above(zero);
                let whole = depth.at_least(half);
                let (mut mean, mut part) = (whole.select(depth, zero), whole.select(one, zero));
                let meets = touches.and(!whole);
                if meets.any() {
                    let (into, way) = (deepest.max(zero), half + half + tiny);
                    let inside = into / way;
                    mean = meets.select(all(0.5) * into * inside, mean);
                    part = meets.select(inside, part);
                }
                let spring = kn * mean;
                let pressed = spring + part * cn * closing;
                let normal = point.area * pressed.max(zero);

                let vx = w.x + (o.y * z - o.z * y);
                let vy = w.y + (o.z * x - o.x * z);
                let (before_x, before_y) = (point.anchor_x, point.anchor_y);
                let stiff = touches.select(point.area * ks, zero);
                let (ex, ey) = (stiff * (x - before_x), stiff * (y - before_y));
                let limit = point.friction * normal.max(zero);
                let square = limit * limit;
                let size = ex * ex + ey * ey;
                let slips = size.above(square);
                let (mut fx, mut fy) = (ex, ey);
                if slips.any() {
                    let keep = slips.select(limit / size.sqrt(), one);
                    (fx, fy) = (ex * keep, ey * keep);
                }
                let moves = slips | !touches;
                let anchor_x = moves.select(x - fx * point.give, before_x);
                let anchor_y = moves.select(y - fy * point.give, before_y);
                let rubbed = fx * (anchor_x - before_x) + fy * (anchor_y - before_y);
                let drag = touches.select(point.area * cs, zero);
                let (mut tx, mut ty) = (fx + drag * vx, fy + drag * vy);
                let size = tx * tx + ty * ty;
                let over = size.above(square);
                if over.any() {
                    let keep = over.select(limit / size.sqrt(), one);
                    (tx, ty) = (tx * keep, ty * keep);
                }
                (point.anchor_x, point.anchor_y) = (anchor_x, anchor_y);
                point.friction = slips.select(self.friction_kinetic, self.friction_static);
                sum[0] = sum[0] - tx;
                sum[1] = sum[1] - ty;
                sum[2] = sum[2] + normal;
                sum[3] = sum[3] + (y * normal + z * ty);
                sum[4] = sum[4] - (z * tx + x * normal);
                sum[5] = sum[5] + (y * tx - x * ty);
                sum[6] = sum[6] + rubbed;
            }
        }
        let [a, b, c, d] = sums;
        std::array::from_fn(|i| (a[i] + b[i]) + (c[i] + d[i]))
    }
}
