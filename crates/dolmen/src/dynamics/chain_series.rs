//! The motion of a chain over one step, as Taylor series.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | σ | | time within the step over its length | – |
//! | s, c | `sin`, `cos` | sin θ and cos θ of each link; θ and 1 for small rotations | – |
//! | P, R | `p`, `r` | Σ_{j≠i} M_ij s_j'' and Σ_{j≠i} M_ij c_j'' | kg m² |
//! | G, Γ | `gravity`, `gamma` | gravity moment and base influence | N m, kg m |
//! | a | `ground` | acceleration of the ground | m/s² |
//! | u, F | `beside`, `pushed` | displacement at each side support, and its force | m, N |
//! | q_i | `held` | friction moment of a stuck joint, positive against a rotation to the right | N m |
//!
//! Links that stuck joints connect rotate as one, or stand still if they are connected to the ground. Their equations are summed, and q follows
//! from the equilibrium of each link, from the top down.

use super::chain_model::ChainModel;
use super::chain_props::PropState;
use super::chain_rotations::ChainRotations;
use super::frame_model::Slider;
use super::{DynamicsError, TimeFunction};
use crate::numeric::polynomial;
use dolmen_linalg::Matrix;

/// Degree of the series. Jorba and Zou (2005): −½ ln ε + 1 = 19 for double precision; a few more terms allow longer steps.
pub(super) const DEGREE: usize = 24;
/// Largest size of the last two terms, as a fraction of the sum of the first ones: below half a unit in the last place.
const TAIL: f64 = 1e-17;
/// Length of a step, s, at or below which an overflow ends the run with an error.
const SHORTEST_S: f64 = 1e-12;
/// Number of first terms with which the last two are compared.
const FIRST_TERMS: usize = 4;

/// Coefficients of one function.
pub(super) type Series = [f64; DEGREE + 1];
/// Coefficients of the integral of a product of two functions.
pub(super) type Work = [f64; 2 * DEGREE + 2];

/// State of a joint's spring during a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum JointState {
    /// Moment k φ.
    Closed,
    /// Moment at its limit, with this sign.
    Open(f64),
}

/// Rotations, rates, and the states of the joints.
#[derive(Clone, Debug)]
pub(super) struct ChainState {
    pub(super) theta: Vec<f64>,
    pub(super) omega: Vec<f64>,
    pub(super) joints: Vec<JointState>,
    pub(super) sliders: Vec<Slider>,
    pub(super) props: Vec<PropState>,
}

/// The constants of the equations and the series of one step.
pub(super) struct ChainSeries<'a> {
    pub(super) model: &'a ChainModel,
    pub(super) mass: Matrix,
    pub(super) gravity: Vec<f64>,
    gamma: Vec<f64>,
    pub(super) theta: Vec<Series>,
    pub(super) across: Vec<Series>,
    pub(super) sin: Vec<Series>,
    cos: Vec<Series>,
    ground_cos: Vec<Series>,
    p: Vec<Series>,
    r: Vec<Series>,
    pub(super) held: Vec<Series>,
    /// u and F of each side support.
    pub(super) beside: Vec<Series>,
    pushed: Vec<Series>,
    /// M_ij cos(θ_i − θ_j), lower triangle.
    turned: Vec<f64>,
    /// The group of each link that rotates as one; `None` for links that stand still.
    group: Vec<Option<usize>>,
    /// The matrix of the groups, factorized.
    factor: Vec<f64>,
    right: Vec<f64>,
    sum: Vec<f64>,
}

