//! Response of one rigid floor with a displaced centre of mass to a spectrum S_a = c/T, its two coupled modes combined by CQC.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | m, ρ | `mass_kg`, `gyration_m` | mass, radius of gyration about its displaced centre | kg, m |
//! | k_x, k_y, k_θ | `stiffness` | stiffness of the storey about its centre of rigidity, the origin | N/m, N m/rad |
//! | w | `weight_over_height_n_m` | m g/h, the reduction by P-delta | N/m |
//! | ζ | `damping_ratio` | damping ratio of every mode | – |
//! | c | `acceleration_times_period_m_s` | S_a T, m/s² times s | m/s |
//! | e | | displacement of the centre across the shaking | m |
//! | φ | | angle of a mode between displacement and ρ times rotation | rad |

use std::f64::consts::TAU;

/// One rigid floor whose centre of rigidity is the origin of the plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DisplacedFloor {
    /// m, kg.
    pub mass_kg: f64,
    /// ρ, m.
    pub gyration_m: f64,
    /// k_x, k_y, N/m, and k_θ, N m/rad.
    pub stiffness: [f64; 3],
    /// w = m g/h, N/m; 0 without P-delta.
    pub weight_over_height_n_m: f64,
    /// ζ.
    pub damping_ratio: f64,
    /// c.
    pub acceleration_times_period_m_s: f64,
}

/// ω and the cosine and sine of φ.
struct Mode {
    omega: f64,
    cos: f64,
    sin: f64,
}

impl DisplacedFloor {
    /// Largest drift along x at the edges y = ± `edges_m[1]` and along y at the edges x = ± `edges_m[0]`, with the centre displaced by
    /// `by_m` across the shaking and shaking along both axes combined by the root of the sum of squares.
    ///
    /// ```text
    /// [a b; b d] [cos φ; sin φ] = ω² [cos φ; sin φ]     a = (k − w)/m,  b = ± k e/(m ρ),  d = (k_θ + k e²)/(m ρ²) − w/m
    /// r_n = row_n cos φ_n S_a/ω_n²                      row: displacement plus arm times rotation
    /// r² = r_1² + r_2² + 2 ρ_12 r_1 r_2                 ρ_12 = 8 ζ² (1 + β) β^(3/2)/[(1 − β²)² + 4 ζ² β (1 + β)²]
    /// ```
    ///
    /// # Source
    /// Chopra (2017), Dynamics of Structures, 9.6 and eqs 13.7.4, 13.7.11 (equal damping ratios).
    pub fn edge_drifts_m(&self, by_m: [f64; 2], edges_m: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|drift_axis| {
            let edge = edges_m[1 - drift_axis];
            let each = [edge, -edge].map(|at| {
                let along = [0, 1].map(|shaken| {
                    let (own, e) = (shaken == drift_axis, by_m[1 - shaken]);
                    self.largest_m(shaken, e, |mode| {
                        // turning about z moves along y by +x θ and along x by −y θ, from the displaced centre
                        let turn = if drift_axis == 1 { 1.0 } else { -1.0 };
                        let arm = if own { at - e } else { at };
                        f64::from(u8::from(own)) * mode.cos + turn * arm * mode.sin / self.gyration_m
                    })
                });
                along[0].hypot(along[1])
            });
            each[0].max(each[1])
        })
    }

    fn largest_m(&self, shaken: usize, e: f64, row: impl Fn(&Mode) -> f64) -> f64 {
        let modes = self.modes(shaken, e);
        let r = modes.each_ref().map(|mode| {
            let period = TAU / mode.omega;
            row(mode) * mode.cos * self.acceleration_times_period_m_s / period / mode.omega.powi(2)
        });
        let (beta, zeta) = (modes[0].omega / modes[1].omega, self.damping_ratio);
        let above = 8.0 * zeta * zeta * (1.0 + beta) * beta.powf(1.5);
        let below = (1.0 - beta * beta).powi(2) + 4.0 * zeta * zeta * beta * (1.0 + beta).powi(2);
        (r[0] * r[0] + r[1] * r[1] + 2.0 * above / below * r[0] * r[1]).sqrt()
    }

    fn modes(&self, shaken: usize, e: f64) -> [Mode; 2] {
        let (m, rho, w) = (self.mass_kg, self.gyration_m, self.weight_over_height_n_m);
        let (k, k_theta) = (self.stiffness[shaken], self.stiffness[2]);
        // the centre of rigidity moves by u + e θ along x, by v − e θ along y
        let sign = if shaken == 0 { 1.0 } else { -1.0 };
        let (a, b) = ((k - w) / m, sign * k * e / (m * rho));
        let d = (k_theta + k * e * e) / (m * rho * rho) - w / m;
        let angle = 0.5 * (2.0 * b).atan2(a - d);
        let (middle, half) = (0.5 * (a + d), (0.5 * (a - d)).hypot(b));
        let of = |square: f64, (sin, cos): (f64, f64)| Mode {
            omega: square.sqrt(),
            cos,
            sin,
        };
        let (sin, cos) = angle.sin_cos();
        [of(middle + half, (sin, cos)), of(middle - half, (cos, -sin))]
    }
}
