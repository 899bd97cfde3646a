//! Taylor series of the motion of a frame while no slider changes its state: the exact solution to rounding.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | Y | `y` | displacements relative to the ground | m |
//! | σ | `sigma` | time within the step, divided by its length h: 0 … 1 | – |
//! | c_k | `y[k]` | coefficient of σᵏ of Y | m |
//! | λ_i | `held` | force of a stuck slider, positive against the storey's motion to the right | N |
//! | A | `pull` | −K of a group of levels that move together, divided by their mass | 1/s² |
//! | z | `offset_m` | position of the slider of a Jenkins element, on the axis of its drift | m |
//!
//! ```text
//! M Y'' + C Y' + K Y + Σ b_i q_i = −M 1 a_ground + F           b_i: upper level of slider i less the level below it
//! q_i = λ_i with b_i·Y' = 0 (Coulomb, stuck) | s f_k (slipping) | k_s (b_i·Y − z_i) (Jenkins, stuck)
//! (k+1)(k+2) c_{k+2} = −h² M⁻¹ (K c_k + (k+1) C c_{k+1}/h + M 1 a_k − F_k + Σ b_i q_i,k)
//! ```
//! Levels that stuck Coulomb sliders connect move as one mass; if they are connected to the ground they do not move. λ follows from the force
//! balance of each level, from the top down.

use super::excitation::FrameLoad;
use super::frame_friction::StoreyFriction;
use super::frame_model::{Model, Rows, Slider, State};
use super::frame_tenon::Joint;
use crate::numeric::{COEFFICIENTS_MOST, polynomial_most};
use std::ops::Range;

/// Terms below this fraction of the largest are negligible: a tenth of the rounding of the largest.
const TERM_LEAST: f64 = 1e-17;
/// Marks levels that are fixed to the ground.
const GROUND: usize = usize::MAX;
/// 1/((k + 1)(k + 2)), the factor from integrating σᵏ twice.
const TWICE: [f64; COEFFICIENTS_MOST] = {
    let mut twice = [0.0; COEFFICIENTS_MOST];
    let mut k = 0;
    while k < COEFFICIENTS_MOST {
        twice[k] = 1.0 / ((k + 1) * (k + 2)) as f64;
        k += 1;
    }
    twice
};

pub(super) type Coefficients = [f64; COEFFICIENTS_MOST];

/// The series of one step, with one row of coefficients per level or storey.
pub(super) struct Series {
    pub(super) n: usize,
    pub(super) h: f64,
    /// Number of powers of σ in `y`.
    pub(super) orders: usize,
    pub(super) y: Vec<Coefficients>,
    /// Series of the drifts, known after the expansion.
    pub(super) drift: Vec<Coefficients>,
    /// Bound of the displacement of a level, or of the drift of a storey, within the step, m: the sum of the magnitudes of its coefficients.
    pub(super) y_most: Vec<f64>,
    pub(super) drift_most: Vec<f64>,
    /// Forces of stuck Coulomb sliders, with `orders − 2` powers.
    pub(super) held: Vec<Coefficients>,
    /// Acceleration of the ground; `ground_orders` counts its nonzero coefficients.
    pub(super) ground: Coefficients,
    pub(super) ground_orders: usize,
    /// Forces at the levels, one row of coefficients per level; empty without forces.
    pub(super) forces: Vec<Coefficients>,
    pub(super) force_orders: usize,
    /// For each level, the lowest level of the group that moves together with it.
    root: Vec<usize>,
    group_mass: Vec<f64>,
    /// Whether a Coulomb slider sticks, so that levels move as one.
    joined: bool,
    /// Spring constants of stuck Jenkins sliders, N/m; 0 for other sliders.
    spring_n_m: Vec<f64>,
    /// Spring constants of tenons in contact, N/m; 0 for the others.
    tenon_n_m: Vec<f64>,
    /// Forces of sliders and tenons on the levels at zero drift, N.
    slider_n: Vec<f64>,
    /// Matrix rows of the lowest level of each group; the rows of other levels are empty.
    pull: Rows,
    drag: Option<Rows>,
    push: Vec<f64>,
    /// Work space for the sum of a row; zero between uses.
    sum: Vec<f64>,
}

