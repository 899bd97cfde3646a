//! Solves a step of the rigid law through a sequence of convex problems, if Newton's method on the law itself does not converge.
//!
//! ```text
//! K ∋ p ⊥ u + s + μ |u_t| n ∈ K*,   K = {|p_t| ≤ μ p_n}
//! ```
//!
//! is Coulomb's law with unilateral contact. With the last term fixed (the `lift`), the law is the optimality condition of a convex
//! function, and Newton's method with a line search always converges to its minimum. Then the term and the multipliers are updated,
//! until every point satisfies the law itself.
//!
//! # Source
//! Acary, V., Cadoux, F., Lemaréchal, C. & Malick, J. (2011) A formulation of the linear discrete Coulomb friction problem via convex
//! optimization. ZAMM 91(2), 155-175; de Saxcé, G. & Feng, Z. Q. (1991) for the law.

use super::block_skyline::SIX;
use super::rigid_faces::{Face, Stiffness, add_wrench, velocity};
use super::rigid_point::{ForceTorque, Part};
use super::rigid_solve::{
    Candidate, LEFT_MOST_M_S, Momentum, OFF_MOST_M_S, Pressing, Solved, Solver, ahead, held_of, hold_impulses,
};

/// Largest number of updates of lifts and multipliers; number of updates without improvement after which the method stops. Our
/// choice.
const ROUNDS_MOST: usize = 60;
const WORSE_MOST: usize = 15;
/// Largest number of Newton steps between updates, and of trial points along each step. Our choice.
const STEPS_MOST: usize = 40;
const LINE_MOST: usize = 12;
/// Fraction to which the line search must reduce the slope along a Newton step. Our choice.
const SLOPE_MOST: f64 = 0.5;

impl Solver {
    /// Improves a solution with too large a residual: `v` and the stored impulses become the best solution found.
    pub(super) fn by_cones(
        &mut self,
        of: Momentum<'_>,
        faces: &mut [Face],
        v: &mut Vec<ForceTorque>,
        solved: &mut Solved,
    ) {
        let mut best = Candidate {
            residual_m_s: solved.residual_m_s,
            velocity: v.clone(),
            held: held_of(faces),
        };
        let mut worse = 0;
        for _ in 0..ROUNDS_MOST {
            solved.rounds += 1;
            for face in faces.iter_mut() {
                let twist = face.twist_of(v);
                face.set_lifts(&twist);
            }
            let left = self.newton_on_cones(of, faces, v, &mut solved.newton_steps);
            hold_impulses(faces);
            // residual of the contact law with these impulses
            let mut residual_m_s = left;
            for face in faces.iter_mut() {
                let twist = face.twist_of(v);
                face.contact_force(&twist, false, None);
                residual_m_s = residual_m_s.max(face.residual());
            }
            if residual_m_s < best.residual_m_s {
                best = Candidate {
                    residual_m_s,
                    velocity: v.clone(),
                    held: held_of(faces),
                };
                worse = 0;
            } else {
                worse += 1;
            }
            if residual_m_s <= OFF_MOST_M_S || worse == WORSE_MOST {
                break;
            }
        }
        best.take(faces, v);
        for point in faces.iter_mut().flat_map(|face| &mut face.points) {
            point.impulse = point.held;
        }
        solved.residual_m_s = best.residual_m_s;
    }

    /// Minimises the convex function between two updates; returns the residual of the momentum balance, m/s.
    fn newton_on_cones(
        &mut self,
        of: Momentum<'_>,
        faces: &mut [Face],
        v: &mut [ForceTorque],
        steps: &mut usize,
    ) -> f64 {
        let mut change = vec![[0.0; SIX]; v.len()];
        let mut trial = v.to_vec();
        let mut left = self.balance(of, faces, v, Pressing::OnCones, true).largest_m_s;
        for _ in 0..STEPS_MOST {
            if left <= LEFT_MOST_M_S {
                break;
            }
            *steps += 1;
            let right = self.right.clone();
            if !self.matrix.factor() {
                return f64::INFINITY;
            }
            self.matrix.solve(&mut self.right);
            for (change, row) in change.iter_mut().zip(&self.rows).skip(1) {
                *change = self.right[*row];
            }
            let down = self.along(&right, &change);
            // the function is convex: the slope increases along the step and is 0 at the minimum
            let (mut low, mut at_low, mut high, mut at_high) = (0.0, -down, f64::INFINITY, 0.0);
            let mut part = 1.0;
            for _ in 0..LINE_MOST {
                ahead(&mut trial, v, &change, part);
                self.balance(of, faces, &trial, Pressing::OnCones, false);
                let slope = -self.along(&self.right, &change);
                if slope.abs() <= SLOPE_MOST * down {
                    break;
                }
                if slope > 0.0 {
                    (high, at_high) = (part, slope);
                } else {
                    (low, at_low) = (part, slope);
                }
                part = match high.is_finite() {
                    true => {
                        let straight = low - at_low * (high - low) / (at_high - at_low);
                        straight.clamp(low + 0.1 * (high - low), high - 0.1 * (high - low))
                    }
                    false => 2.0 * part,
                };
            }
            v.copy_from_slice(&trial);
            left = self.balance(of, faces, v, Pressing::OnCones, true).largest_m_s;
        }
        left
    }

