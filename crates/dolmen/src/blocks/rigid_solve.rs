//! Solves one step of the rigid law: the velocities at which momentum balances and every contact point satisfies its law.
//!
//! ```text
//! M v − b − Σ Gᵀ p(v) = 0,   p(v) = projection by the law of λ − σ ϱ (u + s),   λ ← p until they agree
//! ```
//!
//! Newton's method solves the inner equation with 6 × 6 blocks of the bodies (LU within their skyline: block-tridiagonal for a chain). The
//! outer iteration updates the multipliers λ. When λ = p, every point satisfies unilateral contact and Coulomb's law exactly. The weights ϱ
//! are used unchanged (σ = 1) first. If Newton's method cycles, an interior-point method follows ([`super::rigid_interior`]). Only where this
//! has no solution either, the weights go from soft to hard; if the residual of the points remains too large, convex problems follow
//! ([`super::rigid_cone`]).

use super::block_skyline::{Block, BlockSkyline, SIX};
use super::rigid_faces::{Face, Stiffness};
use super::rigid_point::ForceTorque;
use glam::{DMat3, DVec3};

/// Residual of the momentum balance, over the mass, at which Newton's method ends, m/s. Our choice: far below any visible motion.
pub(super) const LEFT_MOST_M_S: f64 = 1e-9;
/// Residual of the contact law, m/s, at which a solution has converged, or at which it is accepted if further updates do not reduce it. Our
/// choice.
pub(super) const OFF_MOST_M_S: f64 = 1e-8;
const STAYS_M_S: f64 = 1e-6;
/// Residual of the contact law above which an accepted solution is inaccurate, m/s. Our choice.
pub(super) const LOOSE_FROM_M_S: f64 = 1e-6;
/// With unchanged weights: largest number of Newton steps per set of multipliers, and largest number of updates of the multipliers. Our
/// choice.
const DIRECT_STEPS: usize = 10;
const DIRECT_ROUNDS: usize = 20;
/// Factor by which each update of the multipliers must reduce the residual of the contact law. Our choice.
const SLOWEST: f64 = 0.8;
/// Parameters of soft weights: the first σ, the factor to the next σ, Newton steps and halvings for each, sets of multipliers, and number of
/// sets without a solution after which the method stops. Our choice, from tests on falling stacks of 10 to 20 stones.
const SOFTEST_FIRST: f64 = 1e-2;
const HARDER: f64 = 10.0;
const SOFT_STEPS: usize = 20;
const LINE_STEPS: usize = 5;
const ROUNDS_MOST: usize = 60;
const FAILURES_MOST: usize = 12;

/// Mass of a body, and its moments of inertia in the axes of the ground.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inertia {
    pub(super) mass: f64,
    pub(super) turning: DMat3,
    pub(super) radius: f64,
}

/// Inertia of the bodies, and their momentum without contact forces.
#[derive(Clone, Copy, Debug)]
pub(super) struct Momentum<'a> {
    pub(super) inertia: &'a [Inertia],
    pub(super) free: &'a [ForceTorque],
}

/// Method that found a solution.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum SolvedBy {
    /// Newton's method on the law itself.
    #[default]
    Newton,
    /// The interior-point method.
    InteriorPoint,
    /// Softer weights, or convex problems after them.
    SofterWeights,
}

/// Statistics of a solution.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Solved {
    pub(super) converged: bool,
    pub(super) method: SolvedBy,
    /// The larger of the residuals of momentum and contact law, m/s.
    pub(super) residual_m_s: f64,
    pub(super) newton_steps: usize,
    pub(super) rounds: usize,
}

#[derive(Clone, Copy, Debug)]
struct NewtonOptions {
    /// Start from the active contacts and slips of the previous solution instead of evaluating the law.
    presume: bool,
    /// Largest number of halvings of a step until it reduces the residual.
    line_steps: usize,
    steps_most: usize,
}

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct MomentumResidual {
    /// Largest component, as a velocity, m/s.
    pub(super) largest_m_s: f64,
    energy_j: f64,
}

