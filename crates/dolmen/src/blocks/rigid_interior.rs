//! Interior-point method for a solution, if Newton's method on the law itself does not converge.
//!
//! ```text
//! M v − b − Σ Gᵀ p = 0
//! y   = u_n + s_n,   p_n y = τ                                    unilateral contact
//! z_t = u_t + s_t,   (μ p_n, p_t) ∘ (z_0, z_t) = (τ, 0, 0)        Coulomb's disc; z_0 tends to the speed of slip
//! ```
//!
//! ∘ is the product of the second-order cone. Newton steps on these equations reduce τ towards 0, where they are the law. p, y and z stay
//! inside their cones, so no point changes its state at once, and the number of steps hardly depends on how many points open, close or
//! slip. A step solves one system with the 6 × 6 blocks of the bodies, because the unknowns of each point are eliminated:
//!
//! ```text
//! Δp = a − K G Δv,   (M + Σ Gᵀ K G) Δv = b − M v + Σ Gᵀ (p + a)
//! ```
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | p | `impulse` | impulse on S: two components along the plane, one along the normal | N s |
//! | y, z | `opening`, `slip` | velocity along the normal; z_0, then the velocity along the plane | m/s |
//! | K | `plane`, `follows`, `stiff` | along the plane (xx, xy, yy), of the friction with the normal, along the normal | kg |
//! | a | `constant` | change of the impulse if no velocity changes | N s |
//! | W = η [w_0, w_tᵀ; w_t, 1 + w_t w_tᵀ/(1 + w_0)] | `Scaling` | maps z to the same vector as W⁻¹ maps (μ p_n, p_t) | |
//!
//! # Source
//! Nesterov, Y. E. & Todd, M. J. (1998) SIAM J. Optim. 8:324-364 (scaling of the cone); Mehrotra, S. (1992) SIAM J. Optim. 2:575-601
//! (predictor and corrector); Pougkakiotis, S. & Gondzio, J. (2021) Comput. Optim. Appl. 78:307-351 (proximal terms). Differs from the
//! sources: the disc follows the pressure, so the problem is no minimum and the matrix is not symmetric. The proximal terms (p − λ)/ϱ of each
//! step, with λ the last impulse, keep K below ϱ, so that the matrix is no worse than in Newton's method on the law.

use super::block_skyline::SIX;
use super::rigid_faces::{Face, Stiffness, add_stiffness, add_wrench, velocity};
use super::rigid_point::{ForceTorque, Part};
use super::rigid_solve::{LEFT_MOST_M_S, Momentum, OFF_MOST_M_S, Solved, Solver, ahead};

/// Largest number of steps. Our choice.
const STEPS_MOST: usize = 40;
/// √(τ/ϱ) at which the method ends, m/s. It bounds the residual of the law. Our choice: a hundredth of the impulse of a step of 1 ms, over ϱ.
const APART_M_S: f64 = 1e-9;
/// Fraction of the largest step inside the cones. Our choice, the usual one.
const INSIDE: f64 = 0.99;
/// Mass that a point stops, over ϱ: the reciprocal of the hardness of the weights.
const MASS_PART: f64 = 1e-5;
/// Friction coefficient below which a point has no friction here. Our choice.
const FRICTION_LEAST: f64 = 1e-6;
/// Smallest velocity scale of a start, m/s. Our choice.
const SCALE_LEAST_M_S: f64 = 1e-6;
/// Largest part of the disc that friction uses at the start. Our choice.
const DISC_PART: f64 = 0.7;

type Three = [f64; 3];

/// A near point inside its cones, and what a step needs of it.
#[derive(Clone, Copy, Debug, Default)]
struct Inside {
    x: f64,
    y: f64,
    friction: f64,
    /// 1/ϱ along the normal and along the plane, 1/kg.
    soft: [f64; 2],
    offset: Three,
    impulse: Three,
    opening: f64,
    slip: Three,
    scaling: Scaling,
    /// u + s minus z_t and y, along the plane, then along the normal, m/s.
    left: Three,
    stiff: f64,
    plane: Three,
    /// (1 + S/ϱ_t)⁻¹, as `plane`.
    soften: Three,
    follows: [f64; 2],
    constant: Three,
    change: Three,
    change_opening: f64,
    change_slip: Three,
    /// Right sides of the two complementarities, the second one times W.
    wanted: f64,
    wanted_cone: Three,
}

