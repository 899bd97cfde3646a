//! The foot of a column on a bed of springs without tension.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | b, B, D, R | `width_m`, `breadth_m`, `diameter_m`, `radius` | width in the direction of motion, breadth across it; diameter, radius | m |
//! | k_w | `bed_stiffness_n_m3` | pressure of the bed over its indentation | N/m³ |
//! | N, M, e | `normal_n`, `moment_n_m`, `eccentricity_m` | axial force, moment about the centre of the foot, M/N | N, N m, m |
//! | θ, θ0 | `rotation_rad` | rotation of the foot; rotation at which its edge lifts off | rad |
//! | c | `contact_m` | width of the contact | m |
//! | φ | `phi` | half the angle of the arc in contact | rad |

use crate::numeric::nodes_15;
use std::f64::consts::PI;

/// Section of a column at its foot and head.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FootSection {
    /// A rectangle.
    Rectangle {
        /// b, width in the direction of motion, m.
        width_m: f64,
        /// B, breadth across it, m.
        breadth_m: f64,
    },
    /// A circle.
    Circle {
        /// D, diameter, m.
        diameter_m: f64,
    },
}

/// Contact of a foot with its bed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FootPressure {
    /// e = M/N, distance of the resultant from the centre of the foot, m.
    pub eccentricity_m: f64,
    /// c, width of the contact, m.
    pub contact_m: f64,
}

/// Half angle of the contact arc below which the closed forms of the circle lose digits. Our choice.
const PHI_SMALL: f64 = 0.5;
/// Largest number of Newton steps for φ; five are usual. Our choice.
const STEPS_MOST: usize = 60;

impl FootSection {
    /// Width in the direction of motion, m.
    pub fn width_m(&self) -> f64 {
        match *self {
            FootSection::Rectangle { width_m, .. } => width_m,
            FootSection::Circle { diameter_m } => diameter_m,
        }
    }

    /// Second moment of area of the foot, which gives its moment over k_w θ in full contact, m⁴: b³
    /// B/12, or π D⁴/64.
    pub fn second_moment_m4(&self) -> f64 {
        match *self {
            FootSection::Rectangle { width_m, breadth_m } => breadth_m * width_m.powi(3) / 12.0,
            FootSection::Circle { diameter_m } => PI * diameter_m.powi(4) / 64.0,
        }
    }

    /// θ0, the rotation at which an edge of the foot lifts off, rad: 2 N/(k_w B b²), or 8 N/(π k_w D³).
    pub fn uplift_rotation_rad(&self, bed_stiffness_n_m3: f64, normal_n: f64) -> f64 {
        let force_n_m3 = normal_n / bed_stiffness_n_m3;
        match *self {
            FootSection::Rectangle { width_m, breadth_m } => {
                2.0 * force_n_m3 / (breadth_m * width_m * width_m)
            }
            FootSection::Circle { diameter_m } => 8.0 * force_n_m3 / (PI * diameter_m.powi(3)),
        }
    }

    /// The contact of a foot with load N at a rotation θ ≥ 0.
    ///
    /// ```text
    /// θ ≤ θ0:     M = k_w I θ
    /// rectangle:  c = √(2 N/(k_w B θ)),  M = N (b/2 − c/3)
    /// circle:     N = k_w θ R³ n(φ),  n = ⅔ sin³φ − cos φ (φ − sin φ cos φ),  c = R (1 − cos φ)
    ///             M = k_w θ R⁴ m(φ),  m = φ/4 − sin 4φ/16 − ⅔ cos φ sin³φ
    /// ```
    ///
    /// # Limits
    /// The indentation is small compared with the width, and the bed does not crush.
    pub fn pressure(&self, bed_stiffness_n_m3: f64, normal_n: f64, rotation_rad: f64) -> FootPressure {
        let width_m = self.width_m();
        if rotation_rad <= self.uplift_rotation_rad(bed_stiffness_n_m3, normal_n) {
            return FootPressure {
                eccentricity_m: bed_stiffness_n_m3 * self.second_moment_m4() * rotation_rad / normal_n,
                contact_m: width_m,
            };
        }
        match *self {
            FootSection::Rectangle { width_m, breadth_m } => {
                let contact_m = (2.0 * normal_n / (bed_stiffness_n_m3 * breadth_m * rotation_rad)).sqrt();
                FootPressure {
                    eccentricity_m: 0.5 * width_m - contact_m / 3.0,
                    contact_m,
                }
            }
            FootSection::Circle { diameter_m } => {
                let radius = 0.5 * diameter_m;
                let phi = half_angle(normal_n / (bed_stiffness_n_m3 * rotation_rad * radius.powi(3)));
                FootPressure {
                    eccentricity_m: radius * arc_moment(phi) / arc_force(phi),
                    contact_m: 2.0 * radius * (0.5 * phi).sin().powi(2),
                }
            }
        }
    }
}