/// A trial solution and its residual.
#[derive(Clone, Debug)]
pub(super) struct Candidate {
    pub(super) residual_m_s: f64,
    pub(super) velocity: Vec<ForceTorque>,
    pub(super) held: Vec<Vec<[f64; 3]>>,
}

/// Calculation of the contact forces from a velocity.
#[derive(Clone, Copy, Debug)]
pub(super) enum Pressing {
    /// From the contact law itself.
    ByLaw {
        /// Whether the same points are assumed to stay active and to slip, as in [`Face::contact_force`].
        presume: bool,
    },
    /// From the convex problem with fixed lifts.
    OnCones,
}

/// Right side and matrix of Newton's method, with one row per body.
#[derive(Clone, Debug, Default)]
pub(super) struct Solver {
    pub(super) matrix: BlockSkyline,
    /// Row of each body; the ground has none.
    pub(super) rows: Vec<usize>,
    pub(super) right: Vec<ForceTorque>,
}

impl Solver {
    /// A solver for bodies (the ground is 0) with these pairs in contact.
    pub(super) fn of(bodies: usize, touching: &[[usize; 2]]) -> Self {
        let order = order(bodies, touching);
        let mut rows = vec![usize::MAX; bodies];
        for (row, body) in order.iter().enumerate() {
            rows[*body] = row;
        }
        let mut first: Vec<usize> = (0..order.len()).collect();
        for [a, b] in touching {
            if *a > 0 && *b > 0 {
                let (low, high) = (rows[*a].min(rows[*b]), rows[*a].max(rows[*b]));
                first[high] = first[high].min(low);
            }
        }
        Solver {
            right: vec![[0.0; SIX]; first.len()],
            matrix: BlockSkyline::within(first),
            rows,
        }
    }

    /// Solves from initial velocities `v` of the bodies (zero for the ground), which become the solution; the faces store the impulses. A
    /// result with a residual above `worst_m_s` is not a solution.
    pub(super) fn solve(
        &mut self,
        of: Momentum<'_>,
        faces: &mut [Face],
        v: &mut Vec<ForceTorque>,
        worst_m_s: f64,
    ) -> Solved {
        let mut solved = Solved::default();
        let start = Candidate {
            residual_m_s: f64::INFINITY,
            velocity: v.clone(),
            held: held_of(faces),
        };
        self.directly(of, faces, v, &mut solved);
        if !solved.converged {
            start.take(faces, v);
            solved.converged = self.by_interior(of, faces, v, &mut solved);
            solved.method = SolvedBy::InteriorPoint;
        }
        if !solved.converged {
            solved.method = SolvedBy::SofterWeights;
            start.take(faces, v);
            self.softly(of, faces, v, start, &mut solved);
            if solved.residual_m_s > LOOSE_FROM_M_S {
                self.by_cones(of, faces, v, &mut solved);
            }
            solved.converged = solved.residual_m_s <= worst_m_s;
        }
        solved
    }

    /// Solves with softer weights, for which Newton's method rarely cycles. The multipliers are passed on to harder and harder weights, as
    /// long as there are solutions.
    fn softly(
        &mut self,
        of: Momentum<'_>,
        faces: &mut [Face],
        v: &mut Vec<ForceTorque>,
        start: Candidate,
        solved: &mut Solved,
    ) {
        let (mut softness, mut harder, mut failures) = (SOFTEST_FIRST, HARDER, 0);
        // the hardest weights with a solution so far; 0 if there is none
        let mut served = 0.0;
        let mut best = start.clone();
        let mut last = start;
        while failures < FAILURES_MOST {
            for face in faces.iter_mut() {
                face.softness = softness;
            }
            solved.rounds += 1;
            let careful = NewtonOptions {
                presume: false,
                line_steps: LINE_STEPS,
                steps_most: SOFT_STEPS,
            };
            let left = self.newton(of, faces, v, careful, &mut solved.newton_steps);
            if left <= LEFT_MOST_M_S {
                let before = last.residual_m_s;
                let now = faces.iter().map(Face::residual).fold(0.0, f64::max);
                hold_impulses(faces);
                last = Candidate {
                    residual_m_s: now,
                    velocity: v.clone(),
                    held: held_of(faces),
                };
                if now < best.residual_m_s {
                    best.clone_from(&last);
                }
                let stays = softness == 1.0 && now > SLOWEST * before && now <= STAYS_M_S;
                if now <= OFF_MOST_M_S || stays || solved.rounds > ROUNDS_MOST {
                    break;
                }
                served = softness;
                softness = (softness * harder).min(1.0);
            } else {
                failures += 1;
                last.take(faces, v);
                if softness > served && served > 0.0 {
                    harder = harder.sqrt();
                    softness = served;
                } else {
                    softness /= HARDER;
                    served = 0.0;
                }
            }
        }
        best.take(faces, v);
        for face in faces.iter_mut() {
            face.softness = 1.0;
            for point in &mut face.points {
                point.impulse = point.held;
            }
        }
        solved.residual_m_s = best.residual_m_s;
    }

