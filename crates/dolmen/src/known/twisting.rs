//! Closed forms of dry friction of a face that spins, or spins and slides, under uniform pressure.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | a, b | `a_m`, `b_m` | sides of a rectangle | m |
//! | R | – | radius of a disc | m |
//! | r̄ | `mean_radius` | mean distance from the centre: torque = μ N r̄ | m |
//! | ε | `epsilon`, `speed_ratio` | sliding velocity of the centre / (ω R) | – |

use std::f64::consts::TAU;

use super::bisection::sign_change;

/// Mean distance of the points of a rectangle from its centre, m. A face that spins about its centre resists with μ N
/// times this distance.
///
/// ```text
/// d/6 + a²/(12 b) ln((b + d)/a) + b²/(12 a) ln((a + d)/b)      d = √(a² + b²)
/// ```
///
/// # Example
/// ```
/// use dolmen::known::twisting::rectangle_mean_radius_m;
/// assert!((rectangle_mean_radius_m(0.3, 0.2) - 0.0968106).abs() < 5e-8);
/// ```
pub fn rectangle_mean_radius_m(a_m: f64, b_m: f64) -> f64 {
    let d = a_m.hypot(b_m);
    d / 6.0
        + a_m * a_m / (12.0 * b_m) * ((b_m + d) / a_m).ln()
        + b_m * b_m / (12.0 * a_m) * ((a_m + d) / b_m).ln()
}

/// Mean distance of the points of a disc from its centre, m: 2R/3.
pub fn disc_mean_radius_m(radius_m: f64) -> f64 {
    2.0 / 3.0 * radius_m
}

/// Deceleration of a uniform rectangle that spins on its face, rad/s²: μ g r̄ / ((a² + b²)/12).
pub fn rectangle_spin_deceleration_rad_s2(
    a_m: f64,
    b_m: f64,
    friction_coefficient: f64,
    gravity_m_s2: f64,
) -> f64 {
    let gyration = (a_m * a_m + b_m * b_m) / 12.0;
    friction_coefficient * gravity_m_s2 * rectangle_mean_radius_m(a_m, b_m) / gyration
}

/// Time until a spin stops under a constant deceleration, s.
pub fn spin_down_time_s(spin_rad_s: f64, deceleration_rad_s2: f64) -> f64 {
    spin_rad_s / deceleration_rad_s2
}

/// Angle of rotation until it stops, rad.
pub fn spin_down_angle_rad(spin_rad_s: f64, deceleration_rad_s2: f64) -> f64 {
    0.5 * spin_rad_s * spin_rad_s / deceleration_rad_s2
}

/// Friction of a disc that spins and slides, relative to that of pure sliding: force / (μ N), torque / (μ N R).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiscFriction {
    /// Component against the sliding.
    pub force: f64,
    /// Moment against the spin, about the centre of the disc.
    pub torque: f64,
}

/// Friction of a disc at a ratio ε = v/(ωR) of sliding to spinning.
///
/// ```text
/// force = (1/π) ∫ −sin φ ρ²/2 dφ      torque = (1/π) ∫ (ρ³/3 + ε sin φ ρ²/2) dφ, φ from 0 to 2π
/// ρ = −ε sin φ + √(1 − ε² cos² φ)
/// ```
///
/// # Limits
/// 0 ≤ ε < 1: the instantaneous centre of rotation lies within the disc. Accuracy 1e-12 below ε = 0.9; NaN above 1.
///
/// # Source
/// Polar coordinates about the instantaneous centre of rotation, where the direction of slip depends only on φ. The
/// coupling is that of Farkas, Z., Bartels, G., Unger, T. and Wolf, D. E. (2003) Phys. Rev. Lett. 90:248302.
pub fn disc_friction(speed_ratio: f64) -> DiscFriction {
    const POINTS: u32 = 512; // our choice: 256 give the same digits below 0.9
    let epsilon = speed_ratio;
    let mut friction = DiscFriction {
        force: 0.0,
        torque: 0.0,
    };
    for i in 0..POINTS {
        let (sin, cos) = (TAU * f64::from(i) / f64::from(POINTS)).sin_cos();
        let rho = if epsilon <= 1.0 {
            -epsilon * sin + (1.0 - (epsilon * cos).powi(2)).sqrt()
        } else {
            f64::NAN
        };
        friction.force -= sin * rho * rho / f64::from(POINTS);
        friction.torque += rho * rho * (2.0 / 3.0 * rho + epsilon * sin) / f64::from(POINTS);
    }
    friction
}

/// Limit of the ratio ε = v/(ωR) for a uniform disc that slides and spins, as both motions stop together. It holds for any
/// start except pure sliding or pure spin.
///
/// ```text
/// force(ε) = 2 ε torque(ε)      the ratio then stays constant: v'/v = ω'/ω
/// ```
///
/// # Source
/// Farkas et al. (2003): 0.653.
///
/// # Example
/// ```
/// use dolmen::known::twisting::disc_final_speed_ratio;
/// assert!((disc_final_speed_ratio() - 0.653).abs() < 5e-4);
/// ```
pub fn disc_final_speed_ratio() -> f64 {
    let drift = |epsilon: f64| {
        let friction = disc_friction(epsilon);
        friction.force - 2.0 * epsilon * friction.torque
    };
    sign_change(drift, 0.1, 0.95)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(value: f64, expected: f64, tolerance: f64) {
        assert!(
            (value - expected).abs() <= tolerance,
            "{value} is not {expected} within {tolerance}"
        );
    }

    #[test]
    fn exact_mean_radius() {
        near(rectangle_mean_radius_m(0.3, 0.2), 0.096_810_6, 5e-8);
        near(rectangle_mean_radius_m(0.2, 0.3), 0.096_810_6, 5e-8);
        near(rectangle_mean_radius_m(1.0, 1.0), 0.382_598, 5e-7);
        near(rectangle_mean_radius_m(1.0, 1e-6), 0.25, 1e-6); // a line
        near(disc_mean_radius_m(0.3), 0.2, 1e-16);
    }

    #[test]
    fn exact_spin_down() {
        for (gravity, time, angle) in [(9.81, 0.114_07, 16.339), (9.80665, 0.114_11, 16.345)] {
            let deceleration = rectangle_spin_deceleration_rad_s2(0.3, 0.2, 0.5, gravity);
            near(spin_down_time_s(5.0, deceleration), time, 5e-6);
            near(spin_down_angle_rad(5.0, deceleration).to_degrees(), angle, 5e-4);
        }
    }

    #[test]
    fn published_disc_stops_sliding_and_spinning_together() {
        near(disc_final_speed_ratio(), 0.653, 5e-4);
    }

    /// Sums over small squares of the disc, independent of polar coordinates.
    #[test]
    fn holds_friction_of_small_squares() {
        const SIDE: i32 = 1000; // squares per radius
        for epsilon in [0.0, 0.3, 0.653, 0.9] {
            let (mut force, mut torque, mut squares) = (0.0, 0.0, 0.0);
            for i in -SIDE..SIDE {
                for j in -SIDE..SIDE {
                    let [x, y] = [i, j].map(|i| (f64::from(i) + 0.5) / f64::from(SIDE));
                    let (u, v) = (epsilon - y, x);
                    if x * x + y * y < 1.0 {
                        force += u / u.hypot(v);
                        torque += (x * v - y * u) / u.hypot(v);
                        squares += 1.0;
                    }
                }
            }
            let friction = disc_friction(epsilon);
            near(force / squares, friction.force, 2e-5);
            near(torque / squares, friction.torque, 2e-5);
        }
    }
}
