//! The same motion by the matrix exponential: where complex modes coincide or do not swing.

use super::history::Ground;
use super::vibrating::VibratingBuilding;
use dolmen_linalg::Matrix;

/// Terms of the series of e^X for ‖X‖ ≤ 1/2: 22 leave less than 1e-28.
const TERMS: usize = 22;

/// What one step does to the state η, z, η′/ω, z′/ω with ω the highest frequency: x ← E x + Σ_axes (A a + B b).
pub(super) struct ExponentialSteps {
    transition: Matrix,
    ground: [[Vec<f64>; 2]; 2],
    /// Displacements u, v, θ of the floors and strokes of the masses from the state.
    pub(super) outputs: Matrix,
}

impl ExponentialSteps {
    pub(super) fn new(building: &VibratingBuilding, h: f64) -> Self {
        let modes = building.modes();
        let oscillators = building.oscillators();
        let (n, count) = (modes.modes.len(), oscillators.len());
        let size = n + count;
        // M⁻¹K, M⁻¹C with M = diag(1, m)
        let mut stiffness = Matrix::zeros(size, size);
        let mut damping = Matrix::zeros(size, size);
        for (j, mode) in modes.modes.iter().enumerate() {
            stiffness[(j, j)] = mode.omega_rad_s * mode.omega_rad_s;
            damping[(j, j)] = 2.0 * building.damping_ratios()[j] * mode.omega_rad_s;
        }
        for (d, own) in oscillators.iter().enumerate() {
            let mut stretch: Vec<f64> = own.row.clone();
            stretch.resize(size, 0.0);
            stretch[n + d] = -1.0;
            for i in 0..size {
                let inverse = if i == n + d { 1.0 / own.mass } else { 1.0 };
                for j in 0..size {
                    let pair = inverse * stretch[i] * stretch[j];
                    stiffness[(i, j)] += own.stiffness * pair;
                    damping[(i, j)] += own.damping * pair;
                }
            }
        }
        // velocities over the highest frequency: else rows of ω² beside rows of 1 lose digits
        let highest = modes
            .modes
            .iter()
            .map(|mode| mode.omega_rad_s)
            .fold(0.0, f64::max);
        // x, then a and its change within the step, along x and y
        let whole = 2 * size + 4;
        let mut generator = Matrix::zeros(whole, whole);
        for i in 0..size {
            generator[(i, size + i)] = h * highest;
            for j in 0..size {
                generator[(size + i, j)] = -h / highest * stiffness[(i, j)];
                generator[(size + i, size + j)] = -h * damping[(i, j)];
            }
        }
        for axis in 0..2 {
            for (j, mode) in modes.modes.iter().enumerate() {
                generator[(size + j, 2 * size + axis)] = -h / highest * mode.participation[axis];
            }
            for (d, own) in oscillators.iter().enumerate() {
                generator[(size + n + d, 2 * size + axis)] = -h / highest * own.unit[axis];
            }
            generator[(2 * size + axis, 2 * size + 2 + axis)] = 1.0;
        }
        let flow = exponential(&generator);
        let ground = [0, 1].map(|axis| {
            let whole = flow.column(2 * size + axis)[..2 * size].to_vec();
            let change = flow.column(2 * size + 2 + axis)[..2 * size].to_vec();
            let start = whole.iter().zip(&change).map(|(whole, change)| whole - change);
            [start.collect(), change]
        });
        let mut outputs = Matrix::zeros(size, 2 * size);
        for j in 0..n {
            outputs.column_mut(j)[..n].copy_from_slice(modes.shapes.column(j));
            for (d, own) in oscillators.iter().enumerate() {
                outputs[(n + d, j)] = -own.row[j];
            }
        }
        for d in 0..count {
            outputs[(n + d, n + d)] = 1.0;
        }
        ExponentialSteps {
            transition: flow.block(0, 0, 2 * size, 2 * size),
            ground,
            outputs,
        }
    }

    pub(super) fn advance(&self, from: &[f64], to: &mut [f64], ground: Ground) {
        to.fill(0.0);
        for (j, x) in from.iter().enumerate() {
            for (sum, entry) in to.iter_mut().zip(self.transition.column(j)) {
                *sum += entry * x;
            }
        }
        for ([start, end], [a, b]) in self.ground.iter().zip(ground) {
            for (i, sum) in to.iter_mut().enumerate() {
                *sum += start[i] * a + end[i] * b;
            }
        }
    }
}

/// e^X by its series and squaring.
fn exponential(x: &Matrix) -> Matrix {
    let n = x.rows();
    let norm = (0..n)
        .map(|j| x.column(j).iter().map(|value| value.abs()).sum::<f64>())
        .fold(0.0, f64::max);
    let squarings = (2.0 * norm).max(1.0).log2().ceil() as i32;
    let scaled = x.scaled(0.5_f64.powi(squarings));
    let mut sum = Matrix::identity(n);
    for term in (1..=TERMS).rev() {
        // Horner: I + X/1 (I + X/2 (I + …))
        sum = &Matrix::identity(n) + &(&scaled * &sum).scaled(1.0 / term as f64);
    }
    for _ in 0..squarings {
        sum = &sum * &sum;
    }
    sum
}