    /// Solves by Newton's method on the law itself.
    fn directly(&mut self, of: Momentum<'_>, faces: &mut [Face], v: &mut [ForceTorque], solved: &mut Solved) {
        let mut off = f64::INFINITY;
        for round in 0..DIRECT_ROUNDS {
            solved.rounds += 1;
            let options = NewtonOptions {
                presume: round == 0,
                line_steps: 0,
                steps_most: DIRECT_STEPS,
            };
            let left = self.newton(of, faces, v, options, &mut solved.newton_steps);
            let now = faces.iter().map(Face::residual).fold(0.0, f64::max);
            solved.residual_m_s = left.max(now);
            let far = left > LEFT_MOST_M_S || now > SLOWEST * off;
            solved.converged = !far && now <= OFF_MOST_M_S;
            if far || solved.converged {
                return;
            }
            off = now;
            hold_impulses(faces);
        }
    }

    /// Newton's method with fixed multipliers; returns the residual of the momentum balance, m/s.
    fn newton(
        &mut self,
        of: Momentum<'_>,
        faces: &mut [Face],
        v: &mut [ForceTorque],
        options: NewtonOptions,
        steps: &mut usize,
    ) -> f64 {
        let mut presume = options.presume;
        for face in faces.iter_mut() {
            face.forget();
        }
        let mut change = vec![[0.0; SIX]; v.len()];
        let mut trial = v.to_vec();
        let mut left = f64::INFINITY;
        for _ in 0..options.steps_most {
            let now = self.balance(of, faces, v, Pressing::ByLaw { presume }, true);
            let presumed = faces.iter().any(|face| face.swung);
            left = if presumed { f64::INFINITY } else { now.largest_m_s };
            if left <= LEFT_MOST_M_S {
                return left;
            }
            *steps += 1;
            if !self.matrix.factor() {
                return f64::INFINITY;
            }
            self.matrix.solve(&mut self.right);
            for (change, row) in change.iter_mut().zip(&self.rows).skip(1) {
                *change = self.right[*row];
            }
            // halve the step until the residual decreases; accept the last halving in any case
            let mut part = 1.0;
            ahead(&mut trial, v, &change, part);
            let halvings = if presumed { 0 } else { options.line_steps };
            for _ in 0..halvings {
                if self
                    .balance(of, faces, &trial, Pressing::ByLaw { presume: false }, false)
                    .energy_j
                    < now.energy_j
                {
                    break;
                }
                part *= 0.5;
                ahead(&mut trial, v, &change, part);
            }
            v.copy_from_slice(&trial);
            presume = false;
        }
        left
    }

