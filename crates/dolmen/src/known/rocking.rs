//! A rigid rectangular block that rocks freely from one edge of its base to the other, closed forms and quadratures.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | α | `alpha`, `slenderness_rad` | angle between the diagonal and the vertical | rad |
//! | R | `radius` | distance from the edge to the centre of mass | m |
//! | p | `p`, `frequency_parameter_rad_s` | √(W R / I_0), for a rectangle √(3g/4R) | rad/s |
//! | r | `r`, `velocity_ratio` | angular velocity after an impact / before it | – |
//! | θ_0 | `rotation_rad` | rotation at which the block is released | rad |
//! | θ_n | `amplitude_rad` | largest rotation after n impacts | rad |

/// Slenderness α of a block from half its width and half its height, rad: tan α = b/h.
pub fn slenderness_rad(half_width_m: f64, half_height_m: f64) -> f64 {
    half_width_m.atan2(half_height_m)
}

/// Frequency parameter p = √(W R / I_0) = √(3g / 4R) of a uniform rectangle about its edge, rad/s. It describes how fast
/// the block falls and is not a natural frequency.
///
/// # Source
/// Housner, G. W. (1963) Bull. Seism. Soc. Am. 53(2):403-417.
pub fn frequency_parameter_rad_s(half_width_m: f64, half_height_m: f64, gravity_m_s2: f64) -> f64 {
    (0.75 * gravity_m_s2 / half_width_m.hypot(half_height_m)).sqrt()
}

/// Base acceleration above which a block at rest lifts off one edge, m/s²: g tan α = g b/h. In the linear equation of
/// motion, with α instead of tan α, the block lifts off too early.
///
/// # Example
/// ```
/// use dolmen::known::rocking::uplift_acceleration_m_s2;
/// assert!((uplift_acceleration_m_s2(0.2, 1.0, 9.81) - 1.962).abs() < 1e-12); // α g is 1.9365
/// ```
pub fn uplift_acceleration_m_s2(half_width_m: f64, half_height_m: f64, gravity_m_s2: f64) -> f64 {
    gravity_m_s2 * half_width_m / half_height_m
}

/// Ratio of the angular velocities of a uniform rectangle just after and just before an impact, if the impact acts at the
/// new edge, which neither bounces nor slides.
///
/// ```text
/// r = 1 − (m R² / I_0) (1 − cos 2α) = 1 − 1.5 sin² α
/// ```
///
/// # Limits
/// Zero at α = 54.7°, negative above: such a block does not continue to rock.
///
/// # Source
/// Housner (1963). Differs from the source: his r is the ratio of the kinetic energies, the square of this one, see
/// [`housner_energy_ratio`].
pub fn velocity_ratio(slenderness_rad: f64) -> f64 {
    1.0 - 1.5 * slenderness_rad.sin().powi(2)
}

/// r of Housner (1963) as printed: ratio of the kinetic energies just after and just before an impact, with
/// `inertia_ratio` = m R² / I_0, which is ¾ for every uniform rectangle.
///
/// ```text
/// r = [1 − (m R² / I_0) (1 − cos 2α)]²
/// ```
pub fn housner_energy_ratio(slenderness_rad: f64, inertia_ratio: f64) -> f64 {
    (1.0 - inertia_ratio * (1.0 - (2.0 * slenderness_rad).cos())).powi(2)
}

/// Quarter of the period of free rocking by the linear equation, s: from rest at `rotation_rad` to the impact.
///
/// ```text
/// T/4 = (1/p) acosh 1/(1 − θ_0/α)
/// ```
///
/// # Source
/// Housner (1963).
pub fn linear_quarter_period_s(
    slenderness_rad: f64,
    frequency_parameter_rad_s: f64,
    rotation_rad: f64,
) -> f64 {
    (1.0 / (1.0 - rotation_rad / slenderness_rad)).acosh() / frequency_parameter_rad_s
}

