//! Closed forms for a unit mass on a unit spring, with a tuned mass μ on its own spring and dashpot.
//!
//! ```text
//! ẍ + 2 ζ_s ẋ + x + μ (2 ζ f (ẋ − ẏ) + f² (x − y)) = p
//! ÿ + 2 ζ f (ẏ − ẋ) + f² (y − x)                   = q      force: p = 1, q = 0; base acceleration: p = q = −1
//! ```

use num_complex::Complex64;

/// The load: a force on the structure, or an acceleration of its base.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Acts {
    /// Force on the structure; displacement in units of the static displacement.
    Force,
    /// Acceleration of the base; displacement relative to the base, in units of acceleration / ω².
    Base,
}

/// The tuned mass and the damping of the structure, all dimensionless.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TunedMass {
    /// Mass ratio μ.
    pub mass_ratio: f64,
    /// f, natural frequency of the tuned mass over that of the structure.
    pub frequency_ratio: f64,
    /// ζ = c / (2 m ω) with m and ω of the tuned mass.
    pub damping_ratio: f64,
    /// Damping ratio ζ_s of the structure.
    pub structure_damping_ratio: f64,
}

/// Response x per unit load at the frequency r, which is relative to that of the structure.
pub fn response(of: TunedMass, acts: Acts, r: f64) -> Complex64 {
    let (mu, f) = (of.mass_ratio, of.frequency_ratio);
    let s = Complex64::new(0.0, r);
    let link = 2.0 * of.damping_ratio * f * s + f * f;
    let own = s * s + link;
    let above = match acts {
        Acts::Force => own,
        Acts::Base => -(own + mu * link),
    };
    above / ((s * s + 2.0 * of.structure_damping_ratio * s + 1.0) * own + mu * s * s * link)
}

/// Variance of the response to white noise: (1/2π) ∫ |x|² dr over all r.
///
/// # Source
/// The integral of a rational spectrum of order four: James, Nichols & Phillips (1947) Theory of Servomechanisms,
/// appendix; Newland (1993) An Introduction to Random Vibrations, appendix 1.
///
/// # Example
/// ```
/// use dolmen::known::tuned_mass::{variance, Acts, TunedMass};
/// // with a negligible tuned mass: 1 / 4ζ
/// let bare = TunedMass { mass_ratio: 1e-12, frequency_ratio: 1.0, damping_ratio: 1.0, structure_damping_ratio: 0.02 };
/// assert!((variance(bare, Acts::Force) - 12.5).abs() < 1e-9);
/// ```
pub fn variance(of: TunedMass, acts: Acts) -> f64 {
    let (mu, f) = (of.mass_ratio, of.frequency_ratio);
    let (own, link) = (2.0 * of.structure_damping_ratio, 2.0 * of.damping_ratio * f);
    // denominator a0 + a1 s + … + a4 s⁴ with a4 = 1; numerator b0 + b1 s + b2 s²
    let a = [
        f * f,
        link + own * f * f,
        1.0 + f * f * (1.0 + mu) + own * link,
        link * (1.0 + mu) + own,
    ];
    let grows = match acts {
        Acts::Force => 1.0,
        Acts::Base => 1.0 + mu,
    };
    let b = [grows * f * f, grows * link, 1.0];
    let above = a[0] * a[1] * b[2] * b[2]
        + a[0] * a[3] * (b[1] * b[1] - 2.0 * b[0] * b[2])
        + b[0] * b[0] * (a[2] * a[3] - a[1]);
    above / (2.0 * a[0] * (a[1] * a[2] * a[3] - a[0] * a[3] * a[3] - a[1] * a[1]))
}

/// Optimum under a harmonic force without structural damping: frequency ratio, damping ratio and the smallest possible
/// peak of |x|. This is the exact optimum; Den Hartog's fixed points approximate it.
///
/// # Source
/// Nishihara & Asami (2002) J. Vib. Acoust. 124(4):576-582, doi:10.1115/1.1500335.
///
/// # Example
/// ```
/// let [f, zeta, peak] = dolmen::known::tuned_mass::least_peak_under_force(0.05);
/// assert!((f - 0.952_372_0).abs() < 5e-8 && (zeta - 0.133_937_7).abs() < 5e-8 && (peak - 6.407_921).abs() < 5e-7);
/// ```
pub fn least_peak_under_force(mass_ratio: f64) -> [f64; 3] {
    let mu = mass_ratio;
    let root = (4.0 + 3.0 * mu).sqrt();
    let part = 16.0 + 23.0 * mu + 9.0 * mu * mu + 2.0 * (2.0 + mu) * root;
    let f = 2.0 / (1.0 + mu) * (2.0 * part / (3.0 * (64.0 + 80.0 * mu + 27.0 * mu * mu))).sqrt();
    let zeta = 0.25 * ((8.0 + 9.0 * mu - 4.0 * root) / (1.0 + mu)).sqrt();
    let above = (8.0 + 9.0 * mu).powi(2) * (16.0 + 9.0 * mu) - 128.0 * root.powi(3);
    let peak = (above / (3.0 * (32.0 + 27.0 * mu))).sqrt() / (3.0 * mu);
    [f, zeta, peak]
}
