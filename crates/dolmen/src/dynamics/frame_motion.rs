//! A frame with dry friction in time: exact from event to event, whatever the number of storeys.
//!
//! Stages of a step: series of the motion while no slider changes → first event in it → record up to there → let sliders go or
//! stop, and find what the others do then.

use super::DynamicsError;
use super::excitation::FrameLoad;
use super::frame_friction::{FrictionFrame, StoreyFriction};
use super::frame_history::{FrameHistory, FrameOutcome};
use super::frame_record::Recorder;
use super::frame_series::{Model, Series, Slider, State};
use crate::numeric::{COEFFICIENTS_MOST, first_descent};

/// Changes of sliders closer than this are one event, s: what the problem asks its events to be located to.
const TOGETHER_S: f64 = 1e-12;
/// Events closer than this count as a pile, s.
const PILE_S: f64 = 1e-9;
/// Part of the largest force below which a force at an event, or a rate of it over the step, is rounding: some thousand
/// times that of one number, for what the balance of twenty levels sums up.
const ROUNDING: f64 = 1e-12;
/// Rates that are looked at where a force is just at its limit: the deepest case known, springs that a slip begins to stretch, is
/// decided by the third rate for each storey up.
const DECIDING_ORDERS: usize = 24;

/// Options of [`simulate_frame`].
#[derive(Clone, Debug, PartialEq)]
pub struct FrameRun {
    /// Length of the run, s. `None`, the default, for that of the load.
    pub duration_s: Option<f64>,
    /// Time between samples of the history, s. Default 0.005.
    pub output_step_s: f64,
    /// Displacements at the start, m; empty, the default, for none.
    pub start_displacement_m: Vec<f64>,
    /// Velocities at the start, m/s; empty, the default, for none.
    pub start_velocity_m_s: Vec<f64>,
    /// Drift of a storey over its height at which the run ends: the model knows small drifts only. Default 0.1 (our choice):
    /// sin and tan of it differ from it by .2 and .3 %.
    pub drift_ratio_most: f64,
}

impl Default for FrameRun {
    fn default() -> Self {
        FrameRun {
            duration_s: None,
            output_step_s: 0.005,
            start_displacement_m: Vec::new(),
            start_velocity_m_s: Vec::new(),
            drift_ratio_most: 0.1,
        }
    }
}

/// Motion of a frame with dry friction.
///
/// ```text
/// M Y'' + C Y' + K Y + Σ b_i q_i = −M 1 a_ground + F                              n levels
/// Coulomb:  q = s f_k while the slider moves (s its direction); while it stands |q| ≤ f_s and b·Y' = 0
/// Jenkins:  q = k_s (b·Y − z), |q| ≤ f_s; at f_s the slider moves with q = s f_k
/// ```
/// Between events the equation is linear and its solution is expanded in a Taylor series to the last digit (the exponential of
/// its matrix, applied to the state); the ground's acceleration is straight between its samples. Events are the first
/// crossings of the polynomials so found: none is passed over, however short, and each is located to rounding. At an event the
/// sliders that are at rest are let go one by one, the one furthest above its force first, until all agree with the law: a
/// search of order n.
///
/// `progress` gets the simulated time now and then, and stops the run by returning false.
///
/// # Errors
/// [`DynamicsError`] for options out of range, and if at an event no state of sticking and slipping agrees with the law. Nothing
/// is smoothed or guessed.
///
/// # Limits
/// Small drifts, linear springs, constant axial forces. Energy balances to about 1e-13 of the input.
///
/// # Source
/// Park, S.-A. and Min, K.-W. (2010), eqs 9 to 11. Differs from the source: friction acts on the drift (eq. 11, on the
/// displacement, by [`FrictionActsOn`](super::FrictionActsOn)), and sticking is part of the law.
pub fn simulate_frame(
    frame: &FrictionFrame,
    load: &FrameLoad,
    options: &FrameRun,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<FrameHistory, DynamicsError> {
    let duration_s = options.check(frame, load)?;
    let mut motion = Motion::start(frame, load, options)?;
    let mut recorder = Recorder::new(&motion.model, &motion.state, options.output_step_s, duration_s);
    let step_most_s = motion.model.step_most_s().min(load_step_most_s(load));
    let heights_m: Vec<f64> = frame.frame.storeys().iter().map(|s| s.height_m).collect();
    let mut outcome = FrameOutcome::Finished;
    let mut reported = 0;
    'run: for end_s in ends_s(load, duration_s) {
        while end_s - motion.at_s > TOGETHER_S {
            let h = step_most_s.min(end_s - motion.at_s);
            motion.step(h, end_s, &mut recorder)?;
            for (storey, height) in heights_m.iter().enumerate() {
                let drift =
                    motion.state.y[storey] - storey.checked_sub(1).map_or(0.0, |below| motion.state.y[below]);
                if drift.is_nan() || drift.abs() > options.drift_ratio_most * height {
                    outcome = FrameOutcome::DriftLimit {
                        storey,
                        at_s: motion.at_s,
                    };
                    break 'run;
                }
            }
            reported += 1;
            if reported % 256 == 0 && !progress(motion.at_s) {
                outcome = FrameOutcome::Stopped { at_s: motion.at_s };
                break 'run;
            }
        }
    }
    Ok(recorder.finish(&motion.model, &motion.state, motion.at_s, outcome))
}