    /// Sum over the bodies of the momentum residual times a change of their velocities.
    fn along(&self, right: &[ForceTorque], change: &[ForceTorque]) -> f64 {
        let rows = self.rows.iter().zip(change).skip(1);
        rows.map(|(row, change)| right[*row].iter().zip(change).map(|(r, c)| r * c).sum::<f64>())
            .sum()
    }
}

impl Face {
    /// Sets the lifts μ |u_t| from a twist, for the next convex problem.
    fn set_lifts(&mut self, twist: &ForceTorque) {
        for point in &mut self.points {
            let u = velocity(twist, point.x, point.y);
            point.lift = point.friction * (u[0] + point.offset[0]).hypot(u[1] + point.offset[1]);
        }
    }

    /// Impulses at a twist with fixed lifts, their sum on S, and their derivative, which is symmetric.
    ///
    /// ```text
    /// p = the point of K nearest to λ − ϱ (u + s + lift n), with the norm 1/ϱ
    /// ```
    pub(super) fn press_on_cones(
        &mut self,
        twist: &ForceTorque,
        stiffness: Option<&mut Stiffness>,
    ) -> ForceTorque {
        let wanted = stiffness.is_some();
        let (mut sum, mut k) = ([0.0; 6], [[0.0; 6]; 6]);
        for point in self.points.iter_mut().filter(|point| point.part == Part::Near) {
            let (x, y, r, r_t) = (point.x, point.y, point.weight, point.shear_weight);
            let u = velocity(twist, x, y);
            let trial = [
                point.held[0] - r_t * (u[0] + point.offset[0]),
                point.held[1] - r_t * (u[1] + point.offset[1]),
                point.held[2] - r * (u[2] + point.offset[2] + point.lift),
            ];
            let size = trial[0].hypot(trial[1]);
            // with weights ϱ, the cone has the friction coefficient μ √(ϱ_n/ϱ_t)
            let ratio = point.friction * point.friction * r / r_t;
            let reach = trial[2] + point.friction * (r / r_t) * size;
            if trial[2] >= 0.0 && size <= point.friction * trial[2] {
                point.impulse = trial;
                add_wrench(&mut sum, x, y, &point.impulse);
                if wanted {
                    add_stiffness(&mut k, [x, y], [r_t, 0.0, r_t], [0.0, 0.0, r]);
                }
            } else if reach <= 0.0 {
                point.impulse = [0.0; 3];
            } else {
                let normal = reach / (1.0 + ratio);
                let pull = point.friction * normal;
                let along = [trial[0] / size, trial[1] / size];
                point.impulse = [pull * along[0], pull * along[1], normal];
                add_wrench(&mut sum, x, y, &point.impulse);
                if wanted {
                    let stiff = r / (1.0 + ratio);
                    let (with, across) = (point.friction * point.friction * stiff, r_t * pull / size);
                    let plane = [
                        across + (with - across) * along[0] * along[0],
                        (with - across) * along[0] * along[1],
                        across + (with - across) * along[1] * along[1],
                    ];
                    let both = point.friction * stiff;
                    add_stiffness(&mut k, [x, y], plane, [both * along[0], both * along[1], stiff]);
                }
            }
        }
        if let Some(stiffness) = stiffness {
            let upper = k;
            for (row, values) in k.iter_mut().enumerate() {
                for (value, other) in values.iter_mut().zip(&upper).take(row) {
                    *value = other[row];
                }
            }
            *stiffness = k;
        }
        sum
    }
}

