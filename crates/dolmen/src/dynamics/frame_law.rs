//! States of a frame's sliders after an event, from Coulomb's law for all sliders together.

use super::DynamicsError;
use super::frame_events::{Change, Event, Motion};
use super::frame_friction::StoreyFriction;
use super::frame_model::{Slider, drift_m};
use super::frame_record::Recorder;

/// Events closer than this accumulate, s.
const PILE_S: f64 = 1e-9;
/// Fraction of the largest force below which a force at an event, or its rate over the step, counts as rounding: some thousand units in the
/// last place, for the sums over twenty levels.
const ROUNDING: f64 = 1e-12;
/// Number of rates examined for a force exactly at its limit. The deepest known case, springs that a slip begins to stretch, needs three
/// further rates for each storey up.
const DECIDING_ORDERS: usize = 24;

impl Motion<'_> {
    /// Changes the sliders of `events` and determines the states of the others.
    pub(super) fn change(&mut self, recorder: &mut Recorder) -> Result<(), DynamicsError> {
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
        let mut slides = false;
        for &Event { storey, change, .. } in &self.events {
            if let Change::Tenon(change) = change {
                let across = drift_m(&self.state.y, storey);
                if let Some(joint) = &mut self.state.joint[storey] {
                    joint.change(change, across);
                    recorder.happened(self.at_s);
                }
                continue;
            }
            slides = true;
            match (self.model.friction[storey], change) {
                (StoreyFriction::Jenkins { .. }, Change::Goes(sign)) => {
                    self.state.slider[storey] = Slider::Slipping(sign);
                    // a slider that has just stopped and is pushed on immediately: only its velocity is rounding, not its acceleration
                    self.zeros[storey] = self.zeros[storey].min(1);
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
                    // with equal forces it is at its limit, and the rate of its force is that of the drift: zero
                    self.zeros[storey] = if static_force_n == kinetic_force_n { 2 } else { 0 };
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
                // the balance of all sliders decides whether it continues, sticks or reverses
                _ => self.state.slider[storey] = Slider::Stuck,
            }
        }
        self.series.join(&self.model, &self.state);
        self.series.share_velocity(&self.model, &mut self.state);
        // if only tenons change, no force and no slider jumps
        if slides {
            self.unsettled = Some(before);
        }
        Ok(())
    }

    /// Determines which Coulomb sliders at rest stick and which slip. Those that cannot stick are released, the one with the largest violation
    /// first, until all satisfy the law.
    ///
    /// With equal static and kinetic forces the accelerations minimise a strictly convex function, so the state is unique. If a force is
    /// exactly at its limit, its first nonzero derivative decides, order by order. This happens if slip forces are proportional to the weight:
    /// several storeys then reach their limits at the same time.
    pub(super) fn find_state(&mut self, h: f64) -> Result<(), DynamicsError> {
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

    /// Order 0: compares forces with their limits. Returns the sliders exactly at their limits, with the direction of slip.
    fn let_go(&mut self) -> Result<Vec<(usize, f64)>, DynamicsError> {
        let n = self.model.levels();
        let mut going = self.gone.clone();
        for _ in 0..tries_most(n) {
            self.series.join(&self.model, &self.state);
            self.series.next(&self.model, 0);
            self.measure_rounding(0);
            let mut open = Vec::new();
            let mut worst = LawViolation::default();
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
                        let held = self.series.held[i][0];
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
                            // pushed back: it would have stuck
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

    /// Order k: rates of the forces exactly at their limits. Sliders that this order does not decide remain in `open`.
    fn decide(&mut self, open: &mut Vec<(usize, f64)>, k: usize) -> Result<(), DynamicsError> {
        for &(i, _) in open.iter() {
            self.state.slider[i] = Slider::Stuck;
        }
        for _ in 0..tries_most(open.len()) {
            self.series.join(&self.model, &self.state);
            self.series.next(&self.model, k);
            self.measure_rounding(k);
            let rounding = self.rounding_n;
            let mut worst = LawViolation::default();
            let mut left = Vec::new();
            for &(i, sign) in open.iter() {
                match self.state.slider[i] {
                    Slider::Stuck => {
                        let rate = sign * self.series.held[i][k];
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

    /// The rounding error of one order propagates to all higher orders: the springs transmit it undiminished.
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

/// The slider with the largest violation of the law, and its required state.
#[derive(Default)]
struct LawViolation(Option<(f64, usize, Slider)>);

impl LawViolation {
    fn consider(&mut self, excess: f64, storey: usize, to: Slider) {
        if self.0.is_none_or(|(most, ..)| excess > most) {
            self.0 = Some((excess, storey, to));
        }
    }

    fn found(self) -> Option<(usize, Slider)> {
        self.0.map(|(_, storey, to)| (storey, to))
    }
}
