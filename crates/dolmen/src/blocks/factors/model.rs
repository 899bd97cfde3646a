//! Frequencies and shapes as functions of the logarithms of the factors, with their derivatives.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | x_g | `x` | ln c_g of the springs of factor g | – |
//! | φ_q, λ_q | | mode of order q of its family, φᵀ M φ = 1, and ω² of it | |
//! | a | `computed` | displacement at the points measured, of any scale | |
//! | s | `scale` | scale that brings a nearest to what was measured | |

use super::families::Family;
use super::stack_motion::StackMotion;
use crate::numeric::Residuals;
use dolmen_linalg::{Matrix, SymmetricEigen};
use std::f64::consts::TAU;

/// A measured shape.
pub(super) struct ShapeData {
    /// Rows that give the displacements at its points from a mode in the basis of the family, [points × d].
    pub(super) rows: Matrix,
    pub(super) displacement: Vec<f64>,
    pub(super) sd: Vec<f64>,
}

/// A measured mode beside the computed one that it is taken for.
pub(super) struct Datum {
    pub(super) motion: StackMotion,
    pub(super) family: usize,
    /// Order in the family, 0 the lowest.
    pub(super) order: usize,
    pub(super) frequency_hz: f64,
    /// Standard deviation of ln f.
    pub(super) relative_sd: f64,
    pub(super) shape: Option<ShapeData>,
}

/// The families of a stack and what was measured of them.
pub(super) struct FactorModel {
    pub(super) families: Vec<Family>,
    pub(super) data: Vec<Datum>,
    pub(super) unknowns: usize,
}

impl FactorModel {
    /// Frequencies and points of shapes, less one a shape for its scale.
    pub(super) fn data_count(&self) -> usize {
        let of = |datum: &Datum| {
            1 + datum
                .shape
                .as_ref()
                .map_or(0, |shape| shape.displacement.len() - 1)
        };
        self.data.iter().map(of).sum()
    }

    /// Modes of the families that are measured; `None` if a decomposition fails.
    pub(super) fn modes(&self, factors: &[f64]) -> Option<Vec<Option<SymmetricEigen>>> {
        let of = |(at, family): (usize, &Family)| match self.data.iter().any(|datum| datum.family == at) {
            true => family.modes(factors).ok().map(Some),
            false => Some(None),
        };
        self.families.iter().enumerate().map(of).collect()
    }

    /// Frequency of a measured mode, Hz.
    pub(super) fn frequency_hz(&self, datum: &Datum, factors: &[f64]) -> Option<f64> {
        let square = self.families[datum.family].square_of(factors, datum.order)?;
        Some(square.max(0.0).sqrt() / TAU)
    }

    /// ln f: (computed − measured)/sd, shapes: (s a − u)/sd, and their derivatives by x; `None` where a mode has no frequency.
    ///
    /// ```text
    /// d ln f/dx_g = c_g φᵀ K_g φ / (2 λ),    dφ_q/dx_g = Σ_p φ_p c_g φ_pᵀ K_g φ_q / (λ_q − λ_p)
    /// ```
    pub(super) fn residuals(&self, x: &[f64]) -> Option<Residuals> {
        let factors: Vec<f64> = x.iter().map(|x| x.exp()).collect();
        let modes = self.modes(&factors)?;
        let shapes = self.data.iter().filter_map(|datum| datum.shape.as_ref());
        let rows = self.data.len() + shapes.map(|shape| shape.displacement.len()).sum::<usize>();
        let mut residual = Vec::with_capacity(rows);
        let mut jacobian = Matrix::zeros(rows, x.len());
        for datum in &self.data {
            let modes = modes[datum.family].as_ref()?;
            let family = &self.families[datum.family];
            let square = modes
                .values
                .get(datum.order)
                .copied()
                .filter(|square| *square > 0.0)?;
            let mode = modes.vectors.column(datum.order);
            let row = residual.len();
            residual.push((square.sqrt() / (TAU * datum.frequency_hz)).ln() / datum.relative_sd);
            // K_g φ_q, times c_g
            let forces: Vec<Vec<f64>> = family
                .groups
                .iter()
                .zip(&factors)
                .map(|(group, factor)| group.times(mode).iter().map(|force| factor * force).collect())
                .collect();
            for (g, force) in forces.iter().enumerate() {
                jacobian[(row, g)] = 0.5 * product(mode, force) / (square * datum.relative_sd);
            }
            if let Some(shape) = &datum.shape {
                let change = |force: &Vec<f64>| mode_change(modes, datum.order, force);
                let changes: Vec<Vec<f64>> = forces.iter().map(change).collect();
                add_shape(shape, mode, &changes, &mut residual, &mut jacobian);
            }
        }
        Some(Residuals { residual, jacobian })
    }
}

/// Σ_p φ_p φ_pᵀ force / (λ_q − λ_p) over all other modes.
fn mode_change(modes: &SymmetricEigen, order: usize, force: &[f64]) -> Vec<f64> {
    let mut change = vec![0.0; force.len()];
    for (p, value) in modes.values.iter().enumerate() {
        let apart = modes.values[order] - value;
        if p == order || apart == 0.0 {
            continue;
        }
        let other = modes.vectors.column(p);
        let part = product(other, force) / apart;
        for (sum, entry) in change.iter_mut().zip(other) {
            *sum += part * entry;
        }
    }
    change
}

/// Appends (s a − u)/sd with the s that makes its squares least, and its derivatives.
fn add_shape(
    shape: &ShapeData,
    mode: &[f64],
    changes: &[Vec<f64>],
    residual: &mut Vec<f64>,
    jacobian: &mut Matrix,
) {
    let over_sd =
        |values: Vec<f64>| -> Vec<f64> { values.iter().zip(&shape.sd).map(|(v, sd)| v / sd).collect() };
    let computed = over_sd(shape.rows.times(mode));
    let measured = over_sd(shape.displacement.clone());
    let square = product(&computed, &computed);
    let scale = product(&computed, &measured) / square;
    let first = residual.len();
    residual.extend(computed.iter().zip(&measured).map(|(a, u)| scale * a - u));
    for (g, change) in changes.iter().enumerate() {
        let change = over_sd(shape.rows.times(change));
        let scale_change = (product(&change, &measured) - 2.0 * scale * product(&change, &computed)) / square;
        for (i, (da, a)) in change.iter().zip(&computed).enumerate() {
            jacobian[(first + i, g)] = scale * da + scale_change * a;
        }
    }
}

pub(super) fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
