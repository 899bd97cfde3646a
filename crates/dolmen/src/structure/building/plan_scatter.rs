//! Scatter of the stiffness of a storey in plan from the scatter of the measurement.
//!
//! ```text
//! dλ_j = q_jᵀ dK q_j,   dq_j = Σ_(i ≠ j) q_i (q_iᵀ dK q_j)/(λ_j − λ_i),   t = ρθ/u:  dt = (d(ρθ) − t du)/u
//! ```

use super::plan_roots::{PlanRoot, springs};
use super::plan_storey::{EccentricityFrom, PlanMode, PlanMotion, PlanStiffnessError, PlanStorey};
use dolmen_linalg::{Matrix, solve};
use std::f64::consts::TAU;

pub(super) struct Scatter {
    pub(super) stiffness_sd: Option<[f64; 3]>,
    pub(super) eccentricity_sd_m: Option<[f64; 2]>,
    pub(super) amplification: f64,
}

/// Linearises the equations at a root. The unknowns are ln k_x, ln k_y, ln k_θ and, for measured twists, e_x/ρ, e_y/ρ.
pub(super) fn scatter(
    storey: &PlanStorey,
    modes: &[PlanMode; 3],
    root: &PlanRoot,
    from: EccentricityFrom,
) -> Result<Scatter, PlanStiffnessError> {
    let changes = stiffness_changes(storey, root);
    let unknowns = match from {
        EccentricityFrom::Stated => 3,
        EccentricityFrom::Twists => 5,
    };
    let lambda = modes.map(|mode| (TAU * mode.frequency_hz).powi(2));
    let dot = |i: usize, change: &[[f64; 3]; 3], j: usize| -> f64 {
        let (left, right) = (&root.shapes[i], &root.shapes[j]);
        let row = |(l, row): (&f64, &[f64; 3])| l * row.iter().zip(right).map(|(k, r)| k * r).sum::<f64>();
        left.iter().zip(change).map(row).sum()
    };
    // rows: ln f of the three modes, then t of the modes along x and y
    let twisting = |motion: PlanMotion| modes.iter().position(|mode| mode.motion == Some(motion));
    let jacobian = Matrix::from_fn(unknowns, unknowns, |row, column| {
        let change = &changes[column];
        if row < 3 {
            return dot(row, change, row) / (2.0 * lambda[row]);
        }
        let motion = PlanMotion::ALL[row - 3];
        let Some(j) = twisting(motion) else { return 0.0 };
        let mut moved = [0.0; 3];
        for i in (0..3).filter(|&i| i != j) {
            let part = dot(i, change, j) / (lambda[j] - lambda[i]);
            for (moved, q) in moved.iter_mut().zip(&root.shapes[i]) {
                *moved += part * q;
            }
        }
        let shape = &root.shapes[j];
        let along = shape[motion.index()];
        (moved[2] - shape[2] / along * moved[motion.index()]) / along
    });
    let inverse = solve(&jacobian, &Matrix::identity(unknowns))?;
    let mut sd: Vec<f64> = modes
        .iter()
        .map(|mode| mode.frequency_sd_hz / mode.frequency_hz)
        .collect();
    for motion in PlanMotion::ALL.iter().take(unknowns - 3) {
        let twist = twisting(*motion).and_then(|mode| modes[mode].twist);
        sd.push(twist.map_or(0.0, |twist| twist.sd));
    }
    let known = sd.iter().all(|sd| *sd > 0.0);
    let sd_of = |row: usize| {
        let squares = sd
            .iter()
            .enumerate()
            .map(|(j, sd)| (inverse[(row, j)] * sd).powi(2));
        squares.sum::<f64>().sqrt()
    };
    let amplified = (0..3).map(|row| (0..3).map(|j| inverse[(row, j)].abs()).sum());
    Ok(Scatter {
        stiffness_sd: known.then(|| [0, 1, 2].map(|i| root.stiffness[i] * sd_of(i))),
        eccentricity_sd_m: (known && unknowns == 5).then(|| [3, 4].map(|i| storey.gyration_m * sd_of(i))),
        amplification: amplified.fold(0.0, f64::max),
    })
}

/// Derivative of K/m in u, v, ρθ with respect to each of ln k_x, ln k_y, ln k_θ, e_x/ρ, e_y/ρ.
fn stiffness_changes(storey: &PlanStorey, root: &PlanRoot) -> [[[f64; 3]; 3]; 5] {
    let b = springs(storey, root.eccentricity_m);
    let [k_x, k_y, k_theta] = root.stiffness;
    let k = [k_x, k_y, k_theta / storey.gyration_m.powi(2)].map(|k| k / storey.mass_kg);
    let own = |spring: usize| -> [[f64; 3]; 3] {
        std::array::from_fn(|i| std::array::from_fn(|j| k[spring] * b[spring][i] * b[spring][j]))
    };
    // b_y changes by [0 0 1] per e_x, b_x by [0 0 −1] per e_y
    let arm = |spring: usize, sign: f64| -> [[f64; 3]; 3] {
        let last = |at: usize| if at == 2 { sign } else { 0.0 };
        std::array::from_fn(|i| {
            std::array::from_fn(|j| k[spring] * (last(i) * b[spring][j] + b[spring][i] * last(j)))
        })
    };
    [own(0), own(1), own(2), arm(1, 1.0), arm(0, -1.0)]
}