/// Scaling of Nesterov and Todd: W = η [w_0, w_tᵀ; w_t, 1 + w_t w_tᵀ/(1 + w_0)].
#[derive(Clone, Copy, Debug, Default)]
struct Scaling {
    eta: f64,
    w: Three,
}

/// √(x² + y²), in a tenth of the time of `hypot`, which also guards against overflow.
fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// x_0² − |x_t|².
fn det(x: &Three) -> f64 {
    let size = length(x[1], x[2]);
    (x[0] - size) * (x[0] + size)
}

impl Scaling {
    fn of(p: &Three, z: &Three) -> Self {
        let (size_p, size_z) = (det(p).sqrt(), det(z).sqrt());
        let (p, z) = (p.map(|x| x / size_p), z.map(|x| x / size_z));
        let gamma = (0.5 * (1.0 + p[0] * z[0] + p[1] * z[1] + p[2] * z[2])).sqrt();
        let w = [p[0] + z[0], p[1] - z[1], p[2] - z[2]].map(|x| x / (2.0 * gamma));
        // w has unit determinant; its first component from the others, so that rounding cannot leave the cone
        let w_0 = (1.0 + w[1] * w[1] + w[2] * w[2]).sqrt();
        Scaling {
            eta: (size_p / size_z).sqrt(),
            w: [w_0, w[1], w[2]],
        }
    }

    fn times(&self, x: &Three) -> Three {
        self.applied(x, 1.0, self.eta)
    }

    fn inverse_times(&self, x: &Three) -> Three {
        self.applied(x, -1.0, 1.0 / self.eta)
    }

    fn applied(&self, x: &Three, sign: f64, eta: f64) -> Three {
        let [w_0, w_1, w_2] = self.w;
        let along = w_1 * x[1] + w_2 * x[2];
        let part = sign * x[0] + along / (1.0 + w_0);
        [
            eta * (w_0 * x[0] + sign * along),
            eta * (x[1] + part * w_1),
            eta * (x[2] + part * w_2),
        ]
    }
}

/// Product of the cone.
fn product(a: &Three, b: &Three) -> Three {
    [
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
        a[0] * b[1] + b[0] * a[1],
        a[0] * b[2] + b[0] * a[2],
    ]
}

/// u with a ∘ u = x.
fn divided(a: &Three, x: &Three) -> Three {
    let first = (a[0] * x[0] - a[1] * x[1] - a[2] * x[2]) / det(a);
    [first, (x[1] - first * a[1]) / a[0], (x[2] - first * a[2]) / a[0]]
}

/// Largest part of a change that stays in the cone.
fn most_in_cone(at: &Three, change: &Three) -> f64 {
    let a = det(change);
    let b = at[0] * change[0] - at[1] * change[1] - at[2] * change[2];
    let c = det(at);
    let inside = b * b - a * c;
    if a < 0.0 || (b < 0.0 && inside >= 0.0) {
        return c / (-b + inside.max(0.0).sqrt());
    }
    f64::INFINITY
}

/// Largest part of a change that keeps a number positive.
fn most_positive(at: f64, change: f64) -> f64 {
    if change < 0.0 { -at / change } else { f64::INFINITY }
}

impl Inside {
    /// (μ p_n, p_t).
    fn cone(&self) -> Three {
        [self.friction * self.impulse[2], self.impulse[0], self.impulse[1]]
    }

    fn cone_change(&self) -> Three {
        [self.friction * self.change[2], self.change[0], self.change[1]]
    }

    fn slides(&self) -> bool {
        self.friction > FRICTION_LEAST
    }

