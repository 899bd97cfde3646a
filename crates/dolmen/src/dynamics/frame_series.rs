//! The Taylor series of a frame's motion while no slider changes: the exact solution, to the last digits.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | Y | `y` | displacements relative to the ground | m |
//! | σ | `sigma` | time in the step over its length h, 0 … 1 | – |
//! | c_k | `y[k]` | coefficient of σᵏ of Y | m |
//! | λ_i | `held` | force of a stuck slider, positive against the storey's motion to the right | N |
//! | z | `offset_m` | place of the slider of a Jenkins element, on the axis of its drift | m |
//!
//! ```text
//! M Y'' + C Y' + K Y + Σ b_i q_i = −M 1 a_ground + F           b_i: upper level of slider i less the level below it
//! q_i = λ_i with b_i·Y' = 0 (Coulomb, stuck) | s f_k (slipping) | k_s (b_i·Y − z_i) (Jenkins, stuck)
//! (k+1)(k+2) c_{k+2} = −h² M⁻¹ (K c_k + (k+1) C c_{k+1}/h + M 1 a_k − F_k + Σ b_i q_i,k)
//! ```
//! Levels that stuck Coulomb sliders join move as one mass, or not at all if they are joined to the ground; λ follows from the
//! balance of each level, from the top down.

use super::DynamicsError;
use super::excitation::FrameLoad;
use super::frame_friction::{FrictionFrame, StoreyFriction};
use crate::numeric::COEFFICIENTS_MOST;
use dolmen_linalg::Matrix;

/// Terms below this part of the largest count as none: a tenth of the rounding of the largest.
const TERM_LEAST: f64 = 1e-17;
/// Levels that stand with the ground.
const GROUND: usize = usize::MAX;

/// What a slider does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Slider {
    /// There is none.
    Absent,
    /// It sticks.
    Stuck,
    /// It slips towards +1 or −1.
    Slipping(f64),
}

/// Coefficients of one function.
pub(super) type Coefficients = [f64; COEFFICIENTS_MOST];

/// Rows of a matrix, without its zeros: the entries of all rows behind each other.
struct Rows {
    ends: Vec<usize>,
    entries: Vec<(usize, f64)>,
}

impl Rows {
    fn of(matrix: &Matrix) -> Self {
        let mut rows = Rows {
            ends: Vec::with_capacity(matrix.rows()),
            entries: Vec::new(),
        };
        for i in 0..matrix.rows() {
            let row = (0..matrix.columns()).map(|j| (j, matrix[(i, j)]));
            rows.entries.extend(row.filter(|(_, x)| *x != 0.0));
            rows.ends.push(rows.entries.len());
        }
        rows
    }

    fn row(&self, i: usize) -> &[(usize, f64)] {
        let begin = if i == 0 { 0 } else { self.ends[i - 1] };
        &self.entries[begin..self.ends[i]]
    }

    fn times(&self, i: usize, x: &[f64]) -> f64 {
        self.row(i).iter().map(|(j, a)| a * x[*j]).sum()
    }

    /// The same with coefficient k of each level.
    fn times_of(&self, i: usize, levels: &[Coefficients], k: usize) -> f64 {
        self.row(i).iter().map(|(j, a)| a * levels[*j][k]).sum()
    }

    fn times_sizes(&self, i: usize, levels: &[Coefficients], k: usize) -> f64 {
        self.row(i).iter().map(|(j, a)| (a * levels[*j][k]).abs()).sum()
    }

    fn size(&self, i: usize) -> f64 {
        self.row(i).iter().map(|(_, a)| a.abs()).sum()
    }
}

/// A frame as the series need it.
pub(super) struct Model {
    pub(super) mass_kg: Vec<f64>,
    pub(super) friction: Vec<StoreyFriction>,
    /// Level below each slider; `None` for the ground.
    pub(super) below: Vec<Option<usize>>,
    k: Rows,
    c: Option<Rows>,
}

/// Where a frame is and what its sliders do.
#[derive(Clone, Debug)]
pub(super) struct State {
    pub(super) y: Vec<f64>,
    pub(super) v: Vec<f64>,
    pub(super) slider: Vec<Slider>,
    pub(super) offset_m: Vec<f64>,
}

