//! One flat bed of the sliding model: pressure that balances a force and a moment, and the available friction.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | x_p, A_p | `place`, `area` | points of the bed in plan, and their tributary areas | m, m² |
//! | N_p | `force_n` | normal force at a point | N |
//! | X | `resultant_m` | point of application of the normal force | m |
//! | u | [`Twist`] | sliding velocity at a reference point, and spin | m/s, rad/s |
//! | W | [`Wrench`] | force and torque about the same point | N, N m |

use glam::{DMat3, DVec2, DVec3};

/// Largest number of iterations in which points without pressure are removed.
const ROUNDS_MOST: usize = 50;
/// Largest number of iterations for the ratio of required to available friction of a joint.
const GAUGE_STEPS_MOST: usize = 40;
/// Smoothing of |u| for that ratio, relative; the error of the ratio is its square.
const GAUGE_SMOOTH: f64 = 1e-6;

/// Squared friction radius of a point's tributary area, over the area, because the area also resists spin about its own point.
/// Without it the centre of rotation would be trapped at a point. Our choice: a quarter of the value for a disc of that area.
/// The resistance of 6 × 6 points to pure twisting is then 1.0 % too large instead of 0.6 %.
const CELL: f64 = 1.0 / (16.0 * std::f64::consts::PI);

/// Sliding and spin of one face on another; the third component is the spin.
pub(super) type Twist = DVec3;
/// Force and torque in the plane of a face; the third component is the torque.
pub(super) type Wrench = DVec3;

/// A rotated by 90°: the velocity of a point at A under unit spin about the origin.
pub(super) fn turned(a: DVec2) -> DVec2 {
    DVec2::new(-a.y, a.x)
}

/// A point with pressure.
#[derive(Clone, Copy, Debug)]
pub(super) struct PressedPoint {
    /// Position relative to the reference point of the joint, m.
    pub(super) arm: DVec2,
    pub(super) area: f64,
    /// Normal force, N.
    pub(super) force: f64,
}

/// Pressure on a bed and its derivative with respect to the resultant.
#[derive(Clone, Debug)]
pub(super) struct Pressure {
    pub(super) points: Vec<PressedPoint>,
    total: f64,
    /// Position of the resultant relative to the reference point.
    pub(super) resultant: DVec2,
    /// (Σ A φ φᵀ)⁻¹ over the loaded points, φ = (1, x, y).
    inverse: DMat3,
}

/// Friction of a sliding bed, and its derivative.
#[derive(Clone, Copy, Debug)]
pub(super) struct Friction {
    pub(super) wrench: Wrench,
    /// −∂W/∂u, positive semidefinite.
    pub(super) stiff: DMat3,
    /// ∂W/∂X, along x and along y.
    pub(super) with_resultant: [Wrench; 2],
}

impl Pressure {
    /// Linear pressure over the points, without tension, with this sum and resultant; `None` if it does not exist, because the
    /// resultant is outside the bed.
    ///
    /// ```text
    /// N_p = A_p max(0, c·φ_p),   Σ N_p φ_p = N (1, X)           φ_p = (1, x_p, y_p)
    /// ```
    pub(super) fn of(points: &[(DVec2, f64)], total: f64, resultant: DVec2) -> Option<Pressure> {
        let shape = |arm: DVec2| DVec3::new(1.0, arm.x, arm.y);
        let target = total * shape(resultant);
        let mut carries = vec![true; points.len()];
        for _ in 0..ROUNDS_MOST {
            let mut sums = DMat3::ZERO;
            for ((arm, area), _) in points.iter().zip(&carries).filter(|(_, carries)| **carries) {
                let phi = shape(*arm);
                sums += DMat3::from_cols(phi * phi.x, phi * phi.y, phi * phi.z) * *area;
            }
            let size = sums.x_axis.x * sums.y_axis.y * sums.z_axis.z;
            let determinant = sums.determinant();
            if determinant.is_nan() || determinant <= 1e-12 * size {
                return None; // the remaining points lie on a line
            }
            let inverse = sums.inverse();
            let plane = inverse * target;
            let mut changed = false;
            for ((arm, _), carries) in points.iter().zip(&mut carries) {
                let now = plane.dot(shape(*arm)) > 0.0;
                changed |= now != *carries;
                *carries = now;
            }
            if !changed {
                let pressed = points.iter().zip(&carries).filter(|(_, carries)| **carries);
                let pressed = pressed.map(|(&(arm, area), _)| PressedPoint {
                    arm,
                    area,
                    force: area * plane.dot(shape(arm)),
                });
                return Some(Pressure {
                    points: pressed.collect(),
                    total,
                    resultant,
                    inverse,
                });
            }
        }
        None
    }

