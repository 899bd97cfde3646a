//! A pile of flat blocks that slide and twist on each other but do not rock: a second method in addition to the two contact laws.
//!
//! Between state changes of joints (release, stop) the motion is smooth and is integrated by an implicit Runge–Kutta method of
//! fourth order with error control. Steps end where a joint changes its state.

use super::contact_points::ContactRule;
use super::error::{BlocksError, check_times};
use super::sliding_bed::Twist;
use super::sliding_chain::{Chain, Place, Shaking};
use super::sliding_history::{SlidingHistory, SlidingOutcome};
use super::sliding_record::Recorder;
use super::sliding_solve::{NoAcceleration, Slide, Stage};
use super::sliding_state::{State, add};
use crate::signal::GroundMotion;
use crate::structure::stack::Stack;
use glam::{DVec2, DVec3};

/// Coefficients of SDIRK with five stages, orders 4 and 3, L-stable: stages, their weights and times, and the weights of the error.
///
/// # Source
/// Hairer, E. & Wanner, G. (1996) Solving Ordinary Differential Equations II, 2nd ed., table IV.6.5.
const GAMMA: f64 = 0.25;
const STAGES: [[f64; 4]; 5] = [
    [0.0, 0.0, 0.0, 0.0],
    [0.5, 0.0, 0.0, 0.0],
    [17.0 / 50.0, -1.0 / 25.0, 0.0, 0.0],
    [371.0 / 1360.0, -137.0 / 2720.0, 15.0 / 544.0, 0.0],
    [25.0 / 24.0, -49.0 / 48.0, 125.0 / 16.0, -85.0 / 12.0],
];
const TIMES: [f64; 5] = [0.25, 0.75, 11.0 / 20.0, 0.5, 1.0];
const ERROR: [f64; 5] = [-3.0 / 16.0, -27.0 / 32.0, 25.0 / 32.0, 0.0, 0.25];

/// Relative excess of the required force over the friction at which a joint is released. Our choice: a delay of 1e-7 s in an
/// earthquake.
const LETS_GO: f64 = 1e-6;
/// Velocity of a slowing joint below which it stops, m/s. Our choice: the remaining slip is 1e-18 m.
const STOPS_M_S: f64 = 1e-9;
/// Fraction of the time until a slowing joint stops that one step may cover.
const TOWARDS_STOP: f64 = 0.9;
/// Smoothing of friction at rest, over gravity, from the first to the last step of its reduction.
const SMOOTH_FIRST: f64 = 10.0;
const SMOOTH_LAST: f64 = 1e-13;
/// Acceleration over gravity above which a joint at rest is released.
const MOVES: f64 = 1e-8;
/// Fraction of the weight that is zero except for rounding. Our choice: more than the change in a shortest step.
const WEIGHTLESS: f64 = 1e-7;
/// Shortest step, s: the run ends if it has no solution.
const STEP_LEAST_S: f64 = 1e-11;

/// Options of [`simulate_sliding`].
#[derive(Clone, Debug, PartialEq)]
pub struct Sliding {
    /// Points of a bed for the sums of pressure and friction. Default 6 × 6.
    pub contact_rule: ContactRule,
    /// Largest error of a velocity in a step, m/s. Default 1e-8.
    pub tolerance_m_s: f64,
    /// Duration of the run, s. Default `None`: the motion plus `rest_s`.
    pub duration_s: Option<f64>,
    /// Time after the motion, s. Default 2.
    pub rest_s: f64,
    /// Time between samples of the history, s. Default 0.01.
    pub output_step_s: f64,
    /// Initial sliding velocity, m/s, and spin, rad/s, of each block relative to the block below, counted from the bottom. Default
    /// empty: at rest.
    pub starts: Vec<[f64; 3]>,
}

impl Default for Sliding {
    fn default() -> Self {
        Sliding {
            contact_rule: ContactRule::Six,
            tolerance_m_s: 1e-8,
            duration_s: None,
            rest_s: 2.0,
            output_step_s: 0.01,
            starts: Vec::new(),
        }
    }
}