/// A Jenkins slider that sticks: storey, level below it, stiffness and offset.
struct Spring {
    upper: usize,
    lower: Option<usize>,
    stiffness_n_m: f64,
    offset_m: f64,
}

/// The series of one step: one row of coefficients a level or storey.
pub(super) struct Series {
    pub(super) n: usize,
    pub(super) h: f64,
    /// Powers of σ in `y`.
    pub(super) orders: usize,
    pub(super) y: Vec<Coefficients>,
    /// Of the drifts, once the series are expanded.
    pub(super) drift: Vec<Coefficients>,
    /// Forces of stuck Coulomb sliders; `orders − 2` powers.
    pub(super) held: Vec<Coefficients>,
    /// Acceleration of the ground, and how many of its coefficients are not zero.
    pub(super) ground: Coefficients,
    pub(super) ground_orders: usize,
    /// Forces at the levels, one row of coefficients a level; empty for none.
    pub(super) forces: Vec<Coefficients>,
    pub(super) force_orders: usize,
    root: Vec<usize>,
    group_mass: Vec<f64>,
    /// A Coulomb slider sticks: levels move as one.
    joined: bool,
    /// Forces of slipping sliders on the levels, N.
    slipping_n: Vec<f64>,
    springs: Vec<Spring>,
    rest: Vec<f64>,
    group: Vec<f64>,
    carry: Vec<f64>,
}

impl Model {
    pub(super) fn of(frame: &FrictionFrame) -> Result<Self, DynamicsError> {
        let n = frame.frame.storeys().len();
        let k = frame.frame.stiffness_matrix(&frame.stiffness_n_m)?;
        Ok(Model {
            mass_kg: frame.frame.storeys().iter().map(|s| s.mass_kg).collect(),
            friction: frame.friction.iter().map(|friction| friction.acting()).collect(),
            below: (0..n).map(|i| frame.below(i)).collect(),
            k: Rows::of(&k),
            c: frame.damping_matrix()?.as_ref().map(Rows::of),
        })
    }

    pub(super) fn levels(&self) -> usize {
        self.mass_kg.len()
    }

    pub(super) fn damped(&self) -> bool {
        self.c.is_some()
    }

    /// Upper level less the one below the slider.
    pub(super) fn across(&self, i: usize, x: &[f64]) -> f64 {
        x[i] - self.below[i].map_or(0.0, |j| x[j])
    }

    /// Longest step on which the series converges as fast as that of a sine over one radian, s.
    pub(super) fn step_most_s(&self) -> f64 {
        let n = self.levels();
        let mut stiffness: Vec<f64> = (0..n).map(|i| self.k.size(i)).collect();
        for (i, friction) in self.friction.iter().enumerate() {
            if let StoreyFriction::Jenkins {
                stuck_stiffness_n_m, ..
            } = *friction
            {
                stiffness[i] += 2.0 * stuck_stiffness_n_m;
                if let Some(j) = self.below[i] {
                    stiffness[j] += 2.0 * stuck_stiffness_n_m;
                }
            }
        }
        let mut step = f64::INFINITY;
        for (i, &mass) in self.mass_kg.iter().enumerate() {
            if stiffness[i] > 0.0 {
                step = step.min((mass / stiffness[i]).sqrt());
            }
            if let Some(size) = self.c.as_ref().map(|c| c.size(i)).filter(|size| *size > 0.0) {
                step = step.min(mass / size);
            }
        }
        step
    }

    /// Power taken by the dashpots, W.
    pub(super) fn damping_power(&self, v: &[f64]) -> f64 {
        let Some(c) = &self.c else { return 0.0 };
        (0..v.len()).map(|i| v[i] * c.times(i, v)).sum()
    }

    /// Energy of motion relative to the ground, J.
    pub(super) fn kinetic_j(&self, state: &State) -> f64 {
        let terms = self.mass_kg.iter().zip(&state.v);
        0.5 * terms.map(|(m, v)| m * v * v).sum::<f64>()
    }

