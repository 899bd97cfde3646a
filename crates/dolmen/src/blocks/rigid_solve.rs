//! One step of the rigid law: velocities at which impulses and momentum balance, and every point obeys its law.
//!
//! ```text
//! M v − b − Σ Gᵀ p(v) = 0,   p(v) = the law's projection of λ − ϱ (u + s),   λ ← p until they agree
//! ```
//!
//! The inner equation is solved by Newton steps on the blocks of the bodies (LU within their outline: block-tridiagonal on a
//! chain), the outer by carrying the multipliers over. With λ = p every point obeys unilateral contact and Coulomb's law exactly.

use super::block_skyline::{Block, BlockSkyline, SIX};
use super::rigid_faces::{Face, Six, Stiffness, Way};
use glam::{DMat3, DVec3};

/// Momentum left over, over the mass, at which a Newton step is the last, m/s. Chosen here: far below any way that is seen.
pub(super) const LEFT_MOST_M_S: f64 = 1e-9;
/// Distance of a point from its law, m/s, at which a solution is done. Chosen here.
pub(super) const OFF_MOST_M_S: f64 = 1e-8;
/// The same that is accepted where further rounds better it no more: a nanometre a step. Chosen here.
const OFF_WORST_M_S: f64 = 1e-6;
/// Newton steps for one set of multipliers, and times that multipliers are carried over. Chosen here.
const NEWTON_MOST: usize = 120;
const ROUNDS_MOST: usize = 60;
/// The same when the law itself is solved. Chosen here.
const DIRECT_STEPS: usize = 10;
const DIRECT_ROUNDS: usize = 20;
/// Part to which the distance from the law must fall each time that multipliers are carried over. Chosen here.
const SLOWEST: f64 = 0.8;
/// Parts of the weights with which a solution is approached when the law itself is too far. Chosen here.
const SOFTNESS: [f64; 6] = [1e-4, 1e-3, 1e-2, 1e-1, 1.0, 1.0];
const WARM_FROM: usize = 3;
/// Rounds after which the law itself is tried again. Chosen here.
const DIRECT_EVERY: usize = 2;
/// Slope left at the end of a step, in parts of that at its start. Chosen here.
const SLOPE_LEFT: f64 = 0.5;
/// Round from which bounds move only a part of their way, and that part: they may chase each other. Chosen here.
const DAMPED_FROM: usize = 12;
const DAMPED_PART: f64 = 0.4;
const LINE_STEPS: usize = 30;

/// Mass and moments of inertia of a body in the ground's axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inertia {
    pub(super) mass: f64,
    pub(super) turning: DMat3,
    pub(super) radius: f64,
}

/// Masses of the bodies, and the momentum they would have without contacts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Momentum<'a> {
    pub(super) inertia: &'a [Inertia],
    pub(super) free: &'a [Six],
}

/// What a solution took.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Solved {
    pub(super) converged: bool,
    /// Largest of the momentum left over and of the points' distance from their law, m/s.
    pub(super) residual_m_s: f64,
    pub(super) newton_steps: usize,
    pub(super) rounds: usize,
}

/// Rows of the bodies and their matrix.
#[derive(Clone, Debug, Default)]
pub(super) struct Solver {
    matrix: BlockSkyline,
    /// Row of each body; of the ground none.
    rows: Vec<usize>,
    right: Vec<Six>,
    trial: Vec<Six>,
}

