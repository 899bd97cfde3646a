//! Time history of one rocking block, by power series between lift-off, impact and fall.

use super::DynamicsError;
use super::excitation::TimeFunction;
use super::rocking_block::{
    Rocking, RockingBlock, RockingEquation, RockingHistory, RockingImpact, RockingOutcome, positive,
};
use crate::numeric::{first_descent, polynomial};
use std::f64::consts::FRAC_PI_2;

/// Number of coefficients of a series. Our choice: steps of 1/p then reach rounding.
const COEFFICIENTS: usize = 24;
/// Magnitude of the last coefficients, relative to the rotation, above which a step is halved.
const TRUNCATION: f64 = 1e-16;
/// Angular velocity after an impact, divided by p, below which the block comes to rest: its remaining rotation is smaller than this, in rad.
/// Our choice.
const REST_RATIO: f64 = 1e-10;
/// Shortest step, over 1/p. Our choice: no meaningful motion needs shorter ones.
const STEP_LEAST: f64 = 1e-9;
/// Largest number of impacts of a run. Our choice.
const IMPACTS_MOST: usize = 1_000_000;

/// Motion of one block that rocks on the edges of its base.
///
/// Between events the rotation is a power series with enough terms to reach rounding. Steps end at the samples of the ground motion; lift-off,
/// impact and fall are roots of the series.
///
/// # Errors
/// [`DynamicsError::Argument`] for a block, motion or option out of range, or an initial rotation above 90°; [`DynamicsError::TooManyEvents`]
/// after a million impacts.
///
/// # Limits
/// The edge does not slip and the block does not jump: check `friction_needed` and `least_pressure_ratio`. Every impact is at the edge, with
/// the ratio `velocity_ratio`. The model has no ground beside the block: a falling block rotates freely up to 90°. Rotations are accurate to
/// 1e-13 rad until the motion becomes chaotic. Tested by `rocking_block`.
///
/// # Source
/// Housner (1963); Zhang, J. & Makris, N. (2001) J. Eng. Mech. 127(5):473-483 for the exact equation.
///
/// # Example
/// ```
/// use dolmen::dynamics::{Rocking, RockingBlock, TimeFunction, rock_block};
/// let block = RockingBlock::rectangle(0.4, 2.0, 9.81)?;
/// let let_go = Rocking { start_rad: 0.5 * block.slenderness_rad, duration_s: Some(1.0), ..Rocking::default() };
/// let history = rock_block(&block, &TimeFunction::Zero, &TimeFunction::Zero, &let_go)?;
/// assert!((history.impacts[0].at_s - 0.490864).abs() < 5e-7); // a quarter of the period
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn rock_block(
    block: &RockingBlock,
    horizontal_m_s2: &TimeFunction,
    vertical_m_s2: &TimeFunction,
    options: &Rocking,
) -> Result<RockingHistory, DynamicsError> {
    block.check()?;
    horizontal_m_s2.check("horizontal_m_s2")?;
    vertical_m_s2.check("vertical_m_s2")?;
    positive("output_step_s", options.output_step_s)?;
    let shaken_s = horizontal_m_s2.duration_s().max(vertical_m_s2.duration_s());
    let duration_s = options.duration_s.unwrap_or(shaken_s + options.rest_s);
    if !(duration_s >= 0.0 && duration_s.is_finite()) {
        return Err(DynamicsError::Argument {
            argument: "duration_s",
            given: duration_s,
            allowed: "0 or a positive number",
        });
    }
    if options.start_rad.is_nan() || options.start_rad.abs() >= FRAC_PI_2 {
        return Err(DynamicsError::Argument {
            argument: "start_rad",
            given: options.start_rad,
            allowed: "less than π/2 to either side",
        });
    }
    let mut run = Run::of(block, [horizontal_m_s2, vertical_m_s2], options, duration_s);
    while run.time_s < duration_s && !run.over {
        run.step()?;
    }
    Ok(run.history())
}

pub(super) struct Run<'a> {
    block: &'a RockingBlock,
    ground: [&'a TimeFunction; 2],
    options: &'a Rocking,
    breaks_s: Vec<f64>,
    next_break: usize,
    pub(super) time_s: f64,
    /// Side of the edge of rotation, +1 or −1; 0 at rest on the base.
    side: f64,
    u: f64,
    v: f64,
    /// Whether the block has just lifted off; then rounding must not put it to rest again.
    lifted: bool,
    /// Time at which the block last came to rest, s.
    rested_s: f64,
    pub(super) over: bool,
    history: RockingHistory,
}