/// Motion of a pile of blocks with level beds that slide and twist on each other under base motion of up to three components.
///
/// `progress` receives the simulated time at intervals, and stops the run by returning false.
///
/// ```text
/// m_i (v̇_i + a_g) = F_i − F_{i+1},   I_i ω̇_i = T_i − T_{i+1} − d × F_{i+1}
/// N_i(x, y) = C (1 + α x + β y), without tension, balances the weight and the overturning moment of all blocks above
/// (F_i, T_i) = −∫ μ N u/|u| dA if the joint slides with u(x, y);  within the limit surface of friction if it is stuck
/// ```
/// One law describes stick, slide, twist and both together; blocks that stick to each other move as one.
///
/// # Errors
/// [`BlocksError::Option`] for an option out of range; [`BlocksError::NotAPile`] for a stack that is not a single pile of dry level
/// beds; [`BlocksError::NoSliding`] if no accelerations are found.
///
/// # Limits
/// Blocks neither rock nor jump: if they would, the run ends with a status. Position errors are 1e-8 m in 30 s, plus the error of a
/// torque on the points of a bed: 1 % for pure twisting with 6 × 6 points.
///
/// # Source
/// Hwang, I. S. & Kim, J. K. (2002), analysis of sliding of piled multi-block systems considering horizontal rotation (in Korean).
/// Differs from the source: the pressure is a sum of linear functions, in its eq. for N a product; accelerations and pressures are
/// solved together; friction is static up to its limit in force and torque together; without smoothing, because steps end at the
/// events.
///
/// # Example
/// ```
/// use dolmen::blocks::{Sliding, SlidingOutcome, simulate_sliding};
/// use dolmen::structure::stack::{Block, JointMaterial, Solid, Stack};
/// let stone = Block { name: "stone".into(), solid: Solid::cuboid(0.3, 0.2, 0.1)?, density_kg_m3: 2600.0 };
/// let stack = Stack::new(vec![stone], JointMaterial::with_friction(0.5), 9.81)?;
/// let pushed = Sliding { starts: vec![[1.0, 0.0, 0.0]], duration_s: Some(1.0), ..Sliding::default() };
/// let history = simulate_sliding(&stack, None, &pushed, &mut |_| true)?;
/// assert_eq!(history.outcome, SlidingOutcome::Slid);
/// assert!((history.joints[0].residual_slip_m() - 0.5 / (0.5 * 9.81)).abs() < 1e-9); // v²/(2 μ g)
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn simulate_sliding(
    stack: &Stack,
    motion: Option<&GroundMotion>,
    options: &Sliding,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<SlidingHistory, BlocksError> {
    check_times(None, options.duration_s, options.output_step_s, options.rest_s)?;
    if !(options.tolerance_m_s > 0.0 && options.tolerance_m_s.is_finite()) {
        return Err(BlocksError::Option {
            option: "tolerance_m_s",
            given: options.tolerance_m_s,
            allowed: "a positive number",
        });
    }
    let chain = Chain::of(stack, options.contact_rule)?;
    let n = chain.stones.len();
    if options.starts.len() > n || options.starts.iter().flatten().any(|v| !v.is_finite()) {
        return Err(BlocksError::Option {
            option: "starts",
            given: options.starts.len() as f64,
            allowed: "at most one finite start for each block",
        });
    }
    let shaken_s = motion.map_or(0.0, GroundMotion::duration_s);
    let duration_s = options.duration_s.unwrap_or(shaken_s + options.rest_s);
    let mut twists: Vec<Twist> = options.starts.iter().map(|start| DVec3::from(*start)).collect();
    twists.resize(n, DVec3::ZERO);
    let mut run = Run {
        state: State {
            places: chain.drawn(),
            twists,
            input: 0.0,
            friction: 0.0,
        },
        record: Recorder::of(stack, &chain, options.output_step_s),
        chain,
        motion,
        gravity: stack.gravity_m_s2(),
        tolerance: options.tolerance_m_s,
        time_s: 0.0,
        duration_s,
        step_s: duration_s,
        slides: vec![Slide::Stuck; n],
        k: vec![DVec3::ZERO; n],
    };
    let outcome = run.go(progress)?;
    Ok(run.record.finish(outcome, &run.state, run.time_s))
}

struct Step {
    state: State,
    k: Vec<Twist>,
    error: f64,
    /// Largest ratio of required to available friction among the stuck joints.
    gauge: f64,
}

struct Run<'a> {
    chain: Chain,
    motion: Option<&'a GroundMotion>,
    gravity: f64,
    tolerance: f64,
    time_s: f64,
    duration_s: f64,
    /// Step length allowed by the error.
    step_s: f64,
    state: State,
    slides: Vec<Slide>,
    k: Vec<Twist>,
    record: Recorder,
}

