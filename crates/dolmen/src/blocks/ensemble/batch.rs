//! Runs that are computed side by side, step by step.

use super::super::forces::Forces;
use super::bodies::{BodyLanes, Load, step_all};
use super::joints::{JointLanes, Place};
use super::lanes::{Mask, Real, Vector};
use super::queue::{LaneRun, Queue};
use super::watches::WatchLanes;
use crate::signal::MotionCursor;
use glam::{DMat3, DVec3};
use pulp::Simd;

/// Runs with the same number of bodies, one per lane.
///
/// Aligned so that the stack frame of [`Self::drive`] is aligned too: otherwise its loads and stores cross cache lines.
#[repr(C, align(64))]
pub(super) struct Batch<'a, S: Simd> {
    h: Real<S>,
    kick: Real<S>,
    gravity: Vector<S>,
    shaking: Vector<S>,
    slack: Real<S>,
    /// Energies so far, J: work input, work of contacts, friction loss.
    counts: [Real<S>; 3],
    /// Friction loss in the current step, J.
    friction: Real<S>,
    lane_runs: Vec<Option<LaneRun<'a>>>,
    bodies: Vec<BodyLanes<S>>,
    loads: Vec<Load<S>>,
    /// Whether no body in any lane has products of inertia.
    diagonal: bool,
    joints: Vec<JointLanes<S>>,
    watches: Vec<WatchLanes<S>>,
    freed: bool,
    clocks: Vec<Clock<'a>>,
    /// For each lane, whether its patches are in position.
    placed: Vec<bool>,
    forces: Forces,
}

/// Progress of the run in a lane: the quantities that change at every step. [`Run::step`] is updated only when the run is
/// observed.
///
/// [`Run::step`]: super::super::springs::Run::step
#[derive(Clone, Copy, Debug)]
struct Clock<'a> {
    motion: Option<MotionCursor<'a>>,
    h: f64,
    step: usize,
    /// Whether its joints are observed together with those of the other lanes.
    watched: bool,
    /// Next step at which the run is observed.
    look_at: usize,
    /// Number of steps until the next verdict.
    judge_after: usize,
}

impl Clock<'_> {
    /// Clock of a lane without a run.
    const STOPPED: Self = Clock {
        motion: None,
        h: 0.0,
        step: 0,
        watched: false,
        look_at: usize::MAX,
        judge_after: usize::MAX,
    };
}

impl<'a, S: Simd> Batch<'a, S> {
    /// With the first run in the first lane.
    pub(super) fn new(simd: S, first: LaneRun<'a>) -> Self {
        let zero = Real::all(simd, 0.0);
        let nowhere = Vector::all(simd, DVec3::ZERO);
        // copies of the ground in every lane, so that empty lanes have a body that does not move
        let ground = &first.run.assembly.bodies[0];
        let bodies = first.run.assembly.bodies.iter();
        let watched = first.run.observer.watches();
        let mut batch = Batch {
            lane_runs: (0..S::F64_LANES).map(|_| None).collect(),
            bodies: bodies.map(|_| BodyLanes::all(simd, ground)).collect(),
            loads: Vec::new(),
            diagonal: true,
            joints: Vec::new(),
            watches: watched
                .iter()
                .map(|watch| WatchLanes::idle(simd, watch))
                .collect(),
            h: zero,
            kick: zero,
            gravity: nowhere,
            shaking: nowhere,
            slack: Real::all(simd, f64::INFINITY),
            counts: [zero; 3],
            friction: zero,
            freed: false,
            clocks: vec![Clock::STOPPED; S::F64_LANES],
            placed: vec![true; S::F64_LANES],
            forces: Forces::default(),
        };
        batch.seat(0, first);
        batch
    }

    /// Computes all runs to their ends.
    #[inline(always)]
    pub(super) fn drive(mut self, queue: &mut Queue<'a, '_>) {
        self.fill(queue);
        let mut drifted = self.h.above(self.h);
        while self.lane_runs.iter().any(Option::is_some) {
            self.search_pairs_where_moved(drifted);
            drifted = self.contact_forces();
            self.look(queue);
            self.step();
            self.end_step(queue);
        }
    }

