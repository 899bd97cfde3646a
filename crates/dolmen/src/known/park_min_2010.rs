//! Numbers printed in Park, S.-A. and Min, K.-W. (2010) "Simple structural model of Heunginjimun with Coulomb friction",
//! and its formulas as printed. The gate is the east gate of Seoul, lower storey first. Units are those of the source: t,
//! m, kN, kN/mm = 1000 kN/m.

/// Section 3.1: mass of each storey, t.
pub const MASS_T: [f64; 2] = [290.0, 314.0];
/// Section 3.1: column height of each storey, m.
pub const HEIGHT_M: [f64; 2] = [5.84, 7.69];
/// Section 3.1: P of each storey, kN. P1 − P2 = 2842 kN is the weight of 290 t: P1 already includes P2.
pub const AXIAL_KN: [f64; 2] = [5919.0, 3077.0];
/// Section 2: translational modes about the weak axis, Hz.
pub const WEAK_HZ: [f64; 2] = [1.1, 4.2];
/// Section 2: torsional mode about the weak axis, Hz.
pub const TWISTING_HZ: f64 = 1.3;
/// Section 2: the mode about the strong axis, Hz.
pub const STRONG_HZ: f64 = 1.5;
/// Half a unit of the last digit of the printed frequencies, Hz.
pub const ROUNDING_HZ: f64 = 0.05;
/// Section 3.2: storey stiffness, kN/mm.
pub const STIFFNESS_KN_MM: [f64; 2] = [202.0, 15.1];

/// Conversion from kN/mm to kN/m.
const KILO: f64 = 1e3;

/// Eq. 7 as printed: the stiffness matrix in kN/m for k in kN/mm.
///
/// ```text
/// [k1 − P1/l1 − P2 (l1 + l2)/(l1 l2)     P2/l2     ]
/// [P2/l2                                 k2 − P2/l2]
/// ```
pub fn matrix_kn_m(k_kn_mm: [f64; 2]) -> [[f64; 2]; 2] {
    let ([p1, p2], [l1, l2]) = (AXIAL_KN, HEIGHT_M);
    let coupling = p2 / l2;
    [
        [KILO * k_kn_mm[0] - p1 / l1 - p2 * (l1 + l2) / (l1 * l2), coupling],
        [coupling, KILO * k_kn_mm[1] - coupling],
    ]
}

/// Both frequencies of eq. 8 for these stiffnesses, Hz.
pub fn frequencies_hz(k_kn_mm: [f64; 2]) -> [f64; 2] {
    let [[a, c], [_, b]] = matrix_kn_m(k_kn_mm);
    let [m1, m2] = MASS_T;
    let (sum, product) = (a / m1 + b / m2, (a * b - c * c) / (m1 * m2));
    let root = (0.25 * sum * sum - product).sqrt();
    [0.5 * sum - root, 0.5 * sum + root].map(|lambda| lambda.sqrt() / std::f64::consts::TAU)
}

/// Both pairs of stiffness, kN/mm, that satisfy eq. 8 for these frequencies, the smaller k1 first; `None` if there are
/// none. With K11 = m1 u and K22 = m2 v, u and v are the roots of x² − (λ1 + λ2) x + λ1 λ2 + K12²/(m1 m2) = 0.
pub fn stiffness_kn_mm(frequencies_hz: [f64; 2]) -> Option<[[f64; 2]; 2]> {
    let [l1, l2] = frequencies_hz.map(|f| (std::f64::consts::TAU * f).powi(2));
    let [m1, m2] = MASS_T;
    let [[without1, c], [_, without2]] = matrix_kn_m([0.0, 0.0]);
    let discriminant = 0.25 * (l1 - l2).powi(2) - c * c / (m1 * m2);
    if discriminant < 0.0 {
        return None;
    }
    let root = discriminant.sqrt();
    let pair = |u: f64| {
        let v = l1 + l2 - u;
        [(m1 * u - without1) / KILO, (m2 * v - without2) / KILO]
    };
    Some([pair(0.5 * (l1 + l2) - root), pair(0.5 * (l1 + l2) + root)])
}