    /// Energy in springs less what P-delta gave, J.
    pub(super) fn stored_j(&self, state: &State) -> f64 {
        let springs: f64 = (0..self.levels())
            .map(|i| state.y[i] * self.k.times(i, &state.y))
            .sum();
        let series: f64 = (0..self.levels())
            .map(|i| match self.friction[i] {
                StoreyFriction::Jenkins {
                    stuck_stiffness_n_m, ..
                } => {
                    let force = self.jenkins_force(i, state);
                    force * force / stuck_stiffness_n_m
                }
                _ => 0.0,
            })
            .sum();
        0.5 * (springs + series)
    }

    /// Force in the Jenkins element of a storey, N.
    pub(super) fn jenkins_force(&self, i: usize, state: &State) -> f64 {
        match (self.friction[i], state.slider[i]) {
            (
                StoreyFriction::Jenkins {
                    stuck_stiffness_n_m, ..
                },
                Slider::Stuck,
            ) => stuck_stiffness_n_m * (self.across(i, &state.y) - state.offset_m[i]),
            (StoreyFriction::Jenkins { kinetic_force_n, .. }, Slider::Slipping(sign)) => {
                sign * kinetic_force_n
            }
            _ => 0.0,
        }
    }
}

impl Series {
    pub(super) fn new(n: usize) -> Self {
        let rows = vec![[0.0; COEFFICIENTS_MOST]; n];
        Series {
            n,
            h: 1.0,
            orders: 0,
            y: rows.clone(),
            drift: rows.clone(),
            held: rows,
            ground: [0.0; COEFFICIENTS_MOST],
            ground_orders: 0,
            forces: Vec::new(),
            force_orders: 0,
            root: vec![0; n],
            group_mass: vec![0.0; n],
            joined: false,
            slipping_n: vec![0.0; n],
            springs: Vec::with_capacity(n),
            rest: vec![0.0; n],
            group: vec![0.0; n],
            carry: vec![0.0; n],
        }
    }

    /// Series of what acts, over a step of h from `at_s`.
    pub(super) fn act(&mut self, load: &FrameLoad, at_s: f64, h: f64) {
        self.h = h;
        self.ground_orders = load.ground_acceleration_m_s2.series(at_s, h, &mut self.ground);
        self.forces.resize(load.forces_n.len(), [0.0; COEFFICIENTS_MOST]);
        self.force_orders = 0;
        for (f, row) in load.forces_n.iter().zip(&mut self.forces) {
            self.force_orders = self.force_orders.max(f.series(at_s, h, row));
        }
    }

    /// Finds the masses that move as one, and what the other sliders do.
    pub(super) fn join(&mut self, model: &Model, state: &State) {
        self.group_mass.fill(0.0);
        self.slipping_n.fill(0.0);
        self.springs.clear();
        self.joined = false;
        for i in 0..self.n {
            match (model.friction[i], state.slider[i]) {
                (
                    StoreyFriction::Jenkins { kinetic_force_n, .. }
                    | StoreyFriction::Coulomb { kinetic_force_n, .. },
                    Slider::Slipping(sign),
                ) => {
                    self.slipping_n[i] += sign * kinetic_force_n;
                    if let Some(j) = model.below[i] {
                        self.slipping_n[j] -= sign * kinetic_force_n;
                    }
                }
                (
                    StoreyFriction::Jenkins {
                        stuck_stiffness_n_m, ..
                    },
                    Slider::Stuck,
                ) => self.springs.push(Spring {
                    upper: i,
                    lower: model.below[i],
                    stiffness_n_m: stuck_stiffness_n_m,
                    offset_m: state.offset_m[i],
                }),
                _ => {}
            }
            let joined = state.slider[i] == Slider::Stuck
                && matches!(model.friction[i], StoreyFriction::Coulomb { .. });
            self.joined |= joined;
            self.root[i] = match (joined, model.below[i]) {
                (true, None) => GROUND,
                (true, Some(j)) => self.root[j],
                (false, _) => i,
            };
            if self.root[i] != GROUND {
                self.group_mass[self.root[i]] += model.mass_kg[i];
            }
        }
    }

