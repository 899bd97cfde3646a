//! Buckling of chains and columns, closed forms.

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

/// q H³/(EI) at which a uniform column clamped at the foot buckles under its own weight q per length: (9/4) j² with
/// j = 1.866350859 the first zero of the Bessel function J_{−1/3}.
///
/// # Source
/// Greenhill, A. G. (1881) Proc. Cambridge Phil. Soc. 4:65-73.
pub const GREENHILL_COLUMN: f64 = 7.837_347_438;

/// ω H² √(ρA/EI) of a uniform cantilever, first three: roots of cos β cosh β = −1, squared.
pub const UNIFORM_CANTILEVER: [f64; 3] = [3.516_015_269, 22.034_491_565, 61.697_214_364];
