//! Observes a run at intervals: samples, peaks, energies, falls.

use super::after_fall::AfterFall;
use super::assembly::Assembly;
use super::bodies::RigidBody;
use super::fall::Falls;
use super::forces::Forces;
use super::history::{Energy, JointHistory, Outcome, Pose, StackHistory};
use super::patch::LANES;
use super::stillness::{EDGE, Stillness, Swings};
use super::support::{plumb_decides, plumb_margin};
use super::watch::{RelativePose, Watch, length};
use crate::structure::stack::Stack;
use glam::DVec3;

/// Time between observations of peaks and falls, s. Our choice: peaks are flat, and no stone falls faster.
const LOOK_STEP_S: f64 = 5e-3;
/// Limits from which a stone is on the brink: slip as a fraction of the width of the bed, and remaining fraction of its distance to the edge. Our
/// choice: half of its margin against tipping is lost.
const BRINK: f64 = 0.5;

pub(super) struct Observer {
    watches: Vec<Watch>,
    /// Last observation of each joint.
    seen: Vec<RelativePose>,
    falls: Falls,
    /// For each block, distance inside its support of the vertical through its centroid at rest, m; `None` if this distance does not show how close
    /// the block is to tipping.
    margins: Vec<Option<f64>>,
    sample_every: usize,
    /// Number of observations per sample, at most that of steps.
    looks: usize,
    outcome: Option<Outcome>,
    stillness: Stillness,
    /// Whether stones are loose. Stillness then uses two entries for each stone.
    is_loose: bool,
    swings: Swings,
    input: f64,
    contact: f64,
    friction: f64,
    first_potential: f64,
    first_stored: f64,
    /// Largest energy lost in contacts so far, with which created energy is compared.
    most_lost: f64,
    history: StackHistory,
}

impl Observer {
    /// Starts the observation of a stack at rest.
    pub(super) fn new(stack: &Stack, assembly: &Assembly, output_step_s: f64, h: f64) -> Self {
        let sample_every = ((output_step_s / h).round() as usize).max(1);
        let looks = whole_at_least(output_step_s / LOOK_STEP_S).min(sample_every);
        let highest = (1..assembly.bodies.len())
            .max_by(|&a, &b| assembly.bodies[a].drawn.z.total_cmp(&assembly.bodies[b].drawn.z))
            .map_or(0.0, |index| {
                assembly.bodies[index].drawn.z - assembly.bodies[index].position.z
            });
        let points = assembly.patches().flat_map(|patch| &patch.points);
        let contact_points = points
            .map(|group| (0..LANES).filter(|&lane| group.area[lane] > 0.0).count())
            .sum();
        let joints = stack.joints().iter();
        let watches: Vec<Watch> = joints.map(|joint| Watch::of(joint, assembly)).collect();
        let decides = plumb_decides(assembly);
        Observer {
            seen: vec![RelativePose::default(); watches.len()],
            watches,
            falls: Falls::of(stack, assembly),
            sample_every,
            looks,
            margins: (assembly.stones())
                .map(|body| plumb_margin(assembly, body).filter(|_| decides[body]))
                .collect(),
            outcome: None,
            stillness: match stack.loose_material() {
                Some(_) => Stillness::of(2 * stack.blocks().len()),
                None => Stillness::of(stack.joints().len()),
            },
            is_loose: stack.loose_material().is_some(),
            swings: Swings::none(),
            input: 0.0,
            contact: 0.0,
            friction: 0.0,
            first_potential: potential(assembly),
            first_stored: assembly.stored(),
            most_lost: 0.0,
            history: StackHistory {
                outcome: Outcome::Stood,
                time_s: Vec::new(),
                blocks: stack.blocks().len(),
                poses: Vec::new(),
                joints: vec![JointHistory::default(); stack.joints().len()],
                energy: Vec::new(),
                energy_made_j: 0.0,
                broken_ties: Vec::new(),
                time_step_s: h,
                longest_step_s: h,
                steps: 0,
                contact_points,
                settlement_m: highest,
                rigid: None,
            },
        }
    }

    pub(super) fn wants(&self, step: usize) -> bool {
        // distributed over the steps of a sample as evenly as possible; the sample is also an observation
        step * self.looks % self.sample_every < self.looks
    }