impl<'a> ChainSeries<'a> {
    pub(super) fn new(model: &'a ChainModel) -> Self {
        let n = model.chain.links().len();
        let zero = vec![[0.0; DEGREE + 1]; n];
        ChainSeries {
            model,
            mass: model.chain.mass_matrix(),
            gravity: model.chain.gravity_moments_n_m_rad(),
            gamma: model.chain.base_influence_kg_m(),
            theta: zero.clone(),
            across: zero.clone(),
            sin: zero.clone(),
            cos: zero.clone(),
            ground_cos: zero.clone(),
            p: zero.clone(),
            r: zero.clone(),
            held: zero,
            beside: vec![[0.0; DEGREE + 1]; model.props.len()],
            pushed: vec![[0.0; DEGREE + 1]; model.props.len()],
            turned: vec![0.0; n * n],
            group: vec![None; n],
            factor: Vec::with_capacity(n * n),
            right: vec![0.0; n],
            sum: Vec::with_capacity(n),
        }
    }

    /// Length of the first trial step, s: one radian of the stiffest single link.
    pub(super) fn first_step_s(&self) -> f64 {
        let joints = self.model.joints();
        let mut step = f64::INFINITY;
        for (i, joint) in joints.iter().enumerate() {
            let above = joints.get(i + 1).map_or(0.0, |j| j.stiffness_n_m_rad);
            let props = self.model.props.iter();
            let beside: f64 = props
                .map(|prop| prop.stiffness_n_m * prop.lever_m[i].powi(2))
                .sum();
            let stiffness = joint.stiffness_n_m_rad + above + self.gravity[i] + beside;
            step = step.min((self.mass[(i, i)] / stiffness).sqrt());
        }
        step
    }

    /// Finds the groups of links that rotate as one; returns their number.
    fn join(&mut self, sliders: &[Slider]) -> usize {
        let mut groups = 0;
        for (i, slider) in sliders.iter().enumerate() {
            self.group[i] = match (slider, i.checked_sub(1)) {
                (Slider::Stuck, None) => None,
                (Slider::Stuck, Some(below)) => self.group[below],
                _ => {
                    groups += 1;
                    Some(groups - 1)
                }
            };
        }
        groups
    }

    /// Expands the motion from `state` at `at_s`. Returns the length of the step, s, at most `h`, on which the series are exact to rounding. The
    /// series are in fractions of that length.
    ///
    /// ```text
    /// M_ii θ_i'' + Σ_{j≠i} M_ij (c_i s_j'' − s_i c_j'') = h² (G_i s_i − τ_i + τ_{i+1} − Γ_i a c_i − Σ c_i F cos θ_i) − h (δ_i − δ_{i+1})
    /// (c_i s_j'' − s_i c_j'' = cos(θ_i − θ_j) θ_j'' + sin(θ_i − θ_j) θ_j'²)         s' = c θ',  c' = −s θ',  δ = d φ'
    /// ```
    /// Power k of it has one unknown for each link, θ of power k + 2, with the matrix M_ij cos(θ_i − θ_j) of the start for every k.
    pub(super) fn expand(
        &mut self,
        state: &ChainState,
        load: &TimeFunction,
        at_s: f64,
        h: f64,
    ) -> Result<f64, DynamicsError> {
        self.coefficients(state, load, at_s, h);
        let shortest_s = at_s.abs().max(h) * f64::EPSILON;
        let Some(part) = self.part_exact() else {
            // overflow: the trial step is far too long
            if h <= SHORTEST_S {
                return Err(DynamicsError::StepTooShort { at_s, step_s: h });
            }
            return self.expand(state, load, at_s, 0.01 * h);
        };
        if part * h <= shortest_s {
            return Err(DynamicsError::StepTooShort {
                at_s,
                step_s: part * h,
            });
        }
        self.shorten(part);
        Ok(part * h)
    }

