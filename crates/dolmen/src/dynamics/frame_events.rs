//! Steps of a frame from one event to the next: the first slider that changes, and when.

use super::DynamicsError;
use super::excitation::FrameLoad;
use super::frame_friction::{FrictionFrame, StoreyFriction};
use super::frame_model::{Model, Slider, State, drift_m};
use super::frame_record::Recorder;
use super::frame_run::FrameRun;
use super::frame_series::Series;
use super::frame_tenon::{Joint, TenonChange};
use super::frame_tenon_events::tenon_event;
use crate::numeric::{COEFFICIENTS_MOST, first_descent, polynomial_most};

/// Changes of sliders closer than this are one event, s: the required accuracy of events.
pub(super) const TOGETHER_S: f64 = 1e-12;

/// A change of a slider within a step.
#[derive(Clone, Copy)]
pub(super) struct Event {
    pub(super) sigma: f64,
    pub(super) storey: usize,
    pub(super) change: Change,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum Change {
    /// Its force has reached the static force, in this direction.
    Goes(f64),
    /// It has stopped.
    Stops,
    /// The tenons of the storey change.
    Tenon(TenonChange),
}

/// A frame during a run.
pub(super) struct Motion<'a> {
    pub(super) model: Model,
    pub(super) load: &'a FrameLoad,
    pub(super) state: State,
    /// The state at the end of the current step.
    ahead: State,
    pub(super) series: Series,
    pub(super) at_s: f64,
    /// Number of zero first coefficients of each slider's quantity after an event, which contain only rounding.
    pub(super) zeros: Vec<usize>,
    /// The sliders before the event, if they may have to change before the next step.
    pub(super) unsettled: Option<Vec<Slider>>,
    /// Force, or rate of a force, below which it counts as rounding, N; it grows with the order of the rate.
    pub(super) rounding_n: f64,
    /// Sliders that must slip: their static force was reached and is above the kinetic one.
    pub(super) gone: Vec<usize>,
    pub(super) events: Vec<Event>,
    /// Drift of each storey up to which the model is valid, m, and the storey that has exceeded it.
    pub(super) drift_most_m: Vec<f64>,
    pub(super) leaned: Option<usize>,
    pub(super) pile: usize,
    pub(super) pile_at_s: f64,
}