    /// Residual of the momentum balance at `v`. Sets the right side and, on request, the matrix of the next Newton step.
    pub(super) fn balance(
        &mut self,
        of: Momentum<'_>,
        faces: &mut [Face],
        v: &[ForceTorque],
        pressing: Pressing,
        with_matrix: bool,
    ) -> MomentumResidual {
        self.momentum_left(of, v, with_matrix);
        for face in faces.iter_mut() {
            let twist = face.twist_of(v);
            let mut k: Stiffness = [[0.0; 6]; 6];
            let stiffness = with_matrix.then_some(&mut k);
            let wrench = match pressing {
                Pressing::ByLaw { presume } => face.contact_force(&twist, presume, stiffness),
                Pressing::OnCones => face.press_on_cones(&twist, stiffness),
            };
            self.push(face, &wrench);
            if with_matrix {
                self.add(face, &k);
            }
        }
        self.left(of)
    }

    /// Sets the right side to the residual without contact forces, and the matrix to the mass matrix.
    pub(super) fn momentum_left(&mut self, of: Momentum<'_>, v: &[ForceTorque], with_matrix: bool) {
        if with_matrix {
            self.matrix.clear();
        }
        let Momentum { inertia, free } = of;
        self.right.resize(free.len() - 1, [0.0; SIX]);
        for (body, (of, (v, momentum))) in inertia.iter().zip(v.iter().zip(free)).enumerate().skip(1) {
            let turning = of.turning * DVec3::new(v[3], v[4], v[5]);
            let has = [
                of.mass * v[0],
                of.mass * v[1],
                of.mass * v[2],
                turning.x,
                turning.y,
                turning.z,
            ];
            let row = self.rows[body];
            self.right[row] = std::array::from_fn(|i| momentum[i] - has[i]);
            if !with_matrix {
                continue;
            }
            let block = self.matrix.block_mut(row, row);
            for i in 0..3 {
                block[i][i] += of.mass;
                for j in 0..3 {
                    block[3 + i][3 + j] += of.turning.col(j)[i];
                }
            }
        }
    }

    /// Adds the force of a contact on its two bodies to the right side.
    pub(super) fn push(&mut self, face: &Face, wrench: &ForceTorque) {
        let force = face.to_ground * DVec3::new(wrench[0], wrench[1], wrench[2]);
        let torque = face.to_ground * DVec3::new(wrench[3], wrench[4], wrench[5]);
        let sides = [
            (face.plane_body, face.arms[0], -1.0),
            (face.point_body, face.arms[1], 1.0),
        ];
        for (body, arm, sign) in sides {
            if body > 0 {
                let about = torque + arm.cross(force);
                let right = &mut self.right[self.rows[body]];
                for i in 0..3 {
                    right[i] += sign * force[i];
                    right[3 + i] += sign * about[i];
                }
            }
        }
    }

    /// Norm of the right side; infinite if it is not a number.
    pub(super) fn left(&self, of: Momentum<'_>) -> MomentumResidual {
        let mut left = MomentumResidual::default();
        for (body, of) in of.inertia.iter().enumerate().skip(1) {
            let right = &self.right[self.rows[body]];
            for i in 0..3 {
                let (slow, turn) = (right[i] / of.mass, right[3 + i] / (of.mass * of.radius));
                left.largest_m_s = left.largest_m_s.max(slow.abs()).max(turn.abs());
                if slow.is_nan() || turn.is_nan() {
                    left.largest_m_s = f64::INFINITY;
                }
                left.energy_j += 0.5 * of.mass * (slow * slow + turn * turn);
            }
        }
        left
    }