    fn seat(&mut self, lane: usize, lane_run: LaneRun<'a>) {
        let run = &lane_run.run;
        for (body, of_run) in self.bodies.iter_mut().zip(&run.assembly.bodies) {
            body.load(lane, of_run);
            let DMat3 {
                x_axis: x,
                y_axis: y,
                z_axis: z,
            } = of_run.inverse_inertia;
            self.diagonal &= of_run.inverse_inertia == DMat3::from_diagonal(DVec3::new(x.x, y.y, z.z));
        }
        self.h.set(lane, run.h);
        self.kick.set(lane, run.kick());
        self.gravity
            .set(lane, DVec3::new(0.0, 0.0, -run.assembly.gravity));
        self.slack.set(lane, run.assembly.slack());
        for count in &mut self.counts {
            count.set(lane, 0.0);
        }
        let watches = run.observer.watches();
        let watched = watches.len() == self.watches.len()
            && watches
                .iter()
                .zip(&self.watches)
                .all(|(watch, lanes)| lanes.is_between(watch));
        for (watch, lanes) in watches.iter().zip(&mut self.watches).filter(|_| watched) {
            lanes.load(lane, watch, &run.assembly.bodies);
        }
        self.clocks[lane] = Clock {
            motion: run.motion.map(MotionCursor::of),
            h: run.h,
            step: run.step,
            watched,
            look_at: run.step,
            judge_after: run.length.due(),
        };
        self.lane_runs[lane] = Some(lane_run);
        self.load_patches(lane, |_| true);
    }