    /// The series over a step of h, whether they converge on it or not.
    pub(super) fn coefficients(&mut self, state: &ChainState, load: &TimeFunction, at_s: f64, h: f64) {
        let n = state.theta.len();
        let large = self.model.rotations == ChainRotations::Large;
        let groups = self.join(&state.sliders);
        let any_stuck = state.sliders.contains(&Slider::Stuck);
        if !any_stuck {
            self.held.iter_mut().for_each(|series| series.fill(0.0));
        }
        let mut ground: Series = [0.0; DEGREE + 1];
        let ground_terms = load.series(at_s, h, &mut ground);
        self.begin(state, h);
        self.factorize_mass(&state.theta, groups);
        for k in 0..=DEGREE - 2 {
            let twice = ((k + 1) * (k + 2)) as f64;
            if large {
                self.known_rotations(k + 2);
            } else {
                for (sin, cos) in self.sin.iter_mut().zip(&mut self.cos) {
                    (sin[k + 2], cos[k + 2]) = (0.0, 0.0);
                }
            }
            self.push(&state.props, k);
            let known_ground = &ground[..ground_terms];
            self.gravity_and_inertia(known_ground, k, h);
            self.joint_moments(state, k, h);
            self.sum.clear();
            self.sum.resize(groups, 0.0);
            for i in 0..n {
                if let Some(group) = self.group[i] {
                    self.sum[group] += self.right[i];
                }
            }
            substitute(&self.factor, groups, &mut self.sum);
            if any_stuck {
                self.hold(state, k, h);
            }
            for j in 0..n {
                let theta = self.group[j].map_or(0.0, |group| self.sum[group]) / twice;
                self.theta[j][k + 2] = theta;
                self.sin[j][k + 2] += self.cos[j][0] * theta;
                if large {
                    self.cos[j][k + 2] -= self.sin[j][0] * theta;
                }
            }
            for i in 0..n {
                let (p, r) = self.coupled(i, k + 2);
                (self.p[i][k], self.r[i][k]) = (twice * p, twice * r);
            }
        }
        for i in 0..n {
            for k in DEGREE - 1..=DEGREE {
                self.ground_cos[i][k] = (0..ground_terms.min(k + 1))
                    .map(|m| ground[m] * self.cos[i][k - m])
                    .sum();
            }
            for k in 0..=DEGREE {
                self.across[i][k] = self.theta[i][k] - self.below(i, k);
            }
        }
        for k in DEGREE - 1..=DEGREE {
            self.push(&state.props, k);
        }
    }

    /// Coefficients 0 and 1 of θ, sin θ and cos θ.
    fn begin(&mut self, state: &ChainState, h: f64) {
        let large = self.model.rotations == ChainRotations::Large;
        for i in 0..state.theta.len() {
            let (theta, omega) = (state.theta[i], state.omega[i] * h);
            let (s, c) = if large { theta.sin_cos() } else { (theta, 1.0) };
            (self.theta[i][0], self.theta[i][1]) = (theta, omega);
            (self.sin[i][0], self.sin[i][1]) = (s, c * omega);
            (self.cos[i][0], self.cos[i][1]) = (c, if large { -s * omega } else { 0.0 });
        }
    }

    /// Factor of the mass matrix at these rotations; links that stick together are one group.
    fn factorize_mass(&mut self, theta: &[f64], groups: usize) {
        let n = theta.len();
        let large = self.model.rotations == ChainRotations::Large;
        self.factor.clear();
        self.factor.resize(groups * groups, 0.0);
        for i in 0..n {
            for j in 0..=i {
                let turned = if large { (theta[i] - theta[j]).cos() } else { 1.0 };
                let mass = self.mass[(i, j)] * turned;
                self.turned[i * n + j] = mass;
                if let (Some(upper), Some(lower)) = (self.group[i], self.group[j]) {
                    // for two links of one group both M_ij and M_ji count
                    let times = if upper == lower && i != j { 2.0 } else { 1.0 };
                    self.factor[upper * groups + lower] += times * mass;
                }
            }
        }
        factorize(&mut self.factor, groups);
    }

