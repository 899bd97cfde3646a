//! Records the time steps of a frame in two directions.

use super::DynamicsError;
use super::frame_history::{FrameEnergy, FrameHistory, FrameOutcome, FramePeak, Slip, Turn};
use super::frame_model::{Slider, State};
use super::frame_plan_steps::{Direction, Steps};
use super::frame_record::{REST_M_S, peaks_at_samples};
use super::frame_rest::rest_m;

/// Component of the slip force in a direction, as a fraction, below which a storey does not slip in
/// that direction.
const NO_SHARE: f64 = 1e-9;

#[derive(Clone, Copy)]
struct Open {
    from_s: f64,
    from_m: f64,
    sign: f64,
}

pub(super) struct PlanRecord {
    histories: [FrameHistory; 2],
    open: [Vec<Option<Open>>; 2],
    moved: [f64; 2],
    heights_m: Vec<f64>,
    leaned: Vec<f64>,
    slipped: Vec<bool>,
}

impl PlanRecord {
    pub(super) fn new(steps: &Steps) -> Self {
        let n = steps.slips.len();
        let rows = || vec![Vec::new(); n];
        let empty = || FrameHistory {
            outcome: FrameOutcome::Finished,
            duration_s: 0.0,
            time_s: Vec::new(),
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
            energy: Vec::new(),
        };
        let mut record = PlanRecord {
            histories: [empty(), empty()],
            open: [vec![None; n], vec![None; n]],
            moved: [0.0; 2],
            heights_m: steps.heights_m.clone(),
            leaned: vec![0.0; n],
            slipped: vec![false; n],
        };
        record.sample(steps, 0.0);
        record
    }

    /// Records the end of a step.
    pub(super) fn step(&mut self, steps: &Steps, at_s: f64) {
        let has_changed = self.slipped != steps.slips;
        self.slipped.clone_from(&steps.slips);
        for (d, history) in self.histories.iter_mut().enumerate() {
            let direction = &steps.directions[d];
            history.steps += 1;
            history.events += usize::from(has_changed);
            history.duration_s = at_s;
            let State { y, v, .. } = &direction.state;
            for i in 0..y.len() {
                larger(&mut history.displacement_peaks[i], y[i], at_s);
                larger(&mut history.drift_peaks[i], direction.model.across(i, y), at_s);
                follow(
                    (&mut self.open[d][i], &mut history.slips),
                    (direction, i),
                    steps.slips[i],
                    at_s,
                );
            }
            let top = y.len() - 1;
            if v[top] * self.moved[d] < 0.0 {
                history.turns.push(Turn {
                    at_s,
                    displacement_m: y[top],
                });
            }
            if v[top] != 0.0 {
                self.moved[d] = v[top];
            }
        }
        for (i, leaned) in self.leaned.iter_mut().enumerate() {
            let drift = [0, 1].map(|d| steps.directions[d].model.across(i, &steps.directions[d].state.y));
            *leaned = drift[0].hypot(drift[1]) / self.heights_m[i];
        }
    }

    /// The storey whose resultant drift exceeds this fraction of its height.
    pub(super) fn leans_beyond(&self, ratio: f64) -> Option<usize> {
        self.leaned
            .iter()
            .position(|leaned| *leaned > ratio || leaned.is_nan())
    }

    pub(super) fn sample(&mut self, steps: &Steps, at_s: f64) {
        for (history, direction) in self.histories.iter_mut().zip(&steps.directions) {
            history.time_s.push(at_s);
            let acceleration = direction.acceleration_m_s2(at_s);
            for (i, acceleration) in acceleration.iter().enumerate() {
                history.displacement_m[i].push(direction.state.y[i]);
                history.velocity_m_s[i].push(direction.state.v[i]);
                history.acceleration_m_s2[i].push(*acceleration);
                history.friction_force_n[i].push(direction.friction_n[i]);
            }
            history.energy.push(FrameEnergy {
                kinetic_j: direction.model.kinetic_j(&direction.state.v),
                stored_j: direction.model.stored_j(&stuck(direction)),
                input_j: direction.input_j,
                friction_j: direction.friction_j,
                crushing_j: 0.0,
                damping_j: direction.damping_j,
            });
        }
    }

