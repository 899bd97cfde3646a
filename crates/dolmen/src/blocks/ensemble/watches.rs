//! Relative poses of joints for several runs at once, as in [`Watch::see`].

use super::super::bodies::RigidBody;
use super::super::watch::{RelativePose, Watch, angle};
use super::bodies::BodyLanes;
use super::lanes::{Columns, Real, Vector};
use glam::{DMat3, DVec3};
use pulp::Simd;

/// The same joint in each lane, and its last observation.
#[derive(Clone, Debug)]
pub(super) struct WatchLanes<S: Simd> {
    lower: usize,
    upper: usize,
    from_lower: Vector<S>,
    from_upper: Vector<S>,
    axes: Columns<S>,
    /// Whether the axes in all runs are those of the ground.
    level: bool,
    /// As many corners as the run with the most; the other runs repeat their last corner.
    corners: Vec<[Real<S>; 2]>,
    settled: [Real<S>; 3],
    settled_opening: Real<S>,
    opening: Real<S>,
    slip: [Real<S>; 2],
    across: Real<S>,
    along: Real<S>,
}

impl<S: Simd> WatchLanes<S> {
    /// An empty observation of the joint between the bodies of a watch.
    pub(super) fn idle(simd: S, watch: &Watch) -> Self {
        let zero = Real::all(simd, 0.0);
        let nowhere = Vector::all(simd, DVec3::ZERO);
        WatchLanes {
            lower: watch.lower,
            upper: watch.upper,
            from_lower: nowhere,
            from_upper: nowhere,
            axes: Columns::all(simd, DMat3::IDENTITY),
            level: true,
            corners: Vec::new(),
            settled: [zero; 3],
            settled_opening: zero,
            opening: zero,
            slip: [zero; 2],
            across: zero,
            along: Real::all(simd, 1.0),
        }
    }

    /// Whether this joint lies between the bodies of a watch.
    pub(super) fn is_between(&self, watch: &Watch) -> bool {
        (self.lower, self.upper) == (watch.lower, watch.upper)
    }

    /// Loads the joint of one run.
    pub(super) fn load(&mut self, lane: usize, watch: &Watch, bodies: &[RigidBody]) {
        self.from_lower
            .set(lane, watch.origin - bodies[watch.lower].drawn);
        self.from_upper
            .set(lane, watch.origin - bodies[watch.upper].drawn);
        self.axes.set(lane, watch.axes);
        self.level &= watch.level;
        let zero = Real::all(self.across.0, 0.0);
        let more = watch.corners.len().max(self.corners.len());
        self.corners
            .resize(more, self.corners.last().copied().unwrap_or([zero; 2]));
        let last = watch.corners.last().copied().unwrap_or_default();
        for (index, corner) in self.corners.iter_mut().enumerate() {
            let of_lane = watch.corners.get(index).copied().unwrap_or(last);
            for (part, value) in corner.iter_mut().zip(of_lane) {
                part.set(lane, value);
            }
        }
        for (part, value) in self.settled.iter_mut().zip(watch.settled) {
            part.set(lane, value);
        }
        self.settled_opening.set(lane, watch.settled_opening);
    }

    /// Observes the pose in all runs.
    #[inline(always)]
    pub(super) fn see(&mut self, bodies: &[BodyLanes<S>]) {
        let (p, s) = (&bodies[self.lower], &bodies[self.upper]);
        let zero = Real::all(self.across.0, 0.0);
        let now = (s.position + s.rotation * self.from_upper) - (p.position + p.rotation * self.from_lower);
        let ([x, y, _], lower) = if self.level {
            (s.rotation.0, p.rotation)
        } else {
            let [x, y, _] = self.axes.0;
            ([s.rotation * x, s.rotation * y, x], p.rotation * self.axes)
        };
        let middle = lower.transposed_times(now);
        let (x, y) = (lower.transposed_times(x), lower.transposed_times(y));
        let mut opening = zero;
        for [a, b] in &self.corners {
            opening = opening.max(middle.z + (x.z * *a + y.z * *b));
        }
        let [settled_x, settled_y, _] = self.settled;
        self.opening = (opening - self.settled_opening).max(zero);
        self.slip = [middle.x - settled_x, middle.y - settled_y];
        (self.across, self.along) = (x.y - y.x, x.x + y.y);
    }

    /// Last observed pose of the joint of one run.
    pub(super) fn seen(&self, lane: usize) -> RelativePose {
        let [x, y] = self.slip;
        RelativePose {
            opening: self.opening.get(lane),
            slip: [x.get(lane), y.get(lane)],
            yaw: angle(self.across.get(lane), self.along.get(lane)) - self.settled[2].get(lane),
        }
    }
}