    /// Coefficient `power` of sin θ and cos θ, without the contribution of θ of the same power.
    fn known_rotations(&mut self, power: usize) {
        for ((sin, cos), theta) in self.sin.iter_mut().zip(&mut self.cos).zip(&self.theta) {
            let (mut s, mut c) = (0.0, 0.0);
            for m in 1..power {
                let rate = m as f64 * theta[m];
                s += rate * cos[power - m];
                c -= rate * sin[power - m];
            }
            sin[power] = s / power as f64;
            cos[power] = c / power as f64;
        }
    }

    /// Σ M_ij s_j and Σ M_ij c_j over the other links, s and c of this power.
    fn coupled(&self, i: usize, power: usize) -> (f64, f64) {
        let (mut p, mut r) = (0.0, 0.0);
        for j in (0..self.theta.len()).filter(|&j| j != i) {
            p += self.mass[(i, j)] * self.sin[j][power];
            r += self.mass[(i, j)] * self.cos[j][power];
        }
        (p, r)
    }

    /// Starts the right side of power k: gravity, ground and side supports, minus the inertia known from lower powers.
    fn gravity_and_inertia(&mut self, ground: &[f64], k: usize, h: f64) {
        let twice = ((k + 1) * (k + 2)) as f64;
        for i in 0..self.theta.len() {
            let terms = ground.iter().take(k + 1).enumerate();
            self.ground_cos[i][k] = terms.map(|(m, ground)| ground * self.cos[i][k - m]).sum();
            self.right[i] =
                h * h * (self.gravity[i] * self.sin[i][k] - self.gamma[i] * self.ground_cos[i][k]);
            let (p, r) = self.coupled(i, k + 2);
            let mut known = twice * (self.cos[i][0] * p - self.sin[i][0] * r);
            for m in 1..=k {
                known += self.cos[i][m] * self.p[i][k - m] - self.sin[i][m] * self.r[i][k - m];
            }
            self.right[i] -= known + h * h * self.pushed_moment(i, k, |c| c);
        }
    }

    /// Adds the moments of springs, friction and dashpots in the joints to the right side of power k.
    fn joint_moments(&mut self, state: &ChainState, k: usize, h: f64) {
        for i in 0..self.theta.len() {
            let (joint, below) = (self.model.joints[i], i.checked_sub(1));
            let across = |m: usize| self.theta[i][m] - self.below(i, m);
            let spring = match state.joints[i] {
                JointState::Closed => joint.stiffness_n_m_rad * across(k),
                JointState::Open(sign) if k == 0 => sign * self.model.moment_most_n_m[i],
                JointState::Open(_) => 0.0,
            };
            let friction = match (state.sliders[i], joint.friction.moments_n_m()) {
                (Slider::Slipping(sign), Some([_, kinetic])) if k == 0 => sign * kinetic,
                _ => 0.0,
            };
            let moment =
                h * h * (spring + friction) + h * joint.damping_n_m_s_rad * (k + 1) as f64 * across(k + 1);
            self.right[i] -= moment;
            if let Some(b) = below {
                self.right[b] += moment;
            }
        }
    }

    /// Coefficient k of the displacements at the side supports and of their forces.
    fn push(&mut self, states: &[PropState], k: usize) {
        for (p, prop) in self.model.props.iter().enumerate() {
            let moved = prop.lever_m.iter().zip(&self.sin);
            let own: f64 = moved.map(|(c, sin)| c * sin[k]).sum();
            self.beside[p][k] = if k == 0 { own - prop.leaning_m } else { own };
            self.pushed[p][k] = match states[p] {
                PropState::Free => 0.0,
                PropState::Touching(sign) if k == 0 => {
                    prop.stiffness_n_m * (self.beside[p][0] - sign * prop.gap_m)
                }
                PropState::Touching(_) => prop.stiffness_n_m * self.beside[p][k],
            };
        }
    }