    /// Sets scaling, residuals and K at a twist, and the predictor's right sides.
    fn prepare(&mut self, twist: &ForceTorque) {
        let u = velocity(twist, self.x, self.y);
        let p = self.impulse;
        self.left = [
            u[0] + self.offset[0] - self.slip[1],
            u[1] + self.offset[1] - self.slip[2],
            u[2] + self.offset[2] - self.opening,
        ];
        self.stiff = p[2] / (self.opening + p[2] * self.soft[0]);
        self.wanted = -p[2] * self.opening;
        self.plane = [0.0; 3];
        self.follows = [0.0; 2];
        if self.slides() {
            let cone = self.cone();
            self.scaling = Scaling::of(&cone, &self.slip);
            self.wanted_cone = cone.map(|x| -x);
            let (plane, soften) = self.planes();
            (self.plane, self.soften) = (plane, soften);
            let coupling = self.coupling();
            self.follows = times(&soften, &coupling).map(|x| x * self.stiff);
        }
    }

    /// h = H_t0 μ / H_00.
    fn coupling(&self) -> [f64; 2] {
        let [w_0, w_1, w_2] = self.scaling.w;
        let part = 2.0 * w_0 * self.friction / (1.0 + 2.0 * (w_1 * w_1 + w_2 * w_2));
        [part * w_1, part * w_2]
    }

    /// K_t = (1 + S/ϱ_t)⁻¹ S and (1 + S/ϱ_t)⁻¹, each xx, xy, yy.
    fn planes(&self) -> (Three, Three) {
        let [_, w_1, w_2] = self.scaling.w;
        let size = length(w_1, w_2);
        let along = if size > 0.0 {
            [w_1 / size, w_2 / size]
        } else {
            [1.0, 0.0]
        };
        let across = self.scaling.eta * self.scaling.eta;
        let with = across / (1.0 + 2.0 * size * size);
        let of = |with: f64, across: f64| {
            [
                across + (with - across) * along[0] * along[0],
                (with - across) * along[0] * along[1],
                across + (with - across) * along[1] * along[1],
            ]
        };
        let soft = self.soft[1];
        let (part_with, part_across) = (1.0 / (1.0 + soft * with), 1.0 / (1.0 + soft * across));
        (
            of(with * part_with, across * part_across),
            of(part_with, part_across),
        )
    }

    /// Sets a = Δp for Δv = 0.
    fn set_constant(&mut self) {
        let normal =
            self.wanted / (self.opening + self.impulse[2] * self.soft[0]) - self.stiff * self.left[2];
        self.constant = [0.0, 0.0, normal];
        if self.slides() {
            let [w_0, w_1, w_2] = self.scaling.w;
            let ratio = 2.0 * w_0 / (1.0 + 2.0 * (w_1 * w_1 + w_2 * w_2));
            let m = self.wanted_cone;
            let free = [
                m[1] - ratio * w_1 * m[0] + ratio * w_1 * self.friction * normal,
                m[2] - ratio * w_2 * m[0] + ratio * w_2 * self.friction * normal,
            ];
            let free = times(&self.soften, &free);
            let back = times(&self.plane, &[self.left[0], self.left[1]]);
            self.constant[0] = free[0] - back[0];
            self.constant[1] = free[1] - back[1];
        }
    }

    /// Sets the changes from the change of the twist.
    fn follow(&mut self, change: &ForceTorque) {
        let u = velocity(change, self.x, self.y);
        self.change[2] = self.constant[2] - self.stiff * u[2];
        self.change_opening = u[2] + self.soft[0] * self.change[2] + self.left[2];
        if !self.slides() {
            return;
        }
        let back = times(&self.plane, &[u[0], u[1]]);
        for axis in 0..2 {
            self.change[axis] = self.constant[axis] - back[axis] - self.follows[axis] * u[2];
            self.change_slip[1 + axis] = u[axis] + self.soft[1] * self.change[axis] + self.left[axis];
        }
        // ΔP = W q − H ΔZ, first row
        let [w_0, w_1, w_2] = self.scaling.w;
        let eta_2 = self.scaling.eta * self.scaling.eta;
        let cross = 2.0 * eta_2 * w_0 * (w_1 * self.change_slip[1] + w_2 * self.change_slip[2]);
        let h_00 = eta_2 * (1.0 + 2.0 * (w_1 * w_1 + w_2 * w_2));
        self.change_slip[0] = (self.wanted_cone[0] - self.friction * self.change[2] - cross) / h_00;
    }

