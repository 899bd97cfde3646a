//! All solutions for the stiffness of one storey in plan.
//!
//! Coordinates are u, v, ρθ times √m, so that the mass matrix is the identity; stiffness is divided by m, 1/s².
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | q_x, q_y, q_θ | `q` | unit shapes of the modes along x, along y and of torsion | – |
//! | p, s | | ratio v/u of the mode along x; ratio u/v of the mode along y | – |
//! | A, B | `a`, `b` | λ_x − λ_θ, λ_y − λ_θ | (rad/s)² |

use super::plan_storey::{Labelled, PlanStiffnessError, PlanStorey};
use crate::structure::inverse::{SpringModel, roots_by_continuation};
use dolmen_linalg::{Matrix, symmetric_eigen};

/// Largest p of the search: the mode "along x" then moves a thousand times more along y.
pub(super) const SIDEWAYS_MOST: f64 = 1e3;
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

pub(super) struct PlanRoot {
    /// k_x, k_y, N/m, k_θ about the centre of rigidity, N·m/rad.
    pub(super) stiffness: [f64; 3],
    pub(super) eccentricity_m: [f64; 2],
    /// Unit shapes u, v, ρθ of the modes, ascending.
    pub(super) shapes: [[f64; 3]; 3],
    /// p, for a root from measured twists.
    pub(super) sideways: Option<f64>,
}

pub(super) struct PlanRoots {
    pub(super) roots: Vec<PlanRoot>,
    /// Whether all complex solutions were found.
    pub(super) complete: bool,
}

/// Vectors b_x, b_y, b_θ of the springs in u, v, ρθ, with k_θ over ρ².
pub(super) fn springs(storey: &PlanStorey, eccentricity_m: [f64; 2]) -> [[f64; 3]; 3] {
    let [e_x, e_y] = eccentricity_m.map(|e| e / storey.gyration_m);
    [[1.0, 0.0, -e_y], [0.0, 1.0, e_x], [0.0, 0.0, 1.0]]
}

/// Solutions of det(K − λ_j M) = 0 for a given centre of rigidity.
pub(super) fn roots_with_stated_centre(
    storey: &PlanStorey,
    lambda: &[f64; 3],
) -> Result<PlanRoots, PlanStiffnessError> {
    let (m, rho) = (storey.mass_kg, storey.gyration_m);
    let taken = storey.weight_takes_n_m / m;
    if storey.eccentricity_m == [0.0, 0.0] {
        return Ok(uncoupled(storey, lambda));
    }
    let b = springs(storey, storey.eccentricity_m);
    let model = SpringModel {
        mass: Matrix::identity(3),
        rest: Matrix::from_diagonal(&[-taken; 3]),
        springs: Matrix::from_fn(3, 3, |row, column| b[column][row]),
    };
    let found = roots_by_continuation(&model, lambda)?;
    let mut roots = Vec::with_capacity(found.stiffness.len());
    for k in &found.stiffness {
        let scaled = Matrix::from_fn(3, 3, |i, j| {
            let own: f64 = k.iter().zip(&b).map(|(k, b)| k * b[i] * b[j]).sum();
            own - if i == j { taken } else { 0.0 }
        });
        let eigen = symmetric_eigen(&scaled)?;
        roots.push(PlanRoot {
            stiffness: [m * k[0], m * k[1], m * rho * rho * k[2]],
            eccentricity_m: storey.eccentricity_m,
            shapes: [0, 1, 2].map(|j| [0, 1, 2].map(|i| eigen.vectors[(i, j)])),
            sideways: None,
        });
    }
    Ok(PlanRoots {
        roots,
        complete: found.complete,
    })
}

/// Without eccentricity each frequency determines one stiffness, k = m ω² + w, in every order.
fn uncoupled(storey: &PlanStorey, lambda: &[f64; 3]) -> PlanRoots {
    let unit = |at: usize| std::array::from_fn(|i| if i == at { 1.0 } else { 0.0 });
    let of_order = |order: &[usize; 3]| {
        let mut stiffness = [0.0; 3];
        for (at, lambda) in order.iter().zip(lambda) {
            let arm = if *at == 2 { storey.gyration_m.powi(2) } else { 1.0 };
            stiffness[*at] = arm * (storey.mass_kg * lambda + storey.weight_takes_n_m);
        }
        PlanRoot {
            stiffness,
            eccentricity_m: [0.0, 0.0],
            shapes: order.map(unit),
            sideways: None,
        }
    };
    PlanRoots {
        roots: ORDERS.iter().map(of_order).collect(),
        complete: true,
    }
}