/// Quarter of the period of free rocking by the exact equation θ'' = −p² sin(α − θ), s.
///
/// ```text
/// T/4 = (1/p) ∫ dx / √(1 − k² cosh² x), x from 0 to acosh(sin(α/2) / k)      k = sin((α − θ_0)/2)
/// ```
///
/// # Limits
/// 0 < θ_0 < α. Quadrature to 1e-14 of the value for α below 60°.
///
/// # Source
/// Energy: θ'² = 4p² (sin²((α − θ)/2) − k²), and sin((α − θ)/2) = k cosh x, which leaves no singular end.
///
/// # Example
/// ```
/// use dolmen::known::rocking::{frequency_parameter_rad_s, quarter_period_s, slenderness_rad};
/// let alpha = slenderness_rad(0.2, 1.0);
/// let p = frequency_parameter_rad_s(0.2, 1.0, 9.81);
/// assert!((quarter_period_s(alpha, p, 0.5 * alpha) - 0.490864).abs() < 5e-7);
/// ```
pub fn quarter_period_s(slenderness_rad: f64, frequency_parameter_rad_s: f64, rotation_rad: f64) -> f64 {
    let k = (0.5 * (slenderness_rad - rotation_rad)).sin();
    let end = ((0.5 * slenderness_rad).sin() / k).acosh();
    quadrature(|x| 1.0 / (1.0 - (k * x.cosh()).powi(2)).sqrt(), end) / frequency_parameter_rad_s
}

