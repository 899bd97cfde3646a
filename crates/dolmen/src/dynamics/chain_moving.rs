//! A chain during a run: its state, and the samples, peaks and energies of its steps.

use super::TimeFunction;
use super::chain_friction_state::Friction;
use super::chain_history::{
    ChainEnergy, ChainHistory, ChainOutcome, ChainPeak, ChainSupportPeak, ChainTouch, ChainUplift,
};
use super::chain_model::ChainModel;
use super::chain_props::{Prop, PropState};
use super::chain_rigid::ChainRigidJoint;
use super::chain_rotations::ChainRotations;
use super::chain_run::ChainRun;
use super::chain_series::{ChainSeries, ChainState, DEGREE, JointState, Series, rate};
use super::frame_model::Slider;
use crate::numeric::{first_descent, polynomial};

/// Times closer than this are equal, s.
pub(super) const TOGETHER_S: f64 = 1e-12;
/// Fraction of a step after a turning point in which the next one is not searched: the value changes there by its square only.
const BESIDE: f64 = 1e-7;

pub(super) struct Run<'a> {
    pub(super) series: ChainSeries<'a>,
    pub(super) state: ChainState,
    pub(super) friction: Friction,
    /// Friction moment of each joint at the current time, N m.
    friction_n_m: Vec<f64>,
    pub(super) at_s: f64,
    output_step_s: f64,
    pub(super) fall_rad: f64,
    /// Joints that changed at the start of this step: they are at their limit, and rounding hides on which side.
    pub(super) changed: Vec<usize>,
    /// Contacts with side supports that began or ended at the start of this step.
    pub(super) touched: Vec<usize>,
    /// Start of each contact, s.
    met_s: Vec<f64>,
    energy: ChainEnergy,
    pub(super) kinetic_most_j: f64,
    pub(super) left_over_most_j: f64,
    pub(super) opened_s: Vec<f64>,
    /// End of the load, s; 0 for an endless one.
    load_end_s: f64,
    pub(super) history: ChainHistory,
}

impl<'a> Run<'a> {
    pub(super) fn start(
        model: &'a ChainModel,
        rigid: Vec<ChainRigidJoint>,
        load: &TimeFunction,
        options: &ChainRun,
        duration_s: f64,
    ) -> Self {
        let n = model.chain.links().len();
        let given = |values: &[f64]| {
            if values.is_empty() {
                vec![0.0; n]
            } else {
                values.to_vec()
            }
        };
        let theta = given(&options.start_rotation_rad);
        let joints = (0..n).map(|i| {
            let elastic = model.joints[i].stiffness_n_m_rad * model.across_rad(i, &theta);
            if elastic.abs() > model.moment_most_n_m[i] {
                JointState::Open(elastic.signum())
            } else {
                JointState::Closed
            }
        });
        let joints: Vec<JointState> = joints.collect();
        let omega = given(&options.start_velocity_rad_s);
        let sliders: Vec<Slider> = (0..n)
            .map(|i| match model.joints[i].friction.moments_n_m() {
                None if rigid.iter().any(|of| of.joint == i) => Slider::Stuck,
                None => Slider::Absent,
                Some(_) if relative(&omega, i) != 0.0 => Slider::Slipping(relative(&omega, i).signum()),
                Some(_) => Slider::Stuck,
            })
            .collect();
        let of_prop = |prop: &Prop| prop.state(prop.beside_m(&theta, model.rotations));
        let props: Vec<PropState> = model.props.iter().map(of_prop).collect();
        let samples = (duration_s / options.output_step_s) as usize + 2;
        let mut run = Run {
            series: ChainSeries::new(model),
            state: ChainState {
                omega,
                theta,
                joints,
                sliders: sliders.clone(),
                props,
            },
            friction: Friction::start(&sliders),
            friction_n_m: vec![0.0; n],
            at_s: 0.0,
            output_step_s: options.output_step_s,
            fall_rad: options.fall_rad,
            changed: Vec::new(),
            touched: Vec::new(),
            met_s: vec![0.0; model.props.len()],
            energy: ChainEnergy::default(),
            kinetic_most_j: 0.0,
            left_over_most_j: 0.0,
            opened_s: vec![0.0; n],
            load_end_s: load.duration_s(),
            history: ChainHistory {
                outcome: ChainOutcome::Stood,
                times_s: Vec::with_capacity(samples),
                rotation_rad: vec![Vec::with_capacity(samples); n],
                velocity_rad_s: vec![Vec::with_capacity(samples); n],
                joint_moment_n_m: vec![Vec::with_capacity(samples); n],
                friction_moment_n_m: vec![Vec::with_capacity(samples); n],
                energy: Vec::with_capacity(samples),
                rotation_peaks: vec![ChainPeak::default(); n],
                joint_peaks: vec![ChainPeak::default(); n],
                joint_moment_peaks_n_m: vec![0.0; n],
                top_peak_m: 0.0,
                top_peak_at_s: 0.0,
                uplifts: Vec::new(),
                slips: Vec::new(),
                support_force_n: vec![Vec::with_capacity(samples); model.props.len()],
                support_peaks: vec![ChainSupportPeak::default(); model.props.len()],
                touches: Vec::new(),
                friction_events: 0,
                energy_left_over_ratio: 0.0,
                steps: 0,
                at_rest: false,
                assumes_thin_rods: model.chain.assumes_thin_rods(),
                lean_rad: model.lean_rad,
                rigid_joints: rigid,
            },
        };
        if let Some(joint) = run.state.joints.iter().position(|j| *j != JointState::Closed) {
            run.history.outcome = ChainOutcome::Uplifted { joint, at_s: 0.0 };
        }
        run.weigh();
        run.energy.input_j = run.energy.kinetic_j + run.energy.gravity_j + run.energy.springs_j;
        run
    }