    pub(super) fn finish(mut self, steps: &Steps, outcome: FrameOutcome) -> [FrameHistory; 2] {
        for (d, history) in self.histories.iter_mut().enumerate() {
            let direction = &steps.directions[d];
            for i in 0..direction.state.y.len() {
                let at_s = history.duration_s;
                follow(
                    (&mut self.open[d][i], &mut history.slips),
                    (direction, i),
                    false,
                    at_s,
                );
            }
            peaks_at_samples(history);
            history.outcome = outcome;
            history.residual_m.clone_from(&direction.state.y);
            history.rest_m = match outcome {
                FrameOutcome::Finished => rest_m(&direction.model, &stuck(direction), &direction.stays_n()),
                FrameOutcome::DriftLimit { .. } | FrameOutcome::Stopped { .. } => direction.state.y.clone(),
            };
            history.at_rest = direction.state.v.iter().all(|v| v.abs() <= REST_M_S);
        }
        self.histories
    }
}

/// The state with every slider fixed in its position.
fn stuck(direction: &Direction) -> State {
    let n = direction.state.y.len();
    State {
        slider: vec![Slider::Stuck; n],
        offset_m: (0..n).map(|i| direction.slider_m(i)).collect(),
        ..direction.state.clone()
    }
}

fn larger(peak: &mut FramePeak, value_m: f64, at_s: f64) {
    if value_m.abs() > peak.value_m.abs() {
        (peak.value_m, peak.at_s) = (value_m, at_s);
    }
}

/// Starts, ends and reverses the slip of a storey in one direction.
fn follow(
    (open, slips): (&mut Option<Open>, &mut Vec<Slip>),
    (direction, storey): (&Direction, usize),
    is_slipping: bool,
    at_s: f64,
) {
    let rubs = direction.model.friction[storey].limits_n();
    let share = rubs.map_or(0.0, |[_, kinetic_n]| direction.friction_n[storey] / kinetic_n);
    let sign = match is_slipping && share.abs() > NO_SHARE {
        true => share.signum(),
        false => 0.0,
    };
    if open.is_some_and(|of| of.sign == sign) || open.is_none() && sign == 0.0 {
        return;
    }
    let place_m = direction.slider_m(storey);
    if let Some(of) = open.take() {
        slips.push(Slip {
            storey,
            from_s: of.from_s,
            to_s: at_s,
            slip_m: place_m - of.from_m,
        });
    }
    if sign != 0.0 {
        *open = Some(Open {
            from_s: at_s,
            from_m: place_m,
            sign,
        });
    }
}

/// Runs to the end, `each` steps between samples.
pub(super) fn run(
    mut steps: Steps,
    (each, duration_s): (usize, f64),
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<[FrameHistory; 2], DynamicsError> {
    let count = (duration_s / steps.step_s * (1.0 - 1e-12)).ceil() as usize;
    let mut record = PlanRecord::new(&steps);
    let mut outcome = FrameOutcome::Finished;
    for step in 1..=count {
        let at_s = step as f64 * steps.step_s;
        steps.step(at_s - steps.step_s)?;
        record.step(&steps, at_s);
        if step % each == 0 {
            record.sample(&steps, at_s);
        }
        if let Some(storey) = record.leans_beyond(steps.drift_ratio_most) {
            outcome = FrameOutcome::DriftLimit { storey, at_s };
            break;
        }
        if step % 4096 == 0 && !progress(at_s) {
            outcome = FrameOutcome::Stopped { at_s };
            break;
        }
    }
    Ok(record.finish(&steps, outcome))
}
