//! Oscillators with Coulomb friction: closed forms.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | k, f | `stiffness`, `slip_force` | spring and slip force | N/m, N |
//! | g | `frequency_ratio` | frequency of the force over the natural one, ω/ω_n | – |
//! | r | `friction_ratio` | slip force over amplitude of the force, f/P | – |
//! | V, U, S | `v`, `u`, `s` | functions of g | – |

use std::f64::consts::PI;

/// Number of points in the search for the maximum in S, before refinement.
const SCAN: usize = 4000;

/// Steady-state radius, times k/P, of a mass on equal springs along x and y with Coulomb friction in the plane, on a ground that moves in circles. P
/// is mass times acceleration of the ground.
///
/// ```text
/// x0² (1 − g²)² + (r + 2 ζ g x0)² = 1              friction acts perpendicular to the spring force, against the velocity
/// ```
/// `None` if friction holds the mass, r ≥ 1.
///
/// # Source
/// Balance of forces in axes that rotate with the mass: |P|² = |k x0 − m ω² x0|² + |f + c ω x0|².
///
/// # Example
/// ```
/// let radius = dolmen::known::dry_friction::circle_radius(0.5, 0.6, 0.0).unwrap();
/// assert!((radius - 0.8 / 0.75).abs() < 1e-15);
/// ```
pub fn circle_radius(frequency_ratio: f64, friction_ratio: f64, damping_ratio: f64) -> Option<f64> {
    let (g, r) = (frequency_ratio, friction_ratio);
    let v = 1.0 - g * g;
    let d = 2.0 * damping_ratio * g;
    // (v² + d²) x² + 2 r d x − (1 − r²) = 0
    let (a, b, c) = (v * v + d * d, r * d, 1.0 - r * r);
    (r < 1.0).then(|| (-b + (b * b + a * c).sqrt()) / a)
}

/// Displacements at the successive turning points of a free oscillator with Coulomb friction, until it sticks; the first is the start.
///
/// ```text
/// x_{j+1} = −(x_j − 2 (f/k) sign x_j)        while |x_j| > f/k
/// ```
/// The amplitude decreases by four f/k in a cycle. The oscillator rests where |k x| ≤ f.
///
/// # Source
/// Lorenz, H. (1924), in Den Hartog (1931) Trans. ASME 53:107-115.
///
/// # Example
/// ```
/// let turns = dolmen::known::dry_friction::free_decay_turns_m(10.0, 1.0, 1.0);
/// assert_eq!(turns, [10.0, -8.0, 6.0, -4.0, 2.0, 0.0]);
/// ```
pub fn free_decay_turns_m(start_m: f64, stiffness_n_m: f64, slip_force_n: f64) -> Vec<f64> {
    let band = slip_force_n / stiffness_n_m;
    let mut turns = vec![start_m];
    let mut x = start_m;
    while x.abs() > band {
        x = -(x - 2.0 * band * x.signum());
        turns.push(x);
    }
    turns
}

/// Steady-state amplitude, times k/P, of a harmonically forced oscillator with Coulomb friction that moves without stops.
///
/// ```text
/// x0 = (P/k) √(V² − (rU)²)      V = 1/(1 − g²)      U = sin(π/g) / (g (1 + cos(π/g)))
/// no stops if r < |V| / √(U² + S²),  S = max_{0<τ<π} [sin(τ/g)/g + U (cos τ − cos(τ/g))] / sin τ
/// ```
/// `None` if the mass stops at least twice in a cycle: the solution is then not valid.
///
/// # Limits
/// U is infinite at g = 1/2, 1/4, …, and V at g = 1; the result there is `None` or inaccurate.
///
/// # Source
/// Den Hartog, J. P. (1931) Forced vibrations with combined Coulomb and viscous friction. Trans. ASME 53:107-115.
///
/// # Example
/// ```
/// let amplitude = dolmen::known::dry_friction::forced_amplitude(0.9, 0.5).unwrap();
/// assert!((amplitude - 4.215903717).abs() < 1e-9);
/// ```
pub fn forced_amplitude(frequency_ratio: f64, friction_ratio: f64) -> Option<f64> {
    let g = frequency_ratio;
    let v = 1.0 / (1.0 - g * g);
    let u = (PI / g).sin() / (g * (1.0 + (PI / g).cos()));
    let term = |tau: f64| ((tau / g).sin() / g + u * (tau.cos() - (tau / g).cos())) / tau.sin();
    let (mut best, mut at) = (f64::NEG_INFINITY, 0.0);
    for i in 1..SCAN {
        let tau = PI * i as f64 / SCAN as f64;
        if term(tau) > best {
            (best, at) = (term(tau), tau);
        }
    }
    // golden section between the neighbours of the best point
    let (mut low, mut high) = (
        (at - PI / SCAN as f64).max(1e-9),
        (at + PI / SCAN as f64).min(PI - 1e-9),
    );
    let part = 0.5 * (5.0_f64.sqrt() - 1.0);
    for _ in 0..80 {
        let (a, b) = (high - part * (high - low), low + part * (high - low));
        if term(a) > term(b) {
            high = b;
        } else {
            low = a;
        }
    }
    let s = best.max(term(0.5 * (low + high)));
    if friction_ratio >= v.abs() / u.hypot(s) {
        return None;
    }
    Some((v * v - (friction_ratio * u).powi(2)).sqrt())
}

/// Energy that a spring in series with a slider dissipates in one cycle of amplitude X, J.
///
/// ```text
/// 4 f (X − f/k)      0 for X ≤ f/k
/// ```
///
/// # Source
/// Jenkins, G. M. (1962) Analysis of the stress-strain relationships in reactor grade graphite. Br. J. Appl. Phys. 13:30-32.
pub fn jenkins_loop_energy_j(amplitude_m: f64, stiffness_n_m: f64, slip_force_n: f64) -> f64 {
    4.0 * slip_force_n * (amplitude_m - slip_force_n / stiffness_n_m).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_amplitudes() {
        // computed independently, to ten digits
        for (g, r, wanted) in [
            (0.6, 0.3, 1.535601809),
            (0.9, 0.5, 4.215903717),
            (1.5, 0.5, 0.553774924), // √(.92/3)
            (3.0, 0.4, 0.098483877),
        ] {
            let found = forced_amplitude(g, r).unwrap();
            assert!((found - wanted).abs() < 6e-10, "{found} for {wanted}");
        }
        // far below resonance, with large friction, the mass stops
        assert_eq!(forced_amplitude(0.3, 0.9), None);
    }

    #[test]
    fn exact_decay_and_loop() {
        assert!((free_decay_turns_m(9.3, 1.0, 1.0).last().unwrap() - 0.7).abs() < 1e-14);
        assert_eq!(jenkins_loop_energy_j(1.5, 2.0, 1.0), 4.0);
        assert_eq!(jenkins_loop_energy_j(0.4, 2.0, 1.0), 0.0);
    }
}
