//! Similarity of two mode shapes, and deviation of a shape from a real one.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | φ, ψ | `phi`, `psi` | complex mode shapes, one component for each channel |

use dolmen_linalg::Complex64;
use std::f64::consts::FRAC_PI_2;

/// Modal assurance criterion of two shapes, 0 to 1.
///
/// ```text
/// MAC = |φ* ψ|² / (φ*φ) (ψ*ψ)        φ, ψ: channels × 1
/// ```
/// 0 if one of the shapes is zero or their lengths differ.
///
/// # Source
/// Allemang & Brown (1982) Proc. 1st IMAC, 110-116; the complex form.
///
/// # Example
/// ```
/// use dolmen::modal::assurance;
/// use dolmen_linalg::Complex64;
/// let phi = [Complex64::new(1.0, 0.0), Complex64::new(0.5, 0.0)];
/// let turned = phi.map(|x| x * Complex64::new(0.0, -3.0)); // the scale and phase of a shape mean nothing
/// assert!((assurance(&phi, &turned) - 1.0).abs() < 1e-15);
/// ```
pub fn assurance(phi: &[Complex64], psi: &[Complex64]) -> f64 {
    if phi.len() != psi.len() {
        return 0.0;
    }
    let inner: Complex64 = phi.iter().zip(psi).map(|(a, b)| a.conj() * b).sum();
    let (a, b) = (power(phi), power(psi));
    if a > 0.0 && b > 0.0 {
        (inner.norm_sqr() / (a * b)).min(1.0)
    } else {
        0.0
    }
}

/// Modal phase collinearity, 0 to 1: 1 if all components lie on one line of the complex plane.
///
/// ```text
/// MPC = ((Sxx - Syy)² + 4 Sxy²) / (Sxx + Syy)²,   Sxx = Re φᵀ Re φ, Syy = Im φᵀ Im φ, Sxy = Re φᵀ Im φ
/// ```
///
/// # Source
/// Pappa, Elliott & Schenk (1993) J. Guid. Control Dyn. 16(5):852-858.
pub fn phase_collinearity(phi: &[Complex64]) -> f64 {
    let [xx, yy, xy] = scatter(phi);
    let trace = xx + yy;
    if trace > 0.0 {
        ((xx - yy).powi(2) + 4.0 * xy * xy) / (trace * trace)
    } else {
        0.0
    }
}

/// Mean phase deviation over a right angle, 0 (real shape) to 1: mean angle of the components from the line that
/// fits them best, each weighted with its modulus.
///
/// # Source
/// Reynders, Houbrechts & De Roeck (2012) Mech. Syst. Signal Process. 29:228-250, eqs. 24-25.
pub fn phase_deviation(phi: &[Complex64]) -> f64 {
    let (cos, sin) = line(phi);
    let (mut sum, mut weight) = (0.0, 0.0);
    for z in phi {
        let modulus = z.norm();
        if modulus > 0.0 {
            let along = ((z.re * cos + z.im * sin) / modulus).abs().min(1.0);
            sum += modulus * along.acos();
            weight += modulus;
        }
    }
    if weight > 0.0 {
        sum / weight / FRAC_PI_2
    } else {
        1.0
    }
}

/// The shape scaled so that its largest component (the first if several are equal) is 1 + 0i.
pub(crate) fn normalized(phi: &[Complex64]) -> Vec<Complex64> {
    match largest(phi) {
        Some(m) if phi[m].norm_sqr() > 0.0 => {
            let scale = phi[m].inv();
            let mut unit: Vec<Complex64> = phi.iter().map(|z| z * scale).collect();
            unit[m] = Complex64::ONE;
            unit
        }
        _ => phi.to_vec(),
    }
}

/// Index of the component with the largest modulus.
pub(crate) fn largest(phi: &[Complex64]) -> Option<usize> {
    (0..phi.len()).reduce(|best, i| {
        if phi[i].norm_sqr() > phi[best].norm_sqr() {
            i
        } else {
            best
        }
    })
}

fn power(phi: &[Complex64]) -> f64 {
    phi.iter().map(Complex64::norm_sqr).sum()
}

fn scatter(phi: &[Complex64]) -> [f64; 3] {
    phi.iter().fold([0.0; 3], |[xx, yy, xy], z| {
        [xx + z.re * z.re, yy + z.im * z.im, xy + z.re * z.im]
    })
}

/// Direction (cos, sin) of the best-fitting line through 0 in the complex plane.
fn line(phi: &[Complex64]) -> (f64, f64) {
    let [xx, yy, xy] = scatter(phi);
    let angle = 0.5 * (2.0 * xy).atan2(xx - yy);
    (angle.cos(), angle.sin())
}

#[cfg(test)]
mod tests {
    use super::*;

    const I: Complex64 = Complex64::I;

    #[test]
    fn exact_indicators_of_a_real_and_of_a_rotating_shape() {
        let real: Vec<Complex64> = [1.0, -0.4, 0.2].map(|x| x * (2.0 * I).exp()).to_vec();
        assert!((phase_collinearity(&real) - 1.0).abs() < 1e-14);
        assert!(phase_deviation(&real) < 1e-7);
        let rotating = [Complex64::ONE, I]; // quarter turn apart: a circle, no line fits
        assert!(phase_collinearity(&rotating).abs() < 1e-15);
        assert!((phase_deviation(&rotating) - 0.5).abs() < 1e-15); // mean of 0° and 90°
    }

    #[test]
    fn exact_assurance_of_orthogonal_and_of_half_alike_shapes() {
        let (x, y) = ([Complex64::ONE, Complex64::ZERO], [Complex64::ZERO, I]);
        assert_eq!(assurance(&x, &y), 0.0);
        let both = [Complex64::ONE, Complex64::ONE];
        assert!((assurance(&x, &both) - 0.5).abs() < 1e-15);
    }

    #[test]
    fn holds_largest_component_is_one() {
        let unit = normalized(&[0.3 * I, -2.0 * I, Complex64::ONE]);
        assert_eq!(unit[1], Complex64::ONE);
        assert!((unit[0].re + 0.15).abs() < 1e-15);
    }
}
