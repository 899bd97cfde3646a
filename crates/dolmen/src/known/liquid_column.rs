//! Liquid in a U-shaped tube of constant section.
//!
//! ```text
//! ẅ + (ξ / 2L) |ẇ| ẇ + ω_d² w = −α z̈₀,   ω_d = √(2g/L),  α = horizontal / total length
//! ```

/// Frequency ratio and damping ratio of a liquid column that minimise the variance of an undamped structure under a white-noise force. The
/// mass ratio μ includes all of its liquid.
///
/// ```text
/// γ = √(1 + μ(1 − α²/2)) / (1 + μ)        ζ = (α/2) √( μ(1 + μ − α²μ/4) / ((1 + μ)(1 + μ − α²μ/2)) )
/// ```
///
/// # Source
/// Yalla & Kareem (2000) J. Struct. Eng. 126(8):906-915, doi:10.1061/(ASCE)0733-9445(2000)126:8(906). Also derived here: the column is a
/// tuned mass of α²m and a mass of (1 − α²)m that moves with the structure, so Warburton's form is valid for them.
///
/// # Example
/// ```
/// let [f, zeta] = dolmen::known::liquid_column::least_variance_under_force(0.05, 1.0);
/// assert!((f - 0.964_212_2).abs() < 5e-8 && (zeta - 0.109_772_2).abs() < 5e-8); // all of it horizontal: a tuned mass
/// ```
pub fn least_variance_under_force(mass_ratio: f64, length_ratio: f64) -> [f64; 2] {
    let (mu, a2) = (mass_ratio, length_ratio * length_ratio);
    let whole = 1.0 + mu;
    let f = (1.0 + mu * (1.0 - 0.5 * a2)).sqrt() / whole;
    let zeta =
        0.5 * length_ratio * (mu * (whole - 0.25 * a2 * mu) / (whole * (whole - 0.5 * a2 * mu))).sqrt();
    [f, zeta]
}

/// Equivalent damping ratio for the head loss ξ of a column with Gaussian velocity of this standard deviation: both dissipate the same mean
/// power.
///
/// ```text
/// |ẇ| ẇ → √(8/π) σ ẇ:   ζ = ξ σ / (√(2π) L ω_d)
/// ```
pub fn equivalent_damping_ratio(
    head_loss: f64,
    velocity_rms_m_s: f64,
    length_m: f64,
    angular_frequency_rad_s: f64,
) -> f64 {
    head_loss * velocity_rms_m_s / (std::f64::consts::TAU.sqrt() * length_m * angular_frequency_rad_s)
}

/// The next turning point of a column released from w = A: the amplitude B on the other side, by bisection of the exact first integral.
///
/// ```text
/// (1 + βA) e^(−βA) = (1 − βB) e^(βB),   β = ξ/L
/// ```
pub fn next_turn_m(amplitude_m: f64, head_loss: f64, length_m: f64) -> f64 {
    let beta = head_loss / length_m;
    let left = (1.0 + beta * amplitude_m) * (-beta * amplitude_m).exp();
    let (mut low, mut high) = (0.0, amplitude_m);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if (1.0 - beta * middle) * (beta * middle).exp() > left {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}