/// Adds Gᵀ k G of a point to the upper half of the stiffness; k in the plane (xx, xy, yy), and k of the normal (with x, with y, with
/// itself).
fn add_stiffness(k: &mut Stiffness, [x, y]: [f64; 2], [a, b, c]: [f64; 3], [d, e, n]: [f64; 3]) {
    // rows of G: (1, 0, 0, 0, 0, −y), (0, 1, 0, 0, 0, x), (0, 0, 1, y, −x, 0)
    let turned = [b * x - a * y, c * x - b * y, e * x - d * y];
    k[0][0] += a;
    k[0][1] += b;
    k[1][1] += c;
    k[0][5] += turned[0];
    k[1][5] += turned[1];
    k[5][5] += turned[1] * x - turned[0] * y;
    for (row, part) in [(0, d), (1, e), (2, n)] {
        k[row][2] += part;
        k[row][3] += part * y;
        k[row][4] -= part * x;
    }
    k[3][3] += n * y * y;
    k[3][4] -= n * x * y;
    k[4][4] += n * x * x;
    k[2][5] += turned[2];
    k[3][5] += turned[2] * y;
    k[4][5] -= turned[2] * x;
}

#[cfg(test)]
mod tests {
    use super::super::patch::Restitution;
    use super::super::rigid_point::Point;
    use super::*;
    use glam::{DMat3, DVec3};

    const FRICTION: f64 = 0.6;

    fn face(held: [f64; 3]) -> Face {
        Face {
            pair: 0,
            plane_body: 0,
            point_body: 1,
            to_ground: DMat3::IDENTITY,
            arms: [DVec3::ZERO; 2],
            points: vec![Point {
                weight: 300.0,
                shear_weight: 120.0,
                friction: FRICTION,
                part: Part::Near,
                held,
                ..Point::at([0.3, -0.2], 1.0)
            }],
            ahead: [0.0; 6],
            restitution: Restitution::default(),
            warm: false,
            swung: false,
            softness: 1.0,
            whole_weight: 0.0,
        }
    }

    /// Inside, outside and opposite the cone, the impulse is the nearest point of the cone in the norm 1/ϱ, by a search over the
    /// cone.
    #[test]
    fn exact_impulses_are_the_nearest_of_the_cone() {
        for held in [
            [1.0, 0.5, 9.0],
            [4.0, -3.0, 2.0],
            [2.0, 1.0, -0.5],
            [0.3, 0.1, -7.0],
        ] {
            let mut one = face(held);
            one.press_on_cones(&[0.0; 6], None);
            let found = one.points[0].impulse;
            let far = |p: [f64; 3]| {
                ((p[0] - held[0]).powi(2) + (p[1] - held[1]).powi(2)) / 120.0
                    + (p[2] - held[2]).powi(2) / 300.0
            };
            let along = [held[0], held[1]].map(|x| x / held[0].hypot(held[1]));
            assert!(found[0].hypot(found[1]) <= FRICTION * found[2] + 1e-12);
            for i in 0..=400 {
                for j in 0..=40 {
                    let normal = 0.025 * f64::from(i);
                    let pull = FRICTION * normal * f64::from(j) / 40.0;
                    let other = [pull * along[0], pull * along[1], normal];
                    assert!(far(found) <= far(other) + 1e-12, "{held:?}: {found:?} {other:?}");
                }
            }
        }
    }

    #[test]
    fn holds_the_stiffness_is_the_derivative_and_symmetric() {
        for held in [[1.0, 0.5, 9.0], [4.0, -3.0, 2.0], [2.0, 1.0, -0.5]] {
            let mut one = face(held);
            let mut k: Stiffness = [[0.0; 6]; 6];
            one.press_on_cones(&[0.0; 6], Some(&mut k));
            for column in 0..6 {
                let mut of = |step: f64| {
                    let mut twist = [0.0; 6];
                    twist[column] = step;
                    one.press_on_cones(&twist, None)
                };
                let (up, down) = (of(1e-6), of(-1e-6));
                for row in 0..6 {
                    let slope = (down[row] - up[row]) / 2e-6;
                    assert!((slope - k[row][column]).abs() < 1e-5, "{held:?} {row} {column}");
                    assert_eq!(k[row][column], k[column][row]);
                }
            }
        }
    }
}