/// Solutions, with their centres of rigidity, for given twists of the modes along x and y.
///
/// ```text
/// q_x ∝ [1 p t_x]ᵀ,  q_y ∝ [s 1 t_y]ᵀ,  q_xᵀ q_y = 0:  s = −p − t_x t_y,    K/m = Σ λ_j q_j q_jᵀ + w/m I
/// K_uv = 0:  A p (1 + s² + t_y²) + B s (1 + p² + t_x²) = 0,   a cubic in p
/// ```
pub(super) fn roots_with_shapes(storey: &PlanStorey, lambda: &[f64; 3], labelled: &Labelled) -> PlanRoots {
    let roots = real_roots(&cubic(lambda, labelled), SIDEWAYS_MOST).into_iter();
    PlanRoots {
        roots: roots.map(|p| root_at(storey, lambda, labelled, p)).collect(),
        complete: true,
    }
}

/// Coefficients of the cubic in p, lowest first.
pub(super) fn cubic(lambda: &[f64; 3], labelled: &Labelled) -> [f64; 4] {
    let [t_x, t_y] = labelled.twist;
    let [l_x, l_y, l_torsion] = labelled.mode_of.map(|mode| lambda[mode]);
    let (a, b, c) = (l_x - l_torsion, l_y - l_torsion, t_x * t_y);
    let (of_x, of_y) = (1.0 + t_x * t_x, 1.0 + t_y * t_y);
    [
        -b * c * of_x,
        a * (of_y + c * c) - b * of_x,
        (2.0 * a - b) * c,
        a - b,
    ]
}

pub(super) fn root_at(storey: &PlanStorey, lambda: &[f64; 3], labelled: &Labelled, p: f64) -> PlanRoot {
    let [t_x, t_y] = labelled.twist;
    let unit = |v: [f64; 3]| {
        let norm = v.iter().map(|v| v * v).sum::<f64>().sqrt();
        v.map(|v| v / norm)
    };
    let (q_x, q_y) = (unit([1.0, p, t_x]), unit([-p - t_x * t_y, 1.0, t_y]));
    let q_torsion = [
        q_x[1] * q_y[2] - q_x[2] * q_y[1],
        q_x[2] * q_y[0] - q_x[0] * q_y[2],
        q_x[0] * q_y[1] - q_x[1] * q_y[0],
    ];
    PlanRoot {
        sideways: Some(p),
        ..of_shapes(storey, lambda, labelled, [q_x, q_y, q_torsion])
    }
}

fn of_shapes(storey: &PlanStorey, lambda: &[f64; 3], labelled: &Labelled, q: [[f64; 3]; 3]) -> PlanRoot {
    let (m, rho) = (storey.mass_kg, storey.gyration_m);
    let mut shapes = [[0.0; 3]; 3];
    for (mode, q) in labelled.mode_of.iter().zip(q) {
        shapes[*mode] = q;
    }
    let entry = |i: usize, j: usize| {
        let own: f64 = lambda.iter().zip(&shapes).map(|(l, q)| l * q[i] * q[j]).sum();
        m * own + if i == j { storey.weight_takes_n_m } else { 0.0 }
    };
    let (k_x, k_y) = (entry(0, 0), entry(1, 1));
    let (e_x, e_y) = (rho * entry(1, 2) / k_y, -rho * entry(0, 2) / k_x);
    PlanRoot {
        stiffness: [
            k_x,
            k_y,
            rho * rho * entry(2, 2) - k_x * e_y * e_y - k_y * e_x * e_x,
        ],
        eccentricity_m: [e_x, e_y],
        shapes,
        sideways: None,
    }
}

/// Real roots within ± `most` of c_0 + c_1 x + c_2 x² + c_3 x³, ascending. Between its turning points the cubic is monotone.
pub(super) fn real_roots(c: &[f64; 4], most: f64) -> Vec<f64> {
    let value = |x: f64| c[0] + x * (c[1] + x * (c[2] + x * c[3]));
    let mut ends = vec![-most, most];
    ends.extend(turning_points(c).into_iter().filter(|x| x.abs() < most));
    ends.sort_by(f64::total_cmp);
    let mut roots = Vec::new();
    for pair in ends.windows(2) {
        let (mut low, mut high) = (pair[0], pair[1]);
        let rises = value(high) > 0.0;
        if (value(low) > 0.0) == rises {
            continue;
        }
        // until the interval cannot be divided further
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if (value(middle) > 0.0) == rises {
                high = middle;
            } else {
                low = middle;
            }
        }
        roots.push(if value(low) == 0.0 { low } else { high });
    }
    roots
}

/// The turning points of the cubic, computed without cancellation; a division by 0 leaves one of them out.
pub(super) fn turning_points(c: &[f64; 4]) -> Vec<f64> {
    let discriminant = c[2] * c[2] - 3.0 * c[3] * c[1];
    if discriminant < 0.0 {
        return Vec::new();
    }
    let sum = -(c[2] + discriminant.sqrt().copysign(c[2]));
    let turning = [sum / (3.0 * c[3]), c[1] / sum].into_iter();
    turning.filter(|x| x.is_finite()).collect()
}