impl Run<'_> {
    fn go(&mut self, progress: &mut dyn FnMut(f64) -> bool) -> Result<SlidingOutcome, BlocksError> {
        let mut gauge = match self.release() {
            Ok(gauge) => gauge,
            Err(trouble) => return self.end(trouble),
        };
        self.record.begin(&self.chain, &self.state, &self.slides);
        loop {
            if self.shaking(self.time_s).weight <= 0.0 {
                return Ok(SlidingOutcome::LeftTheGround { at_s: self.time_s });
            }
            if self.time_s >= self.duration_s {
                break;
            }
            if !progress(self.time_s) {
                return Ok(SlidingOutcome::Stopped { at_s: self.time_s });
            }
            let next_s = self.next_break_s();
            let mut h = (next_s - self.time_s).min(self.step_s).min(self.towards_stop());
            let step = loop {
                if next_s - self.time_s - h < STEP_LEAST_S {
                    h = next_s - self.time_s;
                }
                let trouble = match self.try_step(h) {
                    Ok(step) if step.error > self.tolerance => {
                        h *= (0.9 * (self.tolerance / step.error).powf(0.25)).max(0.1);
                        None
                    }
                    // a joint would have been released within the step: end the step there
                    Ok(step) if step.gauge > 1.0 + LETS_GO && h > STEP_LEAST_S => {
                        let part = (1.0 + 0.5 * LETS_GO - gauge) / (step.gauge - gauge);
                        h *= part.clamp(0.05, 0.999_999);
                        None
                    }
                    Ok(step) => break step,
                    Err(trouble) => {
                        h *= 0.25;
                        Some(trouble)
                    }
                };
                if h < STEP_LEAST_S {
                    match trouble {
                        Some(trouble) => return self.end(trouble),
                        None => h = STEP_LEAST_S,
                    }
                    if let Ok(step) = self.try_step(h) {
                        break step;
                    }
                    return self.end(NoAcceleration::NoConvergence);
                }
            };
            let grown = 0.9 * (self.tolerance / step.error.max(1e-300)).powf(0.25);
            self.step_s = h * grown.clamp(0.2, 5.0);
            let before_s = self.time_s;
            self.time_s = if h == next_s - before_s {
                next_s
            } else {
                before_s + h
            };
            let before = std::mem::replace(&mut self.state, step.state);
            self.k = step.k;
            let stopped = self.stop();
            self.record
                .take(&self.chain, &before, &self.state, [before_s, self.time_s]);
            gauge = step.gauge;
            if stopped || gauge >= 1.0 {
                gauge = match self.release() {
                    Ok(gauge) => gauge,
                    Err(trouble) => return self.end(trouble),
                };
                self.record.changed(&self.slides, self.time_s);
                self.step_s = self.duration_s;
            }
        }
        Ok(if self.record.moved() {
            SlidingOutcome::Slid
        } else {
            SlidingOutcome::Stuck
        })
    }

    fn end(&self, trouble: NoAcceleration) -> Result<SlidingOutcome, BlocksError> {
        match trouble {
            // without weight there is no pressure, and therefore no rocking
            NoAcceleration::Rocks(_) if self.shaking(self.time_s).weight < WEIGHTLESS * self.gravity => {
                Ok(SlidingOutcome::LeftTheGround { at_s: self.time_s })
            }
            NoAcceleration::Rocks(joint) => Ok(SlidingOutcome::Rocks {
                joint: self.chain.stones[joint].joint,
                at_s: self.time_s,
            }),
            NoAcceleration::NoConvergence => Err(BlocksError::NoSliding { at_s: self.time_s }),
        }
    }

    /// The next sample of the ground motion, or the end.
    fn next_break_s(&self) -> f64 {
        let Some(motion) = self.motion else {
            return self.duration_s;
        };
        let dt = motion.time_step_s();
        let mut index = (self.time_s / dt).floor() + 1.0;
        if index * dt - self.time_s < STEP_LEAST_S {
            index += 1.0;
        }
        if index as usize >= motion.length() {
            return self.duration_s;
        }
        (index * dt).min(self.duration_s)
    }

    fn shaking(&self, time_s: f64) -> Shaking {
        let a = self
            .motion
            .map_or([0.0; 3], |motion| motion.acceleration_at_m_s2(time_s));
        Shaking {
            ground: DVec2::new(a[0], a[1]),
            weight: self.gravity + a[2],
        }
    }

    /// Magnitude of a twist as a velocity: the spin is multiplied by the half diagonal of a square bed.
    fn size(&self, joint: usize, twist: Twist) -> f64 {
        twist
            .truncate()
            .length()
            .hypot(0.5 * self.chain.stones[joint].bed_size * twist.z)
    }

    /// Longest step that does not pass the stop of a slowing joint, s.
    fn towards_stop(&self) -> f64 {
        let mut most = f64::INFINITY;
        for i in 0..self.slides.len() {
            let size = self.size(i, self.state.twists[i]);
            if size > STOPS_M_S {
                let rate = self.slowing(i) / size;
                if rate > 0.0 {
                    most = most.min((TOWARDS_STOP * size / rate).max(STEP_LEAST_S));
                }
            }
        }
        most
    }

    /// Rate of decrease of a joint's velocity, −½ d(size²)/dt.
    fn slowing(&self, joint: usize) -> f64 {
        let (w, k) = (self.state.twists[joint], self.k[joint]);
        let half = 0.5 * self.chain.stones[joint].bed_size;
        -(w.truncate().dot(k.truncate()) + half * half * w.z * k.z)
    }

    /// Stops the joints that have come to rest.
    fn stop(&mut self) -> bool {
        let mut stopped = false;
        for i in 0..self.slides.len() {
            if self.slides[i] != Slide::Stuck
                && self.size(i, self.state.twists[i]) <= STOPS_M_S
                && self.slowing(i) > 0.0
            {
                self.state.twists[i] = DVec3::ZERO;
                stopped = true;
            }
        }
        stopped
    }

    /// Determines which joints at rest are released, and their motion. Returns the largest friction ratio of the other joints.
    fn release(&mut self) -> Result<f64, NoAcceleration> {
        let n = self.slides.len();
        let at_rest: Vec<bool> = self
            .state
            .twists
            .iter()
            .map(|twist| *twist == DVec3::ZERO)
            .collect();
        let shaking = self.shaking(self.time_s);
        let mut gone = vec![false; n];
        // each iteration releases joints that static friction cannot hold; kinetic friction then acts in them
        for _ in 0..=n {
            let law = |i: usize| {
                let stone = &self.chain.stones[i];
                match (at_rest[i], gone[i]) {
                    (false, _) => Slide::Slides,
                    (true, true) => Slide::LetsGo {
                        mu: stone.friction_kinetic,
                    },
                    (true, false) => Slide::LetsGo {
                        mu: stone.friction_static,
                    },
                }
            };
            let slides: Vec<Slide> = (0..n).map(law).collect();
            let mut k = vec![DVec3::ZERO; n];
            let mut smooth = SMOOTH_FIRST * self.gravity;
            while smooth > SMOOTH_LAST * self.gravity {
                let stage = self.instant(&slides, shaking, smooth);
                k = self.chain.accelerations(&stage, &k)?.k;
                smooth *= 0.1;
                for i in (0..n).filter(|&i| at_rest[i]) {
                    if self.size(i, k[i]) < 100.0 * smooth {
                        k[i] *= 0.1; // the velocity of nearly stuck joints is proportional to the smoothing
                    }
                }
            }
            let before = gone.clone();
            for i in 0..n {
                gone[i] |= at_rest[i] && self.size(i, k[i]) > MOVES * self.gravity;
                if at_rest[i] && !gone[i] {
                    k[i] = DVec3::ZERO;
                }
            }
            self.k = k;
            if gone == before {
                break;
            }
        }
        for i in 0..n {
            self.slides[i] = if at_rest[i] && !gone[i] {
                Slide::Stuck
            } else {
                Slide::Slides
            };
        }
        // once more without smoothing, with stuck joints exactly stuck
        let slides: Vec<Slide> = (0..n)
            .map(|i| match self.slides[i] {
                Slide::Slides if at_rest[i] => Slide::LetsGo {
                    mu: self.chain.stones[i].friction_kinetic,
                },
                other => other,
            })
            .collect();
        let stage = self.instant(&slides, shaking, 0.0);
        let solved = self.chain.accelerations(&stage, &self.k)?;
        let gauge = self.gauge(&solved, shaking)?;
        self.k = solved.k;
        // the joint sticks by this search: rounding must not release it immediately
        Ok(gauge.min(1.0 - LETS_GO))
    }

    fn instant<'s>(&'s self, slides: &'s [Slide], shaking: Shaking, smooth: f64) -> Stage<'s> {
        Stage {
            places: &self.state.places,
            twists: &self.state.twists,
            gh: 0.0,
            shaking,
            slides,
            smooth,
        }
    }

    /// Largest ratio of required to available friction among the stuck joints.
    fn gauge(&self, solved: &super::sliding_solve::Solved, shaking: Shaking) -> Result<f64, NoAcceleration> {
        let mut most: f64 = 0.0;
        for (i, slide) in self.slides.iter().enumerate() {
            if *slide == Slide::Stuck {
                let pressure = self.chain.pressure(i, &solved.motion, &solved.load, shaking)?;
                most = most.max(pressure.gauge(self.chain.stones[i].friction_static, solved.load.wrench[i]));
            }
        }
        Ok(most)
    }

    /// One step of the Runge–Kutta method.
    fn try_step(&self, h: f64) -> Result<Step, NoAcceleration> {
        let n = self.slides.len();
        let mut rates: Vec<(Vec<Place>, Vec<Twist>, [f64; 2])> = Vec::with_capacity(5);
        let mut guess = self.k.clone();
        let mut last = None;
        for (weights, time) in STAGES.iter().zip(TIMES) {
            let mut hat = self.state.clone();
            for (weight, (places, twists, energies)) in weights.iter().zip(&rates) {
                add(&mut hat, weight * h, places, twists, *energies);
            }
            let shaking = self.shaking(self.time_s + time * h);
            let stage = Stage {
                places: &hat.places,
                twists: &hat.twists,
                gh: GAMMA * h,
                shaking,
                slides: &self.slides,
                smooth: 0.0,
            };
            let solved = self.chain.accelerations(&stage, &guess)?;
            let lost: f64 = solved
                .load
                .wrench
                .iter()
                .zip(&solved.twists)
                .map(|(w, u)| -w.dot(*u))
                .sum();
            let energies = [self.chain.power(&solved.motion, shaking), lost];
            let places = self.chain.rates(&solved.motion, &solved.twists);
            add(&mut hat, GAMMA * h, &places, &solved.k, energies);
            rates.push((places, solved.k.clone(), energies));
            guess.clone_from(&solved.k);
            last = Some((hat, solved, shaking));
        }
        let (state, solved, shaking) = last.ok_or(NoAcceleration::NoConvergence)?;
        let error = (0..n)
            .map(|i| {
                let sum = ERROR.iter().zip(&rates).map(|(weight, (_, k, _))| *weight * k[i]);
                h * self.size(i, sum.sum())
            })
            .fold(0.0, f64::max);
        let gauge = self.gauge(&solved, shaking)?;
        Ok(Step {
            state,
            k: solved.k,
            error,
            gauge,
        })
    }
}
