//! Time steps of a frame whose two directions share their slip forces; symbols as in `frame_in_plan`.

use super::DynamicsError;
use super::excitation::{FrameLoad, TimeFunction};
use super::frame_friction::{FrictionFrame, Sliders, StoreyFriction};
use super::frame_model::{Model, Slider, State};
use super::frame_run::FrameRun;
use dolmen_linalg::{Matrix, solve};

/// Relative change of a force below which the sweeps over the storeys end. Our choice.
const SWEPT: f64 = 1e-11;
/// Largest number of sweeps: twenty equal storeys take several thousand.
const SWEEPS_MOST: usize = 200_000;

/// One direction of the frame, with its constants and state.
pub(super) struct Direction {
    pub(super) model: Model,
    k: Matrix,
    c: Option<Matrix>,
    /// (M/h + C/2 + h K/4)⁻¹, and the drift velocities under unit forces of the storeys.
    inverse: Matrix,
    gives: Matrix,
    load: FrameLoad,
    pub(super) state: State,
    pub(super) friction_n: Vec<f64>,
    /// Work input, and energy dissipated by friction and by dashpots, J.
    pub(super) input_j: f64,
    pub(super) friction_j: f64,
    pub(super) damping_j: f64,
}

/// State of a frame during time stepping.
pub(super) struct Steps {
    pub(super) directions: [Direction; 2],
    pub(super) slips: Vec<bool>,
    pub(super) heights_m: Vec<f64>,
    pub(super) drift_ratio_most: f64,
    pub(super) step_s: f64,
}

/// Frames, loads and options of both directions.
pub(super) type BothDirections<'a> = ([&'a FrictionFrame; 2], [&'a FrameLoad; 2], [&'a FrameRun; 2]);

/// Force of one storey at the end of a step.
struct Slipped {
    share: [f64; 2],
    work_j: f64,
}

impl Direction {
    fn new(frame: &FrictionFrame, load: &FrameLoad, start: &FrameRun, h: f64) -> Result<Self, DynamicsError> {
        let model = Model::of(frame)?;
        let n = model.levels();
        let k = frame.stiffness_matrix(Sliders::Slipping)?;
        let c = frame.damping_matrix()?;
        let a = Matrix::from_fn(n, n, |i, j| {
            let mass = if i == j { model.mass_kg[i] / h } else { 0.0 };
            mass + c.as_ref().map_or(0.0, |c| 0.5 * c[(i, j)]) + 0.25 * h * k[(i, j)]
        });
        let unit = Matrix::from_fn(n, n, |i, j| f64::from(u8::from(i == j)));
        let inverse = solve(&a, &unit)?;
        // row i minus row i − 1, and the same for columns
        let down = |x: &Matrix, i: usize, j: usize| x[(i, j)] - i.checked_sub(1).map_or(0.0, |i| x[(i, j)]);
        let rows = Matrix::from_fn(n, n, |i, j| down(&inverse, i, j));
        let gives = Matrix::from_fn(n, n, |i, j| {
            rows[(i, j)] - j.checked_sub(1).map_or(0.0, |j| rows[(i, j)])
        });
        let given = |of: &[f64]| if of.is_empty() { vec![0.0; n] } else { of.to_vec() };
        let state = State {
            y: given(&start.start_displacement_m),
            v: given(&start.start_velocity_m_s),
            slider: vec![Slider::Stuck; n],
            offset_m: vec![0.0; n],
            joint: vec![None; n],
        };
        let input_j = model.kinetic_j(&state.v) + model.stored_j(&state);
        let friction_n = (0..n).map(|i| model.jenkins_force(i, &state)).collect();
        Ok(Direction {
            model,
            k,
            c,
            inverse,
            gives,
            load: load.clone(),
            state,
            friction_n,
            input_j,
            friction_j: 0.0,
            damping_j: 0.0,
        })
    }

    /// Load on the levels over a step, mean of its values at both ends: −M 1 a + F.
    fn loads_n(&self, at_s: f64, h: f64) -> Vec<f64> {
        let mean = |of: &TimeFunction| 0.5 * (of.value(at_s) + of.value(at_s + h));
        let ground_m_s2 = mean(&self.load.ground_acceleration_m_s2);
        let forces: Vec<f64> = self.load.forces_n.iter().map(mean).collect();
        let each = self.model.mass_kg.iter().enumerate();
        each.map(|(i, mass)| forces.get(i).copied().unwrap_or(0.0) - mass * ground_m_s2)
            .collect()
    }

    /// Forces on the levels in a step without friction: M v/h − C v/2 − K (u + h v/4) plus the load.
    fn acts_n(&self, h: f64, loads_n: &[f64]) -> Vec<f64> {
        let State { y, v, .. } = &self.state;
        let moved: Vec<f64> = y.iter().zip(v).map(|(y, v)| y + 0.25 * h * v).collect();
        let springs = self.k.times(&moved);
        let dashpots = self.c.as_ref().map(|c| c.times(v));
        let each = self.model.mass_kg.iter().enumerate();
        each.map(|(i, mass)| {
            let damped = dashpots.as_ref().map_or(0.0, |of| 0.5 * of[i]);
            mass * v[i] / h - damped - springs[i] + loads_n[i]
        })
        .collect()
    }