impl FrameRun {
    fn check(&self, frame: &FrictionFrame, load: &FrameLoad) -> Result<f64, DynamicsError> {
        let n = frame.frame.storeys().len();
        let refuse = |argument, given, allowed| {
            Err(DynamicsError::Argument {
                argument,
                given,
                allowed,
            })
        };
        load.ground_acceleration_m_s2.check("ground_acceleration_m_s2")?;
        for force in &load.forces_n {
            force.check("forces_n")?;
        }
        for (argument, given) in [
            ("forces_n", load.forces_n.len()),
            ("start_displacement_m", self.start_displacement_m.len()),
            ("start_velocity_m_s", self.start_velocity_m_s.len()),
        ] {
            if given != 0 && given != n {
                return Err(DynamicsError::Count {
                    argument,
                    given,
                    needed: n,
                });
            }
        }
        for (argument, values) in [
            ("start_displacement_m", &self.start_displacement_m),
            ("start_velocity_m_s", &self.start_velocity_m_s),
        ] {
            if let Some(&given) = values.iter().find(|x| !x.is_finite()) {
                return refuse(argument, given, "a number");
            }
        }
        let positive = |x: f64| x > 0.0 && x.is_finite();
        if !positive(self.output_step_s) {
            return refuse("output_step_s", self.output_step_s, "a positive number");
        }
        if !positive(self.drift_ratio_most) {
            return refuse("drift_ratio_most", self.drift_ratio_most, "a positive number");
        }
        let duration_s = self.duration_s.unwrap_or(load.duration_s());
        if !positive(duration_s) {
            return refuse(
                "duration_s",
                duration_s,
                "a positive number: give it where no sampled load does",
            );
        }
        Ok(duration_s)
    }
}

fn load_step_most_s(load: &FrameLoad) -> f64 {
    let forces = load.forces_n.iter().map(|f| f.step_most_s());
    forces.fold(load.ground_acceleration_m_s2.step_most_s(), f64::min)
}

/// Ends of the stretches on which the load is one series, in order; the last is that of the run.
fn ends_s(load: &FrameLoad, duration_s: f64) -> Vec<f64> {
    let mut ends = load.ground_acceleration_m_s2.breaks_s(duration_s);
    for force in &load.forces_n {
        ends.extend(force.breaks_s(duration_s));
    }
    ends.push(duration_s);
    ends.sort_by(f64::total_cmp);
    ends.dedup_by(|later, earlier| *later - *earlier <= TOGETHER_S);
    ends
}