#[derive(Clone, Copy, PartialEq)]
enum Event {
    None,
    Impact,
    Fall,
    LiftOff { side: f64 },
    Leaves,
}

impl<'a> Run<'a> {
    pub(super) fn of(
        block: &'a RockingBlock,
        ground: [&'a TimeFunction; 2],
        options: &'a Rocking,
        duration_s: f64,
    ) -> Self {
        let mut breaks_s: Vec<f64> = ground.iter().flat_map(|f| f.breaks_s(duration_s)).collect();
        breaks_s.push(duration_s);
        breaks_s.sort_by(f64::total_cmp);
        breaks_s.dedup_by(|b, a| *b - *a < 1e-12 * duration_s); // both components may be sampled at the same times
        let start = options.start_rad;
        Run {
            block,
            ground,
            options,
            breaks_s,
            next_break: 0,
            time_s: 0.0,
            side: if start == 0.0 { 0.0 } else { start.signum() },
            u: start.abs(),
            v: 0.0,
            lifted: false,
            rested_s: f64::NEG_INFINITY,
            over: false,
            history: RockingHistory {
                outcome: RockingOutcome::Stood,
                time_s: Vec::new(),
                rotation_rad: Vec::new(),
                peak_rotation_rad: start.abs(),
                uplift_s: (start != 0.0).then_some(0.0),
                impacts: Vec::new(),
                friction_needed: 0.0,
                least_pressure_ratio: f64::INFINITY,
            },
        }
    }

    pub(super) fn step(&mut self) -> Result<(), DynamicsError> {
        while self.breaks_s[self.next_break] <= self.time_s {
            self.next_break += 1;
        }
        let to_break = self.breaks_s[self.next_break] - self.time_s;
        let of_series = self.ground.iter().map(|f| f.step_most_s());
        let h = of_series
            .fold(to_break, f64::min)
            .min(1.0 / self.block.frequency_parameter_rad_s);
        if self.side == 0.0 {
            self.rest(h)
        } else {
            self.rock(h)
        }
    }

    /// A step at rest on the base, until the moment of the ground acceleration lifts the block off.
    fn rest(&mut self, h: f64) -> Result<(), DynamicsError> {
        let [x, z] = self.accelerations_over_g(h);
        let (sin, cos) = match self.options.equation {
            RockingEquation::Exact => self.block.slenderness_rad.sin_cos(),
            RockingEquation::Linear => (self.block.slenderness_rad, 1.0),
        };
        // rounding must not lift off a block that has just come to rest
        let from = if self.rested_s == self.time_s { 1e-9 } else { 0.0 };
        let mut first = (1.0, Event::None);
        for side in [1.0, -1.0] {
            let mut holds = [0.0; COEFFICIENTS];
            for (k, hold) in holds.iter_mut().enumerate() {
                *hold = sin * z[k] + side * cos * x[k];
            }
            if let Some(at) = first_descent(&holds, from).filter(|at| *at < first.0) {
                first = (at, Event::LiftOff { side });
            }
        }
        if let Some(at) = first_descent(&z, 0.0).filter(|at| *at <= first.0) {
            first = (at, Event::Leaves);
        }
        let (at, event) = first;
        let [friction, pressure] = [polynomial(&x, 0.0), polynomial(&z, 0.0)];
        self.see_forces(friction, pressure);
        self.sample(at * h, |_| 0.0);
        self.advance(at, h);
        match event {
            Event::LiftOff { side } => {
                (self.side, self.lifted) = (side, true);
                self.history.uplift_s.get_or_insert(self.time_s);
            }
            Event::Leaves => {
                self.over = true;
                self.history.outcome = RockingOutcome::LeftTheGround { at_s: self.time_s };
            }
            _ => {}
        }
        Ok(())
    }

    /// A step of rotation about one edge, to its end or to the first event in it.
    fn rock(&mut self, mut h: f64) -> Result<(), DynamicsError> {
        let mut u = self.series(h);
        loop {
            let last = u[COEFFICIENTS - 1].abs() + u[COEFFICIENTS - 2].abs();
            if last <= TRUNCATION * u.iter().fold(0.0, |sum, c| sum + c.abs()) {
                break;
            }
            h *= 0.5;
            if h < STEP_LEAST / self.block.frequency_parameter_rad_s {
                return Err(DynamicsError::Argument {
                    argument: "acceleration of the ground over gravity",
                    given: self.accelerations_over_g(h)[0][0],
                    allowed: "of a size whose motion can be followed: look at its unit",
                });
            }
            u = self.series(h);
        }
        if std::mem::take(&mut self.lifted) {
            u[2] = u[2].max(0.0);
        }
        self.see_edge_forces(&u, h);
        let mut fall = u.map(|c| -c);
        fall[0] += FRAC_PI_2;
        let (mut at, mut event) = (1.0, Event::None);
        if let Some(sooner) = first_descent(&u, 0.0) {
            (at, event) = (sooner, Event::Impact);
        }
        if let Some(sooner) = first_descent(&fall, 0.0).filter(|sooner| *sooner < at) {
            (at, event) = (sooner, Event::Fall);
        }
        self.see_peak(&u, at);
        let side = self.side;
        self.sample(at * h, |t| side * polynomial(&u, t / h));
        (self.u, self.v) = (polynomial(&u, at), slope(&u, at) / h);
        self.advance(at, h);
        match event {
            Event::Impact => self.impact()?,
            Event::Fall => {
                self.over = true;
                self.history.outcome = RockingOutcome::Fell { at_s: self.time_s };
            }
            _ => {}
        }
        Ok(())
    }

    fn impact(&mut self) -> Result<(), DynamicsError> {
        let before = self.v;
        self.history.impacts.push(RockingImpact {
            at_s: self.time_s,
            velocity_rad_s: self.side * before,
        });
        if self.history.impacts.len() > IMPACTS_MOST {
            return Err(DynamicsError::TooManyEvents {
                at_s: self.time_s,
                events: IMPACTS_MOST,
            });
        }
        (self.side, self.u, self.v) = (-self.side, 0.0, -self.block.velocity_ratio * before);
        if self.v < REST_RATIO * self.block.frequency_parameter_rad_s {
            self.rested_s = self.time_s;
            (self.side, self.v) = (0.0, 0.0); // if the ground lifts it off again, `rest` finds this at the same time
        }
        Ok(())
    }

    /// Series of a_x/g and 1 + a_z/g over a step.
    fn accelerations_over_g(&self, h: f64) -> [[f64; COEFFICIENTS]; 2] {
        let mut series = [[0.0; COEFFICIENTS]; 2];
        for (series, ground) in series.iter_mut().zip(self.ground) {
            ground.series(self.time_s, h, series);
            for c in series.iter_mut() {
                *c /= self.block.gravity_m_s2;
            }
        }
        series[1][0] += 1.0;
        series
    }

    /// Coefficients of u(σ), term by term from the equation of motion.
    ///
    /// ```text
    /// (k+1)(k+2) u_{k+2} = −(h p)² Σ (z_j S_{k−j} + s x_j C_{k−j})
    /// k S_k = Σ j φ_j C_{k−j},   k C_k = −Σ j φ_j S_{k−j}        φ = α − u;  S = sin φ, C = cos φ  (linear: φ, 1)
    /// ```
    fn series(&self, h: f64) -> [f64; COEFFICIENTS] {
        let [x, z] = self.accelerations_over_g(h);
        let terms = |c: &[f64]| c.iter().rposition(|c| *c != 0.0).map_or(0, |last| last + 1);
        let (x, z) = (&x[..terms(&x)], &z[..terms(&z)]);
        let mut u = [0.0; COEFFICIENTS];
        let (mut sin, mut cos, mut phi) = ([0.0; COEFFICIENTS], [0.0; COEFFICIENTS], [0.0; COEFFICIENTS]);
        (u[0], u[1]) = (self.u, self.v * h);
        let scale = -(h * self.block.frequency_parameter_rad_s).powi(2);
        for k in 0..COEFFICIENTS {
            phi[k] = if k == 0 { self.block.slenderness_rad } else { 0.0 } - u[k];
            match (self.options.equation, k) {
                (RockingEquation::Linear, _) => {
                    sin[k] = phi[k];
                    cos[k] = if k == 0 { 1.0 } else { 0.0 };
                }
                (RockingEquation::Exact, 0) => (sin[0], cos[0]) = phi[0].sin_cos(),
                (RockingEquation::Exact, _) => {
                    let (mut s, mut c) = (0.0, 0.0);
                    for j in 1..=k {
                        s += j as f64 * phi[j] * cos[k - j];
                        c -= j as f64 * phi[j] * sin[k - j];
                    }
                    (sin[k], cos[k]) = (s / k as f64, c / k as f64);
                }
            }
            if k + 2 < COEFFICIENTS {
                let mut force = 0.0;
                for (j, z) in z.iter().enumerate().take(k + 1) {
                    force += z * sin[k - j];
                }
                for (j, x) in x.iter().enumerate().take(k + 1) {
                    force += self.side * x * cos[k - j];
                }
                u[k + 2] = scale * force / ((k + 1) * (k + 2)) as f64;
            }
        }
        u
    }

    /// Records the forces at the edge at the start of a step, divided by the weight, from the acceleration of the mass centre.
    ///
    /// ```text
    /// a_x + s R (u″ cos φ + u′² sin φ),   g + a_z + R (u″ sin φ − u′² cos φ)      R = g (m R² / I_0) / p²
    /// ```
    fn see_edge_forces(&mut self, u: &[f64; COEFFICIENTS], h: f64) {
        let block = self.block;
        let [x, z] = self.accelerations_over_g(h);
        let (sin, cos) = (block.slenderness_rad - self.u).sin_cos();
        let (turned, square) = (2.0 * u[2] / (h * h), self.v * self.v);
        let r_over_g = block.inertia_ratio / block.frequency_parameter_rad_s.powi(2);
        let friction = x[0] + self.side * r_over_g * (turned * cos + square * sin);
        let pressure = z[0] + r_over_g * (turned * sin - square * cos);
        self.see_forces(friction, pressure);
    }

    fn see_forces(&mut self, friction: f64, pressure: f64) {
        let needed = if pressure > 0.0 {
            friction.abs() / pressure
        } else {
            f64::INFINITY
        };
        self.history.friction_needed = self.history.friction_needed.max(needed);
        self.history.least_pressure_ratio = self.history.least_pressure_ratio.min(pressure);
    }

    /// Records the largest rotation up to σ = `at`: at the end or at a turning point.
    fn see_peak(&mut self, u: &[f64; COEFFICIENTS], at: f64) {
        let mut rate = [0.0; COEFFICIENTS];
        for k in 1..COEFFICIENTS {
            rate[k - 1] = k as f64 * u[k];
        }
        let turns = first_descent(&rate, 0.0).filter(|turn| *turn <= at);
        for sigma in [Some(at), turns].into_iter().flatten() {
            let rotation = polynomial(u, sigma);
            self.history.peak_rotation_rad = self.history.peak_rotation_rad.max(rotation);
        }
    }

    /// Records the samples up to `until` after the current time.
    fn sample(&mut self, until: f64, value: impl Fn(f64) -> f64) {
        loop {
            let at = self.history.time_s.len() as f64 * self.options.output_step_s;
            if at > self.time_s + until {
                return;
            }
            let rotation = value(at - self.time_s);
            self.history.time_s.push(at);
            self.history.rotation_rad.push(rotation);
        }
    }

    fn advance(&mut self, at: f64, h: f64) {
        let to_break = self.breaks_s[self.next_break];
        self.time_s += at * h;
        if at == 1.0 && (to_break - self.time_s).abs() < 1e-6 * h {
            self.time_s = to_break; // set exactly, so that rounding leaves no tiny step
        }
    }

    pub(super) fn history(mut self) -> RockingHistory {
        if self.history.outcome == RockingOutcome::Stood && self.history.uplift_s.is_some() {
            self.history.outcome = RockingOutcome::Rocked;
        }
        self.history
    }
}

fn slope(c: &[f64], sigma: f64) -> f64 {
    let terms = c.iter().enumerate().skip(1).rev();
    terms.fold(0.0, |sum, (k, c)| sum * sigma + k as f64 * c)
}