impl FootSection {
    /// de/dθ of a foot with load N at a rotation θ ≥ 0, m.
    ///
    /// ```text
    /// θ ≤ θ0:     k_w I/N
    /// rectangle:  c/(6 θ)
    /// circle:     (e − R m′/n′)/θ,   m′/n′ = ⅔ sin³φ/(φ − sin φ cos φ)       from dn/dθ = −n/θ
    /// ```
    pub(super) fn eccentricity_slope_m(
        &self,
        bed_stiffness_n_m3: f64,
        normal_n: f64,
        rotation_rad: f64,
    ) -> f64 {
        if rotation_rad <= self.uplift_rotation_rad(bed_stiffness_n_m3, normal_n) {
            return bed_stiffness_n_m3 * self.second_moment_m4() / normal_n;
        }
        let pressure = self.pressure(bed_stiffness_n_m3, normal_n, rotation_rad);
        match *self {
            FootSection::Rectangle { .. } => pressure.contact_m / (6.0 * rotation_rad),
            FootSection::Circle { diameter_m } => {
                let phi = 2.0 * (pressure.contact_m / diameter_m).sqrt().min(1.0).asin();
                let sin = phi.sin();
                let edge_m = 0.5 * diameter_m * 2.0 / 3.0 * sin.powi(4) / arc_force_slope(phi);
                (pressure.eccentricity_m - edge_m) / rotation_rad
            }
        }
    }
}

/// n(φ) = ∫ sin t (t − sin t cos t) dt.
fn arc_force(phi: f64) -> f64 {
    if phi < PHI_SMALL {
        return integral(phi, arc_force_slope);
    }
    let (sin, cos) = phi.sin_cos();
    2.0 / 3.0 * sin.powi(3) - cos * (phi - sin * cos)
}

/// n′(φ); by a series where t − sin t cos t loses digits.
fn arc_force_slope(phi: f64) -> f64 {
    let (sin, cos) = phi.sin_cos();
    if phi >= PHI_SMALL {
        return sin * (phi - sin * cos);
    }
    // t − ½ sin 2t = Σ ± (2t)^(2j+1)/(2 (2j+1)!)
    let double = 2.0 * phi;
    let mut term = 0.5 * double;
    let mut sum = 0.0;
    for j in 1..12 {
        let n = f64::from(2 * j);
        term *= -double * double / (n * (n + 1.0));
        sum -= term;
    }
    sin * sum
}

/// m(φ) = ⅔ ∫ sin⁴t dt.
fn arc_moment(phi: f64) -> f64 {
    if phi < PHI_SMALL {
        return integral(phi, |t| 2.0 / 3.0 * t.sin().powi(4));
    }
    let (sin, cos) = phi.sin_cos();
    0.25 * phi - (4.0 * phi).sin() / 16.0 - 2.0 / 3.0 * cos * sin.powi(3)
}

fn integral(high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let nodes = nodes_15(0.0, high);
    nodes.iter().map(|node| node.weight * f(node.x)).sum()
}

/// φ with n(φ) = `force`, from 0 to π: Newton steps, halved if they leave the bracket.
fn half_angle(force: f64) -> f64 {
    let (mut low, mut high) = (0.0, PI);
    let mut phi = (7.5 * force).powf(0.2).min(0.9 * PI); // n = 2 φ⁵/15 near 0
    for _ in 0..STEPS_MOST {
        let off = arc_force(phi) - force;
        if off > 0.0 {
            high = phi;
        } else {
            low = phi;
        }
        let newton = phi - off / arc_force_slope(phi);
        let next = if newton > low && newton < high {
            newton
        } else {
            0.5 * (low + high)
        };
        if (next - phi).abs() <= 2.0 * f64::EPSILON * phi {
            return next;
        }
        phi = next;
    }
    phi
}