/// A change of a slider within a step.
#[derive(Clone, Copy)]
struct Event {
    sigma: f64,
    storey: usize,
    change: Change,
}

#[derive(Clone, Copy, PartialEq)]
enum Change {
    /// Its force has reached the static one, in this direction.
    Goes(f64),
    /// It has come to a stop.
    Stops,
}

struct Motion<'a> {
    model: Model,
    load: &'a FrameLoad,
    state: State,
    series: Series,
    at_s: f64,
    /// How many first coefficients of what each slider waits for are zero, after an event: there they hold rounding.
    zeros: Vec<usize>,
    /// Sliders may have to change before the next step; what they did before, if so.
    unsettled: Option<Vec<Slider>>,
    /// Below this a force or a rate of it is rounding, N: it grows with the orders that are looked at.
    rounding_n: f64,
    /// Sliders that go at any price: their static force was reached and is above the kinetic one.
    gone: Vec<usize>,
    events: Vec<Event>,
    pile: usize,
    pile_at_s: f64,
}

impl<'a> Motion<'a> {
    fn start(frame: &FrictionFrame, load: &'a FrameLoad, options: &FrameRun) -> Result<Self, DynamicsError> {
        let model = Model::of(frame)?;
        let n = model.levels();
        let given = |values: &Vec<f64>| {
            if values.is_empty() {
                vec![0.0; n]
            } else {
                values.clone()
            }
        };
        let mut state = State {
            y: given(&options.start_displacement_m),
            v: given(&options.start_velocity_m_s),
            slider: vec![Slider::Absent; n],
            offset_m: vec![0.0; n],
        };
        for i in 0..n {
            let (across, speed) = (model.across(i, &state.y), model.across(i, &state.v));
            state.slider[i] = match model.friction[i] {
                StoreyFriction::None => Slider::Absent,
                StoreyFriction::Coulomb { .. } if speed != 0.0 => Slider::Slipping(speed.signum()),
                StoreyFriction::Coulomb { .. } => Slider::Stuck,
                StoreyFriction::Jenkins {
                    stuck_stiffness_n_m,
                    static_force_n,
                    kinetic_force_n,
                } => {
                    // a start beyond its force finds the slider slipped so far
                    if stuck_stiffness_n_m * across.abs() > static_force_n {
                        state.offset_m[i] = across - across.signum() * kinetic_force_n / stuck_stiffness_n_m;
                    }
                    Slider::Stuck
                }
            };
        }
        let mut motion = Motion {
            series: Series::new(n),
            model,
            load,
            state,
            at_s: 0.0,
            zeros: vec![0; n],
            unsettled: None,
            rounding_n: 0.0,
            gone: Vec::new(),
            events: Vec::new(),
            pile: 0,
            pile_at_s: f64::NEG_INFINITY,
        };
        motion.unsettled = Some(motion.state.slider.clone());
        Ok(motion)
    }

    /// Goes on by h at most, to the next event; `end_s` is where the series of the load ends.
    fn step(&mut self, mut h: f64, end_s: f64, recorder: &mut Recorder) -> Result<(), DynamicsError> {
        if let Some(before) = self.unsettled.take() {
            self.find_state(h)?;
            recorder.changed(&self.model, &self.state, &before, self.at_s);
        }
        loop {
            self.series.act(self.load, self.at_s, h);
            self.series.join(&self.model, &self.state);
            if self.series.expand(&self.model, &self.state) {
                break;
            }
            h *= 0.5;
        }
        let sigma = self.first_events(h);
        let begin_s = self.at_s;
        let ends = self.events.is_empty() && end_s - (begin_s + h) <= TOGETHER_S;
        self.at_s = if ends { end_s } else { begin_s + sigma * h };
        recorder.stretch(&self.model, &self.state, &self.series, begin_s, sigma);
        self.advance(sigma);
        if sigma * h > TOGETHER_S {
            self.zeros.fill(0);
        }
        if !self.events.is_empty() {
            self.change(recorder)?;
        }
        Ok(())
    }

