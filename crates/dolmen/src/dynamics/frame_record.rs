//! What is kept of a frame's motion: samples, true peaks, slips and energy.

use super::frame_friction::StoreyFriction;
use super::frame_history::{FrameEnergy, FrameHistory, FrameOutcome, FramePeak, Slip, Turn};
use super::frame_series::{Model, Series, Slider, State, at_with_rates};
use crate::numeric::{COEFFICIENTS_MOST, first_descent, polynomial};

/// Events closer than this count once, s.
const ONE_EVENT_S: f64 = 1e-9;
/// Speed of everything below which a frame is at rest, m/s: what a century turns into a third of a millimetre.
const REST_M_S: f64 = 1e-13;
/// Part of the largest speed below which a speed is rounding.
const ROUNDING: f64 = 1e-12;
/// Coefficients of the work: a product of two series.
const WORK_MOST: usize = 2 * COEFFICIENTS_MOST;
/// Nodes and weights of Gauss and Legendre on [0, 1], 8 points: exact for polynomials of degree 15.
const GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_47),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

pub(super) struct Recorder {
    history: FrameHistory,
    output_step_s: f64,
    samples: usize,
    energy: FrameEnergy,
    /// Work put in since the start of the series under way: coefficients of σ, and how many there are.
    work: [f64; WORK_MOST],
    work_orders: usize,
    /// The state at a place of the series under way.
    now: State,
    /// Per storey: where and when the slip under way began.
    slipping: Vec<Option<(f64, f64)>>,
    last_event_s: f64,
    /// Direction in which the top level moved last, and its largest speed at the end of a stretch, m/s.
    top_direction: f64,
    top_speed: f64,
}

impl Recorder {
    pub(super) fn new(model: &Model, state: &State, output_step_s: f64, duration_s: f64) -> Self {
        let n = model.levels();
        // a sample a little past the end by rounding is the end
        let samples = (duration_s / output_step_s * (1.0 + 1e-12)).floor() as usize + 1;
        let rows = || vec![Vec::with_capacity(samples); n];
        let energy = FrameEnergy {
            kinetic_j: model.kinetic_j(state),
            stored_j: model.stored_j(state),
            input_j: model.kinetic_j(state) + model.stored_j(state),
            ..FrameEnergy::default()
        };
        let mut recorder = Recorder {
            history: FrameHistory {
                outcome: FrameOutcome::Finished,
                duration_s: 0.0,
                time_s: Vec::with_capacity(samples),
                displacement_m: rows(),
                velocity_m_s: rows(),
                acceleration_m_s2: rows(),
                friction_force_n: rows(),
                displacement_peaks: vec![FramePeak::default(); n],
                drift_peaks: vec![FramePeak::default(); n],
                slips: Vec::new(),
                turns: Vec::new(),
                residual_m: Vec::new(),
                at_rest: false,
                events: 0,
                steps: 0,
                energy: Vec::with_capacity(samples),
            },
            output_step_s,
            samples,
            energy,
            work: [0.0; WORK_MOST],
            work_orders: 0,
            now: state.clone(),
            slipping: vec![None; n],
            last_event_s: f64::NEG_INFINITY,
            top_direction: 0.0,
            top_speed: 0.0,
        };
        let absent = vec![Slider::Absent; n];
        recorder.follow_slips(model, state, &absent, 0.0);
        recorder
    }

    /// Takes up the motion of one series from `begin_s` to σ.
    pub(super) fn stretch(
        &mut self,
        model: &Model,
        state: &State,
        series: &Series,
        begin_s: f64,
        sigma: f64,
    ) {
        self.history.steps += 1;
        let end_s = begin_s + sigma * series.h;
        let before = self.energy;
        for i in 0..series.n {
            let (level, drift) = (&series.y[i][..series.orders], &series.drift[i][..series.orders]);
            let history = &mut self.history;
            extend(
                &mut history.displacement_peaks[i],
                level,
                begin_s,
                series.h,
                sigma,
            );
            extend(&mut history.drift_peaks[i], drift, begin_s, series.h, sigma);
        }
        self.turn(series, begin_s, sigma);
        // places and speeds follow at each sample
        self.now.slider.clone_from(&state.slider);
        self.now.offset_m.clone_from(&state.offset_m);
        self.expand_work(model, series);
        while self.history.time_s.len() < self.samples {
            let t = self.history.time_s.len() as f64 * self.output_step_s;
            // the last sample may lie past the end by rounding
            if t > end_s * (1.0 + 1e-12) {
                break;
            }
            self.sample(model, state, series, begin_s, t);
        }
        self.energy = before;
        self.add_work(model, state, series, sigma);
    }