impl Solver {
    /// For bodies (the ground is 0) that touch in these pairs.
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
            trial: Vec::new(),
        }
    }

    /// Solves from velocities `v` of the bodies (of the ground zeros), which become the solution; the faces keep the impulses.
    pub(super) fn solve(&mut self, of: Momentum<'_>, faces: &mut [Face], v: &mut Vec<Six>) -> Solved {
        let mut solved = Solved::default();
        let (start, held) = (v.clone(), held_of(faces));
        self.directly(of, faces, v, DIRECT_STEPS, &mut solved);
        if solved.converged {
            return solved;
        }
        v.clone_from(&start);
        hold(faces, &held);
        let begin = if faces.iter().any(|face| face.warm) {
            WARM_FROM
        } else {
            0
        };
        set_bounds(faces, 1.0);
        let mut best = (f64::INFINITY, start);
        for round in begin..ROUNDS_MOST {
            let softness = SOFTNESS.get(round).copied().unwrap_or(1.0);
            for face in faces.iter_mut() {
                face.way = Way::Bounded(softness);
            }
            solved.rounds += 1;
            let left = self.newton(of, faces, v, false, NEWTON_MOST, &mut solved.newton_steps);
            let now = faces.iter().map(Face::residual).fold(left, f64::max);
            for face in faces.iter_mut() {
                face.way = Way::Direct;
            }
            if round + 1 >= SOFTNESS.len() {
                if now < best.0 && left <= LEFT_MOST_M_S {
                    best = (now, v.clone());
                    for face in faces.iter_mut() {
                        face.keep_best();
                    }
                }
                if best.0 <= OFF_MOST_M_S {
                    break;
                }
            }
            hold_impulses(faces);
            set_bounds(faces, if round < DAMPED_FROM { 1.0 } else { DAMPED_PART });
            if round + 1 >= SOFTNESS.len() && (round + 1 - SOFTNESS.len()).is_multiple_of(DIRECT_EVERY) {
                let (near, held) = (v.clone(), held_of(faces));
                self.directly(of, faces, v, DIRECT_STEPS, &mut solved);
                if solved.converged {
                    return solved;
                }
                v.clone_from(&near);
                hold(faces, &held);
            }
        }
        v.clone_from(&best.1);
        for face in faces.iter_mut() {
            face.take_best();
        }
        solved.residual_m_s = best.0;
        solved.converged = best.0 <= OFF_WORST_M_S;
        solved
    }

    /// Solves by Newton steps on the law itself, at most so many for one set of multipliers.
    fn directly(
        &mut self,
        of: Momentum<'_>,
        faces: &mut [Face],
        v: &mut Vec<Six>,
        most: usize,
        solved: &mut Solved,
    ) {
        let mut off = f64::INFINITY;
        for round in 0..DIRECT_ROUNDS {
            solved.rounds += 1;
            let left = self.newton(of, faces, v, round == 0, most, &mut solved.newton_steps);
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

    /// Newton steps for the multipliers held; what is left of the momentum, m/s.
    fn newton(
        &mut self,
        of: Momentum<'_>,
        faces: &mut [Face],
        v: &mut Vec<Six>,
        presume: bool,
        most: usize,
        steps: &mut usize,
    ) -> f64 {
        let bounded = faces.first().is_some_and(|face| face.way != Way::Direct);
        let mut presume = presume;
        for face in faces.iter_mut() {
            face.forget();
        }
        let mut left = f64::INFINITY;
        for _ in 0..most {
            let [largest, _] = self.balance(of, faces, v, presume, true);
            let presumed = faces.iter().any(|face| face.swung);
            left = if presumed { f64::INFINITY } else { largest };
            if left <= LEFT_MOST_M_S {
                return left;
            }
            *steps += 1;
            if !self.matrix.factor() {
                return f64::INFINITY;
            }
            let mut change = std::mem::take(&mut self.right);
            self.matrix.solve(&mut change);
            let part = match bounded {
                true => self.least_along(of, faces, v, &change),
                false => 1.0,
            };
            self.ahead(v, &change, part);
            std::mem::swap(v, &mut self.trial);
            self.right = change;
            presume = false;
        }
        left
    }

    /// The part of a step up to which a convex problem falls: where its slope along the step is small enough, by false position.
    fn least_along(&mut self, of: Momentum<'_>, faces: &mut [Face], v: &[Six], change: &[Six]) -> f64 {
        let mut slope = |part: f64| {
            self.ahead(v, change, part);
            let trial = std::mem::take(&mut self.trial);
            self.balance(of, faces, &trial, false, false);
            self.trial = trial;
            let products = self
                .right
                .iter()
                .zip(change)
                .map(|(r, c)| -> f64 { r.iter().zip(c).map(|(r, c)| r * c).sum() });
            products.sum::<f64>()
        };
        // the right side is the slope downwards
        let at_end = slope(1.0);
        let at_start = slope(0.0);
        if at_end >= -SLOPE_LEFT * at_start {
            return 1.0;
        }
        let (mut low, mut high) = ((0.0, at_start), (1.0, at_end));
        for _ in 0..LINE_STEPS {
            let part = low.0 + (high.0 - low.0) * low.1 / (low.1 - high.1);
            let at = slope(part);
            if at.abs() <= SLOPE_LEFT * at_start {
                return part;
            }
            if at > 0.0 {
                low = (part, at);
                high.1 *= 0.5;
            } else {
                high = (part, at);
                low.1 *= 0.5;
            }
        }
        low.0
    }

    /// v + part × change.
    fn ahead(&mut self, v: &[Six], change: &[Six], part: f64) {
        self.trial.clear();
        self.trial.extend_from_slice(v);
        for (body, v) in self.trial.iter_mut().enumerate().skip(1) {
            for (v, change) in v.iter_mut().zip(&change[self.rows[body]]) {
                *v += part * change;
            }
        }
    }

    /// What is left of the momentum at `v`: its largest part and the sum of squares, as velocities; the right side and (if
    /// asked for) the matrix of the next Newton step.
    fn balance(
        &mut self,
        of: Momentum<'_>,
        faces: &mut [Face],
        v: &[Six],
        presume: bool,
        with_matrix: bool,
    ) -> [f64; 2] {
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
            if with_matrix {
                let block = self.matrix.block_mut(row, row);
                for i in 0..3 {
                    block[i][i] += of.mass;
                    for j in 0..3 {
                        block[3 + i][3 + j] += of.turning.col(j)[i];
                    }
                }
            }
        }
        for face in faces.iter_mut() {
            let (p, s) = (face.plane_body, face.point_body);
            let at = |body: usize| (body > 0).then(|| &v[body]);
            let twist = face.twist(at(p), at(s));
            let mut k: Stiffness = [[0.0; 6]; 6];
            let wrench = face.press(&twist, presume, with_matrix.then_some(&mut k));
            let force = face.to_ground * DVec3::new(wrench[0], wrench[1], wrench[2]);
            let torque = face.to_ground * DVec3::new(wrench[3], wrench[4], wrench[5]);
            for (body, arm, sign) in [(p, face.arms[0], -1.0), (s, face.arms[1], 1.0)] {
                if body > 0 {
                    let about = torque + arm.cross(force);
                    let right = &mut self.right[self.rows[body]];
                    for i in 0..3 {
                        right[i] += sign * force[i];
                        right[3 + i] += sign * about[i];
                    }
                }
            }
            if with_matrix {
                self.add(face, &k);
            }
        }
        let (mut largest, mut squares) = (0.0_f64, 0.0);
        for (body, of) in inertia.iter().enumerate().skip(1) {
            let right = &self.right[self.rows[body]];
            for i in 0..3 {
                let (slow, turn) = (right[i] / of.mass, right[3 + i] / (of.mass * of.radius));
                largest = largest.max(slow.abs()).max(turn.abs());
                if slow.is_nan() || turn.is_nan() {
                    largest = f64::INFINITY;
                }
                squares += of.mass * (slow * slow + turn * turn);
            }
        }
        [largest, squares]
    }

    /// Adds what a contact holds against the motion of its two bodies.
    ///
    /// ```text
    /// twist = Rᵀ (X_s v_s − X_p v_p),   X = [1, −[r]×; 0, 1]:   J_ab += ± X_aᵀ R K Rᵀ X_b
    /// ```
    fn add(&mut self, face: &Face, k: &Stiffness) {
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

/// Impulses held, face by face.
fn held_of(faces: &[Face]) -> Vec<Vec<[f64; 3]>> {
    let of = |face: &Face| face.points.iter().map(|point| point.held).collect();
    faces.iter().map(of).collect()
}

fn hold(faces: &mut [Face], held: &[Vec<[f64; 3]>]) {
    for (face, held) in faces.iter_mut().zip(held) {
        for (point, held) in face.points.iter_mut().zip(held) {
            point.held = *held;
        }
    }
}

/// Carries the multipliers over.
fn hold_impulses(faces: &mut [Face]) {
    for face in faces {
        for point in &mut face.points {
            point.held = point.impulse;
        }
    }
}

/// Moves the bounds of friction a part of the way to what the normal impulses give.
fn set_bounds(faces: &mut [Face], part: f64) {
    for face in faces {
        for point in &mut face.points {
            point.bound += part * (point.held[2].max(0.0) - point.bound);
        }
    }
}

/// [r]×.
fn cross(r: DVec3) -> DMat3 {
    DMat3::from_cols(
        DVec3::new(0.0, r.z, -r.y),
        DVec3::new(-r.z, 0.0, r.x),
        DVec3::new(r.y, -r.x, 0.0),
    )
}

/// Bodies in an order in which those that touch lie near each other; without the ground.
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