    /// Sets the right sides of the corrector for a target τ.
    fn correct(&mut self, tau: f64) {
        self.wanted = tau - self.impulse[2] * self.opening - self.change[2] * self.change_opening;
        if self.slides() {
            let scaled = self.scaling.times(&self.slip);
            let first = self.scaling.inverse_times(&self.cone_change());
            let second = self.scaling.times(&self.change_slip);
            let both = product(&first, &second);
            let part = divided(&scaled, &[tau - both[0], -both[1], -both[2]]);
            let q = [part[0] - scaled[0], part[1] - scaled[1], part[2] - scaled[2]];
            self.wanted_cone = self.scaling.times(&q);
        }
    }

    /// Largest part of the changes that stays inside.
    fn most(&self) -> f64 {
        let normal = most_positive(self.impulse[2], self.change[2])
            .min(most_positive(self.opening, self.change_opening));
        if !self.slides() {
            return normal;
        }
        normal
            .min(most_in_cone(&self.cone(), &self.cone_change()))
            .min(most_in_cone(&self.slip, &self.change_slip))
    }

    /// Number of complementarities.
    fn terms(&self) -> f64 {
        if self.slides() { 2.0 } else { 1.0 }
    }

    /// Sum of the products of the complementarities after a part of the changes, J; each of them is τ in the end of a step.
    fn gap(&self, part: f64) -> f64 {
        let ahead = |at: f64, change: f64| at + part * change;
        let mut gap = ahead(self.impulse[2], self.change[2]) * ahead(self.opening, self.change_opening);
        if self.slides() {
            let (p, dp) = (self.cone(), self.cone_change());
            for axis in 0..3 {
                gap += ahead(p[axis], dp[axis]) * ahead(self.slip[axis], self.change_slip[axis]);
            }
        }
        gap
    }

    /// Adds a part of the changes.
    fn advance(&mut self, part: f64) {
        for axis in 0..3 {
            self.impulse[axis] += part * self.change[axis];
            self.slip[axis] += part * self.change_slip[axis];
        }
        self.opening += part * self.change_opening;
    }
}

/// A symmetric 2 × 2 matrix times a vector.
fn times(k: &Three, x: &[f64; 2]) -> [f64; 2] {
    [k[0] * x[0] + k[1] * x[1], k[1] * x[0] + k[2] * x[1]]
}

impl Solver {
    /// Finds a solution from initial velocities `v`; the faces store its impulses. Returns whether there is one: momentum balances and every
    /// point satisfies the law as accurately as by Newton's method.
    pub(super) fn by_interior(
        &mut self,
        of: Momentum<'_>,
        faces: &mut [Face],
        v: &mut [ForceTorque],
        solved: &mut Solved,
    ) -> bool {
        let scale = self.velocity_scale(of, faces, v);
        let mut inside: Vec<Vec<Inside>> = faces.iter().map(|face| face.inside(v, scale)).collect();
        let weights: f64 = inside.iter().flatten().map(|point| 1.0 / point.soft[0]).sum();
        let terms: f64 = inside.iter().flatten().map(Inside::terms).sum();
        let mut change = vec![[0.0; SIX]; v.len()];
        solved.rounds += 1;
        for _ in 0..STEPS_MOST {
            for (face, points) in faces.iter().zip(&mut inside) {
                let twist = face.twist_of(v);
                points.iter_mut().for_each(|point| point.prepare(&twist));
            }
            let gap: f64 = inside.iter().flatten().map(|point| point.gap(0.0)).sum();
            let left = self.unbalanced(of, faces, &inside, v);
            if !left.is_finite() || !gap.is_finite() {
                return false;
            }
            if gap <= APART_M_S * APART_M_S * weights && left <= LEFT_MOST_M_S {
                let now = law_left(faces, &inside, v);
                if now <= OFF_MOST_M_S {
                    solved.residual_m_s = left.max(now);
                    return true;
                }
            }
            solved.newton_steps += 1;
            self.gather(of, faces, &mut inside, v, true);
            if !self.matrix.factor() {
                return false;
            }
            self.follow(faces, &mut inside, &mut change);
            let part = inside.iter().flatten().map(Inside::most).fold(1.0, f64::min);
            let then: f64 = inside.iter().flatten().map(|point| point.gap(part)).sum();
            let tau = (then / gap).clamp(0.0, 1.0).powi(3) * gap / terms;
            inside.iter_mut().flatten().for_each(|point| point.correct(tau));
            self.gather(of, faces, &mut inside, v, false);
            self.follow(faces, &mut inside, &mut change);
            let most = inside
                .iter()
                .flatten()
                .map(Inside::most)
                .fold(f64::INFINITY, f64::min);
            let part = (INSIDE * most).min(1.0);
            inside.iter_mut().flatten().for_each(|point| point.advance(part));
            let from = v.to_vec();
            ahead(v, &from, &change, part);
        }
        false
    }