impl Series {
    pub(super) fn new(n: usize) -> Self {
        let rows = vec![[0.0; COEFFICIENTS_MOST]; n];
        let zero = vec![0.0; n];
        Series {
            n,
            h: 1.0,
            orders: 0,
            y: rows.clone(),
            drift: rows.clone(),
            y_most: zero.clone(),
            drift_most: zero.clone(),
            held: rows,
            ground: [0.0; COEFFICIENTS_MOST],
            ground_orders: 0,
            forces: Vec::new(),
            force_orders: 0,
            root: vec![0; n],
            group_mass: zero.clone(),
            joined: false,
            spring_n_m: zero.clone(),
            tenon_n_m: zero.clone(),
            slider_n: zero.clone(),
            pull: Rows::default(),
            drag: None,
            push: zero.clone(),
            sum: zero,
        }
    }

    /// Sets the load series for a step of length h from `at_s`.
    pub(super) fn act(&mut self, load: &FrameLoad, at_s: f64, h: f64) {
        self.h = h;
        self.ground_orders = load.ground_acceleration_m_s2.series(at_s, h, &mut self.ground);
        self.forces.resize(load.forces_n.len(), [0.0; COEFFICIENTS_MOST]);
        self.force_orders = 0;
        for (f, row) in load.forces_n.iter().zip(&mut self.forces) {
            self.force_orders = self.force_orders.max(f.series(at_s, h, row));
        }
    }

