//! Poles of all orders from the Markov parameters of an observer (eigensystem realization), with their standard deviations.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | H | `hankel` | H(i, j) = h_{i+j+1} W: effect of past inputs and innovations on the future | l r × q r |
//! | W | `weights` | Cholesky factors of the covariances of inputs and innovations | q × q |
//! | U, S, V | `u`, `svd` | of H | n columns |
//! | O↑, O↓ | `upper`, `shifted` | U without its last, first block row | l (r - 1) × n |
//! | χ, φ | `left`, `right` | left and right eigenvectors of A, χᵀφ = 1 | n |

use super::markov_parameters::MarkovParameters;
use super::observer::Observer;
use crate::modal::indicators::{normalized, phase_collinearity, phase_deviation};
use crate::modal::subspace::{
    Deviations, Order, Pole, correction, forward_substitute, frequency_and_damping, nearest, poles_of, state,
};
use crate::modal::{ModalError, PoleDeviation};
use dolmen_linalg::{Complex64, Matrix, Qr, Svd, cholesky, qr, svd};

/// Relative error of a frequency and a damping ratio due to sampling, because the ground reacts to the structure within a sample. Measured on a
/// simulated frame with ten samples per period of its highest mode.
const SAMPLED_FREQUENCY: f64 = 2e-4;
const SAMPLED_DAMPING: f64 = 5e-3;

/// The state of a structure, realized at every even order.
pub(super) struct Realization {
    /// By order, then by frequency; shapes in the units of the channels.
    pub(super) poles: Vec<Pole>,
    pub(super) singular_values: Vec<f64>,
    /// The poles if the sensors have the additional possible noise.
    pub(super) noisier: Vec<Pole>,
    rate_hz: f64,
    svd: Svd,
    upper: Qr,
    shifted: Matrix,
    block_rows: usize,
    /// Change of the weighted responses by each block of time.
    changes: Vec<MarkovParameters>,
    /// State matrices decomposed so far, by order.
    orders: Vec<Option<Order>>,
}

pub(super) struct Realize<'a> {
    pub(super) block_rows: usize,
    pub(super) order_most: usize,
    pub(super) rate_hz: f64,
    /// Standard deviation of each channel, by which the observer was scaled.
    pub(super) scales: &'a [f64],
}

/// `None` if the responses grow, because a structure has no such observer.
///
/// # Errors
/// [`ModalError::Linalg`].
///
/// # Source
/// Juang, Phan, Horta & Longman (1993) J. Guid. Control Dyn. 16(2):320-329. Differs from the source: innovations are inputs too, weighted by their
/// strength, so that unmeasured forces reveal modes as well; all orders are realized from one QR (Döhler & Mevel 2012).
pub(super) fn realize(observer: &Observer, how: &Realize<'_>) -> Result<Option<Realization>, ModalError> {
    const GROWTH_MOST: f64 = 10.0; // over the largest of the first samples
    let (l, r) = (observer.outputs, how.block_rows);
    let steps = 2 * r;
    let markov = observer.markov_parameters(steps);
    let early = (0..r).map(|k| markov.largest(k)).fold(0.0, f64::max);
    let late = (r..steps).map(|k| markov.largest(k)).fold(0.0, f64::max);
    if !late.is_finite() || late > GROWTH_MOST * early {
        return Ok(None);
    }
    let weights = weights(observer)?;
    let changes = observer.changes.iter();
    let changes = changes.map(|moved| observer.change(&markov, steps, moved).weighted(&weights));
    let changes = changes.collect();
    let markov = markov.weighted(&weights);
    let q = markov.columns;
    let hankel = Matrix::from_fn(l * r, q * r, |i, j| {
        markov.at(i / l + j / q + 1)[(i % l) * q + j % q]
    });
    let svd = svd(&hankel)?;
    let n = how.order_most.min(svd.s.len()) / 2 * 2;
    let u = svd.u.block(0, 0, l * r, n);
    let upper = qr(&u.block(0, 0, l * (r - 1), n))?;
    let shifted = upper.q.transpose_times(&u.block(l, 0, l * (r - 1), n));
    let mut poles = Vec::new();
    for order in (2..=n).step_by(2) {
        let found = poles_of(&state(&upper.r, &shifted, order), &u, l, 1.0 / how.rate_hz)?;
        poles.extend(found.into_iter().map(|pole| in_units(pole, how.scales)));
    }
    Ok(Some(Realization {
        poles,
        singular_values: svd.s.clone(),
        noisier: Vec::new(),
        rate_hz: how.rate_hz,
        svd,
        upper,
        shifted,
        block_rows: r,
        changes,
        orders: (0..=n).map(|_| None).collect(),
    }))
}

fn in_units(mut pole: Pole, scales: &[f64]) -> Pole {
    let shape: Vec<Complex64> = pole.shape.iter().zip(scales).map(|(z, s)| z * s).collect();
    pole.phase_collinearity = phase_collinearity(&shape);
    pole.phase_deviation = phase_deviation(&shape);
    pole.shape = normalized(&shape);
    pole
}