    /// Adds the stiffness of a contact between its two bodies to the matrix.
    ///
    /// ```text
    /// twist = Rᵀ (X_s v_s − X_p v_p),   X = [1, −[r]×; 0, 1]:   J_ab += ± X_aᵀ R K Rᵀ X_b
    /// ```
    pub(super) fn add(&mut self, face: &Face, k: &Stiffness) {
        let part = |row: usize, column: usize| {
            let block = DMat3::from_cols(
                DVec3::new(k[row][column], k[row + 1][column], k[row + 2][column]),
                DVec3::new(k[row][column + 1], k[row + 1][column + 1], k[row + 2][column + 1]),
                DVec3::new(k[row][column + 2], k[row + 1][column + 2], k[row + 2][column + 2]),
            );
            face.to_ground * block * face.to_ground.transpose()
        };
        let (a, b, c, d) = (part(0, 0), part(0, 3), part(3, 0), part(3, 3));
        let sides = [
            (face.plane_body, cross(face.arms[0])),
            (face.point_body, cross(face.arms[1])),
        ];
        for (on, (body_1, arm_1)) in sides.iter().enumerate() {
            for (of, (body_2, arm_2)) in sides.iter().enumerate() {
                if *body_1 == 0 || *body_2 == 0 {
                    continue;
                }
                let (right_top, right_low) = (b - a * *arm_2, d - c * *arm_2);
                let (low, low_right) = (*arm_1 * a + c, *arm_1 * right_top + right_low);
                let sign = if on == of { 1.0 } else { -1.0 };
                let block: &mut Block = self.matrix.block_mut(self.rows[*body_1], self.rows[*body_2]);
                for i in 0..3 {
                    for j in 0..3 {
                        block[i][j] += sign * a.col(j)[i];
                        block[i][3 + j] += sign * right_top.col(j)[i];
                        block[3 + i][j] += sign * low.col(j)[i];
                        block[3 + i][3 + j] += sign * low_right.col(j)[i];
                    }
                }
            }
        }
    }
}

impl Candidate {
    /// Restores the stored solution.
    pub(super) fn take(&self, faces: &mut [Face], v: &mut Vec<ForceTorque>) {
        v.clone_from(&self.velocity);
        for (face, held) in faces.iter_mut().zip(&self.held) {
            for (point, held) in face.points.iter_mut().zip(held) {
                point.held = *held;
            }
        }
    }
}

/// Trial velocities v + part × change.
pub(super) fn ahead(trial: &mut [ForceTorque], v: &[ForceTorque], change: &[ForceTorque], part: f64) {
    for (trial, (v, change)) in trial.iter_mut().zip(v.iter().zip(change)).skip(1) {
        *trial = std::array::from_fn(|i| v[i] + part * change[i]);
    }
}

/// The stored impulses, face by face.
pub(super) fn held_of(faces: &[Face]) -> Vec<Vec<[f64; 3]>> {
    let of = |face: &Face| face.points.iter().map(|point| point.held).collect();
    faces.iter().map(of).collect()
}

/// Updates the multipliers with the impulses.
pub(super) fn hold_impulses(faces: &mut [Face]) {
    for face in faces {
        for point in &mut face.points {
            point.held = point.impulse;
        }
    }
}

/// The cross-product matrix [r]×.
fn cross(r: DVec3) -> DMat3 {
    DMat3::from_cols(
        DVec3::new(0.0, r.z, -r.y),
        DVec3::new(-r.z, 0.0, r.x),
        DVec3::new(r.y, -r.x, 0.0),
    )
}

/// Orders the bodies, without the ground, so that bodies in contact are close to each other.
///
/// # Source
/// Cuthill, E. & McKee, J. (1969) Proc. 24th ACM Nat. Conf. 157-172.
fn order(bodies: usize, touching: &[[usize; 2]]) -> Vec<usize> {
    let mut near = vec![Vec::new(); bodies];
    for [a, b] in touching {
        if *a > 0 && *b > 0 {
            near[*a].push(*b);
            near[*b].push(*a);
        }
    }
    for list in &mut near {
        list.sort_unstable();
        list.dedup();
    }
    let mut order: Vec<usize> = Vec::with_capacity(bodies);
    let mut taken = vec![false; bodies];
    taken[0] = true;
    while order.len() + 1 < bodies {
        let loose = (1..bodies).filter(|body| !taken[*body]);
        let Some(start) = loose.min_by_key(|body| (near[*body].len(), *body)) else {
            break;
        };
        taken[start] = true;
        let mut at = order.len();
        order.push(start);
        while at < order.len() {
            let mut next: Vec<usize> = near[order[at]]
                .iter()
                .copied()
                .filter(|body| !taken[*body])
                .collect();
            next.sort_by_key(|body| (near[*body].len(), *body));
            for body in next {
                taken[body] = true;
                order.push(body);
            }
            at += 1;
        }
    }
    order
}