    /// Puts the first event and those together with it into `events`; returns where the step ends.
    fn first_events(&mut self, h: f64) -> f64 {
        self.events.clear();
        let mut first = 1.0_f64;
        let together = TOGETHER_S / h;
        for storey in 0..self.model.levels() {
            let Some(event) = self.event_of(storey) else {
                continue;
            };
            if event.sigma <= first + together {
                first = first.min(event.sigma);
                self.events.push(event);
            }
        }
        self.events.retain(|event| event.sigma <= first + together);
        self.events
            .iter()
            .fold(first, |last, event| last.max(event.sigma))
    }

    /// First change of one slider within the step.
    fn event_of(&self, storey: usize) -> Option<Event> {
        let zeros = self.zeros[storey];
        let s = &self.series;
        let at = |rows: &[f64], k: usize| {
            let below = self.model.below[storey].map_or(0.0, |j| rows[k * s.n + j]);
            rows[k * s.n + storey] - below
        };
        let mut c = [0.0; COEFFICIENTS_MOST];
        match (self.model.friction[storey], self.state.slider[storey]) {
            (_, Slider::Slipping(sign)) => {
                let orders = s.orders - 1;
                for (k, c) in c[..orders].iter_mut().enumerate() {
                    *c = sign * (k + 1) as f64 * at(&s.y, k + 1);
                }
                settle(&mut c[..orders], zeros);
                let sigma = first_descent(&c[..orders], 0.0)?;
                Some(Event {
                    sigma,
                    storey,
                    change: Change::Stops,
                })
            }
            (StoreyFriction::Coulomb { static_force_n, .. }, Slider::Stuck) => {
                let orders = s.orders - 2;
                for (k, c) in c[..orders].iter_mut().enumerate() {
                    *c = s.held[k * s.n + storey];
                }
                goes(storey, &c[..orders], static_force_n, zeros)
            }
            (
                StoreyFriction::Jenkins {
                    stuck_stiffness_n_m,
                    static_force_n,
                    ..
                },
                Slider::Stuck,
            ) => {
                for (k, c) in c[..s.orders].iter_mut().enumerate() {
                    *c = stuck_stiffness_n_m * at(&s.y, k);
                }
                c[0] -= stuck_stiffness_n_m * self.state.offset_m[storey];
                goes(storey, &c[..s.orders], static_force_n, zeros)
            }
            (StoreyFriction::None, _) | (_, Slider::Absent) => None,
        }
    }

    /// The state at σ of the step.
    fn advance(&mut self, sigma: f64) {
        let s = &self.series;
        for i in 0..s.n {
            let (mut y, mut v) = (0.0, 0.0);
            for k in (1..s.orders).rev() {
                let c = s.y[k * s.n + i];
                y = y * sigma + c;
                v = v * sigma + k as f64 * c;
            }
            self.state.y[i] = y * sigma + s.y[i];
            self.state.v[i] = v / s.h;
        }
        self.series.share_velocity(&self.model, &mut self.state);
    }

