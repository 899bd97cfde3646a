//! Closed forms for a mass on a spring with a second spring that acts only beyond a gap.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | k, k_t | `within`, `bearing` | spring that always acts, and spring beyond the gap | N/m |
//! | g | `gap` | displacement at which the second spring comes into contact, on either side | m |
//! | A | `amplitude` | amplitude of a free vibration | m |
//! | f | `crushing` | force at which the face of the second spring crushes | N |
//! | c | `friction` | slip force of a slider in parallel with both springs | N |

/// Period of free vibration, s.
///
/// ```text
/// T = 4 [acos((g − e)/(A − e))/ω₁ + atan(ω₀ g/v)/ω₀]         A > g; ω₀ = √(k/m), ω₁ = √((k + k_t)/m), e = k_t g/(k + k_t)
/// v = ω₁ √((A − e)² − (g − e)²)                                k = 0: the second term is g/v
/// ```
/// `None` without a restoring force: no spring within the gap, and A not beyond it.
///
/// # Source
/// Each part of a quarter of the period is that of a linear oscillator.
///
/// # Example
/// ```
/// // no spring within the gap: half a period on the second spring, and four times the distance g at speed ω (A − g)
/// let period = dolmen::known::gap_spring::period_s([0.0, 4.0], 1.0, 0.5, 1.5).unwrap();
/// assert!((period - (std::f64::consts::PI + 4.0 * 0.5 / 2.0)).abs() < 1e-14);
/// ```
pub fn period_s([within, bearing]: [f64; 2], mass: f64, gap: f64, amplitude: f64) -> Option<f64> {
    let omega_0 = (within / mass).sqrt();
    if amplitude <= gap {
        return (within > 0.0).then(|| std::f64::consts::TAU / omega_0);
    }
    let whole = within + bearing;
    let omega_1 = (whole / mass).sqrt();
    let middle = bearing * gap / whole;
    let (far, near) = (amplitude - middle, gap - middle);
    let speed = omega_1 * (far * far - near * near).sqrt();
    let beyond = (near / far).acos() / omega_1;
    let inside = match within > 0.0 {
        true => (omega_0 * gap / speed).atan() / omega_0,
        false => gap / speed,
    };
    Some(4.0 * (beyond + inside))
}

/// Crushed depth of the face, m, after the mass passes the middle with this energy, J; without a spring within the gap.
///
/// ```text
/// E = c (g + f/k_t + d) + f²/2k_t + f d                         0 where E does not reach f
/// ```
pub fn crushed_m(energy: f64, gap: f64, bearing: f64, [crushing, friction]: [f64; 2]) -> f64 {
    let before = friction * (gap + crushing / bearing) + 0.5 * crushing * crushing / bearing;
    ((energy - before) / (crushing + friction)).max(0.0)
}
