//! Motion of a building by the matrix exponential, for complex modes that coincide or do not oscillate.

use super::stepping::{Ground, Stepping};
use super::vibrating::VibratingBuilding;
use dolmen_linalg::Matrix;

/// Number of terms of the series of e^X for ‖X‖ ≤ 1/2: the remainder after 22 terms is less than 1e-28.
const TERMS: usize = 22;

/// A linear system whose base moves: ẍ + M⁻¹C ẋ + M⁻¹K x = −e a.
pub(crate) struct BaseDriven {
    /// M⁻¹K and M⁻¹C, n × n.
    pub(crate) stiffness: Matrix,
    pub(crate) damping: Matrix,
    /// e of the base along x and along y.
    pub(crate) influences: [Vec<f64>; 2],
    /// Output matrix for the displacements, rows × n.
    pub(crate) outputs: Matrix,
    /// Highest frequency, rad/s, by which velocities are divided.
    pub(crate) highest_rad_s: f64,
}

/// One step of the state x, x′/ω with ω the highest frequency: s ← E s + Σ_axes (A a + B b).
pub(crate) struct ExponentialSteps {
    transition: Matrix,
    ground: [[Vec<f64>; 2]; 2],
    outputs: Matrix,
    /// s′ = `rates` s + `pushes` a.
    rates: Matrix,
    pushes: [Vec<f64>; 2],
}

impl ExponentialSteps {
    pub(super) fn of_building(building: &VibratingBuilding, h: f64) -> Self {
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
        let influences = [0, 1].map(|axis| {
            let shaken = modes.modes.iter().map(|mode| mode.participation[axis]);
            shaken
                .chain(oscillators.iter().map(|own| own.unit[axis]))
                .collect()
        });
        let mut outputs = Matrix::zeros(size, size);
        for j in 0..n {
            outputs.column_mut(j)[..n].copy_from_slice(modes.shapes.column(j));
            for (d, own) in oscillators.iter().enumerate() {
                outputs[(n + d, j)] = -own.row[j];
            }
        }
        for d in 0..count {
            outputs[(n + d, n + d)] = 1.0;
        }
        let highest_rad_s = modes.omegas_rad_s().into_iter().fold(0.0, f64::max);
        let driven = BaseDriven {
            stiffness,
            damping,
            influences,
            outputs,
            highest_rad_s,
        };
        ExponentialSteps::new(&driven, h)
    }

    pub(crate) fn new(driven: &BaseDriven, h: f64) -> Self {
        let size = driven.stiffness.rows();
        // velocities are divided by the highest frequency: entries of ω² and 1 in one matrix would lose
        // digits
        let highest = driven.highest_rad_s;
        let mut rates = Matrix::zeros(2 * size, 2 * size);
        for i in 0..size {
            rates[(i, size + i)] = highest;
            for j in 0..size {
                rates[(size + i, j)] = -driven.stiffness[(i, j)] / highest;
                rates[(size + i, size + j)] = -driven.damping[(i, j)];
            }
        }
        let pushes = driven.influences.each_ref().map(|influence| {
            let pushed = influence.iter().map(|e| -e / highest);
            vec![0.0; size].into_iter().chain(pushed).collect::<Vec<f64>>()
        });
        // the state, then a and its change within the step, along x and y
        let whole = 2 * size + 4;
        let mut generator = Matrix::zeros(whole, whole);
        for j in 0..2 * size {
            for (to, rate) in generator.column_mut(j).iter_mut().zip(rates.column(j)) {
                *to = h * rate;
            }
        }
        for (axis, push) in pushes.iter().enumerate() {
            for (to, push) in generator.column_mut(2 * size + axis).iter_mut().zip(push) {
                *to = h * push;
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
        let mut outputs = Matrix::zeros(driven.outputs.rows(), 2 * size);
        for j in 0..size {
            outputs.column_mut(j).copy_from_slice(driven.outputs.column(j));
        }
        ExponentialSteps {
            transition: flow.block(0, 0, 2 * size, 2 * size),
            ground,
            outputs,
            rates,
            pushes,
        }
    }
}

impl Stepping for ExponentialSteps {
    fn outputs(&self) -> &Matrix {
        &self.outputs
    }

    fn rate_row(&self, row: &[f64]) -> Vec<f64> {
        let columns = (0..self.rates.columns()).map(|j| self.rates.column(j));
        columns
            .map(|column| row.iter().zip(column).map(|(r, x)| r * x).sum())
            .collect()
    }

    fn ground_of_row(&self, row: &[f64]) -> [f64; 2] {
        self.pushes
            .each_ref()
            .map(|push| row.iter().zip(push).map(|(r, x)| r * x).sum())
    }

    fn advance(&self, from: &[f64], to: &mut [f64], ground: Ground) {
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