    /// Gives the levels that move as one exactly one velocity: that of their momentum.
    pub(super) fn share_velocity(&mut self, model: &Model, state: &mut State) {
        self.group.fill(0.0);
        for i in 0..self.n {
            if self.root[i] != GROUND {
                self.group[self.root[i]] += model.mass_kg[i] * state.v[i];
            }
        }
        for i in 0..self.n {
            state.v[i] = match self.root[i] {
                GROUND => 0.0,
                // alone: as it is, to the last digit
                root if self.group_mass[root] == model.mass_kg[i] => state.v[i],
                root => self.group[root] / self.group_mass[root],
            };
        }
    }

    /// Coefficients of the motion from a state, as long as no slider changes. Returns whether the series converged.
    /// [`Series::act`] and [`Series::join`] come first.
    pub(super) fn expand(&mut self, model: &Model, state: &State) -> bool {
        self.begin(state);
        let size = |y: &[Coefficients], k: usize| y.iter().fold(0.0_f64, |most, row| most.max(row[k].abs()));
        let mut largest = size(&self.y, 1);
        let mut before = largest;
        let least = self.orders_least();
        let mut converged = false;
        self.orders = COEFFICIENTS_MOST;
        for k in 0..COEFFICIENTS_MOST - 2 {
            self.next(model, k);
            let size = size(&self.y, k + 2);
            largest = largest.max(size);
            if k + 1 >= least && size.max(before) <= TERM_LEAST * largest {
                self.orders = k + 3;
                converged = true;
                break;
            }
            before = size;
        }
        let orders = self.orders;
        for i in 0..self.n {
            let (below, own) = self.y.split_at(i);
            let drift = &mut self.drift[i][..orders];
            match below.last() {
                None => drift.copy_from_slice(&own[0][..orders]),
                Some(below) => {
                    for (drift, (own, below)) in drift.iter_mut().zip(own[0][..orders].iter().zip(below)) {
                        *drift = own - below;
                    }
                }
            }
        }
        converged
    }

    /// Coefficients of the motion across a slider.
    pub(super) fn slider_row(&self, model: &Model, i: usize) -> &[f64] {
        // on the drift, or on the displacement relative to the ground
        let row = match model.below[i] {
            Some(_) => &self.drift[i],
            None => &self.y[i],
        };
        &row[..self.orders]
    }

    /// Displacements and velocities at σ.
    pub(super) fn place(&self, sigma: f64, now: &mut State) {
        for (row, (y, v)) in self.y.iter().zip(now.y.iter_mut().zip(&mut now.v)) {
            let [at, rate, _] = at_with_rates(&row[..self.orders], sigma);
            (*y, *v) = (at, rate / self.h);
        }
    }

    /// Coefficients 0 and 1 of the motion.
    pub(super) fn begin(&mut self, state: &State) {
        for (row, (y, v)) in self.y.iter_mut().zip(state.y.iter().zip(&state.v)) {
            (row[0], row[1]) = (*y, v * self.h);
        }
    }

    /// Mass times coefficient k of the acceleration across a slider, N.
    pub(super) fn inertia(&self, model: &Model, i: usize, k: usize) -> f64 {
        let factor = ((k + 1) * (k + 2)) as f64 / (self.h * self.h);
        let below = model.below[i].map_or(0.0, |j| self.y[j][k + 2]);
        model.mass_kg[i] * factor * (self.y[i][k + 2] - below)
    }

    /// Largest force of order k that enters the balance of any level, N: what rounding is measured by.
    pub(super) fn force_scale(&self, model: &Model, state: &State, k: usize) -> f64 {
        let rate = (k + 1) as f64 / self.h;
        let of_level = |i: usize| {
            let springs = model.k.times_sizes(i, &self.y, k);
            let dashpots = model
                .c
                .as_ref()
                .map_or(0.0, |c| rate * c.times_sizes(i, &self.y, k + 1));
            let force = self.forces.get(i).map_or(0.0, |force| force[k].abs());
            let slider = match (model.friction[i], state.slider[i]) {
                (
                    StoreyFriction::Coulomb { kinetic_force_n, .. }
                    | StoreyFriction::Jenkins { kinetic_force_n, .. },
                    Slider::Slipping(_),
                ) if k == 0 => kinetic_force_n,
                _ => self.held[i][k].abs(),
            };
            springs + dashpots + model.mass_kg[i] * self.ground[k].abs() + force + slider
        };
        (0..self.n).map(of_level).fold(0.0, f64::max)
    }

