//! Records the motion of a frame: samples, true peaks, slips and energies.

use super::frame_friction::StoreyFriction;
use super::frame_history::{FrameEnergy, FrameHistory, FrameOutcome, FramePeak, Slip, Turn};
use super::frame_model::{Model, Slider, State, drift_m};
use super::frame_rest::rest_m;
use super::frame_series::{Series, at_with_rates};
use super::frame_work::Work;
use crate::numeric::{COEFFICIENTS_MOST, first_descent, polynomial};

/// Events closer together than this are one event, s.
const ONE_EVENT_S: f64 = 1e-9;
/// Speed below which a frame is at rest, m/s: a third of a millimetre per century.
pub(super) const REST_M_S: f64 = 1e-13;
/// Fraction of the largest speed below which a speed is only rounding.
const ROUNDING: f64 = 1e-12;
/// Number of samples that are evaluated together.
const LANES: usize = 2;
pub(super) struct Recorder {
    history: FrameHistory,
    output_step_s: f64,
    samples: usize,
    work: Work,
    taken: usize,
    /// State at each evaluated sample of the current series.
    now: [State; LANES],
    /// Constant forces at the levels, N.
    stays_n: Vec<f64>,
    /// For each storey, position and time at the start of the current slip.
    slipping: Vec<Option<(f64, f64)>>,
    last_event_s: f64,
    /// Last direction of motion of the top level, and its largest speed at the end of any interval, m/s.
    top_direction: f64,
    top_speed: f64,
}

impl Recorder {
    pub(super) fn new(model: &Model, state: &State, output_step_s: f64, duration_s: f64) -> Self {
        let n = model.levels();
        // a sample slightly after the end, by rounding, is the last sample
        let samples = (duration_s / output_step_s * (1.0 + 1e-12)).floor() as usize + 1;
        let rows = || vec![vec![0.0; samples]; n];
        let mut recorder = Recorder {
            history: FrameHistory {
                outcome: FrameOutcome::Finished,
                duration_s: 0.0,
                time_s: vec![0.0; samples],
                displacement_m: rows(),
                velocity_m_s: rows(),
                acceleration_m_s2: rows(),
                friction_force_n: rows(),
                displacement_peaks: vec![FramePeak::default(); n],
                drift_peaks: vec![FramePeak::default(); n],
                slips: Vec::new(),
                turns: Vec::new(),
                tenons: vec![None; n],
                residual_m: Vec::new(),
                rest_m: Vec::new(),
                at_rest: false,
                events: 0,
                steps: 0,
                energy: vec![FrameEnergy::default(); samples],
            },
            output_step_s,
            samples,
            work: Work::start(model, state),
            taken: 0,
            now: std::array::from_fn(|_| state.clone()),
            stays_n: Vec::new(),
            slipping: vec![None; n],
            last_event_s: f64::NEG_INFINITY,
            top_direction: 0.0,
            top_speed: 0.0,
        };
        let absent = vec![Slider::Absent; n];
        recorder.follow_slips(model, state, &absent, 0.0);
        recorder
    }

    /// The recorder, with constant forces at the levels.
    pub(super) fn under(self, stays_n: Vec<f64>) -> Self {
        Recorder { stays_n, ..self }
    }

    /// Records the motion of one series from `begin_s` to σ, between a state and the state `ahead`.
    pub(super) fn stretch(
        &mut self,
        model: &Model,
        state: &State,
        ahead: &State,
        series: &Series,
        begin_s: f64,
        sigma: f64,
    ) {
        self.history.steps += 1;
        let end_s = begin_s + sigma * series.h;
        for i in 0..series.n {
            let history = &mut self.history;
            let peaks = [
                (&mut history.displacement_peaks[i], series.y_most[i], &series.y[i]),
                (
                    &mut history.drift_peaks[i],
                    series.drift_most[i],
                    &series.drift[i],
                ),
            ];
            for (peak, most, row) in peaks {
                if most > peak.value_m.abs() {
                    extend(peak, &row[..series.orders], begin_s, series.h, sigma);
                }
            }
        }
        self.turn(series, ahead, begin_s, sigma);
        // positions and velocities are set at each sample
        for now in &mut self.now {
            now.slider.clone_from(&state.slider);
            now.offset_m.clone_from(&state.offset_m);
            now.joint.clone_from(&state.joint);
        }
        self.work.expand(model, series);
        // rounding may put the last sample after the end
        let last_s = end_s * (1.0 + 1e-12);
        loop {
            let mut sigmas = [0.0; LANES];
            let mut count = 0;
            for sigma in &mut sigmas {
                let t = (self.taken + count) as f64 * self.output_step_s;
                if self.taken + count == self.samples || t > last_s {
                    break;
                }
                self.history.time_s[self.taken + count] = t;
                *sigma = ((t - begin_s) / series.h).clamp(0.0, 1.0);
                count += 1;
            }
            if count == 0 {
                break;
            }
            self.sample(model, state, series, sigmas, count);
            self.taken += count;
        }
        self.work.energy = self.work.at(model, [state, ahead], series, sigma);
    }

