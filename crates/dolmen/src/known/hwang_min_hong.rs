//! Hwang, Min, Hong: Control of coupled lateral torsional vibration of tall building under dynamic lateral loads (in Korean), with
//! reference to Hua Gao et al. (1994). Its example is a floor of 10 × 8 m with eccentric walls. The drawing is lost; the numbers
//! here reproduce its Table 1.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | k_x, k_y | `STIFFNESS` | stiffness of the storey over the mass of the floor | 1/s² |
//! | e | `RIGIDITY_X_M` | position of the centre of rigidity relative to the centre of mass, along x | m |
//! | k_θ | `rotation` | torsional stiffness about the centre of mass, over the mass | m²/s² |
//! | ρ² | `GYRATION_SQUARED_M2` | square of the radius of gyration | m² |

/// Sides of the floor along x and y, m.
pub const FLOOR_M: [f64; 2] = [10.0, 8.0];
/// ρ² = (10² + 8²)/12, m².
pub const GYRATION_SQUARED_M2: f64 = 164.0 / 12.0;
/// k_x and k_y over the mass, 1/s².
pub const STIFFNESS: [f64; 2] = [2.2821 * 2.2821, 0.7 * 2.2821 * 2.2821];
/// Centre of rigidity along x from the middle of the floor, m.
pub const RIGIDITY_X_M: f64 = -1.5;
/// Table 1: circular frequencies, rad/s.
pub const OMEGA_RAD_S: [f64; 3] = [1.8471, 2.2821, 3.6056];
/// Table 1: r_x of modes 1 and 3, m; mode 2 moves along x only.
pub const RADIUS_M: [f64; 2] = [-23.378, 0.5845];
/// Table 1: |φ_y| and |φ_θ| of modes 1 and 3, mode by mode, to a common norm.
pub const SHAPE: [[f64; 2]; 2] = [[5.04, 0.22], [0.79, 1.36]];

/// k_θ about the centre of mass over the mass, m²/s²: walls along x at y = ±4 m, along y at x = ±5 m.
pub fn rotation() -> f64 {
    16.0 * STIFFNESS[0] + 25.0 * STIFFNESS[1]
}

/// A mode that combines y and θ of one floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MixedMode {
    /// ω, rad/s.
    pub omega_rad_s: f64,
    /// r_x = −φ_y/φ_θ, m.
    pub radius_m: f64,
}

/// The two modes of a floor of unit mass with stiffness k_y at e and k_θ about its centre of mass, lower mode first.
///
/// ```text
/// ω² = (a + b)/2 ∓ √((a − b)²/4 + (k_y e)²/ρ²),  a = k_y, b = k_θ/ρ²        r_x = k_y e/(k_y − ω²)
/// ```
pub fn mixed_modes(
    stiffness_y: f64,
    eccentricity_m: f64,
    rotation: f64,
    gyration_squared_m2: f64,
) -> [MixedMode; 2] {
    let (a, b) = (stiffness_y, rotation / gyration_squared_m2);
    let coupling = stiffness_y * eccentricity_m;
    let root = (0.25 * (a - b).powi(2) + coupling * coupling / gyration_squared_m2).sqrt();
    [-root, root].map(|root| {
        let squared = 0.5 * (a + b) + root;
        MixedMode {
            omega_rad_s: squared.sqrt(),
            radius_m: coupling / (stiffness_y - squared),
        }
    })
}
