//! Rigid bodies: state and step. Body 0 is the ground, body i + 1 is block i.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | x | `position` | centroid, in the frame of the ground | m |
//! | R | `rotation` | rotation from the axes as drawn | – |
//! | v, ω | `velocity`, `spin` | velocity of the centroid; angular velocity | m/s, rad/s |
//! | L | `momentum` | angular momentum about the centroid | kg m²/s |
//! | J | `inertia` | inertia about the centroid, in the axes as drawn | kg m² |

use crate::structure::stack::{Body, Joint, Stack};
use glam::{DMat3, DQuat, DVec3};

/// Square of the rotation per step up to which the series of its quaternion is used, rad²: 0.05 rad, where its error is below 1e-16.
pub(super) const SERIES_MOST: f64 = 2.5e-3;

/// Index of a body in the bodies of a stack.
pub(super) fn index_of(body: Body) -> usize {
    match body {
        Body::Ground => 0,
        Body::Block(block) => block + 1,
    }
}

/// The bodies of a joint, the lower index first.
pub(super) fn ends_of(joint: &Joint) -> (usize, usize) {
    let (lower, upper) = (index_of(joint.lower), joint.upper + 1);
    (lower.min(upper), lower.max(upper))
}

#[derive(Clone, Debug)]
pub(super) struct RigidBody {
    pub(super) mass: f64,
    pub(super) inverse_mass: f64,
    pub(super) inertia: DMat3,
    pub(super) inverse_inertia: DMat3,
    pub(super) drawn: DVec3,
    pub(super) position: DVec3,
    pub(super) turn: DQuat,
    pub(super) rotation: DMat3,
    pub(super) velocity: DVec3,
    pub(super) momentum: DVec3,
    pub(super) spin: DVec3,
    /// Largest distance of a corner from the centroid, m.
    pub(super) radius: f64,
    /// Upper bound of the path of any of its points, m.
    pub(super) travel: f64,
}

impl RigidBody {
    /// The ground: it does not move and has no weight.
    pub(super) fn ground() -> Self {
        RigidBody {
            mass: 0.0,
            inverse_mass: 0.0,
            inertia: DMat3::ZERO,
            inverse_inertia: DMat3::ZERO,
            drawn: DVec3::ZERO,
            position: DVec3::ZERO,
            turn: DQuat::IDENTITY,
            rotation: DMat3::IDENTITY,
            velocity: DVec3::ZERO,
            momentum: DVec3::ZERO,
            spin: DVec3::ZERO,
            radius: 0.0,
            travel: 0.0,
        }
    }

    pub(super) fn set_spin(&mut self, spin: DVec3) {
        self.momentum = self.rotation * (self.inertia * (self.rotation.transpose() * spin));
        self.spin = spin;
    }

    /// Rotates the body by a rotation vector about its centroid.
    pub(super) fn turn_by(&mut self, vector: DVec3) {
        self.turn = (rotation_of(vector) * self.turn).normalize();
        self.rotation = DMat3::from_quat(self.turn);
    }

    /// One leapfrog step, first velocities, then positions: velocities from t − h/2 to t + h/2 (`kick` = h; h/2 at the start, from
    /// t), positions from t to t + h.
    #[inline]
    pub(super) fn step(&mut self, acceleration: DVec3, torque: DVec3, kick: f64, h: f64) {
        self.velocity += acceleration * kick;
        self.momentum += torque * kick;
        // in the body's axes, where J is constant: L at the start of the step, ω at its middle, as for a free body
        let own = self.rotation.transpose() * self.momentum;
        let start = self.inverse_inertia * own;
        let middle = start + (self.inverse_inertia * own.cross(start)) * (0.5 * h);
        let spin = self.rotation * middle;
        self.spin = spin;
        self.position += self.velocity * h;
        let turned = rotation_of(spin * h) * self.turn;
        self.turn = turned * (1.5 - 0.5 * turned.length_squared()); // normalisation by one Newton step
        self.rotation = DMat3::from_quat(self.turn);
        let (v, w) = (self.velocity.abs(), spin.abs());
        self.travel += (v.x + v.y + v.z + self.radius * (w.x + w.y + w.z)) * h;
    }

    /// Positions after `h` seconds at the present velocities.
    pub(super) fn drift(&mut self, h: f64) {
        self.position += self.velocity * h;
        let turned = rotation_of(self.spin * h) * self.turn;
        self.turn = turned * (1.5 - 0.5 * turned.length_squared()); // normalisation by one Newton step
        self.rotation = DMat3::from_quat(self.turn);
        let (v, w) = (self.velocity.abs(), self.spin.abs());
        self.travel += (v.x + v.y + v.z + self.radius * (w.x + w.y + w.z)) * h.abs();
    }