    /// A turn of the top level within the stretch: one, since a step is shorter than half a swing of any mode. It counts once the
    /// level moves the other way, so that a stop is none.
    fn turn(&mut self, series: &Series, begin_s: f64, sigma: f64) {
        let c = &series.y[series.n - 1][..series.orders];
        let last = at_with_rates(c, sigma)[1] / series.h;
        self.top_speed = self.top_speed.max(last.abs());
        if last.abs() <= ROUNDING * self.top_speed || last * self.top_direction > 0.0 {
            return;
        }
        let before = std::mem::replace(&mut self.top_direction, last.signum());
        if before == 0.0 {
            return;
        }
        let mut v = [0.0; COEFFICIENTS_MOST];
        let v = &mut v[..c.len() - 1];
        for (k, v) in v.iter_mut().enumerate() {
            *v = before * (k + 1) as f64 * c[k + 1];
        }
        let at = first_descent(v, 0.0).unwrap_or(0.0).min(sigma);
        self.history.turns.push(Turn {
            at_s: begin_s + at * series.h,
            displacement_m: polynomial(c, at),
        });
    }

    fn sample(&mut self, model: &Model, state: &State, series: &Series, begin_s: f64, t: f64) {
        let sigma = ((t - begin_s) / series.h).clamp(0.0, 1.0);
        let kept = self.energy;
        self.add_work(model, state, series, sigma);
        let (now, history) = (&mut self.now, &mut self.history);
        history.time_s.push(t);
        let ground = polynomial(&series.ground[..series.ground_orders], sigma);
        for i in 0..series.n {
            let [y, rate, half] = at_with_rates(&series.y[i][..series.orders], sigma);
            (now.y[i], now.v[i]) = (y, rate / series.h);
            history.displacement_m[i].push(y);
            history.velocity_m_s[i].push(now.v[i]);
            history.acceleration_m_s2[i].push(2.0 * half / (series.h * series.h) + ground);
            let peak = &mut history.displacement_peaks[i];
            peak.at_samples_m = peak.at_samples_m.max(y.abs());
            let drift = y - i.checked_sub(1).map_or(0.0, |j| now.y[j]);
            let peak = &mut history.drift_peaks[i];
            peak.at_samples_m = peak.at_samples_m.max(drift.abs());
        }
        for i in 0..series.n {
            let force = match (model.friction[i], now.slider[i]) {
                (StoreyFriction::Coulomb { .. }, Slider::Stuck) => {
                    polynomial(&series.held[i][..series.orders - 2], sigma)
                }
                (StoreyFriction::Coulomb { kinetic_force_n, .. }, Slider::Slipping(sign)) => {
                    sign * kinetic_force_n
                }
                _ => model.jenkins_force(i, now),
            };
            history.friction_force_n[i].push(force);
        }
        self.energy.kinetic_j = model.kinetic_j(&self.now);
        self.energy.stored_j = model.stored_j(&self.now);
        self.history.energy.push(self.energy);
        self.energy = kept;
    }

    /// ∫ force dY and −∫ M 1 a_ground dY from the start of the series, as one polynomial in σ.
    fn expand_work(&mut self, model: &Model, series: &Series) {
        let products = series.orders + series.ground_orders.max(series.force_orders);
        self.work[..products].fill(0.0);
        self.work_orders = 0;
        let mut add = |p: &[f64], j: usize, slope: f64| {
            let slope = slope * j as f64;
            for (work, p) in self.work[j..j + p.len()].iter_mut().zip(p) {
                *work += p * slope;
            }
            self.work_orders = self.work_orders.max(j + p.len());
        };
        for j in 1..series.orders {
            if series.ground_orders > 0 {
                let momentum: f64 = series.y.iter().zip(&model.mass_kg).map(|(y, m)| y[j] * m).sum();
                add(&series.ground[..series.ground_orders], j, -momentum);
            }
            for (y, force) in series.y.iter().zip(&series.forces) {
                add(&force[..series.force_orders], j, y[j]);
            }
        }
        for (power, work) in self.work[..self.work_orders].iter_mut().enumerate().skip(1) {
            *work /= power as f64;
        }
    }