    /// Changes the sliders of `events` and finds what the others do then.
    fn change(&mut self, recorder: &mut Recorder) -> Result<(), DynamicsError> {
        if self.at_s - self.pile_at_s > PILE_S {
            (self.pile, self.pile_at_s) = (0, self.at_s);
        }
        self.pile += 1;
        if self.pile > 50 + 10 * self.model.levels() {
            return Err(DynamicsError::TooManyEvents {
                at_s: self.at_s,
                events: self.pile,
            });
        }
        let before = self.state.slider.clone();
        for &Event { storey, change, .. } in &self.events {
            match (self.model.friction[storey], change) {
                (StoreyFriction::Jenkins { .. }, Change::Goes(sign)) => {
                    self.state.slider[storey] = Slider::Slipping(sign);
                    recorder.jump(&self.model, storey);
                }
                (
                    StoreyFriction::Jenkins {
                        stuck_stiffness_n_m,
                        static_force_n,
                        kinetic_force_n,
                    },
                    Change::Stops,
                ) => {
                    if let Slider::Slipping(sign) = self.state.slider[storey] {
                        let across = self.model.across(storey, &self.state.y);
                        self.state.offset_m[storey] = across - sign * kinetic_force_n / stuck_stiffness_n_m;
                    }
                    self.state.slider[storey] = Slider::Stuck;
                    if static_force_n == kinetic_force_n {
                        // its force is at the limit, and the rate of it is that of the drift: none
                        self.zeros[storey] = 2;
                    }
                }
                (
                    StoreyFriction::Coulomb {
                        static_force_n,
                        kinetic_force_n,
                    },
                    Change::Goes(sign),
                ) if static_force_n > kinetic_force_n => {
                    self.state.slider[storey] = Slider::Slipping(sign);
                    self.gone.push(storey);
                }
                // whether it goes on, holds, or turns is found from the balance of all
                _ => self.state.slider[storey] = Slider::Stuck,
            }
        }
        self.series.join(&self.model, &self.state);
        self.series.share_velocity(&self.model, &mut self.state);
        self.unsettled = Some(before);
        Ok(())
    }

    /// Finds which Coulomb sliders that stand still hold and which go: those that cannot hold are let go, the worst first, until
    /// all agree with the law.
    ///
    /// With equal static and kinetic forces the accelerations are the minimum of a strictly convex function, so that the state is
    /// one. Where a force is just at its limit, the first of its rates that is not zero decides, order by order: storeys that
    /// carry their own weight times one coefficient reach their limits all at once.
    fn find_state(&mut self, h: f64) -> Result<(), DynamicsError> {
        self.series.act(self.load, self.at_s, h);
        self.series.begin(&self.state);
        self.rounding_n = 0.0;
        let mut open = self.let_go()?;
        for order in 1..DECIDING_ORDERS {
            if open.is_empty() {
                break;
            }
            self.decide(&mut open, order)?;
        }
        for (storey, _) in open {
            self.state.slider[storey] = Slider::Stuck;
            self.zeros[storey] = DECIDING_ORDERS;
        }
        self.gone.clear();
        Ok(())
    }

    /// Order 0: forces against their limits. Returns the sliders that are just at theirs, with the direction of going.
    fn let_go(&mut self) -> Result<Vec<(usize, f64)>, DynamicsError> {
        let n = self.model.levels();
        let mut going = self.gone.clone();
        for _ in 0..tries_most(n) {
            self.series.join(&self.model, &self.state);
            self.series.next(&self.model, &self.state, 0);
            self.measure_rounding(0);
            let mut open = Vec::new();
            let mut worst = Worst::default();
            for i in 0..n {
                let StoreyFriction::Coulomb {
                    static_force_n,
                    kinetic_force_n,
                } = self.model.friction[i]
                else {
                    continue;
                };
                match self.state.slider[i] {
                    Slider::Stuck => {
                        self.zeros[i] = 0;
                        let held = self.series.held[i];
                        let over = held.abs() - static_force_n;
                        if over > self.rounding_n {
                            worst.consider(over / held.abs(), i, Slider::Slipping(held.signum()));
                        } else if over >= -self.rounding_n && static_force_n == kinetic_force_n {
                            open.push((i, held.signum()));
                        }
                    }
                    Slider::Slipping(sign) if going.contains(&i) => {
                        let inertia = sign * self.series.inertia(&self.model, i, 0);
                        if inertia > self.rounding_n || self.gone.contains(&i) {
                            self.zeros[i] = 1;
                        } else if inertia < -self.rounding_n {
                            // driven back: it would have held
                            worst.consider(-inertia / kinetic_force_n.max(-inertia), i, Slider::Stuck);
                        } else {
                            open.push((i, sign));
                        }
                    }
                    _ => {}
                }
            }
            let Some((storey, to)) = worst.found() else {
                return Ok(open);
            };
            self.state.slider[storey] = to;
            match to {
                Slider::Stuck => going.retain(|i| *i != storey),
                _ => going.push(storey),
            }
        }
        Err(self.no_state())
    }