impl<'a> Motion<'a> {
    pub(super) fn start(
        frame: &FrictionFrame,
        load: &'a FrameLoad,
        options: &FrameRun,
    ) -> Result<Self, DynamicsError> {
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
            joint: Vec::new(),
        };
        let tenons = frame.tenons.iter().enumerate();
        state.joint = tenons
            .map(|(i, tenon)| tenon.map(|tenon| Joint::at(tenon, drift_m(&state.y, i))))
            .collect();
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
                    // a start beyond the static force means that the slider has already slipped by the difference
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
            ahead: state.clone(),
            state,
            at_s: 0.0,
            zeros: vec![0; n],
            unsettled: None,
            rounding_n: 0.0,
            gone: Vec::new(),
            events: Vec::new(),
            drift_most_m: frame
                .frame
                .storeys()
                .iter()
                .map(|storey| options.drift_ratio_most * storey.height_m)
                .collect(),
            leaned: None,
            pile: 0,
            pile_at_s: f64::NEG_INFINITY,
        };
        motion.unsettled = Some(motion.state.slider.clone());
        let drift_m = |storey: usize| motion.model.across(storey, &motion.state.y).abs();
        motion.leaned = (0..n).find(|storey| drift_m(*storey) >= motion.drift_most_m[*storey]);
        Ok(motion)
    }

    /// Advances by at most h, to the next event; `end_s` is the end of the current load series.
    pub(super) fn step(
        &mut self,
        mut h: f64,
        end_s: f64,
        recorder: &mut Recorder,
    ) -> Result<(), DynamicsError> {
        if let Some(before) = self.unsettled.take() {
            self.find_state(h)?;
            recorder.changed(&self.model, &self.state, &before, self.at_s);
            self.series.join(&self.model, &self.state);
        }
        loop {
            self.series.act(self.load, self.at_s, h);
            if self.series.expand(&self.model, &self.state) {
                break;
            }
            h *= 0.5;
        }
        let mut sigma = self.first_events(h);
        if let Some((storey, at)) = self.leans_too_far().filter(|(_, at)| *at <= sigma) {
            sigma = at;
            self.leaned = Some(storey);
            self.events.clear();
        }
        let begin_s = self.at_s;
        let ends = self.events.is_empty() && self.leaned.is_none() && end_s - (begin_s + h) <= TOGETHER_S;
        self.at_s = if ends { end_s } else { begin_s + sigma * h };
        self.series.place(sigma, &mut self.ahead);
        recorder.stretch(
            &self.model,
            &self.state,
            &self.ahead,
            &self.series,
            begin_s,
            sigma,
        );
        std::mem::swap(&mut self.state.y, &mut self.ahead.y);
        std::mem::swap(&mut self.state.v, &mut self.ahead.v);
        self.series.share_velocity(&self.model, &mut self.state);
        if sigma * h > TOGETHER_S {
            self.zeros.fill(0);
        }
        if !self.events.is_empty() {
            self.change(recorder)?;
        }
        Ok(())
    }

    /// The first storey whose drift exceeds its limit, and the fraction of the step at which it does.
    fn leans_too_far(&self) -> Option<(usize, f64)> {
        let s = &self.series;
        let mut first: Option<(usize, f64)> = None;
        for (storey, &most_m) in self.drift_most_m.iter().enumerate() {
            if s.drift_most[storey] < most_m {
                continue;
            }
            let drift = &s.drift[storey][..s.orders];
            for sign in [1.0, -1.0] {
                let mut c = [0.0; COEFFICIENTS_MOST];
                let c = &mut c[..s.orders];
                for (c, drift) in c.iter_mut().zip(drift) {
                    *c = -sign * drift;
                }
                c[0] += most_m;
                if let Some(sigma) = first_descent(c, 0.0)
                    && first.is_none_or(|(_, earlier)| sigma < earlier)
                {
                    first = Some((storey, sigma));
                }
            }
        }
        first
    }

    /// Collects the first event and all simultaneous events in `events`. Returns the end of the step.
    fn first_events(&mut self, h: f64) -> f64 {
        self.events.clear();
        let mut first = 1.0_f64;
        let together = TOGETHER_S / h;
        for storey in 0..self.model.levels() {
            let of_tenons = self.state.joint[storey].as_ref().and_then(|joint| {
                let s = &self.series;
                let below_m = storey.checked_sub(1).map_or(0.0, |below| s.y_most[below]);
                let moved_m = s.y_most[storey].max(below_m);
                tenon_event(joint, &s.drift[storey][..s.orders], moved_m)
            });
            let of_tenons = of_tenons.map(|(change, sigma)| Event {
                sigma,
                storey,
                change: Change::Tenon(change),
            });
            for event in self.event_of(storey).into_iter().chain(of_tenons) {
                if event.sigma <= first + together {
                    first = first.min(event.sigma);
                    self.events.push(event);
                }
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
        match (self.model.friction[storey], self.state.slider[storey]) {
            (_, Slider::Slipping(sign)) => {
                let across = s.slider_row(&self.model, storey);
                let mut c = [0.0; COEFFICIENTS_MOST];
                let c = &mut c[..across.len() - 1];
                let mut power = 0.0;
                for (c, across) in c.iter_mut().zip(&across[1..]) {
                    power += sign;
                    *c = power * across;
                }
                settle(c, zeros);
                let sigma = first_descent(c, 0.0)?;
                Some(Event {
                    sigma,
                    storey,
                    change: Change::Stops,
                })
            }
            (StoreyFriction::Coulomb { static_force_n, .. }, Slider::Stuck) => {
                goes(storey, &s.held[storey][..s.orders - 2], static_force_n, zeros)
            }
            (
                StoreyFriction::Jenkins {
                    stuck_stiffness_n_m,
                    static_force_n,
                    ..
                },
                Slider::Stuck,
            ) => {
                let across = s.slider_row(&self.model, storey);
                let mut c = [0.0; COEFFICIENTS_MOST];
                let c = &mut c[..across.len()];
                for (c, across) in c.iter_mut().zip(across) {
                    *c = stuck_stiffness_n_m * across;
                }
                c[0] -= stuck_stiffness_n_m * self.state.offset_m[storey];
                goes(storey, c, static_force_n, zeros)
            }
            (StoreyFriction::None, _) | (_, Slider::Absent) => None,
        }
    }
}

/// First time at which a force, given by its coefficients, reaches the static limit in either direction.
fn goes(storey: usize, force: &[f64], static_force_n: f64, zeros: usize) -> Option<Event> {
    if polynomial_most(force) < static_force_n {
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
        // only the limit on the side of the force
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

/// Removes rounding if a slider that has just changed starts at zero, so that the first true coefficient decides.
fn settle(c: &mut [f64], zeros: usize) {
    let zeros = zeros.min(c.len());
    c[..zeros].fill(0.0);
}