    pub(super) fn close(&mut self, joint: usize) {
        self.history.uplifts.push(ChainUplift {
            joint,
            from_s: self.opened_s[joint],
            to_s: self.at_s,
        });
    }

    /// Sets the new state of a side support.
    pub(super) fn touch(&mut self, prop: usize, state: PropState) {
        match state {
            PropState::Touching(_) => self.met_s[prop] = self.at_s,
            PropState::Free => self.left(prop),
        }
        self.state.props[prop] = state;
        self.touched.push(prop);
    }

    fn left(&mut self, support: usize) {
        self.history.touches.push(ChainTouch {
            support,
            from_s: self.met_s[support],
            to_s: self.at_s,
        });
    }

    /// End of the run: open contacts end with it.
    pub(super) fn end_touches(&mut self) {
        for support in 0..self.state.props.len() {
            if self.state.props[support] != PropState::Free {
                self.left(support);
            }
        }
        self.history.touches.sort_by(|a, b| a.from_s.total_cmp(&b.from_s));
    }

    /// Records peaks, samples, energy and the new state of a step of `h` s.
    pub(super) fn record(&mut self, h: f64, whole_to_s: Option<f64>) {
        let n = self.state.theta.len();
        for i in 0..n {
            look(
                &self.series.theta[i],
                self.at_s,
                h,
                &mut self.history.rotation_peaks[i],
            );
            let across = match self.history.rigid_joints.iter().find(|of| of.joint == i) {
                Some(of) => self.series.held[i].map(|moment| moment / of.stiffness_n_m_rad),
                None => self.series.across[i],
            };
            look(&across, self.at_s, h, &mut self.history.joint_peaks[i]);
        }
        for (p, prop) in self.series.model.props.iter().enumerate() {
            let largest = &mut self.history.support_peaks[p];
            let mut peak = ChainPeak {
                rotation_rad: largest.displacement_m,
                at_s: largest.at_s,
            };
            look(&self.series.beside[p], self.at_s, h, &mut peak);
            *largest = ChainSupportPeak {
                displacement_m: peak.rotation_rad,
                force_n: prop.force_n(peak.rotation_rad),
                at_s: peak.at_s,
            };
        }
        let mut top: Series = [0.0; DEGREE + 1];
        for (link, sin) in self.series.model.chain.links().iter().zip(&self.series.sin) {
            for (top, sin) in top.iter_mut().zip(sin) {
                *top += link.length_m * sin;
            }
        }
        let mut peak = ChainPeak {
            rotation_rad: self.history.top_peak_m,
            at_s: self.history.top_peak_at_s,
        };
        look(&top, self.at_s, h, &mut peak);
        (self.history.top_peak_m, self.history.top_peak_at_s) = (peak.rotation_rad, peak.at_s);

        let (ground, damping) = (self.series.ground_work_j(), self.series.damping_work_j(h));
        let (from_s, before) = (self.at_s, self.energy);
        let turned: Vec<f64> = (0..n).map(|i| self.across_now(i)).collect();
        let mut to_s = from_s + h;
        if let Some(end_s) = whole_to_s.filter(|end| (end - to_s).abs() <= TOGETHER_S) {
            to_s = end_s;
        }
        loop {
            let next_s = self.history.times_s.len() as f64 * self.output_step_s;
            let within = next_s < to_s;
            let (time_s, sigma) = if within {
                (next_s, (next_s - from_s) / h)
            } else {
                (to_s, 1.0)
            };
            self.at_s = time_s;
            for i in 0..n {
                [self.state.theta[i], self.state.omega[i]] = self.series.at(i, sigma, h);
            }
            self.energy.input_j = before.input_j + polynomial(&ground, sigma);
            self.energy.damping_j = before.damping_j + polynomial(&damping, sigma);
            self.energy.friction_j = before.friction_j + self.friction_work_j(&turned);
            self.friction_now(sigma);
            self.weigh();
            if !within {
                break;
            }
            self.sample();
        }
        self.left_over_most_j = self.left_over_most_j.max(self.energy.left_over_j().abs());
    }

    /// Energy dissipated by friction for these rotations of the joints, J: no joint reverses within a step.
    fn friction_work_j(&self, from_rad: &[f64]) -> f64 {
        let of_joint = |(i, from): (usize, &f64)| match (
            self.state.sliders[i],
            self.series.model.joints[i].friction.moments_n_m(),
        ) {
            (Slider::Slipping(_), Some([_, kinetic])) => kinetic * (self.across_now(i) - from).abs(),
            _ => 0.0,
        };
        from_rad.iter().enumerate().map(of_joint).sum()
    }