    /// Order k: rates of the forces that are just at their limits. Keeps in `open` those that this order does not decide.
    fn decide(&mut self, open: &mut Vec<(usize, f64)>, k: usize) -> Result<(), DynamicsError> {
        for &(i, _) in open.iter() {
            self.state.slider[i] = Slider::Stuck;
        }
        for _ in 0..tries_most(open.len()) {
            self.series.join(&self.model, &self.state);
            self.series.next(&self.model, &self.state, k);
            self.measure_rounding(k);
            let rounding = self.rounding_n;
            let mut worst = Worst::default();
            let mut left = Vec::new();
            for &(i, sign) in open.iter() {
                match self.state.slider[i] {
                    Slider::Stuck => {
                        let rate = sign * self.series.held[k * self.series.n + i];
                        if rate > rounding {
                            worst.consider(rate, i, Slider::Slipping(sign));
                        } else if rate < -rounding {
                            self.zeros[i] = k;
                        } else {
                            left.push((i, sign));
                        }
                    }
                    _ => {
                        let inertia = sign * self.series.inertia(&self.model, i, k);
                        if inertia < -rounding {
                            worst.consider(-inertia, i, Slider::Stuck);
                        } else if inertia > rounding {
                            self.zeros[i] = k + 1;
                        } else {
                            left.push((i, sign));
                        }
                    }
                }
            }
            let Some((storey, to)) = worst.found() else {
                *open = left;
                return Ok(());
            };
            self.state.slider[storey] = to;
        }
        Err(self.no_state())
    }

    /// An error of one order stays in all that follow: the springs of a step pass it on undiminished.
    fn measure_rounding(&mut self, k: usize) {
        let scale = self.series.force_scale(&self.model, &self.state, k);
        self.rounding_n = self.rounding_n.max(ROUNDING * scale);
    }

    fn no_state(&self) -> DynamicsError {
        DynamicsError::NoState {
            at_s: self.at_s,
            tried: tries_most(self.model.levels()),
        }
    }
}

fn tries_most(sliders: usize) -> usize {
    20 + 10 * sliders
}

/// The slider furthest from the law, and what it should do.
#[derive(Default)]
struct Worst(Option<(f64, usize, Slider)>);

impl Worst {
    fn consider(&mut self, excess: f64, storey: usize, to: Slider) {
        if self.0.is_none_or(|(most, ..)| excess > most) {
            self.0 = Some((excess, storey, to));
        }
    }

    fn found(self) -> Option<(usize, Slider)> {
        self.0.map(|(_, storey, to)| (storey, to))
    }
}

/// First time at which a force, given by its coefficients, reaches the static one in either direction.
fn goes(storey: usize, force: &[f64], static_force_n: f64, zeros: usize) -> Option<Event> {
    let rest: f64 = force[1..].iter().map(|c| c.abs()).sum();
    if force[0].abs() + rest < static_force_n {
        return None;
    }
    let mut first: Option<Event> = None;
    for sign in [1.0, -1.0] {
        let mut c = [0.0; COEFFICIENTS_MOST];
        let c = &mut c[..force.len()];
        for (c, force) in c.iter_mut().zip(force) {
            *c = -sign * force;
        }
        c[0] += static_force_n;
        // the limit it is at, not the other
        if c[0] < 0.5 * static_force_n {
            settle(c, zeros);
        }
        if let Some(sigma) = first_descent(c, 0.0)
            && first.is_none_or(|event| sigma < event.sigma)
        {
            first = Some(Event {
                sigma,
                storey,
                change: Change::Goes(sign),
            });
        }
    }
    first
}

/// Takes away what rounding has left where a slider that has just changed starts at a zero, so that the first true coefficient
/// decides.
fn settle(c: &mut [f64], zeros: usize) {
    let zeros = zeros.min(c.len());
    c[..zeros].fill(0.0);
}