/// ∫ f from 0 to `end`, by Gauss-Legendre quadrature on panels.
fn quadrature(f: impl Fn(f64) -> f64, end: f64) -> f64 {
    const PANELS: u32 = 64; // our choice: 32 give the same 14 digits
    const POINTS: [(f64, f64); 5] = [
        (-0.906_179_845_938_664, 0.236_926_885_056_189_08),
        (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
        (0.0, 0.568_888_888_888_888_9),
        (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
        (0.906_179_845_938_664, 0.236_926_885_056_189_08),
    ];
    let half = 0.5 * end / f64::from(PANELS);
    let panel = |i: u32| {
        let middle = half * f64::from(2 * i + 1);
        POINTS
            .iter()
            .map(|(x, weight)| weight * f(middle + half * x))
            .sum::<f64>()
    };
    half * (0..PANELS).map(panel).sum::<f64>()
}

/// Largest rotation of a block released at `rotation_rad` after a number of impacts, by the linear equation, rad.
///
/// ```text
/// θ_n = α (1 − √(1 − r^2n (1 − (1 − θ_0/α)²)))
/// ```
///
/// # Source
/// Housner (1963), with his r the square of ours.
pub fn linear_amplitude_rad(
    slenderness_rad: f64,
    velocity_ratio: f64,
    rotation_rad: f64,
    impacts: u32,
) -> f64 {
    let left = 1.0 - rotation_rad / slenderness_rad;
    let energy = velocity_ratio.powi(2).powf(f64::from(impacts)) * (1.0 - left * left);
    slenderness_rad * (1.0 - (1.0 - energy).sqrt())
}

/// Exact largest rotation of a block released at `rotation_rad` after a number of impacts, rad.
///
/// ```text
/// sin²((α − θ_n)/2) = sin²(α/2) − r^2n (sin²(α/2) − sin²((α − θ_0)/2))
/// ```
///
/// # Source
/// Energy: a fraction r² remains after each impact.
pub fn amplitude_rad(slenderness_rad: f64, velocity_ratio: f64, rotation_rad: f64, impacts: u32) -> f64 {
    let rest = (0.5 * slenderness_rad).sin().powi(2);
    let released = (0.5 * (slenderness_rad - rotation_rad)).sin().powi(2);
    let energy = velocity_ratio.powi(2).powf(f64::from(impacts)) * (rest - released);
    slenderness_rad - 2.0 * (rest - energy).sqrt().asin()
}

/// Exact times of the first impacts of a block released at rest, s: the first after a quarter of a period, each of the
/// others after half a period for its amplitude.
///
/// # Limits
/// 0 < θ_0 < α. Times are accurate to 1e-13 of their value; amplitudes below 1e-8 rad lose digits.
pub fn impact_times_s(
    slenderness_rad: f64,
    frequency_parameter_rad_s: f64,
    velocity_ratio: f64,
    rotation_rad: f64,
    impacts: u32,
) -> Vec<f64> {
    let mut time = 0.0;
    let mut times = Vec::new();
    for n in 0..impacts {
        let amplitude = amplitude_rad(slenderness_rad, velocity_ratio, rotation_rad, n);
        let quarter = quarter_period_s(slenderness_rad, frequency_parameter_rad_s, amplitude);
        time += if n == 0 { quarter } else { 2.0 * quarter };
        times.push(time);
    }
    times
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALPHA: f64 = 0.197_395_559_849_880_75; // atan 0.2
    const STANDARD: f64 = 9.80665;

    fn near(value: f64, expected: f64, tolerance: f64) {
        assert!(
            (value - expected).abs() <= tolerance,
            "{value} is not {expected} within {tolerance}"
        );
    }

    #[test]
    fn exact_block_of_two_metres() {
        near(slenderness_rad(0.2, 1.0), ALPHA, 1e-16);
        near(frequency_parameter_rad_s(0.2, 1.0, 9.81), 2.686_005, 5e-7);
        near(frequency_parameter_rad_s(0.2, 1.0, STANDARD), 2.685_546, 5e-7);
        near(velocity_ratio(ALPHA), 0.942_308, 5e-7);
        near(
            velocity_ratio(ALPHA).powi(2),
            housner_energy_ratio(ALPHA, 0.75),
            1e-15,
        );
        assert!(uplift_acceleration_m_s2(0.2, 1.0, 9.81) > 1.013 * ALPHA * 9.81);
    }

    #[test]
    fn exact_quarter_period() {
        for (gravity, linear, exact) in [(9.81, 0.490_304, 0.490_864), (STANDARD, 0.490_387, 0.490_948)] {
            let p = frequency_parameter_rad_s(0.2, 1.0, gravity);
            near(linear_quarter_period_s(ALPHA, p, 0.5 * ALPHA), linear, 5e-7);
            near(quarter_period_s(ALPHA, p, 0.5 * ALPHA), exact, 5e-7);
        }
        // A slender block is nearly linear; the difference is proportional to the square of the slenderness.
        near(
            quarter_period_s(1e-5, 1.0, 0.7e-5),
            linear_quarter_period_s(1e-5, 1.0, 0.7e-5),
            1e-9,
        );
    }

    #[test]
    fn exact_amplitude_after_impacts() {
        let r = velocity_ratio(ALPHA);
        for (impacts, linear, exact) in [(1, 0.4220, 0.4222), (5, 0.2345, 0.2348), (20, 0.0354, 0.0355)] {
            near(
                linear_amplitude_rad(ALPHA, r, 0.5 * ALPHA, impacts) / ALPHA,
                linear,
                5e-5,
            );
            near(amplitude_rad(ALPHA, r, 0.5 * ALPHA, impacts) / ALPHA, exact, 5e-5);
        }
    }

    /// The same fall and impacts by numerical integration of the equation of motion, which is independent of the
    /// quadrature.
    #[test]
    fn holds_steps_of_the_equation_of_motion_reach_the_same_impacts() {
        const STEP: f64 = 1e-3;
        let (p, r) = (frequency_parameter_rad_s(0.2, 1.0, 9.81), velocity_ratio(ALPHA));
        let acceleration = |theta: f64| -p * p * (ALPHA - theta).sin();
        let step = |theta: f64, omega: f64, h: f64| {
            let k1 = (omega, acceleration(theta));
            let k2 = (omega + 0.5 * h * k1.1, acceleration(theta + 0.5 * h * k1.0));
            let k3 = (omega + 0.5 * h * k2.1, acceleration(theta + 0.5 * h * k2.0));
            let k4 = (omega + h * k3.1, acceleration(theta + h * k3.0));
            (
                theta + h / 6.0 * (k1.0 + 2.0 * k2.0 + 2.0 * k3.0 + k4.0),
                omega + h / 6.0 * (k1.1 + 2.0 * k2.1 + 2.0 * k3.1 + k4.1),
            )
        };
        let (mut theta, mut omega, mut time) = (0.5 * ALPHA, 0.0, 0.0);
        for expected in impact_times_s(ALPHA, p, r, 0.5 * ALPHA, 20) {
            while step(theta, omega, STEP).0 > 0.0 {
                (theta, omega) = step(theta, omega, STEP);
                time += STEP;
            }
            let part = super::super::bisection::sign_change(|h| step(theta, omega, h).0, 0.0, STEP);
            time += part;
            near(time, expected, 2e-11);
            (theta, omega) = (0.0, -r * step(theta, omega, part).1);
        }
    }
}