    /// Coefficient k of the moments of the side supports on link i, Σ c_i F cos θ_i, with each term passed through `of`.
    fn pushed_moment(&self, i: usize, k: usize, of: impl Fn(f64) -> f64) -> f64 {
        let mut sum = 0.0;
        for (prop, pushed) in self.model.props.iter().zip(&self.pushed) {
            if prop.lever_m[i] > 0.0 {
                let terms = (0..=k).map(|m| of(prop.lever_m[i] * pushed[m] * self.cos[i][k - m]));
                sum += terms.sum::<f64>();
            }
        }
        sum
    }

    /// Coefficient k of the rotation below joint i: of the lower link, or of the ground, which leans.
    fn below(&self, i: usize, k: usize) -> f64 {
        match i.checked_sub(1) {
            Some(below) => self.theta[below][k],
            None if k == 0 => self.model.lean_rad,
            None => 0.0,
        }
    }

    /// Coefficient k of the moments of stuck joints, from the equilibrium of the links above them.
    fn hold(&mut self, state: &ChainState, k: usize, h: f64) {
        let n = state.theta.len();
        let mut left = 0.0;
        for i in (0..n).rev() {
            let mut inertia = 0.0;
            for j in 0..n {
                if let Some(group) = self.group[j] {
                    inertia += self.turned[i.max(j) * n + i.min(j)] * self.sum[group];
                }
            }
            left += self.right[i] - inertia;
            self.held[i][k] = match state.sliders[i] {
                Slider::Stuck => left / (h * h),
                _ => {
                    left = 0.0;
                    0.0
                }
            };
        }
    }

    /// Largest sum of the magnitudes of the moments of order k in one link, N m: the scale of rounding.
    pub(super) fn moment_scale(&self, state: &ChainState, k: usize, h: f64) -> f64 {
        let n = state.theta.len();
        let second = ((k + 1) * (k + 2)) as f64 / (h * h);
        let of_joint = |i: usize| {
            let joint = self.model.joints[i];
            let friction = match (state.sliders[i], joint.friction.moments_n_m()) {
                (Slider::Slipping(_), Some([_, kinetic])) if k == 0 => kinetic,
                (Slider::Stuck, _) => self.held[i][k].abs(),
                _ => 0.0,
            };
            let dashpot = joint.damping_n_m_s_rad * (k + 1) as f64 / h * self.across[i][k + 1].abs();
            joint.stiffness_n_m_rad * self.across[i][k].abs() + dashpot + friction
        };
        let of_link = |i: usize| {
            let acts = self.gravity[i] * self.sin[i][k].abs() + self.gamma[i] * self.ground_cos[i][k].abs();
            let mut inertia = 0.0;
            for j in 0..n {
                inertia += self.mass[(i, j)] * second * self.theta[j][k + 2].abs();
            }
            for m in 1..=k {
                inertia += (self.cos[i][m] * self.p[i][k - m]).abs() / (h * h);
                inertia += (self.sin[i][m] * self.r[i][k - m]).abs() / (h * h);
            }
            let above = if i + 1 < n { of_joint(i + 1) } else { 0.0 };
            acts + inertia + of_joint(i) + above + self.pushed_moment(i, k, f64::abs)
        };
        (0..n).map(of_link).fold(0.0, f64::max)
    }

    /// Coefficient k of the inertia moment of φ'', N m.
    pub(super) fn inertia(&self, joint: usize, k: usize, h: f64) -> f64 {
        let second = ((k + 1) * (k + 2)) as f64 / (h * h);
        self.mass[(joint, joint)] * second * self.across[joint][k + 2]
    }

    /// The fraction of [0, 1] on which the last terms are negligible compared with the first ones; `None` if they are not finite.
    pub(super) fn part_exact(&self) -> Option<f64> {
        let size = |k: usize| -> f64 { self.theta.iter().map(|c| c[k].abs()).sum() }; // a sum keeps NaN
        let sizes: Vec<f64> = (0..=DEGREE).map(size).collect();
        let mut part: f64 = 1.0;
        loop {
            let at = |k: usize| sizes[k] * part.powi(k as i32);
            let first: f64 = (0..=FIRST_TERMS).map(at).sum();
            let last = at(DEGREE - 1) + at(DEGREE);
            if !(first + last).is_finite() {
                return None;
            }
            if last <= TAIL * first || part < f64::EPSILON {
                return Some(part);
            }
            part *= 0.98 * (TAIL * first / last).powf(1.0 / DEGREE as f64).clamp(0.1, 1.0);
        }
    }