    /// Adds the energies of a step: work input, work of contacts, friction loss, J.
    pub(super) fn count(&mut self, [input, contact, friction]: [f64; 3]) {
        self.input += input;
        self.contact += contact;
        self.friction += friction;
        self.history.steps += 1;
    }

    /// Sets the energies of all steps so far: work input, work of contacts, friction loss, J.
    pub(super) fn set_counts(&mut self, [input, contact, friction]: [f64; 3], steps: usize) {
        (self.input, self.contact, self.friction) = (input, contact, friction);
        self.history.steps = steps;
    }

    /// Whether a requested step is a sample.
    pub(super) fn samples(&self, step: usize) -> bool {
        step.is_multiple_of(self.sample_every)
    }

    /// The next requested step after `step`.
    pub(super) fn next_wanted(&self, step: usize) -> usize {
        let looks_done = step * self.looks / self.sample_every;
        ((looks_done + 1) * self.sample_every).div_ceil(self.looks)
    }

    pub(super) fn watches(&self) -> &[Watch] {
        &self.watches
    }

    /// Observes the poses of all joints.
    pub(super) fn see(&mut self, bodies: &[RigidBody]) {
        for (seen, watch) in self.seen.iter_mut().zip(&self.watches) {
            *seen = watch.see(bodies);
        }
    }

    /// Sets the pose of a joint that the caller has observed.
    pub(super) fn set_seen(&mut self, joint: usize, seen: RelativePose) {
        self.seen[joint] = seen;
    }

    /// Observes the stack at time t, with the last observed poses of the joints. Positions are those at t. Velocities are those at t − h/2 (at the
    /// start: at 0), with the accelerations that advance them over a kick.
    pub(super) fn look(
        &mut self,
        assembly: &Assembly,
        acceleration: &[DVec3],
        forces: &Forces,
        shaking: DVec3,
        [time_s, kick]: [f64; 2],
    ) {
        let sampled = self.samples(self.history.steps);
        self.stillness.at(time_s);
        for (index, (watch, joint)) in self.watches.iter().zip(&mut self.history.joints).enumerate() {
            let seen = self.seen[index];
            let [x, y] = seen.slip;
            self.stillness
                .see(index, [seen.opening, x, y, seen.yaw * watch.reach]);
            joint.peak_opening_m = joint.peak_opening_m.max(seen.opening);
            joint.peak_slip_m = joint.peak_slip_m.max(length(seen.slip));
            joint.peak_yaw_rad = joint.peak_yaw_rad.max(seen.yaw.abs());
            if sampled {
                joint.opening_m.push(seen.opening);
                joint.slip_m.push(seen.slip);
                joint.yaw_rad.push(seen.yaw);
            }
        }
        if self.is_loose {
            self.see_loose(assembly);
        }
        self.judge(assembly, time_s);
        if !sampled {
            return;
        }
        self.history.time_s.push(time_s);
        // work up to t of the current step; none at the start
        let started = self.history.steps > 0;
        let half = if started { 0.5 * kick } else { 0.0 };
        let (mut kinetic, mut input, mut contact) = (0.0, self.input, self.contact);
        let stones = assembly.stones();
        for (body, force) in assembly.bodies.iter().zip(&forces.force).skip(stones.end) {
            // the work of moving ground on the stone is input energy
            let work = half * force.dot(body.velocity);
            contact += work;
            input -= work;
        }
        for (index, body) in assembly.bodies.iter().enumerate().take(stones.end).skip(1) {
            let q = body.turn;
            self.history.poses.push(Pose {
                centroid_m: body.position.into(),
                rotation: [q.w, q.x, q.y, q.z],
            });
            let ahead = 2.0 * half;
            let next = body.velocity + acceleration[index] * ahead;
            let turning = body.momentum + forces.torque[index] * ahead;
            kinetic += body.mass * body.velocity.dot(next) + body.spin.dot(turning);
            input -= half * body.mass * shaking.dot(body.velocity);
            contact += half * (forces.force[index].dot(body.velocity) + forces.torque[index].dot(body.spin));
        }
        let stored = assembly.stored() - self.first_stored;
        let lost = -contact - stored;
        self.most_lost = self.most_lost.max(lost);
        self.history.energy_made_j = self.history.energy_made_j.max(self.most_lost - lost);
        let clipping = assembly.clip_loss();
        self.history.energy.push(Energy {
            kinetic_j: 0.5 * kinetic,
            potential_j: potential(assembly) - self.first_potential,
            stored_j: stored,
            input_j: input,
            friction_j: self.friction,
            damping_j: lost - self.friction - clipping,
            clipping_j: clipping,
        });
    }