    /// Finds the groups of levels that move together and their springs, for the current slider states. Call again after each change of state.
    pub(super) fn join(&mut self, model: &Model, state: &State) {
        self.group_mass.fill(0.0);
        self.slider_n.fill(0.0);
        self.spring_n_m.fill(0.0);
        self.joined = false;
        for i in 0..self.n {
            let force = match (model.friction[i], state.slider[i]) {
                (
                    StoreyFriction::Jenkins { kinetic_force_n, .. }
                    | StoreyFriction::Coulomb { kinetic_force_n, .. },
                    Slider::Slipping(sign),
                ) => sign * kinetic_force_n,
                (
                    StoreyFriction::Jenkins {
                        stuck_stiffness_n_m, ..
                    },
                    Slider::Stuck,
                ) => {
                    self.spring_n_m[i] = stuck_stiffness_n_m;
                    -stuck_stiffness_n_m * state.offset_m[i]
                }
                _ => 0.0,
            };
            self.slider_n[i] += force;
            if let Some(j) = model.below[i] {
                self.slider_n[j] -= force;
            }
            let [tenon_n_m, tenon_n] = state.joint[i].as_ref().map_or([0.0; 2], Joint::spring);
            self.tenon_n_m[i] = tenon_n_m;
            self.slider_n[i] += tenon_n;
            if let Some(j) = i.checked_sub(1) {
                self.slider_n[j] -= tenon_n;
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
        self.pull.clear();
        let mut drag = model.c.is_some().then(|| self.drag.take().unwrap_or_default());
        drag.iter_mut().for_each(Rows::clear);
        for i in 0..self.n {
            let members = self.members(i);
            let per_mass = -1.0 / self.group_mass[i].max(f64::MIN_POSITIVE);
            self.push[i] = per_mass * self.slider_n[members.clone()].iter().sum::<f64>();
            let mut columns = i..i;
            for member in members.clone() {
                columns = both(columns, model.k.sum_up(member, &mut self.sum));
                for (storey, sign) in [(member, 1.0), (member + 1, -1.0)] {
                    if storey < self.n && (storey == member || model.below[storey] == Some(member)) {
                        let spring = sign * self.spring_n_m[storey];
                        self.sum[storey] += spring;
                        let below = model.below[storey];
                        if let Some(j) = below {
                            self.sum[j] -= spring;
                        }
                        columns = both(columns, below.unwrap_or(storey)..storey + 1);
                    }
                    if storey < self.n && self.tenon_n_m[storey] != 0.0 {
                        let spring = sign * self.tenon_n_m[storey];
                        self.sum[storey] += spring;
                        let below = storey.checked_sub(1);
                        if let Some(j) = below {
                            self.sum[j] -= spring;
                        }
                        columns = both(columns, below.unwrap_or(storey)..storey + 1);
                    }
                }
            }
            self.pull.add(per_mass, &mut self.sum, columns);
            if let (Some(drag), Some(c)) = (&mut drag, &model.c) {
                let mut columns = i..i;
                for member in members {
                    columns = both(columns, c.sum_up(member, &mut self.sum));
                }
                drag.add(per_mass, &mut self.sum, columns);
            }
        }
        self.drag = drag;
    }

    /// The levels of the group whose lowest level is i; empty if i is not the lowest of a group.
    fn members(&self, i: usize) -> Range<usize> {
        let others = self.root[i..].iter().take_while(|root| **root == i).count();
        i..i + others
    }

    /// Gives the levels of each group a common velocity that keeps their momentum.
    pub(super) fn share_velocity(&mut self, model: &Model, state: &mut State) {
        for i in 0..self.n {
            if self.root[i] == GROUND {
                state.v[i] = 0.0;
            }
            let members = self.members(i);
            // a single level keeps its velocity exactly
            if members.len() > 1 {
                let momentum: f64 = members.clone().map(|m| model.mass_kg[m] * state.v[m]).sum();
                state.v[members].fill(momentum / self.group_mass[i]);
            }
        }
    }

    /// Computes the coefficients of the motion from a state, as long as no slider changes. Returns whether the series converged. Call
    /// [`Series::act`] and [`Series::join`] first.
    pub(super) fn expand(&mut self, model: &Model, state: &State) -> bool {
        self.begin(state);
        // without dashpots coefficient k + 2 depends only on coefficient k, so two coefficients are computed at a time
        let converged = if self.drag.is_some() {
            self.powers::<1>()
        } else {
            self.powers::<2>()
        };
        let orders = self.orders;
        if self.joined {
            self.hold(model, 0, orders - 2);
        }
        for i in 0..self.n {
            let (below, own) = self.y.split_at(i);
            let (own, drift) = (&own[0][..orders], &mut self.drift[i][..orders]);
            match below.last() {
                None => drift.copy_from_slice(own),
                Some(below) => {
                    for (drift, (own, below)) in drift.iter_mut().zip(own.iter().zip(below)) {
                        *drift = own - below;
                    }
                }
            }
            self.y_most[i] = polynomial_most(own);
            self.drift_most[i] = polynomial_most(drift);
        }
        converged
    }

    /// Computes all powers, L at a time, until two successive ones are negligible.
    fn powers<const L: usize>(&mut self) -> bool {
        let mut largest = self.y.iter().fold(0.0_f64, |most, y| most.max(y[1].abs()));
        let mut before = largest;
        let least = self.orders_least();
        for k in (0..COEFFICIENTS_MOST - 2).step_by(L) {
            let sizes = self.advance::<L>(k);
            let now = sizes.into_iter().fold(0.0, larger);
            largest = larger(largest, now);
            let last_two = if L == 1 { larger(before, now) } else { now };
            if k + L >= least && last_two <= TERM_LEAST * largest {
                self.orders = k + L + 2;
                return true;
            }
            before = now;
        }
        self.orders = COEFFICIENTS_MOST;
        false
    }

    /// Computes coefficients k + 2 to k + 1 + L of the motion from the earlier ones; returns their largest magnitudes.
    fn advance<const L: usize>(&mut self, k: usize) -> [f64; L] {
        let h_squared = self.h * self.h;
        let steps: [f64; L] = some(&TWICE, k).map(|twice| h_squared * twice);
        let ground: [f64; L] = some(&self.ground, k);
        let mut sizes = [0.0; L];
        for (i, pull) in self.pull.each().enumerate() {
            let mut new = [0.0; L];
            if self.root[i] == i {
                for (j, pull) in pull {
                    let y: [f64; L] = some(&self.y[*j], k);
                    for l in 0..L {
                        new[l] += pull * y[l];
                    }
                }
                if k == 0 {
                    new[0] += self.push[i];
                }
                if let Some(drag) = &self.drag {
                    let rate = (k + 1) as f64 / self.h;
                    let sum: f64 = drag.row(i).iter().map(|(j, drag)| drag * self.y[*j][k + 1]).sum();
                    new[0] += rate * sum;
                }
                if !self.forces.is_empty() {
                    for member in self.members(i) {
                        let force: [f64; L] = some(&self.forces[member], k);
                        for l in 0..L {
                            new[l] += force[l] / self.group_mass[i];
                        }
                    }
                }
                for l in 0..L {
                    new[l] = (new[l] - ground[l]) * steps[l];
                }
            } else if let Some(root) = self.y.get(self.root[i]) {
                new = some(root, k + 2);
            }
            for l in 0..L {
                sizes[l] = larger(sizes[l], new[l].abs());
            }
            self.y[i][k + 2..k + 2 + L].copy_from_slice(&new);
        }
        sizes
    }

    /// Coefficients `from` to `to` of the forces of stuck Coulomb sliders, from the top down. The balance of each level gives them: m a + rest +
    /// λ_i − (λ of the stuck slider above) = 0.
    fn hold(&mut self, model: &Model, from: usize, to: usize) {
        for i in (0..self.n).rev() {
            let (lower, upper) = self.held.split_at_mut(i + 1);
            let held = &mut lower[i][from..to];
            held.fill(0.0);
            if self.root[i] == i {
                continue;
            }
            let mut add = |factor: f64, row: &[f64]| {
                for (held, x) in held.iter_mut().zip(row) {
                    *held += factor * x;
                }
            };
            if let Some(above) = upper.first().filter(|_| model.below[i + 1] == Some(i)) {
                add(1.0, &above[from..]);
            }
            for (j, k) in model.k.row(i) {
                add(-k, &self.y[*j][from..]);
            }
            for (storey, sign) in [(i, -1.0), (i + 1, 1.0)] {
                if storey < self.n && (storey == i || model.below[storey] == Some(i)) {
                    let spring = sign * self.spring_n_m[storey];
                    if spring != 0.0 {
                        add(spring, &self.y[storey][from..]);
                        if let Some(j) = model.below[storey] {
                            add(-spring, &self.y[j][from..]);
                        }
                    }
                }
                if storey < self.n && self.tenon_n_m[storey] != 0.0 {
                    let spring = sign * self.tenon_n_m[storey];
                    add(spring, &self.y[storey][from..]);
                    if let Some(j) = storey.checked_sub(1) {
                        add(-spring, &self.y[j][from..]);
                    }
                }
            }
            add(-model.mass_kg[i], &self.ground[from..]);
            if let Some(force) = self.forces.get(i) {
                add(1.0, &force[from..]);
            }
            let inertia = model.mass_kg[i] / (self.h * self.h);
            let second = self.y[i][from + 2..].iter().zip(&TWICE[from..]);
            for (held, (y, twice)) in held.iter_mut().zip(second) {
                *held -= inertia * (y / twice);
            }
            if let Some(c) = &model.c {
                for (j, c) in c.row(i) {
                    let mut power = from as f64;
                    for (held, y) in held.iter_mut().zip(&self.y[*j][from + 1..]) {
                        power += 1.0;
                        *held -= c / self.h * (power * y);
                    }
                }
            }
            if let Some(held) = held.first_mut().filter(|_| from == 0) {
                *held -= self.slider_n[i];
            }
        }
    }

    /// Coefficients of the relative motion across a slider.
    pub(super) fn slider_row(&self, model: &Model, i: usize) -> &[f64] {
        // relative motion is the drift, or the displacement relative to the ground
        let row = match model.below[i] {
            Some(_) => &self.drift[i],
            None => &self.y[i],
        };
        &row[..self.orders]
    }

    /// Sets displacements and velocities to those at σ.
    pub(super) fn place(&self, sigma: f64, now: &mut State) {
        for (row, (y, v)) in self.y.iter().zip(now.y.iter_mut().zip(&mut now.v)) {
            let [at, rate] = at_with_rate(&row[..self.orders], sigma);
            (*y, *v) = (at, rate / self.h);
        }
    }

    /// Sets coefficients 0 and 1 of the motion from a state.
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

    /// Largest force of order k in the balance of any level, N: the scale for rounding errors.
    pub(super) fn force_scale(&self, model: &Model, state: &State, k: usize) -> f64 {
        let rate = (k + 1) as f64 / self.h;
        let sizes = |row: &[(usize, f64)], k: usize| -> f64 {
            row.iter().map(|(j, a)| (a * self.y[*j][k]).abs()).sum()
        };
        let of_level = |i: usize| {
            let springs = sizes(model.k.row(i), k);
            let dashpots = model.c.as_ref().map_or(0.0, |c| rate * sizes(c.row(i), k + 1));
            let force = self.forces.get(i).map_or(0.0, |force| force[k].abs());
            let slider = match (model.friction[i], state.slider[i]) {
                (
                    StoreyFriction::Coulomb { kinetic_force_n, .. }
                    | StoreyFriction::Jenkins { kinetic_force_n, .. },
                    Slider::Slipping(_),
                ) if k == 0 => kinetic_force_n,
                _ => self.held[i][k].abs(),
            };
            let tenon = match state.joint[i].as_ref().map(Joint::spring) {
                None => 0.0,
                Some([spring_n_m, at_zero_n]) => {
                    let constant_n = if k == 0 { at_zero_n.abs() } else { 0.0 };
                    spring_n_m * drift_m_most(&self.y, i, k) + constant_n
                }
            };
            springs + tenon + dashpots + model.mass_kg[i] * self.ground[k].abs() + force + slider
        };
        (0..self.n).map(of_level).fold(0.0, f64::max)
    }

    /// Number of powers that the load needs: a sine needs powers until its terms are negligible.
    fn orders_least(&self) -> usize {
        if self.ground_orders <= 2 && self.force_orders <= 2 {
            return 2;
        }
        let tail = |row: &[f64; COEFFICIENTS_MOST], orders: usize| {
            let largest = row.iter().fold(0.0, |most, x| larger(most, x.abs()));
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

    /// Computes coefficient k + 2 of the motion and coefficient k of the forces of stuck sliders from the earlier ones. Call [`Series::join`]
    /// first.
    pub(super) fn next(&mut self, model: &Model, k: usize) {
        self.advance::<1>(k);
        self.hold(model, k, k + 1);
    }
}

/// Bound of coefficient k of a drift: the sum of the magnitudes for its two levels.
fn drift_m_most(y: &[Coefficients], i: usize, k: usize) -> f64 {
    y[i][k].abs() + i.checked_sub(1).map_or(0.0, |below| y[below][k].abs())
}

/// The smallest range that includes both ranges; an empty range is ignored.
fn both(a: Range<usize>, b: Range<usize>) -> Range<usize> {
    match (a.is_empty(), b.is_empty()) {
        (true, _) => b,
        (_, true) => a,
        _ => a.start.min(b.start)..a.end.max(b.end),
    }
}

/// L coefficients, beginning with the k-th.
fn some<const L: usize>(c: &Coefficients, k: usize) -> [f64; L] {
    let mut some = [0.0; L];
    some.copy_from_slice(&c[k..k + L]);
    some
}

/// The larger of two numbers, compiled to one instruction; NaN is ignored.
fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// A polynomial and its derivative, by Horner's rule.
pub(super) fn at_with_rate(c: &[f64], sigma: f64) -> [f64; 2] {
    let [mut value, mut rate] = [0.0; 2];
    for c in c.iter().rev() {
        rate = rate * sigma + value;
        value = value * sigma + c;
    }
    [value, rate]
}

/// A polynomial, its derivative and half its second derivative, at several values of σ.
pub(super) fn at_with_rates<const L: usize>(c: &[f64], sigma: [f64; L]) -> [[f64; L]; 3] {
    let [mut value, mut rate, mut half] = [[0.0; L]; 3];
    for c in c.iter().rev() {
        for l in 0..L {
            half[l] = half[l] * sigma[l] + rate[l];
            rate[l] = rate[l] * sigma[l] + value[l];
            value[l] = value[l] * sigma[l] + c;
        }
    }
    [value, rate, half]
}
