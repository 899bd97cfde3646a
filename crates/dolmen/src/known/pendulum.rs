//! A rigid pendulum at any amplitude.

use std::f64::consts::TAU;

/// Period, s, of a pendulum with amplitude `amplitude_rad`; ω² = G/M for small oscillations.
///
/// ```text
/// T = (4/ω) K(sin A/2) = 2π / (ω agm(1, cos A/2))
/// ```
///
/// # Source
/// Gauss; Landau and Lifshitz, Mechanics, § 11, problem 1.
///
/// # Example
/// ```
/// use dolmen::known::pendulum::period_s;
/// // K(√½) = Γ(1/4)² / (4 √π) = 1.8540746773013719
/// let quarter = period_s(std::f64::consts::FRAC_PI_2, 1.0) / 4.0;
/// assert!((quarter - 1.854_074_677_301_371_9).abs() < 1e-14);
/// ```
pub fn period_s(amplitude_rad: f64, small_swings_rad_s: f64) -> f64 {
    let (mut a, mut b) = (1.0, (0.5 * amplitude_rad).cos());
    while (a - b).abs() > 1e-15 * a {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    TAU / (small_swings_rad_s * a)
}