    /// Rescales the series to the first `part` of the step.
    pub(super) fn shorten(&mut self, part: f64) {
        if part == 1.0 {
            return;
        }
        for list in [
            &mut self.theta,
            &mut self.across,
            &mut self.sin,
            &mut self.ground_cos,
            &mut self.held,
            &mut self.beside,
        ] {
            for series in list.iter_mut() {
                let mut power = 1.0;
                for c in series.iter_mut() {
                    *c *= power;
                    power *= part;
                }
            }
        }
    }

    /// Work of the ground from the start of the step, J: −Σ Γ_i ∫ a c_i θ_i' dσ.
    pub(super) fn ground_work_j(&self) -> Work {
        let mut work = [0.0; 2 * DEGREE + 2];
        for (i, gamma) in self.gamma.iter().enumerate() {
            add_integral(-gamma, &self.ground_cos[i], &rate(&self.theta[i]), &mut work);
        }
        work
    }

    /// Energy dissipated by the dashpots from the start of the step of `h` s, J: Σ d_i ∫ φ_i'² dσ / h.
    pub(super) fn damping_work_j(&self, h: f64) -> Work {
        let mut work = [0.0; 2 * DEGREE + 2];
        for (joint, across) in self.model.joints.iter().zip(&self.across) {
            if joint.damping_n_m_s_rad > 0.0 {
                let rate = rate(across);
                add_integral(joint.damping_n_m_s_rad / h, &rate, &rate, &mut work);
            }
        }
        work
    }

    /// θ and θ' at σ of a step of `h` s.
    pub(super) fn at(&self, link: usize, sigma: f64, h: f64) -> [f64; 2] {
        [
            polynomial(&self.theta[link], sigma),
            polynomial(&rate(&self.theta[link]), sigma) / h,
        ]
    }
}

/// Coefficients of the derivative; the last is 0.
pub(super) fn rate(c: &Series) -> Series {
    let mut rate = [0.0; DEGREE + 1];
    for k in 1..=DEGREE {
        rate[k - 1] = k as f64 * c[k];
    }
    rate
}

/// Adds the coefficients of factor ∫ f g dσ.
fn add_integral(factor: f64, f: &Series, g: &Series, sum: &mut Work) {
    for (i, f) in f.iter().enumerate().filter(|(_, f)| **f != 0.0) {
        for (j, g) in g.iter().enumerate() {
            sum[i + j + 1] += factor * f * g / (i + j + 1) as f64;
        }
    }
}

/// Cholesky factorization: the lower triangle of A becomes L with A = L Lᵀ. The mass matrix of a rotated chain is positive definite.
fn factorize(a: &mut [f64], n: usize) {
    for j in 0..n {
        for i in j..n {
            let inner: f64 = (0..j).map(|m| a[i * n + m] * a[j * n + m]).sum();
            a[i * n + j] -= inner;
        }
        let root = a[j * n + j].sqrt();
        for i in j..n {
            a[i * n + j] /= root;
        }
    }
}

/// Solves L Lᵀ x = b in place.
fn substitute(l: &[f64], n: usize, b: &mut [f64]) {
    for i in 0..n {
        let inner: f64 = (0..i).map(|m| l[i * n + m] * b[m]).sum();
        b[i] = (b[i] - inner) / l[i * n + i];
    }
    for i in (0..n).rev() {
        let inner: f64 = (i + 1..n).map(|m| l[m * n + i] * b[m]).sum();
        b[i] = (b[i] - inner) / l[i * n + i];
    }
}