    /// Adds work put in and taken from the start of the series to σ.
    fn add_work(&mut self, model: &Model, state: &State, series: &Series, sigma: f64) {
        self.energy.input_j += polynomial(&self.work[..self.work_orders], sigma);
        for i in 0..series.n {
            if let (
                StoreyFriction::Coulomb { kinetic_force_n, .. }
                | StoreyFriction::Jenkins { kinetic_force_n, .. },
                Slider::Slipping(_),
            ) = (model.friction[i], state.slider[i])
            {
                let way = sigma * polynomial(&series.slider_row(model, i)[1..], sigma);
                self.energy.friction_j += kinetic_force_n * way.abs();
            }
        }
        if model.damped() {
            let mut taken = 0.0;
            for (node, weight) in GAUSS {
                for node in [node, -node] {
                    series.place(0.5 * sigma * (1.0 + node), &mut self.now);
                    taken += 0.5 * weight * model.damping_power(&self.now.v);
                }
            }
            self.energy.damping_j += taken * sigma * series.h;
        }
    }

    /// A Jenkins slider jumps from its static to its kinetic force.
    pub(super) fn jump(&mut self, model: &Model, storey: usize) {
        if let StoreyFriction::Jenkins {
            stuck_stiffness_n_m,
            static_force_n,
            kinetic_force_n,
        } = model.friction[storey]
        {
            let squares = static_force_n * static_force_n - kinetic_force_n * kinetic_force_n;
            self.energy.friction_j += 0.5 * squares / stuck_stiffness_n_m;
        }
    }

    /// Takes note of sliders that changed.
    pub(super) fn changed(&mut self, model: &Model, state: &State, before: &[Slider], at_s: f64) {
        if state.slider == before {
            return;
        }
        if at_s - self.last_event_s > ONE_EVENT_S {
            self.history.events += 1;
        }
        self.last_event_s = at_s;
        self.follow_slips(model, state, before, at_s);
    }

    fn follow_slips(&mut self, model: &Model, state: &State, before: &[Slider], at_s: f64) {
        for (storey, before) in before.iter().enumerate() {
            if state.slider[storey] == *before {
                continue;
            }
            let place = model.across(storey, &state.y);
            if let Some((from_s, from)) = self.slipping[storey].take() {
                self.history.slips.push(Slip {
                    storey,
                    from_s,
                    to_s: at_s,
                    slip_m: place - from,
                });
            }
            if matches!(state.slider[storey], Slider::Slipping(_)) {
                self.slipping[storey] = Some((at_s, place));
            }
        }
    }

    pub(super) fn finish(
        mut self,
        model: &Model,
        state: &State,
        at_s: f64,
        outcome: FrameOutcome,
    ) -> FrameHistory {
        let absent = vec![Slider::Absent; model.levels()];
        let before = state.slider.clone();
        let ended = State {
            slider: absent,
            ..state.clone()
        };
        self.follow_slips(model, &ended, &before, at_s);
        let mut history = self.history;
        history.outcome = outcome;
        history.duration_s = at_s;
        history.residual_m.clone_from(&state.y);
        history.at_rest = state.v.iter().all(|v| v.abs() <= REST_M_S);
        history
    }
}

/// Takes the largest absolute value of a polynomial on [0, σ] into a peak.
fn extend(peak: &mut FramePeak, c: &[f64], begin_s: f64, h: f64, sigma: f64) {
    let most: f64 = c.iter().map(|x| x.abs()).sum();
    if most <= peak.value_m.abs() {
        return;
    }
    let mut consider = |at: f64| {
        let value = polynomial(c, at);
        if value.abs() > peak.value_m.abs() {
            peak.value_m = value;
            peak.at_s = begin_s + at * h;
        }
    };
    consider(0.0);
    consider(sigma);
    // turning points: the velocity crosses zero downwards, then upwards, in turns
    let mut velocity = [0.0; COEFFICIENTS_MOST];
    let velocity = &mut velocity[..c.len() - 1];
    for (k, v) in velocity.iter_mut().enumerate() {
        *v = (k + 1) as f64 * c[k + 1];
    }
    let mut from = 0.0;
    for _ in 0..4 {
        if polynomial(velocity, from) < 0.0 {
            velocity.iter_mut().for_each(|v| *v = -*v);
        }
        match first_descent(velocity, from) {
            Some(at) if at <= sigma => {
                consider(at);
                from = at;
                velocity.iter_mut().for_each(|v| *v = -*v);
            }
            _ => break,
        }
    }
}