    /// Forces on the levels from the forces of the storeys: Bᵀ q.
    pub(super) fn on_levels(&self, storeys_n: &[f64]) -> Vec<f64> {
        let above = |i: usize| storeys_n.get(i + 1).copied().unwrap_or(0.0);
        (0..storeys_n.len()).map(|i| storeys_n[i] - above(i)).collect()
    }

    /// Absolute accelerations of the levels, m/s², from springs, dashpots, friction and loads.
    pub(super) fn acceleration_m_s2(&self, at_s: f64) -> Vec<f64> {
        let springs = self.k.times(&self.state.y);
        let dashpots = self.c.as_ref().map(|c| c.times(&self.state.v));
        let rubs = self.on_levels(&self.friction_n);
        let each = self.model.mass_kg.iter().enumerate();
        each.map(|(i, mass)| {
            let damped = dashpots.as_ref().map_or(0.0, |of| of[i]);
            let force_n = self.load.forces_n.get(i).map_or(0.0, |of| of.value(at_s));
            (force_n - springs[i] - damped - rubs[i]) / mass
        })
        .collect()
    }

    /// Series spring of a Jenkins element, N/m; `None` for a Coulomb slider or no slider.
    pub(super) fn series_n_m(&self, storey: usize) -> Option<f64> {
        match self.model.friction[storey] {
            StoreyFriction::Jenkins {
                stuck_stiffness_n_m, ..
            } => Some(stuck_stiffness_n_m),
            StoreyFriction::Coulomb { .. } | StoreyFriction::None => None,
        }
    }

    /// Mean force of a friction element over a step that ends at `end_n`: the end value for Coulomb's law, the mean value for a
    /// Jenkins spring.
    fn over_step_n(&self, storey: usize, end_n: f64) -> f64 {
        match self.series_n_m(storey) {
            Some(_) => 0.5 * (self.friction_n[storey] + end_n),
            None => end_n,
        }
    }

    /// Constant forces at the levels, N.
    pub(super) fn stays_n(&self) -> Vec<f64> {
        self.load.forces_n.iter().map(TimeFunction::constant).collect()
    }

    pub(super) fn slider_m(&self, storey: usize) -> f64 {
        let across = self.model.across(storey, &self.state.y);
        across
            - self
                .series_n_m(storey)
                .map_or(0.0, |k| self.friction_n[storey] / k)
    }
}

impl Steps {
    pub(super) fn new((frames, loads, runs): BothDirections<'_>, step_s: f64) -> Result<Self, DynamicsError> {
        let storeys = frames[0].frame().storeys();
        Ok(Steps {
            directions: [
                Direction::new(frames[0], loads[0], runs[0], step_s)?,
                Direction::new(frames[1], loads[1], runs[1], step_s)?,
            ],
            slips: vec![false; storeys.len()],
            heights_m: storeys.iter().map(|storey| storey.height_m).collect(),
            drift_ratio_most: runs[0].drift_ratio_most,
            step_s,
        })
    }

    pub(super) fn step(&mut self, at_s: f64) -> Result<(), DynamicsError> {
        let h = self.step_s;
        let loads = [0, 1].map(|d| self.directions[d].loads_n(at_s, h));
        let acts = [0, 1].map(|d| self.directions[d].acts_n(h, &loads[d]));
        // drift velocities at the end of the step without friction
        let free = [0, 1].map(|d| {
            let speeds = self.directions[d].inverse.times(&acts[d]);
            let model = &self.directions[d].model;
            (0..speeds.len())
                .map(|i| model.across(i, &speeds))
                .collect::<Vec<f64>>()
        });
        let (ends, works) = self.sweep(&free, at_s)?;
        for d in [0, 1] {
            let direction = &mut self.directions[d];
            let over: Vec<f64> = (0..ends[d].len())
                .map(|i| direction.over_step_n(i, ends[d][i]))
                .collect();
            let rubs = direction.on_levels(&over);
            let left: Vec<f64> = acts[d]
                .iter()
                .zip(&rubs)
                .map(|(acts, rubs)| acts - rubs)
                .collect();
            let after = direction.inverse.times(&left);
            let mean: Vec<f64> = direction
                .state
                .v
                .iter()
                .zip(&after)
                .map(|(a, b)| 0.5 * (a + b))
                .collect();
            if let Some(c) = &direction.c {
                let taken = c.times(&mean);
                direction.damping_j += h * mean.iter().zip(taken).map(|(v, f)| v * f).sum::<f64>();
            }
            direction.input_j += h * loads[d].iter().zip(&mean).map(|(f, v)| f * v).sum::<f64>();
            for i in 0..over.len() {
                let stretch = direction
                    .series_n_m(i)
                    .map_or(0.0, |k| (ends[d][i] - direction.friction_n[i]) / k);
                direction.friction_j += over[i] * (h * direction.model.across(i, &mean) - stretch);
            }
            for (y, v) in direction.state.y.iter_mut().zip(&mean) {
                *y += h * v;
            }
            direction.state.v = after;
            direction.friction_n.clone_from(&ends[d]);
        }
        for (slips, work_j) in self.slips.iter_mut().zip(works) {
            *slips = work_j > 0.0;
        }
        Ok(())
    }