    /// Sets the changes of bodies and points from the factors and the right side.
    fn follow(&mut self, faces: &[Face], inside: &mut [Vec<Inside>], change: &mut [ForceTorque]) {
        self.matrix.solve(&mut self.right);
        for (change, row) in change.iter_mut().zip(&self.rows).skip(1) {
            *change = self.right[*row];
        }
        for (face, points) in faces.iter().zip(inside) {
            let twist = face.twist_of(change);
            points.iter_mut().for_each(|point| point.follow(&twist));
        }
    }

    /// Residual of the momentum balance with the impulses, m/s.
    fn unbalanced(
        &mut self,
        of: Momentum<'_>,
        faces: &[Face],
        inside: &[Vec<Inside>],
        v: &[ForceTorque],
    ) -> f64 {
        self.momentum_left(of, v, false);
        for (face, points) in faces.iter().zip(inside) {
            let mut sum = [0.0; 6];
            points
                .iter()
                .for_each(|point| add_wrench(&mut sum, point.x, point.y, &point.impulse));
            self.push(face, &sum);
        }
        self.left(of).largest_m_s
    }

    /// Sets the right side of a step and, on request, its matrix.
    fn gather(
        &mut self,
        of: Momentum<'_>,
        faces: &[Face],
        inside: &mut [Vec<Inside>],
        v: &[ForceTorque],
        with_matrix: bool,
    ) {
        self.momentum_left(of, v, with_matrix);
        for (face, points) in faces.iter().zip(inside) {
            let mut sum = [0.0; 6];
            let mut k: Stiffness = [[0.0; 6]; 6];
            for point in points.iter_mut() {
                point.set_constant();
                let p = std::array::from_fn(|axis| point.impulse[axis] + point.constant[axis]);
                add_wrench(&mut sum, point.x, point.y, &p);
                if with_matrix {
                    let at = [point.x, point.y];
                    add_stiffness(&mut k, at, point.plane, point.stiff, Some(point.follows));
                }
            }
            self.push(face, &sum);
            if with_matrix {
                k[1][0] = k[0][1];
                k[5][0] = k[0][5];
                k[5][1] = k[1][5];
                k[3][2] = k[2][3];
                k[4][2] = k[2][4];
                k[4][3] = k[3][4];
                self.add(face, &k);
            }
        }
    }

    /// Largest velocity that the step changes.
    fn velocity_scale(&mut self, of: Momentum<'_>, faces: &[Face], v: &[ForceTorque]) -> f64 {
        self.momentum_left(of, v, false);
        let mut scale: f64 = self.left(of).largest_m_s;
        for face in faces {
            let twist = face.twist_of(v);
            for point in face.points.iter().filter(|point| point.part == Part::Near) {
                let u = velocity(&twist, point.x, point.y);
                scale = scale.max(-u[2] - point.offset[2]);
            }
        }
        scale.max(SCALE_LEAST_M_S)
    }
}

/// Stores the impulses as multipliers; returns the residual of the law itself with them, m/s.
fn law_left(faces: &mut [Face], inside: &[Vec<Inside>], v: &[ForceTorque]) -> f64 {
    let mut left = 0.0_f64;
    for (face, points) in faces.iter_mut().zip(inside) {
        let near = face.points.iter_mut().filter(|point| point.part == Part::Near);
        for (point, of) in near.zip(points) {
            point.held = of.impulse;
        }
        let twist = face.twist_of(v);
        face.contact_force(&twist, false, None);
        left = left.max(face.residual());
        for point in &mut face.points {
            point.impulse = point.held;
        }
    }
    left
}

