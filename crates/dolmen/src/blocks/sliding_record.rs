//! Records the motion of a sliding pile: samples within steps, peaks, intervals of sliding, and the energy balance.

use super::history::{JointHistory, Pose};
use super::sliding_chain::{Chain, Place};
use super::sliding_history::{SlidingHistory, SlidingOutcome, SlidingSpell};
use super::sliding_solve::Slide;
use super::sliding_state::State;
use crate::structure::stack::Stack;
use glam::{DVec2, DVec3};

/// Observation of one joint.
#[derive(Debug)]
struct Watch {
    joint: usize,
    /// Middle of the joint relative to the centroids of the upper and the lower block, as drawn, m.
    from_upper: DVec2,
    from_lower: DVec2,
    /// The first two axes of the joint.
    axes: [DVec2; 2],
    /// Start of the current sliding, s.
    slides_from_s: Option<f64>,
}

#[derive(Debug)]
pub(super) struct Recorder {
    output_step_s: f64,
    watches: Vec<Watch>,
    /// Blocks in the order of the pile, with the heights of their centroids.
    blocks: Vec<(usize, f64)>,
    /// Kinetic energy at the start.
    first: f64,
    history: SlidingHistory,
}

impl Recorder {
    pub(super) fn of(stack: &Stack, chain: &Chain, output_step_s: f64) -> Recorder {
        let mut below = DVec2::ZERO;
        let watches = chain.stones.iter().map(|stone| {
            let joint = &stack.joints()[stone.joint];
            let middle = DVec3::from(joint.origin_m).truncate();
            let own = stone.centroid.truncate();
            Watch {
                joint: stone.joint,
                from_upper: middle - own,
                from_lower: middle - std::mem::replace(&mut below, own),
                axes: [0, 1].map(|axis| DVec3::from(joint.axes[axis]).truncate()),
                slides_from_s: None,
            }
        });
        Recorder {
            output_step_s,
            watches: watches.collect(),
            blocks: chain
                .stones
                .iter()
                .map(|stone| (stone.block, stone.centroid.z))
                .collect(),
            first: 0.0,
            history: SlidingHistory {
                outcome: SlidingOutcome::Stuck,
                time_s: Vec::new(),
                blocks: chain.stones.len(),
                poses: Vec::new(),
                joints: vec![JointHistory::default(); stack.joints().len()],
                spells: Vec::new(),
                input_j: 0.0,
                friction_j: 0.0,
                energy_error_j: 0.0,
                steps: 0,
            },
        }
    }

    pub(super) fn begin(&mut self, chain: &Chain, state: &State, slides: &[Slide]) {
        self.first = chain.kinetic(&chain.motion(&state.places, &state.twists));
        self.changed(slides, 0.0);
        self.sample(0.0, &state.places);
    }

    /// Records a step and the samples in it, by cubics through positions and velocities at its ends.
    pub(super) fn take(&mut self, chain: &Chain, before: &State, after: &State, [from_s, to_s]: [f64; 2]) {
        self.history.steps += 1;
        let h = to_s - from_s;
        let [start, end] = [before, after].map(|state| chain.motion(&state.places, &state.twists));
        let energy = chain.kinetic(&end) + after.friction - after.input - self.first;
        self.history.energy_error_j = self.history.energy_error_j.max(energy.abs());
        let rates = [
            chain.rates(&start, &before.twists),
            chain.rates(&end, &after.twists),
        ];
        loop {
            let at_s = self.history.time_s.len() as f64 * self.output_step_s;
            if at_s > to_s {
                break;
            }
            let t = (at_s - from_s) / h;
            let [left, right] = [(1.0 - t) * (1.0 - t), t * t];
            let weights = [
                left * (1.0 + 2.0 * t),
                right * (3.0 - 2.0 * t),
                left * t * h,
                -right * (1.0 - t) * h,
            ];
            let between = |i: usize| {
                let ends = [before.places[i], after.places[i], rates[0][i], rates[1][i]];
                let mut place = Place::default();
                for (weight, end) in weights.iter().zip(ends) {
                    place.shift += *weight * end.shift;
                    place.yaw += *weight * end.yaw;
                }
                // a stuck joint keeps its exact position
                if before.places[i] == after.places[i] {
                    after.places[i]
                } else {
                    place
                }
            };
            let places: Vec<Place> = (0..after.places.len()).map(between).collect();
            self.sample(at_s, &places);
        }
        self.see(&after.places);
    }

    /// Slip and rotation of the joints at given positions.
    fn seen(&self, places: &[Place]) -> Vec<([f64; 2], f64)> {
        let of = |(watch, place): (&Watch, &Place)| {
            let upper = place.shift + DVec2::from_angle(place.yaw).rotate(watch.from_upper);
            let slip = upper - watch.from_lower;
            (watch.axes.map(|axis| axis.dot(slip)), place.yaw)
        };
        self.watches.iter().zip(places).map(of).collect()
    }

    fn see(&mut self, places: &[Place]) {
        let seen = self.seen(places);
        for (watch, (slip, yaw)) in self.watches.iter().zip(seen) {
            let joint = &mut self.history.joints[watch.joint];
            joint.peak_slip_m = joint.peak_slip_m.max(slip[0].hypot(slip[1]));
            joint.peak_yaw_rad = joint.peak_yaw_rad.max(yaw.abs());
        }
    }

    fn sample(&mut self, at_s: f64, places: &[Place]) {
        let seen = self.seen(places);
        for (watch, (slip, yaw)) in self.watches.iter().zip(seen) {
            let joint = &mut self.history.joints[watch.joint];
            joint.opening_m.push(0.0);
            joint.slip_m.push(slip);
            joint.yaw_rad.push(yaw);
        }
        self.history.time_s.push(at_s);
        let still = Pose {
            centroid_m: [0.0; 3],
            rotation: [1.0, 0.0, 0.0, 0.0],
        };
        let mut poses = vec![still; self.blocks.len()];
        let (mut centre, mut yaw) = (DVec2::ZERO, 0.0_f64);
        for (&(block, height), place) in self.blocks.iter().zip(places) {
            centre += DVec2::from_angle(yaw).rotate(place.shift);
            yaw += place.yaw;
            let (sin, cos) = (0.5 * yaw).sin_cos();
            poses[block] = Pose {
                centroid_m: [centre.x, centre.y, height],
                rotation: [cos, 0.0, 0.0, sin],
            };
        }
        self.history.poses.extend(poses);
    }

    /// Records which joints were released or have stopped.
    pub(super) fn changed(&mut self, slides: &[Slide], at_s: f64) {
        for (watch, slide) in self.watches.iter_mut().zip(slides) {
            match (*slide == Slide::Stuck, watch.slides_from_s) {
                (true, Some(from_s)) => {
                    watch.slides_from_s = None;
                    self.history.spells.push(SlidingSpell {
                        joint: watch.joint,
                        from_s,
                        to_s: at_s,
                    });
                }
                (false, None) => watch.slides_from_s = Some(at_s),
                _ => {}
            }
        }
    }

    pub(super) fn moved(&self) -> bool {
        !self.history.spells.is_empty() || self.watches.iter().any(|watch| watch.slides_from_s.is_some())
    }

    pub(super) fn finish(mut self, outcome: SlidingOutcome, state: &State, at_s: f64) -> SlidingHistory {
        self.changed(&vec![Slide::Stuck; self.watches.len()], at_s);
        SlidingHistory {
            outcome,
            input_j: state.input,
            friction_j: state.friction,
            ..self.history
        }
    }
}
