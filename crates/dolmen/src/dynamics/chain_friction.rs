//! Determines which joints of a chain stick and which rotate after an event, by Coulomb's law for all joints together.
//!
//! Moments and rates are compared by their Taylor series, coefficient by coefficient: if the moment of a joint is exactly at its limit,
//! the first coefficient above rounding decides whether the joint rotates or sticks. For these series the law is a linear
//! complementarity problem with a positive definite matrix. It is solved by pivoting: the joint with the largest violation changes
//! first. If the iteration does not end after some steps, the violating joint with the lowest index changes instead, which always ends
//! (Murty).
//!
//! # Source
//! Murty, K. G. (1974) Note on a Bard-type scheme for solving the complementarity problem. Opsearch 11:123-130. Differs from the
//! source: the numbers are series.

use super::chain_friction_state::Change;
use super::chain_moving::Run;
use super::chain_series::DEGREE;
use super::frame_model::Slider;
use super::{ChainSlip, DynamicsError, TimeFunction};
use crate::numeric::first_descent;

/// Events closer together than this are one event, s.
const PILE_S: f64 = 1e-9;
/// Fraction of the largest moment below which a moment at an event, or its rate over the step, counts as rounding, as for frames.
const ROUNDING: f64 = 1e-12;
/// Angular velocity of every link below which a chain is at rest, rad/s.
const REST_RAD_S: f64 = 1e-13;

/// A joint that violates the law: the power of time of the violation, its size, and the required state of the joint.
struct LawViolation {
    power: usize,
    excess: f64,
    joint: usize,
    to: Slider,
}

