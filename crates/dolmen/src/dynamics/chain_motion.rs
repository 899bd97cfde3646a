//! The motion of a chain of links up to collapse.
//!
//! Stages of a step: find the sticking joints → expand the series from the state → shorten the step until the series is exact → find the first
//! event in it → record until the event → change the joint.

use super::chain_friction_state::Change;
use super::chain_history::{ChainHistory, ChainOutcome};
use super::chain_model::ChainModel;
use super::chain_moving::{Run, TOGETHER_S};
use super::chain_props::PropState;
use super::chain_rigid::{holding, rigid_joints};
use super::chain_run::ChainRun;
use super::chain_series::{JointState, Series};
use super::{DynamicsError, TimeFunction};
use crate::numeric::first_descent;

/// Largest growth of a step over the one before it.
const GROWTH: f64 = 1.5;
/// Steps between calls of `progress`.
const STEPS_A_CALL: usize = 256;

/// Motion of a chain under an acceleration of the ground, m/s².
///
/// ```text
/// Σ_j M_ij (cos(θ_i − θ_j) θ_j'' + sin(θ_i − θ_j) θ_j'²) = G_i sin θ_i − τ_i + τ_{i+1} − δ_i + δ_{i+1} − Γ_i a_g cos θ_i
/// τ_i = k_i φ_i, at most N_i b_i/2 in size where the joint opens;  δ_i = d_i φ_i';  φ_i = θ_i − θ_{i−1}         n links
/// θ_0 = 0, or the lean of the whole chain;  a side support adds −Σ c_i F cos θ_i, F = s (u − g) beyond its gap, u = Σ c_i sin θ_i
/// with friction τ_i + q_i:  q_i = f_k sign φ_i' while the joint rotates; while it sticks φ_i' = 0 and |q_i| ≤ f_s
/// ```
/// The solution is a Taylor series of degree 24 whose last terms are below rounding. The ground acceleration is linear between its samples,
/// where steps end. Events are the first roots of these polynomials: a joint that opens or closes, a contact with a side support that begins or
/// ends, the fall of a link. No event is missed, however short. Peaks are also those of the polynomials. Links connected by stuck joints rotate
/// together, and so do links connected by very stiff joints, which change every other natural frequency by less than 1e-4
/// ([`ChainHistory::rigid_joints`]), unless the bed of such a joint would come to its edge. Friction is not regularised: sticking, slipping and
/// reversal are events, at which the states of all joints at rest are determined together.
///
/// `progress` receives the simulated time at intervals, and stops the run by returning false.
///
/// # Errors
/// [`DynamicsError`] for options out of range, and if a step becomes too short. Nothing is regularised or guessed.
///
/// # Limits
/// Motion is in one plane. Joints do not slide, and closing joints and side supports lose no energy. Axial forces are those at rest. A fall is a
/// limit of rotation, without a ground to land on. Steps are explicit: a dashpot that is many orders of magnitude above the others makes them
/// correspondingly short. Over 100 s of five links without damping the energy balance has a measured error of 1.5e-14 of the largest kinetic
/// energy.
///
/// # Source
/// Equations: Choi (2021), eqs 3 to 28, without the assumption of small rotations. Method: Jorba, À. and Zou, M. (2005) A software package for
/// the numerical integration of ODEs by means of high-order Taylor methods. Exp. Math. 14:99-117. Differs from the source: the degree is always
/// 24, and a step that is too long is shortened before it is taken.
pub fn simulate_chain(
    model: &ChainModel,
    ground_acceleration_m_s2: &TimeFunction,
    options: &ChainRun,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<ChainHistory, DynamicsError> {
    let load = ground_acceleration_m_s2;
    let duration_s = options.check(model, load)?;
    let mut released = Vec::new();
    loop {
        let rigid = rigid_joints(model, options, &released);
        let holding = holding(model, &rigid);
        let mut run = Run::start(&holding, rigid, load, options, duration_s);
        match follow(&mut run, load, duration_s, progress)? {
            None => return Ok(run.finish()),
            Some(joint) => released.push(joint),
        }
    }
}

/// Computes a run to its end. Returns the rigid joint that would rock on the edge of its bed, if there is one.
fn follow(
    run: &mut Run<'_>,
    load: &TimeFunction,
    duration_s: f64,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<Option<usize>, DynamicsError> {
    let mut ends = load.breaks_s(duration_s);
    ends.push(duration_s);
    let mut try_s = run.series.first_step_s();
    let first_end_s = ends.iter().find(|end| **end > TOGETHER_S).copied();
    run.settle(
        load,
        try_s.min(load.step_most_s()).min(first_end_s.unwrap_or(try_s)),
    )?;
    run.friction_now(0.0);
    run.sample();
    for end_s in ends {
        while end_s - run.at_s > TOGETHER_S {
            let limit_s = load.step_most_s().min(end_s - run.at_s);
            let asked_s = try_s.min(limit_s);
            run.settle(load, asked_s)?;
            let h = run.series.expand(&run.state, load, run.at_s, asked_s)?;
            try_s = if asked_s < try_s && h == asked_s {
                try_s
            } else {
                GROWTH * h
            };
            if let Some(joint) = run.beyond_its_bed() {
                return Ok(Some(joint));
            }
            let ended = run.step(h, end_s)?;
            let steps = run.history.steps;
            if ended {
                return Ok(None);
            }
            if steps.is_multiple_of(STEPS_A_CALL) && !progress(run.at_s) {
                run.history.outcome = ChainOutcome::Stopped { at_s: run.at_s };
                return Ok(None);
            }
        }
    }
    Ok(None)
}

#[derive(Clone, Copy)]
enum Event {
    Joint(usize, JointState),
    Friction(usize, Change),
    Prop(usize, PropState),
    Fall(usize),
}

impl Run<'_> {
    /// Advances by the expanded step of `h` s, or to the first event in it. Returns whether the run is over.
    fn step(&mut self, h: f64, end_s: f64) -> Result<bool, DynamicsError> {
        let mut first = (1.0, None);
        for i in 0..self.state.theta.len() {
            for sign in [1.0, -1.0] {
                let mut left: Series = self.series.theta[i].map(|c| -sign * c);
                left[0] += self.fall_rad;
                if let Some(sigma) = first_descent(&left, 0.0).filter(|s| *s <= first.0) {
                    first = (sigma, Some(Event::Fall(i)));
                }
            }
            self.first_change(i, &mut first);
            if let Some((sigma, change)) = self.first_slider_change(i).filter(|(s, _)| *s <= first.0) {
                first = (sigma, Some(Event::Friction(i, change)));
            }
        }
        for prop in 0..self.state.props.len() {
            self.first_touch(prop, &mut first);
        }
        let (part, event) = first;
        // a change at the very start of a step has no effect
        if part > 0.0 {
            self.series.shorten(part);
            self.record(part * h, if part == 1.0 { Some(end_s) } else { None });
        }
        self.history.steps += 1;
        self.changed.clear();
        self.touched.clear();
        if part * h > TOGETHER_S {
            self.friction.moved_on();
        }
        Ok(match event {
            Some(Event::Fall(link)) => {
                self.history.outcome = ChainOutcome::Fell {
                    link,
                    at_s: self.at_s,
                };
                true
            }
            Some(Event::Joint(joint, state)) => {
                match state {
                    JointState::Open(_) => {
                        self.opened_s[joint] = self.at_s;
                        if self.history.outcome == ChainOutcome::Stood {
                            self.history.outcome = ChainOutcome::Uplifted {
                                joint,
                                at_s: self.at_s,
                            };
                        }
                    }
                    JointState::Closed => self.close(joint),
                }
                self.state.joints[joint] = state;
                self.changed.push(joint);
                false
            }
            Some(Event::Prop(prop, state)) => {
                self.touch(prop, state);
                false
            }
            Some(Event::Friction(joint, change)) => {
                self.change_slider(joint, change)?;
                false
            }
            None => false,
        })
    }

    /// A rigid joint whose moment within the step reaches N b/2, the moment at the edge of its bed.
    fn beyond_its_bed(&self) -> Option<usize> {
        let mut rigid = self.history.rigid_joints.iter().map(|of| of.joint);
        rigid.find(|joint| {
            let (held, most) = (
                &self.series.held[*joint],
                self.series.model.moment_most_n_m[*joint],
            );
            if held.iter().map(|c| c.abs()).sum::<f64>() < most {
                return false;
            }
            held[0].abs() >= most
                || [1.0, -1.0].into_iter().any(|sign| {
                    let mut left = held.map(|c| -sign * c);
                    left[0] += most;
                    first_descent(&left, 0.0).is_some()
                })
        })
    }

    /// Moves `first` forward if joint `i` opens or closes before it.
    fn first_change(&self, i: usize, first: &mut (f64, Option<Event>)) {
        let most = self.series.model.moment_most_n_m[i];
        if most.is_infinite() {
            return;
        }
        let k = self.series.model.joints[i].stiffness_n_m_rad;
        let moment = self.series.across[i].map(|c| k * c);
        let changes = match self.state.joints[i] {
            JointState::Closed => [1.0, -1.0].map(|sign| Some((-sign, most, JointState::Open(sign)))),
            JointState::Open(sign) => [Some((sign, -most, JointState::Closed)), None],
        };
        for (sign, limit, next) in changes.into_iter().flatten() {
            let mut left = moment.map(|c| sign * c);
            left[0] += limit;
            if self.changed.contains(&i) && left[0].abs() < most {
                left[0] = 0.0;
            }
            if let Some(sigma) = first_descent(&left, 0.0).filter(|s| *s <= first.0) {
                *first = (sigma, Some(Event::Joint(i, next)));
            }
        }
    }

    /// Moves `first` forward if a contact with a side support begins or ends before it.
    fn first_touch(&self, p: usize, first: &mut (f64, Option<Event>)) {
        let gap_m = self.series.model.props[p].gap_m;
        if gap_m == 0.0 {
            return;
        }
        let changes = match self.state.props[p] {
            PropState::Free => [1.0, -1.0].map(|sign| Some((-sign, gap_m, PropState::Touching(sign)))),
            PropState::Touching(sign) => [Some((sign, -gap_m, PropState::Free)), None],
        };
        for (sign, limit, next) in changes.into_iter().flatten() {
            let mut left = self.series.beside[p].map(|c| sign * c);
            left[0] += limit;
            if self.touched.contains(&p) && left[0].abs() < gap_m {
                left[0] = 0.0;
            }
            if let Some(sigma) = first_descent(&left, 0.0).filter(|s| *s <= first.0) {
                *first = (sigma, Some(Event::Prop(p, next)));
            }
        }
    }

    fn finish(mut self) -> ChainHistory {
        for joint in 0..self.state.joints.len() {
            if self.state.joints[joint] != JointState::Closed {
                self.close(joint);
            }
            self.end_slip(joint);
            let across_rad = self.history.joint_peaks[joint].rotation_rad;
            let rigid = self.history.rigid_joints.iter().find(|of| of.joint == joint);
            self.history.joint_moment_peaks_n_m[joint] = match rigid {
                Some(of) => (of.stiffness_n_m_rad * across_rad).abs(),
                None => self.series.model.moment_n_m(joint, across_rad).abs(),
            };
        }
        self.end_touches();
        self.history.uplifts.sort_by(|a, b| a.from_s.total_cmp(&b.from_s));
        if self.history.times_s.last() != Some(&self.at_s) {
            self.sample();
        }
        self.history.at_rest = self.is_at_rest();
        self.end_undecided();
        self.history.slips = std::mem::take(&mut self.friction.slips);
        self.history.friction_events = self.friction.events;
        if self.kinetic_most_j > 0.0 {
            self.history.energy_left_over_ratio = self.left_over_most_j / self.kinetic_most_j;
        }
        self.history
    }
}