    /// Forces of all storeys at the end of the step, and the friction work in each storey.
    fn sweep(&self, free: &[Vec<f64>; 2], at_s: f64) -> Result<([Vec<f64>; 2], Vec<f64>), DynamicsError> {
        let n = self.slips.len();
        let mut ends = [0, 1].map(|d| self.directions[d].friction_n.clone());
        let mut works = vec![0.0; n];
        for _ in 0..SWEEPS_MOST {
            let mut change = 0.0_f64;
            for i in 0..n {
                let limits = [0, 1].map(|d| self.limit_n(d, i));
                if limits == [None, None] {
                    continue;
                }
                let found = self.storey(i, limits, (free, &ends));
                for d in [0, 1] {
                    if let Some(limit_n) = limits[d] {
                        let end_n = limit_n * found.share[d];
                        change = change.max((end_n - ends[d][i]).abs() / limit_n);
                        ends[d][i] = end_n;
                    }
                }
                works[i] = found.work_j;
            }
            if change <= SWEPT {
                return Ok((ends, works));
            }
        }
        Err(DynamicsError::NoState {
            at_s,
            tried: SWEEPS_MOST,
        })
    }

    /// Current slip force of a storey in a direction; `None` without friction.
    fn limit_n(&self, d: usize, storey: usize) -> Option<f64> {
        let [fixed_n, kinetic_n] = self.directions[d].model.friction[storey].limits_n()?;
        Some(if self.slips[storey] { kinetic_n } else { fixed_n })
    }

    /// Force of one storey for given forces of the other storeys.
    ///
    /// ```text
    /// Coulomb:  Δ = h (c − G q⁺)                          α = h G f²,              β = h c f
    /// Jenkins:  Δ = h (δ' + c − G (q + q⁺)/2)/2 − (q⁺ − q)/k   α = (h G/4 + 1/k) f²,  β = [h (δ' + c − G q/2)/2 + q/k] f
    /// f Δ = β − α s = λ s
    /// ```
    /// c is the drift velocity at the end of the step without the storey's own force, δ' that at the start, and G that from a unit
    /// force.
    fn storey(
        &self,
        i: usize,
        limits: [Option<f64>; 2],
        (free, ends): (&[Vec<f64>; 2], &[Vec<f64>; 2]),
    ) -> Slipped {
        let h = self.step_s;
        let (mut alpha, mut beta) = ([1.0; 2], [0.0; 2]);
        for d in [0, 1] {
            let Some(limit_n) = limits[d] else { continue };
            let direction = &self.directions[d];
            let mut c = free[d][i];
            for (j, end_n) in ends[d].iter().enumerate().filter(|(j, _)| *j != i) {
                c -= direction.gives[(i, j)] * direction.over_step_n(j, *end_n);
            }
            let g = direction.gives[(i, i)];
            match direction.series_n_m(i) {
                None => {
                    alpha[d] = h * g * limit_n * limit_n;
                    beta[d] = h * c * limit_n;
                }
                Some(k) => {
                    let (before_n, speed) = (
                        direction.friction_n[i],
                        direction.model.across(i, &direction.state.v),
                    );
                    alpha[d] = (0.25 * h * g + 1.0 / k) * limit_n * limit_n;
                    beta[d] = (0.5 * h * (speed + c - 0.5 * g * before_n) + before_n / k) * limit_n;
                }
            }
        }
        on_the_disc(alpha, beta)
    }
}

/// Solves β = (α + λ) s with |s| ≤ 1, where λ = 0 unless |s| = 1.
fn on_the_disc(alpha: [f64; 2], beta: [f64; 2]) -> Slipped {
    let share = |work_j: f64| [0, 1].map(|d| beta[d] / (alpha[d] + work_j));
    let mut work_j = 0.0;
    let held = share(0.0);
    if held[0].hypot(held[1]) <= 1.0 {
        return Slipped { share: held, work_j };
    }
    // |s|² − 1 decreases and is convex in λ: Newton's method from the left does not overshoot the root
    for _ in 0..100 {
        let s = share(work_j);
        let over = s[0] * s[0] + s[1] * s[1] - 1.0;
        let slope: f64 = [0, 1]
            .iter()
            .map(|&d| -2.0 * s[d] * s[d] / (alpha[d] + work_j))
            .sum();
        let next = work_j - over / slope;
        if next <= work_j * (1.0 + 1e-15) {
            break;
        }
        work_j = next;
    }
    let s = share(work_j);
    let size = s[0].hypot(s[1]);
    Slipped {
        share: s.map(|s| s / size),
        work_j,
    }
}