    /// Empties a lane; its bodies and patches remain without effect.
    fn leave(&mut self, lane: usize) -> Option<LaneRun<'a>> {
        let lane_run = self.lane_runs[lane].take()?;
        let ground = &lane_run.run.assembly.bodies[0];
        for body in &mut self.bodies {
            body.load(lane, ground);
        }
        self.slack.set(lane, f64::INFINITY);
        self.gravity.set(lane, DVec3::ZERO);
        self.shaking.set(lane, DVec3::ZERO);
        self.clocks[lane] = Clock::STOPPED;
        self.placed[lane] = true;
        for joint in &mut self.joints {
            joint.clear(lane);
        }
        Some(lane_run)
    }

    /// Examines pairs again in runs in which bodies have moved too far.
    #[inline(always)]
    fn search_pairs_where_moved(&mut self, drifted: Mask<S>) {
        let mut farthest = Real::all(self.h.0, 0.0);
        for body in &self.bodies {
            farthest = farthest.max(body.travel);
        }
        let calls = (farthest + farthest).at_least(self.slack) | drifted;
        if calls.any() {
            self.search_pairs(&calls.ones());
        }
    }

    #[inline(never)]
    fn search_pairs(&mut self, calls: &Real<S>) {
        for lane in 0..S::F64_LANES {
            if calls.get(lane) == 0.0 || self.lane_runs[lane].is_none() {
                continue;
            }
            self.write_back(lane);
            let Some(lane_run) = &mut self.lane_runs[lane] else {
                continue;
            };
            let assembly = &mut lane_run.run.assembly;
            for joint in &self.joints {
                if joint.has_drifted(lane) {
                    assembly.set_stale(joint.place.pair);
                }
            }
            let placed = self.placed[lane];
            assembly.look();
            self.slack.set(lane, assembly.slack());
            for (body, of_run) in self.bodies.iter_mut().zip(&assembly.bodies) {
                body.travel.set(lane, of_run.travel);
            }
            let looked = assembly.looked().to_vec();
            self.load_patches(lane, |pair| !placed || looked.contains(&pair));
        }
        self.lay_out();
    }

    /// Writes the state of a lane to its run: its bodies and patches.
    fn write_back(&mut self, lane: usize) {
        let Some(lane_run) = &mut self.lane_runs[lane] else {
            return;
        };
        let assembly = &mut lane_run.run.assembly;
        for (body, of_run) in self.bodies.iter().zip(&mut assembly.bodies) {
            body.unload(lane, of_run);
        }
        let placed = self.placed[lane];
        for joint in self.joints.iter().filter(|_| placed) {
            if let Some(patch) = assembly.patch_mut(joint.place.pair)
                && patch.plane_body == joint.place.plane_body
            {
                joint.unload(lane, patch);
            }
        }
    }

    /// Loads the patches of the pairs `changed` of a lane, if there is a large enough place for each.
    fn load_patches(&mut self, lane: usize, changed: impl Fn(usize) -> bool) {
        let Some(lane_run) = &self.lane_runs[lane] else {
            return;
        };
        let mut contacts = lane_run.run.assembly.contacts().peekable();
        for joint in &mut self.joints {
            let here = contacts.next_if(|(pair, patch, ..)| {
                *pair == joint.place.pair
                    && patch.plane_body == joint.place.plane_body
                    && patch.points.len() <= joint.place.groups
            });
            match here {
                Some((pair, patch, outline, most)) if changed(pair) => joint.load(lane, patch, outline, most),
                Some(_) => {}
                None => joint.clear(lane),
            }
        }
        self.placed[lane] = contacts.next().is_none();
    }

    /// Makes places for the patches of all lanes, if one has no place.
    fn lay_out(&mut self) {
        if self.placed.iter().all(|placed| *placed) {
            return;
        }
        let mut places: Vec<Place> = Vec::new();
        for lane in 0..S::F64_LANES {
            self.write_back(lane);
            // a patch that has drifted in this step is examined in the next one, wherever its place is then
            if let Some(lane_run) = &mut self.lane_runs[lane] {
                let drifted = self.joints.iter().filter(|joint| joint.has_drifted(lane));
                drifted.for_each(|joint| lane_run.run.assembly.set_stale(joint.place.pair));
            }
            let contacts = self.lane_runs[lane]
                .iter()
                .flat_map(|lane_run| lane_run.run.assembly.contacts());
            for (pair, patch, ..) in contacts {
                let place = Place {
                    pair,
                    plane_body: patch.plane_body,
                    point_body: patch.point_body,
                    groups: patch.points.len(),
                };
                let same =
                    |other: &&mut Place| (other.pair, other.plane_body) == (place.pair, place.plane_body);
                match places.iter_mut().find(same) {
                    Some(other) => other.groups = other.groups.max(place.groups),
                    None => places.push(place),
                }
            }
        }
        places.sort_by_key(|place| (place.pair, place.plane_body));
        let simd = self.h.0;
        self.joints = places
            .into_iter()
            .map(|place| JointLanes::idle(simd, place))
            .collect();
        for lane in 0..S::F64_LANES {
            self.load_patches(lane, |_| true);
        }
    }

    /// Computes the forces of all contacts. Returns the lanes in which a patch has drifted.
    #[inline(always)]
    fn contact_forces(&mut self) -> Mask<S> {
        let zero = Real::all(self.h.0, 0.0);
        let nowhere = Vector {
            x: zero,
            y: zero,
            z: zero,
        };
        let nothing = Load {
            force: nowhere,
            torque: nowhere,
        };
        self.loads.clear();
        self.loads.resize(self.bodies.len(), nothing);
        let half_step = Real::all(self.h.0, 0.5) * self.h;
        let mut drifted = zero.above(zero);
        let mut friction = zero;
        for joint in &mut self.joints {
            let (rubbed, far) = joint.add_contact_forces(&self.bodies, &mut self.loads, half_step);
            friction = friction + rubbed;
            drifted = drifted | far;
        }
        self.friction = friction;
        for (lane, clock) in self.clocks.iter_mut().enumerate() {
            if let Some(motion) = &mut clock.motion {
                let shaking = motion.acceleration_at_m_s2(clock.step as f64 * clock.h);
                self.shaking.set(lane, DVec3::from(shaking));
            }
        }
        drifted
    }

    /// Calls the observers of runs that are due; runs that end leave their lanes.
    #[inline(always)]
    fn look(&mut self, queue: &mut Queue<'a, '_>) {
        if !self.clocks.iter().any(|clock| clock.step == clock.look_at) {
            return;
        }
        for watch in &mut self.watches {
            watch.see(&self.bodies);
        }
        for lane in 0..S::F64_LANES {
            if self.clocks[lane].step == self.clocks[lane].look_at {
                self.look_at(lane, queue);
            }
        }
    }

    #[inline(never)]
    fn look_at(&mut self, lane: usize, queue: &mut Queue<'a, '_>) {
        let Some(lane_run) = &mut self.lane_runs[lane] else {
            return;
        };
        lane_run.run.step = self.clocks[lane].step;
        if lane_run.run.observer.samples(lane_run.run.step) {
            self.write_back(lane);
        } else {
            for (body, of_run) in self.bodies.iter().zip(&mut lane_run.run.assembly.bodies) {
                body.unload_place(lane, of_run);
            }
        }
        let Some(lane_run) = &mut self.lane_runs[lane] else {
            return;
        };
        let run = &mut lane_run.run;
        run.observer
            .set_counts(self.counts.map(|count| count.get(lane)), run.step);
        let forces = &mut self.forces;
        if run.observer.samples(run.step) {
            forces.force.clear();
            forces.torque.clear();
            for load in &self.loads {
                forces.force.push(load.force.get(lane));
                forces.torque.push(load.torque.get(lane));
            }
        }
        self.clocks[lane].look_at = run.observer.next_wanted(run.step);
        let index = lane_run.index;
        if self.clocks[lane].watched {
            for (joint, watch) in self.watches.iter().enumerate() {
                run.observer.set_seen(joint, watch.seen(lane));
            }
        } else {
            run.observer.see(&run.assembly.bodies);
        }
        if !run.look_as_seen(forces, &mut |time_s| (queue.progress)(index, time_s)) {
            self.write_back(lane);
            self.end(lane, queue);
        }
    }

    /// Velocities and positions of all bodies.
    #[inline(always)]
    fn step(&mut self) {
        let zero = Real::all(self.h.0, 0.0);
        let (bodies, loads) = (&mut self.bodies[1..], &self.loads[1..]);
        let (ground, steps) = ([self.gravity, self.shaking], [self.kick, self.h]);
        let mut sums = [zero; 2];
        if self.diagonal {
            step_all::<S, true>(bodies, loads, ground, steps, &mut sums);
        } else {
            step_all::<S, false>(bodies, loads, ground, steps, &mut sums);
        }
        let [input, contact] = sums;
        let half_kick = Real::all(self.h.0, 0.5) * self.kick;
        let work = [half_kick * input, half_kick * contact, self.friction];
        for (count, work) in self.counts.iter_mut().zip(work) {
            *count = *count + work;
        }
        self.kick = self.h;
    }

    /// Counts the step; completed runs leave, and new runs take their lanes.
    #[inline(always)]
    fn end_step(&mut self, queue: &mut Queue<'a, '_>) {
        for lane in 0..S::F64_LANES {
            let clock = &mut self.clocks[lane];
            clock.step += 1;
            if clock.step > clock.judge_after {
                self.judge(lane, queue);
            }
        }
        if self.freed {
            self.fill(queue);
        }
    }

    /// Ends the run of a lane that has completed its steps, unless its stones still move.
    #[inline(never)]
    fn judge(&mut self, lane: usize, queue: &mut Queue<'a, '_>) {
        self.write_back(lane);
        let Some(lane_run) = &mut self.lane_runs[lane] else {
            return;
        };
        lane_run.run.step = self.clocks[lane].step;
        if lane_run.run.is_over() {
            self.end(lane, queue);
        } else {
            self.clocks[lane].judge_after = lane_run.run.length.due();
        }
    }

    /// Ends the run of a lane: its result is passed on, or the run starts again with a shorter step.
    #[inline(never)]
    fn end(&mut self, lane: usize, queue: &mut Queue<'a, '_>) {
        let counts = self.counts.map(|count| count.get(lane));
        if let Some(mut lane_run) = self.leave(lane) {
            let steps = lane_run.run.step;
            lane_run.run.observer.set_counts(counts, steps);
            queue.end(lane_run);
            self.freed = true;
        }
    }

    #[inline(never)]
    fn fill(&mut self, queue: &mut Queue<'a, '_>) {
        self.freed = false;
        for lane in 0..S::F64_LANES {
            if self.lane_runs[lane].is_some() {
                continue;
            }
            if let Some(lane_run) = queue.next() {
                self.seat(lane, lane_run);
            }
        }
        self.lay_out();
    }
}