    /// Moments of inertia after `h` seconds of rotation at the current spin, in the ground's axes.
    pub(super) fn inertia_after(&self, h: f64) -> DMat3 {
        let turn = self.spin * h;
        let rotation = match turn == DVec3::ZERO {
            true => self.rotation,
            false => DMat3::from_quat((rotation_of(turn) * self.turn).normalize()),
        };
        rotation * self.inertia * rotation.transpose()
    }

    /// Present position of a point drawn at `drawn`.
    #[inline]
    pub(super) fn now(&self, drawn: DVec3) -> DVec3 {
        self.position + self.rotation * (drawn - self.drawn)
    }
}

/// Quaternion of a rotation vector.
#[inline]
pub(super) fn rotation_of(vector: DVec3) -> DQuat {
    let square = vector.length_squared();
    if square > SERIES_MOST {
        return DQuat::from_scaled_axis(vector);
    }
    // sin(θ/2)/θ and cos(θ/2)
    let q = 0.25 * square;
    let ([s3, s5, s7], [c2, c4, c6]) = (SINE_SERIES, COSINE_SERIES);
    let sine = 0.5 * (1.0 - q * s3 * (1.0 - q * s5 * (1.0 - q * s7)));
    let cosine = 1.0 - q * c2 * (1.0 - q * c4 * (1.0 - q * c6));
    let v = vector * sine;
    DQuat::from_xyzw(v.x, v.y, v.z, cosine)
}

/// Ratios of the terms of sin x / x and of cos x.
pub(super) const SINE_SERIES: [f64; 3] = [1.0 / 6.0, 1.0 / 20.0, 1.0 / 42.0];
pub(super) const COSINE_SERIES: [f64; 3] = [1.0 / 2.0, 1.0 / 12.0, 1.0 / 30.0];

/// The bodies of a stack as drawn, at rest.
pub(super) fn bodies_of(stack: &Stack) -> Vec<RigidBody> {
    let mut bodies = vec![RigidBody::ground()];
    for block in stack.blocks() {
        let centroid = DVec3::from(block.solid.centroid_m());
        let inertia = without_rounding(block.solid.inertia_m5(), block.density_kg_m3);
        let mass = block.mass_kg();
        let corners = block.solid.vertices_m().iter();
        let radius = corners
            .map(|corner| DVec3::from(*corner).distance(centroid))
            .fold(0.0, f64::max);
        bodies.push(RigidBody {
            mass,
            inverse_mass: 1.0 / mass,
            inertia,
            inverse_inertia: inertia.inverse(),
            drawn: centroid,
            position: centroid,
            radius,
            ..RigidBody::ground()
        });
    }
    bodies
}

/// The inertia without products that are only rounding, for a stone with planes of symmetry.
fn without_rounding(inertia_m5: [[f64; 3]; 3], density_kg_m3: f64) -> DMat3 {
    const ROUNDING: f64 = 1e-14;
    let largest = (0..3).map(|i| inertia_m5[i][i]).fold(0.0, f64::max);
    let mut inertia = inertia_m5;
    for entry in inertia.iter_mut().flatten() {
        *entry = if entry.abs() > ROUNDING * largest {
            *entry * density_kg_m3
        } else {
            0.0
        };
    }
    DMat3::from_cols_array_2d(&inertia)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_a_free_body_keeps_energy_and_momentum_as_it_tumbles() {
        let mut body = RigidBody {
            mass: 2.0,
            inverse_mass: 0.5,
            inertia: DMat3::from_diagonal(DVec3::new(1.0, 2.0, 3.0)),
            inverse_inertia: DMat3::from_diagonal(DVec3::new(1.0, 0.5, 1.0 / 3.0)),
            ..RigidBody::ground()
        };
        body.set_spin(DVec3::new(0.1, 3.0, 0.1)); // about the middle axis, which is unstable: it turns over
        let (energy, momentum) = (body.momentum.dot(body.spin), body.momentum);
        let mut turned_over = false;
        for _ in 0..20_000 {
            body.step(DVec3::ZERO, DVec3::ZERO, 1e-3, 1e-3);
            turned_over |= (body.rotation.transpose() * body.spin).y < -2.0;
        }
        assert!(turned_over);
        assert!((body.momentum.dot(body.spin) / energy - 1.0).abs() < 1e-4);
        assert_eq!(body.momentum, momentum);
        assert!((body.turn.length() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn exact_series_of_a_small_rotation() {
        for angle in [1e-9, 1e-4, 0.0499, 0.3] {
            let vector = DVec3::new(0.6, 0.0, 0.8) * angle;
            let q = rotation_of(vector);
            let exact = DQuat::from_xyzw(
                0.6 * (0.5 * angle).sin(),
                0.0,
                0.8 * (0.5 * angle).sin(),
                (0.5 * angle).cos(),
            );
            assert!((q - exact).length() < 2e-16, "{angle}");
        }
    }
}