impl Run<'_> {
    /// First change of a joint's friction within the step, with its time σ as a fraction of the step.
    pub(super) fn first_slider_change(&self, joint: usize) -> Option<(f64, Change)> {
        let [holds, _] = self.series.model.joints[joint].friction.moments_n_m()?;
        let zeros = self.friction.zeros[joint].min(DEGREE + 1);
        match self.state.sliders[joint] {
            Slider::Slipping(sign) => {
                let mut rate = super::chain_series::rate(&self.series.across[joint]).map(|c| sign * c);
                rate[..zeros].fill(0.0);
                first_descent(&rate, 0.0).map(|sigma| (sigma, Change::Stops))
            }
            Slider::Stuck => {
                let held = &self.series.held[joint];
                if held.iter().map(|c| c.abs()).sum::<f64>() < holds {
                    return None;
                }
                let mut first: Option<(f64, Change)> = None;
                for sign in [1.0, -1.0] {
                    let mut left = held.map(|c| -sign * c);
                    left[0] += holds;
                    // compare only with the limit on the side of the moment
                    if left[0] < 0.5 * holds {
                        left[..zeros].fill(0.0);
                    }
                    if let Some(sigma) = first_descent(&left, 0.0)
                        && first.is_none_or(|(earlier, _)| sigma < earlier)
                    {
                        first = Some((sigma, Change::Goes(sign)));
                    }
                }
                first
            }
            Slider::Absent => None,
        }
    }

    /// Changes the friction state of a joint. Before the next step `settle` determines the states of all joints.
    pub(super) fn change_slider(&mut self, joint: usize, change: Change) -> Result<(), DynamicsError> {
        let friction = &mut self.friction;
        if self.at_s - friction.pile_at_s > PILE_S {
            (friction.pile, friction.pile_at_s) = (0, self.at_s);
        }
        friction.pile += 1;
        if friction.pile > 50 + 10 * self.state.sliders.len() {
            return Err(DynamicsError::TooManyEvents {
                at_s: self.at_s,
                events: friction.pile,
            });
        }
        if friction.unsettled.is_none() {
            friction.unsettled = Some(self.state.sliders.clone());
        }
        let moments = self.series.model.joints[joint].friction.moments_n_m();
        self.state.sliders[joint] = match (change, moments) {
            (Change::Goes(sign), Some([holds, turns])) if holds > turns => {
                friction.gone.push(joint);
                friction.zeros[joint] = 1;
                Slider::Slipping(sign)
            }
            // `settle` finds from the balance of all joints whether it continues, sticks or reverses
            _ => Slider::Stuck,
        };
        Ok(())
    }

    /// Determines which joints at rest stick and which rotate, if this is open after an event. `h` is the length of the next step, s.
    pub(super) fn settle(&mut self, load: &TimeFunction, mut h: f64) -> Result<(), DynamicsError> {
        let Some(before) = self.friction.unsettled.take() else {
            return Ok(());
        };
        let n = self.state.sliders.len();
        for joint in 0..n {
            // joints that were released at this event are still at rest
            let at_rest = self.friction.zeros[joint] > 0 && !self.friction.gone.contains(&joint);
            if at_rest && matches!(self.state.sliders[joint], Slider::Slipping(_)) {
                self.state.sliders[joint] = Slider::Stuck;
            }
            // the links on both sides of a stuck joint have exactly equal angular velocities
            if self.state.sliders[joint] == Slider::Stuck {
                self.state.omega[joint] = joint.checked_sub(1).map_or(0.0, |below| self.state.omega[below]);
            }
        }
        let resting: Vec<usize> = (0..n)
            .filter(|joint| self.state.sliders[*joint] == Slider::Stuck)
            .collect();
        let worst_first = 10 + 4 * n;
        // upper bound of the states that Murty's rule visits for few joints; for many joints it visits far fewer
        let tries_most = worst_first + (1usize << resting.len().min(12));
        for tried in 0..=tries_most {
            self.series.coefficients(&self.state, load, self.at_s, h);
            while self.series.part_exact().is_none() {
                h *= 0.01;
                self.series.coefficients(&self.state, load, self.at_s, h);
            }
            let mut off = self.off_the_law(&resting, h);
            let next = if tried < worst_first {
                off.sort_by(|a, b| a.power.cmp(&b.power).then(b.excess.total_cmp(&a.excess)));
                off.first()
            } else {
                off.iter().min_by_key(|off| off.joint)
            };
            let Some(next) = next else {
                self.note_slips(&before);
                return Ok(());
            };
            self.state.sliders[next.joint] = next.to;
        }
        Err(DynamicsError::NoJointState {
            at_s: self.at_s,
            tried: tries_most,
        })
    }

    /// The joints at rest that violate the law, in order. Also stores the first power of the series of each joint.
    fn off_the_law(&mut self, resting: &[usize], h: f64) -> Vec<LawViolation> {
        let mut rounding_n_m = [0.0; DEGREE - 1];
        let mut largest: f64 = 0.0;
        for (k, rounding) in rounding_n_m.iter_mut().enumerate() {
            // the error of one power propagates to all higher powers
            largest = largest.max(ROUNDING * self.series.moment_scale(&self.state, k, h));
            *rounding = largest;
        }
        let mut off = Vec::new();
        for &joint in resting {
            let Some([holds, turns]) = self.series.model.joints[joint].friction.moments_n_m() else {
                continue;
            };
            let (margin, to): (Box<dyn Fn(usize) -> f64>, Slider) = match self.state.sliders[joint] {
                Slider::Slipping(sign) => {
                    let series = &self.series;
                    (
                        Box::new(move |k| sign * series.inertia(joint, k, h)),
                        Slider::Stuck,
                    )
                }
                _ => {
                    let held = self.series.held[joint];
                    let sign = held[0].signum();
                    let at = move |k: usize| {
                        if k == 0 {
                            holds - held[0].abs()
                        } else {
                            -sign * held[k]
                        }
                    };
                    (Box::new(at), Slider::Slipping(sign))
                }
            };
            let power = (0..DEGREE - 1).find(|&k| margin(k).abs() > rounding_n_m[k]);
            let stuck = matches!(to, Slider::Slipping(_));
            // a joint at its static limit, above the kinetic limit, sticks until it exceeds the limit
            let may_pass = |power: usize| !(stuck && power > 0 && holds > turns);
            if let Some(power) = power.filter(|power| margin(*power) < 0.0 && may_pass(*power)) {
                let excess = -margin(power) / holds;
                off.push(LawViolation {
                    power,
                    excess,
                    joint,
                    to,
                });
            }
            let zeros = power.unwrap_or(DEGREE);
            self.friction.zeros[joint] = match (stuck, holds > turns) {
                (true, true) => 0,
                (true, false) => zeros,
                (false, _) => zeros + 1,
            };
        }
        off
    }

    /// Records the joints that began to slip, reversed or stopped.
    fn note_slips(&mut self, before: &[Slider]) {
        let mut changed = false;
        for (joint, before) in before.iter().enumerate() {
            let now = self.state.sliders[joint];
            if now == *before {
                continue;
            }
            changed |= *before != Slider::Absent || now != Slider::Stuck;
            self.end_slip(joint);
            if matches!(now, Slider::Slipping(_)) {
                self.friction.turning[joint] = Some((self.at_s, self.across_now(joint)));
            }
        }
        if changed {
            if self.friction.events == 0 || self.at_s - self.friction.last_event_s > PILE_S {
                self.friction.events += 1;
            }
            self.friction.last_event_s = self.at_s;
        }
    }

    /// Ends the slip of a joint, if it is slipping.
    pub(super) fn end_slip(&mut self, joint: usize) {
        if let Some((from_s, from_rad)) = self.friction.turning[joint].take() {
            self.friction.slips.push(ChainSlip {
                joint,
                from_s,
                to_s: self.at_s,
                slip_rad: self.across_now(joint) - from_rad,
            });
        }
    }

    pub(super) fn is_at_rest(&self) -> bool {
        self.state.omega.iter().all(|rate| rate.abs() <= REST_RAD_S)
    }
}
