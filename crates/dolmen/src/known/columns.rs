//! Closed forms for the buckling and vibration of chains and columns.

use super::bisection::sign_change;
use std::f64::consts::FRAC_PI_2;

/// Tip load at which a chain of n equal weightless rigid links on equal springs k buckles, in units of k/L.
///
/// ```text
/// P L / k = 4 sin²(π / (2 (2n + 1)))
/// ```
///
/// # Source
/// Hencky, H. (1920) Der Eisenbau 11:437-452; clamped at the foot, free at the top.
pub fn hencky_tip_load(links: u32) -> f64 {
    4.0 * (FRAC_PI_2 / f64::from(2 * links + 1)).sin().powi(2)
}

/// Load factor q H³/(EI) at which a uniform column, clamped at the foot, buckles under its weight q per length: (9/4) j² with j =
/// 1.866350859, the first zero of the Bessel function J_{−1/3}.
///
/// # Source
/// Greenhill, A. G. (1881) Proc. Cambridge Phil. Soc. 4:65-73.
pub const GREENHILL_COLUMN: f64 = 7.837_347_438;

/// First three values of ω H² √(ρA/EI) of a uniform cantilever: squared roots of cos β cosh β = −1.
///
/// # Source
/// Euler, L. (1744) Methodus inveniendi lineas curvas, Additamentum I.
pub const UNIFORM_CANTILEVER: [f64; 3] = [3.516_015_268_5, 22.034_491_564_7, 61.697_214_414];

/// First three values of ω H² √(ρA/EI) of cantilevers that taper to a point, with A and I at the foot. They are z²/4 with z the roots of
/// J_m(z) I_{m+1}(z) + I_m(z) J_{m+1}(z) = 0. `order` m = 1: a wedge, with linear depth and uniform breadth; m = 2: a cone or pyramid.
///
/// # Source
/// Kirchhoff, G. R. (1879) Monatsber. Akad. Wiss. Berlin 815-828. The roots are those of a clamped circular plate with m
/// nodal diameters.
pub fn pointed_cantilever(order: i32) -> [f64; 3] {
    const STEP: f64 = 0.05; // adjacent roots are more than 3 apart
    const HALVINGS: usize = 60;
    let f = |z: f64| {
        bessel_series(order, z, -1.0) * bessel_series(order + 1, z, 1.0)
            + bessel_series(order, z, 1.0) * bessel_series(order + 1, z, -1.0)
    };
    let mut roots = [0.0; 3];
    let mut low = 1.0;
    for root in &mut roots {
        while f(low) * f(low + STEP) > 0.0 {
            low += STEP;
        }
        let (mut a, mut b) = (low, low + STEP);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (a + b);
            if f(a) * f(middle) > 0.0 {
                a = middle;
            } else {
                b = middle;
            }
        }
        *root = 0.25 * a * a;
        low += STEP;
    }
    roots
}

/// First three values of ω H² √(ρA/EI) of a cantilever of square or round section whose sides taper linearly to half, with A and I at the
/// foot. They are k²/4 with k from det = 0 for y = (J_2, Y_2, I_2, K_2)(2 k √x)/x under y = y' = 0 at x = 1, (x⁴ y'')= (x⁴ y'')' = 0 at x =
/// ½, computed with 25 digits.
///
/// # Source
/// Kirchhoff, G. R. (1879), his solution for a cone truncated at half its height; roots by mpmath 1.3.
pub const HALVED_CANTILEVER: [f64; 3] = [4.625_150_252_43, 19.547_613_180_5, 48.578_899_333_9];

/// First three values of ω H² √(ρA/EI) of a uniform Timoshenko cantilever: the roots b of
///
/// ```text
/// 2 + [b²(r² − s²)² + 2] cosh bα cos bβ − b (r² + s²)/√(1 − b²r²s²) sinh bα sin bβ = 0
/// α, β = {∓(r² + s²) + [(r² − s²)² + 4/b²]^½}^½ / √2
/// ```
///
/// `r` is the radius of gyration over H, `s` is √(EI/κGA)/H. Valid while b r s < 1, which holds for the first three modes of a beam with r
/// below 0.1.
///
/// # Source
/// Huang, T. C. (1961) J. Appl. Mech. 28:579-584, clamped and free.
pub fn timoshenko_cantilever(r: f64, s: f64) -> [f64; 3] {
    const STEP: f64 = 0.05;
    let (r2, s2) = (r * r, s * s);
    let f = |b: f64| {
        let root = ((r2 - s2) * (r2 - s2) + 4.0 / (b * b)).sqrt();
        let (alpha, beta) = ((0.5 * (root - r2 - s2)).sqrt(), (0.5 * (root + r2 + s2)).sqrt());
        let (alpha, beta) = (b * alpha, b * beta);
        2.0 + (b * b * (r2 - s2) * (r2 - s2) + 2.0) * alpha.cosh() * beta.cos()
            - b * (r2 + s2) / (1.0 - b * b * r2 * s2).sqrt() * alpha.sinh() * beta.sin()
    };
    let mut low = STEP;
    std::array::from_fn(|_| {
        while f(low) * f(low + STEP) > 0.0 {
            low += STEP;
        }
        low += STEP;
        sign_change(f, low - STEP, low)
    })
}

/// Distance between the centre of a unit square and the centre of the part that a line across the diagonal cuts off, for a fraction a of the
/// area. Up to half of the square the part is a triangle with legs √(2 a), beyond that the square without such a triangle.
pub fn square_cut_across_its_diagonal(share: f64) -> f64 {
    let of_triangle = |share: f64| 2.0_f64.sqrt() * (0.5 - (2.0 * share).sqrt() / 3.0);
    match share <= 0.5 {
        true => of_triangle(share),
        false => (1.0 - share) / share * of_triangle(1.0 - share),
    }
}

/// J_m (`sign` −1) or I_m (`sign` 1) by power series: 10 digits up to z = 13.
fn bessel_series(order: i32, z: f64, sign: f64) -> f64 {
    const TERMS: i32 = 60;
    let half = 0.5 * z;
    let mut term = (1..=order).fold(1.0, |product, i| product * half / f64::from(i));
    let mut sum = 0.0;
    for i in 1..=TERMS {
        sum += term;
        term *= sign * half * half / f64::from(i * (i + order));
    }
    sum
}