impl Face {
    /// The near points at the start, well inside their cones.
    fn inside(&self, v: &[ForceTorque], scale: f64) -> Vec<Inside> {
        let twist = self.twist_of(v);
        let near = self.points.iter().filter(|point| point.part == Part::Near);
        near.map(|point| {
            let u = velocity(&twist, point.x, point.y);
            let typical = MASS_PART * point.weight * scale;
            let normal = point.held[2].max(0.0) + typical;
            let size = length(point.held[0], point.held[1]);
            let limit = DISC_PART * point.friction * normal;
            let keep = if size > limit { limit / size } else { 1.0 };
            let slip = [u[0] + point.offset[0], u[1] + point.offset[1]];
            Inside {
                x: point.x,
                y: point.y,
                friction: point.friction,
                soft: [1.0 / point.weight, 1.0 / point.shear_weight],
                offset: point.offset,
                impulse: [keep * point.held[0], keep * point.held[1], normal],
                opening: (u[2] + point.offset[2]).max(0.0) + scale,
                slip: [length(slip[0], slip[1]) + scale, slip[0], slip[1]],
                ..Inside::default()
            }
        })
        .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::patch::Restitution;
    use super::super::rigid_point::Point;
    use super::super::rigid_solve::Inertia;
    use super::*;
    use glam::{DMat3, DVec3};

    const FRICTION: f64 = 0.6;
    const MASS_KG: f64 = 10.0;

    /// A chain of cubes of 1 m on the ground, with four points in each joint.
    struct Chain {
        inertia: Vec<Inertia>,
        faces: Vec<Face>,
        solver: Solver,
    }

    fn chain(stones: usize) -> Chain {
        let turning = DMat3::from_diagonal(DVec3::splat(MASS_KG / 6.0));
        let stone = Inertia {
            mass: MASS_KG,
            turning,
            radius: 1.0,
        };
        let touching: Vec<[usize; 2]> = (0..stones).map(|below| [below, below + 1]).collect();
        let face = |below: usize| {
            let at = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]];
            let points = at.map(|at| Point {
                friction: FRICTION,
                part: Part::Near,
                ..Point::at(at, 0.25)
            });
            let mut face = Face {
                pair: below,
                plane_body: below,
                point_body: below + 1,
                to_ground: DMat3::IDENTITY,
                arms: [DVec3::new(0.0, 0.0, 0.5), DVec3::new(0.0, 0.0, -0.5)],
                points: points.to_vec(),
                ahead: [0.0; 6],
                restitution: Restitution::default(),
                warm: false,
                swung: false,
                softness: 1.0,
                whole_weight: 1e5 * MASS_KG * (stones - below) as f64,
            };
            face.weigh();
            face
        };
        Chain {
            inertia: vec![stone; stones + 1],
            faces: (0..stones).map(face).collect(),
            solver: Solver::of(stones + 1, &touching),
        }
    }

    impl Chain {
        /// Velocities after an impulse on each stone, from rest.
        fn pushed(&mut self, free: &[ForceTorque]) -> Option<Vec<ForceTorque>> {
            let of = Momentum {
                inertia: &self.inertia,
                free,
            };
            let (mut v, mut solved) = (vec![[0.0; SIX]; free.len()], Solved::default());
            let found = self.solver.by_interior(of, &mut self.faces, &mut v, &mut solved);
            found.then_some(v)
        }
    }

    /// A cube that is pushed sticks, slides, or leaves the ground, as by Coulomb's law; pushed above its middle it slides as long as it does
    /// not tip.
    #[test]
    fn exact_a_cube_sticks_slides_or_leaves() {
        let down = -0.1 * MASS_KG;
        for (push, up, expected) in [
            (0.03, down, [0.0, 0.0]),
            (0.09, down, [0.09 - 0.6 * 0.1, 0.0]),
            (0.2, 0.3 * MASS_KG, [0.2, 0.3]),
        ] {
            // the torque about the centre cancels that of friction, so that the cube does not tip
            let friction = if up < 0.0 {
                (push * MASS_KG).min(-FRICTION * up)
            } else {
                0.0
            };
            let free = [[0.0; SIX], [push * MASS_KG, 0.0, up, 0.0, -0.5 * friction, 0.0]];
            let v = chain(1).pushed(&free).unwrap();
            for (found, exact) in v[1].iter().zip([expected[0], 0.0, expected[1], 0.0, 0.0, 0.0]) {
                assert!((found - exact).abs() < 2e-8, "{push}: {:?}", v[1]);
            }
        }
    }

    /// All joints of a tower open and slip at once: momentum balances, and each point satisfies the law, by other formulas than those of the
    /// method.
    #[test]
    fn holds_the_law_where_all_joints_open_at_once() {
        let stones = 40;
        let mut of = chain(stones);
        let free: Vec<ForceTorque> = (0..=stones)
            .map(|i| {
                let way = [0.31, -0.17, 0.2, 0.23, -0.29, 0.11];
                std::array::from_fn(|axis| 2.0 * MASS_KG * way[axis] * (1.7 * (i * (axis + 2)) as f64).sin())
            })
            .collect();
        let v = of.pushed(&free).unwrap();
        let mut open = 0;
        let mut left = free.clone();
        for (body, left) in left.iter_mut().enumerate().skip(1) {
            for (axis, left) in left.iter_mut().enumerate() {
                let inertia = if axis < 3 { MASS_KG } else { MASS_KG / 6.0 };
                *left -= inertia * v[body][axis];
            }
        }
        for face in &of.faces {
            for point in &face.points {
                let (p, at) = (DVec3::from(point.impulse), [point.x, point.y]);
                let speed = |body: usize, z: f64| {
                    let [x, y, up, a, b, c] = if body > 0 { v[body] } else { [0.0; 6] };
                    DVec3::new(x, y, up) + DVec3::new(a, b, c).cross(DVec3::new(at[0], at[1], z))
                };
                let u = speed(face.point_body, -0.5) - speed(face.plane_body, 0.5);
                let (slip, pull) = (u.truncate(), p.truncate());
                open += usize::from(u.z > 1e-6);
                assert!(p.z >= 0.0 && u.z > -1e-8 && p.z * u.z < 1e-7, "{p} {u}");
                assert!(pull.length() <= FRICTION * p.z + 1e-8, "{p} {u}");
                assert!(
                    (slip * FRICTION * p.z + pull * slip.length()).length() < 1e-7,
                    "{p} {u}"
                );
                for (body, z, sign) in [(face.point_body, -0.5, 1.0), (face.plane_body, 0.5, -1.0)] {
                    let torque = DVec3::new(at[0], at[1], z).cross(p);
                    let all = [p.x, p.y, p.z, torque.x, torque.y, torque.z];
                    left[body]
                        .iter_mut()
                        .zip(all)
                        .for_each(|(left, p)| *left += sign * p);
                }
            }
        }
        assert!(open >= stones / 2 && open < 4 * stones, "{open} points open");
        let most = left
            .iter()
            .skip(1)
            .flatten()
            .fold(0.0_f64, |most, x| most.max(x.abs()));
        assert!(most < 1e-7, "{most} N s");
    }

    #[test]
    fn exact_scaling_maps_both_sides_to_one_vector() {
        for (p, z) in [
            ([1.0, 0.3, -0.2], [0.1, 0.02, 0.05]),
            ([2.0, 1.99, 0.01], [1e-3, -9.9e-4, 0.0]),
        ] {
            let scaling = Scaling::of(&p, &z);
            let (one, other) = (scaling.times(&z), scaling.inverse_times(&p));
            for (one, other) in one.iter().zip(other) {
                assert!((one - other).abs() < 1e-12, "{one} {other}");
            }
            let back = product(&p, &divided(&p, &z));
            assert!(
                back.iter().zip(z).all(|(back, z)| (back - z).abs() < 1e-12),
                "{back:?}"
            );
        }
    }
}