    /// Records a turning point of the top level in the interval. There is at most one, because a step is shorter than half a cycle of any mode.
    /// A mere stop does not count: the level must move back.
    fn turn(&mut self, series: &Series, ahead: &State, begin_s: f64, sigma: f64) {
        let top = series.n - 1;
        let last = ahead.v[top];
        self.top_speed = self.top_speed.max(last.abs());
        if last.abs() <= ROUNDING * self.top_speed || last * self.top_direction > 0.0 {
            return;
        }
        let before = std::mem::replace(&mut self.top_direction, last.signum());
        if before == 0.0 {
            return;
        }
        let c = &series.y[top][..series.orders];
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

    /// Records the next samples at several σ of the series; those beyond `count` are ignored.
    fn sample(&mut self, model: &Model, state: &State, series: &Series, sigmas: [f64; LANES], count: usize) {
        let Recorder {
            history, now: nows, ..
        } = self;
        let taken = self.taken..self.taken + count;
        let grounds = sigmas.map(|sigma| polynomial(&series.ground[..series.ground_orders], sigma));
        let (per_step, per_step_squared) = (1.0 / series.h, 2.0 / (series.h * series.h));
        for (i, row) in series.y.iter().enumerate() {
            let [ys, rates, halves] = at_with_rates(&row[..series.orders], sigmas);
            for (lane, sample) in taken.clone().enumerate() {
                let (y, v) = (ys[lane], rates[lane] * per_step);
                (nows[lane].y[i], nows[lane].v[i]) = (y, v);
                history.displacement_m[i][sample] = y;
                history.velocity_m_s[i][sample] = v;
                history.acceleration_m_s2[i][sample] = halves[lane] * per_step_squared + grounds[lane];
            }
        }
        for (i, forces) in history.friction_force_n.iter_mut().enumerate() {
            for (lane, sample) in taken.clone().enumerate() {
                forces[sample] = match (model.friction[i], state.slider[i]) {
                    (StoreyFriction::Coulomb { .. }, Slider::Stuck) => {
                        polynomial(&series.held[i][..series.orders - 2], sigmas[lane])
                    }
                    (StoreyFriction::Coulomb { kinetic_force_n, .. }, Slider::Slipping(sign)) => {
                        sign * kinetic_force_n
                    }
                    _ => model.jenkins_force(i, &nows[lane]),
                };
            }
        }
        for ((sample, now), sigma) in taken.zip(nows).zip(sigmas) {
            history.energy[sample] = FrameEnergy {
                kinetic_j: model.kinetic_j(&now.v),
                stored_j: model.stored_j(now),
                ..self.work.at(model, [state, now], series, sigma)
            };
        }
    }

    /// Records the jump of a Jenkins slider from its static to its kinetic force.
    pub(super) fn jump(&mut self, model: &Model, storey: usize) {
        if let StoreyFriction::Jenkins {
            stuck_stiffness_n_m,
            static_force_n,
            kinetic_force_n,
        } = model.friction[storey]
        {
            let squares = static_force_n * static_force_n - kinetic_force_n * kinetic_force_n;
            self.work.energy.friction_j += 0.5 * squares / stuck_stiffness_n_m;
        }
    }

    /// Records the sliders that changed their state.
    pub(super) fn changed(&mut self, model: &Model, state: &State, before: &[Slider], at_s: f64) {
        if state.slider == before {
            return;
        }
        self.happened(at_s);
        self.follow_slips(model, state, before, at_s);
    }

    pub(super) fn happened(&mut self, at_s: f64) {
        if at_s - self.last_event_s > ONE_EVENT_S {
            self.history.events += 1;
        }
        self.last_event_s = at_s;
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
        let rows = [
            &mut history.displacement_m,
            &mut history.velocity_m_s,
            &mut history.acceleration_m_s2,
            &mut history.friction_force_n,
        ];
        rows.into_iter()
            .flatten()
            .chain([&mut history.time_s])
            .for_each(|row| row.truncate(self.taken));
        history.energy.truncate(self.taken);
        peaks_at_samples(&mut history);
        history.outcome = outcome;
        history.duration_s = at_s;
        let joints = state.joint.iter().enumerate();
        history.tenons = joints
            .map(|(i, joint)| Some(joint.as_ref()?.faces_at(drift_m(&state.y, i))))
            .collect();
        history.residual_m.clone_from(&state.y);
        history.rest_m = match outcome {
            FrameOutcome::Finished => rest_m(model, state, &self.stays_n),
            _ => state.y.clone(),
        };
        history.at_rest = state.v.iter().all(|v| v.abs() <= REST_M_S);
        history
    }
}

/// Updates a peak with the largest magnitude of a polynomial on [0, σ].
fn extend(peak: &mut FramePeak, c: &[f64], begin_s: f64, h: f64, sigma: f64) {
    let mut consider = |at: f64| {
        let value = polynomial(c, at);
        if value.abs() > peak.value_m.abs() {
            peak.value_m = value;
            peak.at_s = begin_s + at * h;
        }
    };
    consider(0.0);
    consider(sigma);
    // turning points: zeros of the velocity, alternately from positive to negative and back
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

/// Sets the peaks to the largest values at the samples.
pub(super) fn peaks_at_samples(history: &mut FrameHistory) {
    let largest = |most: f64, value: f64| if value > most { value } else { most };
    let rows = &history.displacement_m;
    for (i, row) in rows.iter().enumerate() {
        history.displacement_peaks[i].at_samples_m = row.iter().map(|y| y.abs()).fold(0.0, largest);
        history.drift_peaks[i].at_samples_m = match i.checked_sub(1) {
            None => history.displacement_peaks[i].at_samples_m,
            Some(below) => {
                let drifts = row.iter().zip(&rows[below]);
                drifts.map(|(y, below)| (y - below).abs()).fold(0.0, largest)
            }
        };
    }
}