    /// Current rotation across a joint, rad.
    pub(super) fn across_now(&self, joint: usize) -> f64 {
        self.series.model.across_rad(joint, &self.state.theta)
    }

    /// Moments of friction at σ of the step.
    pub(super) fn friction_now(&mut self, sigma: f64) {
        for i in 0..self.friction_n_m.len() {
            self.friction_n_m[i] = match (
                self.state.sliders[i],
                self.series.model.joints[i].friction.moments_n_m(),
            ) {
                (Slider::Slipping(sign), Some([_, kinetic])) => sign * kinetic,
                (Slider::Stuck, _) => polynomial(&self.series.held[i], sigma),
                _ => 0.0,
            };
        }
    }

    pub(super) fn sample(&mut self) {
        self.history.times_s.push(self.at_s);
        for i in 0..self.state.theta.len() {
            let spring = self.series.model.moment_n_m(i, self.across_now(i));
            self.history.joint_moment_n_m[i].push(spring + self.friction_n_m[i]);
            let is_rigid = self.history.rigid_joints.iter().any(|of| of.joint == i);
            self.history.friction_moment_n_m[i].push(if is_rigid { 0.0 } else { self.friction_n_m[i] });
            self.history.rotation_rad[i].push(self.state.theta[i]);
            self.history.velocity_rad_s[i].push(self.state.omega[i]);
        }
        let model = self.series.model;
        for (prop, forces) in model.props.iter().zip(&mut self.history.support_force_n) {
            forces.push(prop.force_n(prop.beside_m(&self.state.theta, model.rotations)));
        }
        self.history.energy.push(self.energy);
    }

    pub(super) fn weigh(&mut self) {
        let (theta, omega) = (&self.state.theta, &self.state.omega);
        let large = self.series.model.rotations == ChainRotations::Large;
        let n = theta.len();
        let (mut kinetic, mut gravity, mut springs) = (0.0, 0.0, 0.0);
        for i in 0..n {
            for j in 0..n {
                let turned = if large { (theta[i] - theta[j]).cos() } else { 1.0 };
                kinetic += 0.5 * self.series.mass[(i, j)] * turned * omega[i] * omega[j];
            }
            // 1 − cos θ = 2 sin²(θ/2)
            let half = if large {
                (0.5 * theta[i]).sin()
            } else {
                0.5 * theta[i]
            };
            gravity -= 2.0 * self.series.gravity[i] * half * half;
            let model = self.series.model;
            springs += model.spring_energy_j(i, model.across_rad(i, theta));
        }
        let model = self.series.model;
        for prop in &model.props {
            springs += prop.energy_j(prop.beside_m(theta, model.rotations));
        }
        self.energy.kinetic_j = kinetic;
        self.energy.gravity_j = gravity;
        self.energy.springs_j = springs;
        self.kinetic_most_j = self.kinetic_most_j.max(kinetic);
    }

    /// Sets the outcome to `StillLeaning` if a link was falling at the end of the run. It compares with the samples since the end of the load,
    /// at least with the second half of the run, in which a decaying oscillation leans further.
    pub(super) fn end_undecided(&mut self) {
        let is_over = matches!(
            self.history.outcome,
            ChainOutcome::Stood | ChainOutcome::Uplifted { .. }
        );
        let from_s = self.load_end_s.min(0.5 * self.at_s);
        if is_over && let Some(link) = self.history.leaning_out(from_s) {
            self.history.outcome = ChainOutcome::StillLeaning {
                link,
                at_s: self.at_s,
            };
        }
    }
}

/// Rate of the rotation across joint i, from its links.
fn relative(omega: &[f64], i: usize) -> f64 {
    omega[i] - i.checked_sub(1).map_or(0.0, |below| omega[below])
}

/// Raises `peak` to the largest magnitude of `c` on the step.
fn look(c: &Series, at_s: f64, h: f64, peak: &mut ChainPeak) {
    if c.iter().map(|c| c.abs()).sum::<f64>() <= peak.rotation_rad.abs() {
        return;
    }
    let mut take = |sigma: f64| {
        let value = polynomial(c, sigma);
        if value.abs() > peak.rotation_rad.abs() {
            *peak = ChainPeak {
                rotation_rad: value,
                at_s: at_s + sigma * h,
            };
        }
    };
    take(0.0);
    take(1.0);
    // turning points: zeros of the rate, alternately falling and rising
    let rising = rate(c);
    let falling = rising.map(|c| -c);
    let mut sigma = 0.0;
    let mut sign = rising.iter().find(|c| **c != 0.0).is_some_and(|c| *c > 0.0);
    for _ in 0..DEGREE {
        let Some(turn) = first_descent(if sign { &rising } else { &falling }, sigma) else {
            break;
        };
        take(turn);
        // past the turning point, where rounding hides the sign of the rate
        (sigma, sign) = (turn + BESIDE, !sign);
        if sigma >= 1.0 {
            break;
        }
    }
}