    /// Records the position and the rotation of every loose stone, both as lengths.
    fn see_loose(&mut self, assembly: &Assembly) {
        for (block, body) in assembly.bodies[assembly.stones()].iter().enumerate() {
            let (at, turned, r) = (body.position, body.rotation, body.radius);
            self.stillness.see(2 * block, [at.x, at.y, at.z, 0.0]);
            let turns = [turned.x_axis.y, turned.y_axis.z, turned.z_axis.x, turned.z_axis.y];
            self.stillness.see(2 * block + 1, turns.map(|part| r * part));
        }
    }

    fn judge(&mut self, assembly: &Assembly, at_s: f64) {
        if matches!(
            self.outcome,
            Some(Outcome::Fell { .. } | Outcome::Diverged { .. })
        ) {
            return;
        }
        if assembly.bodies.iter().any(|body| !body.position.is_finite()) {
            self.outcome = Some(Outcome::Diverged { at_s });
            return;
        }
        if let Some((block, at_s)) = self.falls.look(assembly, at_s) {
            let joint = self.gave_way(&assembly.bodies);
            self.outcome = Some(Outcome::Fell { block, joint, at_s });
            return;
        }
        if self.outcome.is_none() {
            let opened = self
                .history
                .joints
                .iter()
                .position(|joint| joint.peak_opening_m > StackHistory::UPLIFT_LEAST_M);
            self.outcome = opened.map(|joint| Outcome::Uplifted { joint, at_s });
        }
    }

    /// The joint with the largest opening or slip; the lowest of several equal ones.
    fn gave_way(&self, bodies: &[RigidBody]) -> usize {
        let (mut farthest, mut joint) = (f64::NEG_INFINITY, 0);
        for (index, watch) in self.watches.iter().enumerate() {
            let seen = watch.see(bodies);
            let moved = seen.opening.max(seen.slip[0].hypot(seen.slip[1]));
            if moved > farthest {
                (farthest, joint) = (moved, index);
            }
        }
        joint
    }

    /// Distance from the vertical through a stone's centroid to the edge of its support, over that at rest; 1 if there was none at rest.
    fn margin_ratio(&self, assembly: &Assembly, block: usize) -> f64 {
        let rest = self.margins[block].filter(|margin| *margin > 0.0);
        let now = plumb_margin(assembly, block + 1);
        now.zip(rest).map_or(1.0, |(now, rest)| now / rest)
    }

    /// The stone on the brink with the smallest remaining distance, if any.
    fn on_the_brink(&self, assembly: &Assembly) -> Option<Outcome> {
        let (mut least, mut found) = (f64::INFINITY, None);
        for block in 0..self.margins.len() {
            let margin_ratio = self.margin_ratio(assembly, block);
            let (mut slip_m, mut far) = (0.0_f64, false);
            for watch in self.watches.iter().filter(|watch| watch.upper == block + 1) {
                let [x, y] = watch.see(&assembly.bodies).slip;
                slip_m = slip_m.max(x.hypot(y));
                far |= x.hypot(y) > BRINK * watch.width_along([x, y]);
            }
            if (far || margin_ratio < BRINK) && margin_ratio < least {
                least = margin_ratio;
                found = Some(Outcome::Slid {
                    block,
                    slip_m,
                    margin_ratio,
                });
            }
        }
        found
    }

    /// A stone that is not at rest, if there is one, with the remaining fraction of its distance to the edge of the support. It is a stone whose
    /// centroid is at or beyond its edge, or the upper stone of the joint with the largest motion.
    fn moving(&self, assembly: &Assembly) -> Option<(usize, f64)> {
        let each = (0..self.margins.len()).map(|block| (block, self.margin_ratio(assembly, block)));
        let least = each.min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((block, ratio)) = least.filter(|(_, ratio)| *ratio < EDGE) {
            return Some((block, ratio));
        }
        let moving = self.stillness.moving_joint()?;
        let block = match self.is_loose {
            true => moving / 2,
            false => self.watches[moving].upper - 1,
        };
        Some((block, self.margin_ratio(assembly, block)))
    }