    /// Powers that what acts needs: a sine goes on until its terms are too small to count.
    fn orders_least(&self) -> usize {
        let tail = |row: &[f64; COEFFICIENTS_MOST], orders: usize| {
            let largest = largest_of(row);
            (0..orders)
                .rev()
                .find(|&k| row[k].abs() > TERM_LEAST * largest)
                .map_or(0, |k| k + 1)
        };
        let forces = self.forces.iter().map(|row| tail(row, self.force_orders));
        forces
            .fold(tail(&self.ground, self.ground_orders), usize::max)
            .max(2)
    }

    /// Coefficient k + 2 of the motion and k of the forces of stuck sliders, from those before. [`Series::join`] comes first.
    pub(super) fn next(&mut self, model: &Model, k: usize) {
        let factor = self.h * self.h / ((k + 1) * (k + 2)) as f64;
        let ground = self.ground[k];
        let mut begin = 0;
        for ((rest, mass), &end) in self.rest.iter_mut().zip(&model.mass_kg).zip(&model.k.ends) {
            let mut sum = mass * ground;
            for (j, a) in &model.k.entries[begin..end] {
                sum += a * self.y[*j][k];
            }
            (*rest, begin) = (sum, end);
        }
        if let Some(c) = &model.c {
            let rate = (k + 1) as f64 / self.h;
            for (i, rest) in self.rest.iter_mut().enumerate() {
                *rest += rate * c.times_of(i, &self.y, k + 1);
            }
        }
        for (rest, force) in self.rest.iter_mut().zip(&self.forces) {
            *rest -= force[k];
        }
        if k == 0 {
            for (rest, force) in self.rest.iter_mut().zip(&self.slipping_n) {
                *rest += force;
            }
        }
        for spring in &self.springs {
            let mut across = self.y[spring.upper][k] - spring.lower.map_or(0.0, |j| self.y[j][k]);
            if k == 0 {
                across -= spring.offset_m;
            }
            let force = spring.stiffness_n_m * across;
            self.rest[spring.upper] += force;
            if let Some(j) = spring.lower {
                self.rest[j] -= force;
            }
        }
        if !self.joined {
            let rows = self.y.iter_mut().zip(&mut self.held);
            for ((y, held), (rest, mass)) in rows.zip(self.rest.iter().zip(&model.mass_kg)) {
                y[k + 2] = -rest / mass * factor;
                held[k] = 0.0;
            }
            return;
        }
        self.group.fill(0.0);
        for (rest, &root) in self.rest.iter().zip(&self.root) {
            if root != GROUND {
                self.group[root] += rest;
            }
        }
        self.carry.fill(0.0);
        for i in (0..self.n).rev() {
            let root = self.root[i];
            let acceleration = if root == GROUND {
                0.0
            } else {
                -self.group[root] / self.group_mass[root]
            };
            self.y[i][k + 2] = acceleration * factor;
            // balance of the level: m a + rest + λ_i − Σ λ of the stuck sliders that stand on it = 0
            let held = if root == i {
                0.0
            } else {
                self.carry[i] - (model.mass_kg[i] * acceleration + self.rest[i])
            };
            self.held[i][k] = held;
            if let Some(j) = model.below[i] {
                self.carry[j] += held;
            }
        }
    }
}

/// A polynomial, its derivative and half its second one, by Horner's rule.
pub(super) fn at_with_rates(c: &[f64], sigma: f64) -> [f64; 3] {
    let [mut value, mut rate, mut half] = [0.0; 3];
    for c in c.iter().rev() {
        half = half * sigma + rate;
        rate = rate * sigma + value;
        value = value * sigma + c;
    }
    [value, rate, half]
}

fn largest_of(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, x| most.max(x.abs()))
}
