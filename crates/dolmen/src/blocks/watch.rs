//! Relative pose of the two sides of a joint, as observed in a run.

use super::assembly::Assembly;
use super::bodies::{RigidBody, index_of};
use crate::structure::stack::{Body, Joint};
use glam::{DMat3, DVec3};

/// A joint to be observed.
#[derive(Clone, Debug)]
pub(super) struct Watch {
    pub(super) lower: usize,
    pub(super) upper: usize,
    pub(super) origin: DVec3,
    pub(super) axes: DMat3,
    /// Whether the axes are those of the ground.
    pub(super) level: bool,
    /// Corners of the patch along the first two axes, relative to the origin, m.
    pub(super) corners: Vec<[f64; 2]>,
    /// Distance to the farthest corner, m.
    pub(super) reach: f64,
    /// Slip and yaw after settlement.
    pub(super) settled: [f64; 3],
    /// Largest gap at a corner after settlement, m.
    pub(super) settled_opening: f64,
}

/// Pose of the upper body relative to the lower one: largest gap at a corner, shift, rotation.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct RelativePose {
    pub(super) opening: f64,
    pub(super) slip: [f64; 2],
    pub(super) yaw: f64,
}

/// The body below a joint; if the ground moves, the ground body under its stone.
pub(super) fn lower_body(joint: &Joint, assembly: &Assembly) -> usize {
    match joint.lower {
        Body::Ground => assembly.ground_under(joint.upper + 1),
        Body::Block(_) => index_of(joint.lower),
    }
}

impl Watch {
    pub(super) fn of(joint: &Joint, assembly: &Assembly) -> Self {
        let bodies = &assembly.bodies;
        let axes = DMat3::from_cols_array_2d(&joint.axes);
        let origin = DVec3::from(joint.origin_m);
        let mut watch = Watch {
            lower: lower_body(joint, assembly),
            upper: joint.upper + 1,
            origin,
            axes,
            level: axes == DMat3::IDENTITY,
            corners: joint.patch.corners_m.clone(),
            reach: joint
                .patch
                .corners_m
                .iter()
                .copied()
                .map(length)
                .fold(0.0, f64::max),
            settled: [0.0; 3],
            settled_opening: 0.0,
        };
        let seen = watch.see(bodies);
        watch.settled = [seen.slip[0], seen.slip[1], seen.yaw];
        watch.settled_opening = seen.opening;
        watch
    }

    /// Width of the patch as drawn along a direction in its plane, m.
    pub(super) fn width_along(&self, direction: [f64; 2]) -> f64 {
        let length = direction[0].hypot(direction[1]).max(f64::MIN_POSITIVE);
        let along = |corner: &[f64; 2]| (corner[0] * direction[0] + corner[1] * direction[1]) / length;
        let places = self.corners.iter().map(along);
        let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| {
            (low.min(place), high.max(place))
        });
        high - low
    }

    pub(super) fn see(&self, bodies: &[RigidBody]) -> RelativePose {
        let (lower, upper) = (&bodies[self.lower], &bodies[self.upper]);
        let now = upper.now(self.origin) - lower.now(self.origin);
        // the shift of the upper side's origin, and its axes, in the axes of the lower side; a corner at (a, b) has
        // shifted by
        // // middle + (a x + b y) − (a, b, 0)
        let (middle, x, y) = if self.level {
            (
                transposed_times(&lower.rotation, now),
                transposed_times(&lower.rotation, upper.rotation.x_axis),
                transposed_times(&lower.rotation, upper.rotation.y_axis),
            )
        } else {
            let lower = lower.rotation * self.axes;
            (
                transposed_times(&lower, now),
                transposed_times(&lower, upper.rotation * self.axes.x_axis),
                transposed_times(&lower, upper.rotation * self.axes.y_axis),
            )
        };
        let mut opening = 0.0;
        for [a, b] in &self.corners {
            opening = f64::max(opening, middle.z + (x.z * a + y.z * b));
        }
        let yaw = angle(x.y - y.x, x.x + y.y);
        RelativePose {
            opening: (opening - self.settled_opening).max(0.0),
            slip: [middle.x - self.settled[0], middle.y - self.settled[1]],
            yaw: yaw - self.settled[2],
        }
    }
}

/// Mᵀ v.
#[inline(always)]
fn transposed_times(matrix: &DMat3, v: DVec3) -> DVec3 {
    DVec3::new(matrix.x_axis.dot(v), matrix.y_axis.dot(v), matrix.z_axis.dot(v))
}

/// Angle of a direction, rad; for small angles by a series, ten times faster, with an error below 1e-17.
pub(super) fn angle(across: f64, along: f64) -> f64 {
    const SMALL: f64 = 0.02;
    if across.abs() > SMALL * along {
        return across.atan2(along);
    }
    let t = across / along;
    let q = t * t;
    t * (1.0 - q * (1.0 / 3.0 - q * (1.0 / 5.0 - q * (1.0 / 7.0 - q * (1.0 / 9.0 - q / 11.0)))))
}

pub(super) fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

#[cfg(test)]
mod tests {
    use super::angle;

    #[test]
    fn exact_angle_of_a_direction() {
        for angle_rad in [0.0, 1e-12, 3e-3, 0.0199, 0.0201, 1.0, 2.0, 3.1] {
            for sign in [1.0, -1.0] {
                let (across, along) = (sign * f64::sin(angle_rad), f64::cos(angle_rad));
                let difference = angle(across, along) - across.atan2(along);
                assert!(difference.abs() < 1e-17, "{angle_rad}: {difference}");
            }
        }
    }
}