    /// Whether a run may end here, after its shaking: the stack is at rest or rocks with decreasing amplitude, or the verdict is known.
    pub(super) fn may_end(&mut self, assembly: &Assembly, time_s: f64) -> bool {
        let is_open = matches!(self.outcome, None | Some(Outcome::Uplifted { .. }));
        if !is_open {
            return true;
        }
        let way = self.stillness.farthest().map_or(0.0, |(way, _)| way);
        let each = (0..self.margins.len()).map(|block| self.margin_ratio(assembly, block));
        let margin_ratio = each.fold(f64::INFINITY, f64::min);
        if !self.is_loose {
            self.swings.see(time_s, way, margin_ratio);
        }
        self.swings.die_down() || self.moving(assembly).is_none()
    }

    /// Whether the run is open, and all stones are at rest.
    pub(super) fn is_at_rest(&self, assembly: &Assembly) -> bool {
        matches!(self.outcome, None | Some(Outcome::Uplifted { .. })) && self.moving(assembly).is_none()
    }

    /// Whether the run ends before its time.
    pub(super) fn ended(&self, after_fall: AfterFall) -> bool {
        match self.outcome {
            Some(Outcome::Diverged { .. }) => true,
            Some(Outcome::Fell { .. }) => after_fall == AfterFall::Stop,
            _ => false,
        }
    }

    /// Ends the run at a step without a solution.
    pub(super) fn not_converged(&mut self, at_s: f64, residual_m_s: f64) {
        self.outcome = Some(Outcome::NotConverged { at_s, residual_m_s });
    }

    pub(super) fn stop(&mut self, at_s: f64) {
        if !matches!(self.outcome, Some(Outcome::Fell { .. })) {
            self.outcome = Some(Outcome::Stopped { at_s });
        }
    }

    /// Outcome from the final positions of the stones; uplift of joints is not considered here.
    fn at_the_end(&self, assembly: &Assembly) -> Option<Outcome> {
        let at_s = self.history.time_s.last().copied().unwrap_or_default();
        match self.moving(assembly) {
            Some((block, margin_ratio)) if !self.swings.die_down() => Some(Outcome::StillMoving {
                block,
                margin_ratio,
                at_s,
            }),
            _ => match self.falls.at_rest(assembly, at_s) {
                Some((block, at_s)) => {
                    let joint = self.gave_way(&assembly.bodies);
                    Some(Outcome::Fell { block, joint, at_s })
                }
                None => self.on_the_brink(assembly),
            },
        }
    }

    /// The finished history; `steps` are the step of the run and the longest stable step, s.
    pub(super) fn finish(self, assembly: &Assembly, steps: [f64; 2]) -> StackHistory {
        let links = assembly.links().iter().enumerate();
        let broken_ties = links
            .filter(|(_, link)| link.broken)
            .map(|(index, _)| index)
            .collect();
        let outcome = match self.outcome {
            None | Some(Outcome::Uplifted { .. }) => self.at_the_end(assembly).or(self.outcome.clone()),
            _ => self.outcome.clone(),
        };
        let mut joints = self.history.joints;
        for (joint, watch) in joints.iter_mut().zip(&self.watches) {
            joint.bearing = assembly.bearing_of(watch.lower, watch.upper);
        }
        StackHistory {
            outcome: outcome.unwrap_or(Outcome::Stood),
            joints,
            time_step_s: steps[0],
            longest_step_s: steps[1],
            broken_ties,
            ..self.history
        }
    }
}

/// Rounds up, except for rounding errors; at least 1.
pub(super) fn whole_at_least(number: f64) -> usize {
    const ROUNDING: f64 = 1e-9;
    ((number * (1.0 - ROUNDING)).ceil() as usize).max(1)
}

/// Potential energy Σ m g z, J.
fn potential(assembly: &Assembly) -> f64 {
    let bodies = assembly.bodies.iter().skip(1);
    bodies
        .map(|body| body.mass * assembly.gravity * body.position.z)
        .sum()
}