    /// Friction of a face that slides with `u`, whose magnitude is smoothed by `smooth`; `gain` is ∂u/∂(unknowns).
    ///
    /// ```text
    /// W = −μ Σ N_p (t_p, x_p × t_p + r_p² ω/s_p),   t_p = u_p/s_p,   s_p = √(|u_p|² + r_p² ω² + ε²),   u_p = u + ω × x_p
    /// ```
    pub(super) fn friction(&self, mu: f64, u: Twist, smooth: f64) -> Friction {
        let mut friction = Friction {
            wrench: DVec3::ZERO,
            stiff: DMat3::ZERO,
            with_resultant: [DVec3::ZERO; 2],
        };
        // inclination of the pressure plane for a unit shift of the resultant
        let tilt = [DVec3::Y, DVec3::Z].map(|axis| self.inverse * (self.total * axis));
        for point in &self.points {
            let lever = turned(point.arm);
            let velocity = u.truncate() + u.z * lever;
            let cell = CELL * point.area;
            let size = (velocity.length_squared() + cell * u.z * u.z + smooth * smooth).sqrt();
            if size == 0.0 {
                continue; // the centre of rotation itself
            }
            let t = velocity / size;
            let spin = cell * u.z / size;
            let along = DVec3::new(t.x, t.y, lever.dot(t) + spin);
            let unit = -mu * along;
            friction.wrench += point.force * unit;
            let phi = DVec3::new(1.0, point.arm.x, point.arm.y);
            for (derivative, tilt) in friction.with_resultant.iter_mut().zip(tilt) {
                *derivative += point.area * tilt.dot(phi) * unit;
            }
            // (1 − t tᵀ)/|u| for velocities, transformed to the three components by the lever arm
            let weight = mu * point.force / size;
            let (x, y) = (DVec3::new(1.0, 0.0, lever.x), DVec3::new(0.0, 1.0, lever.y));
            for (column, c) in [(0, DVec3::X), (1, DVec3::Y), (2, DVec3::Z)] {
                let image = x * x.dot(c) + y * y.dot(c) + cell * DVec3::Z * c.z - along * along.dot(c);
                *friction.stiff.col_mut(column) += weight * image;
            }
        }
        friction
    }

    /// Equivalent radius for spin, √(Σ N x²/Σ N) about the resultant.
    pub(super) fn radius(&self) -> f64 {
        let moment: f64 = self
            .points
            .iter()
            .map(|p| p.force * (p.arm - self.resultant).length_squared())
            .sum();
        (moment / self.total).sqrt()
    }

    /// Ratio of a wrench to the available friction: 1 where the joint slips, below 1 where it holds.
    ///
    /// ```text
    /// λ = max over u of  −W·u / h(u),   h(u) = μ Σ N_p |u_p|
    /// ```
    pub(super) fn gauge(&self, mu: f64, wrench: Wrench) -> f64 {
        let force = wrench.truncate();
        let torque = wrench.z - self.resultant.perp_dot(force);
        let most = mu * self.total;
        // a combination of pure sliding and pure spin already shows that the joint holds
        let spin = self.friction(mu, turned(self.resultant).extend(0.0) * -1.0 + DVec3::Z, 0.0);
        let (aside, spin) = (
            spin.wrench.truncate().length(),
            (spin.wrench.z - self.resultant.perp_dot(spin.wrench.truncate())).abs(),
        );
        let bound = force.length() / most + torque.abs() * (most + aside) / (spin * most);
        if bound <= 1.0 {
            return bound;
        }
        self.exact_gauge(mu, wrench)
    }

    /// 1 / min h(u) over −W·u = 1, by Newton's method in the remaining two directions.
    fn exact_gauge(&self, mu: f64, wrench: Wrench) -> f64 {
        let radius = self.radius();
        let scale = DVec3::new(1.0, 1.0, 1.0 / radius); // spins as velocities at the radius
        let pull = -wrench * scale;
        let along = pull / pull.length_squared();
        let (b, c) = pull.normalize().any_orthonormal_pair();
        let mut place = DVec2::ZERO;
        let at = |place: DVec2| along + place.x * b + place.y * c;
        let smooth = GAUGE_SMOOTH * along.length();
        let value = |u: DVec3| -> f64 {
            let u = u * scale;
            let of = |p: &PressedPoint| {
                let velocity = u.truncate() + u.z * turned(p.arm);
                let cell = CELL * p.area * u.z * u.z;
                p.force * (velocity.length_squared() + cell + smooth * smooth).sqrt()
            };
            mu * self.points.iter().map(of).sum::<f64>()
        };
        let mut least = value(at(place));
        for _ in 0..GAUGE_STEPS_MOST {
            let friction = self.friction(mu, at(place) * scale, smooth);
            let gradient = -friction.wrench * scale;
            let image = |d: DVec3| (friction.stiff * (d * scale)) * scale;
            let (gb, gc) = (gradient.dot(b), gradient.dot(c));
            let (bb, bc, cc) = (image(b).dot(b), image(b).dot(c), image(c).dot(c));
            let determinant = bb * cc - bc * bc;
            if determinant.is_nan() || determinant <= 0.0 {
                break;
            }
            let step = -DVec2::new(cc * gb - bc * gc, bb * gc - bc * gb) / determinant;
            let slope = step.dot(DVec2::new(gb, gc));
            if slope.abs() < 1e-14 * least {
                break;
            }
            let mut part = 1.0;
            loop {
                let tried = value(at(place + part * step));
                if tried <= least + 1e-4 * part * slope || part < 1e-6 {
                    least = least.min(tried);
                    break;
                }
                part *= 0.5;
            }
            place += part * step;
        }
        1.0 / least
    }
}