/// Inputs and innovations are uncorrelated; the weight of each is its strength.
fn weights(observer: &Observer) -> Result<Matrix, ModalError> {
    let (m, l) = (observer.inputs, observer.outputs);
    let (of_inputs, of_innovations) = (cholesky(&observer.of_inputs)?, cholesky(&observer.innovation)?);
    Ok(Matrix::from_fn(m + l, m + l, |i, j| match (i < m, j < m) {
        (true, true) => of_inputs[(i, j)],
        (false, false) => of_innovations[(i - m, j - m)],
        _ => 0.0,
    }))
}

impl Realization {
    /// Changes of frequency, Hz, and damping ratio by each block of time.
    ///
    /// ```text
    /// dλ = χᵀ R_n⁻¹ Q_nᵀ (dH↓ - λ dH↑) V_n S_n⁻¹ φ = Σ_k ⟨W_k, dh_{k+2} - λ dh_{k+1}⟩
    /// ```
    fn pole_changes(&mut self, pole: &Pole) -> Result<Vec<[f64; 2]>, ModalError> {
        let (n, lambda) = (pole.order, pole.eigenvalue);
        let order = match &mut self.orders[n] {
            Some(order) => order,
            slot @ None => slot.insert(Order::of(&state(&self.upper.r, &self.shifted, n))?),
        };
        let index = nearest(&order.values, lambda);
        let (right, left) = (order.right.column(index), order.left.column(index));
        let mut left = left.to_vec();
        forward_substitute(&self.upper.r, &mut left);
        let rows = times(&self.upper.q, &left);
        let scaled: Vec<Complex64> = right.iter().zip(&self.svd.s).map(|(x, s)| x / s).collect();
        let columns = times(&self.svd.v, &scaled);
        let Some(first) = self.changes.first() else {
            return Ok(Vec::new());
        };
        let (l, q, r) = (first.rows, first.columns, self.block_rows);
        let mut weights = vec![Complex64::ZERO; (2 * r - 2) * l * q];
        for (i, row) in rows.chunks_exact(l).enumerate() {
            for (j, column) in columns.chunks_exact(q).enumerate() {
                let of = &mut weights[(i + j) * l * q..(i + j + 1) * l * q];
                for (at, w) in of.iter_mut().enumerate() {
                    *w += row[at / q] * column[at % q];
                }
            }
        }
        let of_block = |change: &MarkovParameters| {
            let mut d_lambda = Complex64::ZERO;
            for (k, weights) in weights.chunks_exact(l * q).enumerate() {
                let (next, this) = (change.at(k + 2), change.at(k + 1));
                let pairs = weights.iter().zip(next.iter().zip(this));
                d_lambda += pairs
                    .map(|(w, (next, this))| w * (next - lambda * this))
                    .sum::<Complex64>();
            }
            frequency_and_damping(pole, d_lambda, self.rate_hz)
        };
        let by_time = self.changes.iter().map(of_block);
        let by_noise = self.noisier.iter().filter(|other| other.order == n);
        let apart = |other: &Pole| (other.eigenvalue - lambda).norm();
        let nearest = by_noise.min_by(|a, b| apart(a).total_cmp(&apart(b)));
        let by_noise = nearest.map(|other| {
            [
                other.frequency_hz - pole.frequency_hz,
                other.damping_ratio - pole.damping_ratio,
            ]
        });
        let by_sampling = [
            SAMPLED_FREQUENCY * pole.frequency_hz,
            SAMPLED_DAMPING * pole.damping_ratio,
        ];
        Ok(by_time.chain(by_noise).chain([by_sampling]).collect())
    }
}

impl Deviations for Realization {
    fn frequency_sd_hz(&mut self, pole: &Pole) -> Result<f64, ModalError> {
        Ok(self.deviation(pole)?.frequency_sd_hz)
    }

    fn deviation(&mut self, pole: &Pole) -> Result<PoleDeviation, ModalError> {
        let changes = self.pole_changes(pole)?;
        let share = correction(changes.len()).sqrt();
        let norm = |at: usize| share * changes.iter().map(|d| d[at] * d[at]).sum::<f64>().sqrt();
        Ok(PoleDeviation {
            frequency_sd_hz: norm(0),
            frequency_changes_hz: changes.iter().map(|d| share * d[0]).collect(),
            damping_ratio_sd: norm(1),
            shape_sd: Vec::new(),
        })
    }
}

/// First columns of a real matrix times a vector.
fn times(m: &Matrix, x: &[Complex64]) -> Vec<Complex64> {
    let mut y = vec![Complex64::ZERO; m.rows()];
    for (j, x) in x.iter().enumerate() {
        for (y, m) in y.iter_mut().zip(m.column(j)) {
            *y += x * m;
        }
    }
    y
}
