//! Frequencies and mode shapes as functions of the logarithms of the joint factors, with their derivatives.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | x_g | `x` | ln c_g, factor on the springs of group g | – |
//! | φ_q, λ_q | | mode of order q in its family, φᵀ M φ = 1, and its ω² | |
//! | a | `computed` | computed displacement at the measured points, with any scale | |
//! | s | `scale` | scale that fits a to the measured shape | |

use super::families::Family;
use super::stack_motion::StackMotion;
use crate::numeric::Residuals;
use dolmen_linalg::{Matrix, SymmetricEigen};
use std::f64::consts::TAU;

pub(super) struct ShapeData {
    /// Rows that give the displacements at the measured points from a mode in the basis of the family, [points × d].
    pub(super) rows: Matrix,
    pub(super) displacement: Vec<f64>,
    pub(super) sd: Vec<f64>,
}

/// Identification of a measured mode within its family.
#[derive(Clone, Copy, Debug)]
pub(super) enum ModeOfFamily {
    /// By its order among all modes of the family, 0 the lowest. Used if all modes of the family have the same kind of motion.
    Order(usize),
    /// By its number among the modes in which the measured motion predominates, 0 the lowest. Used if sway along x, sway along y and torsion are
    /// coupled: their modes then cross as the springs change.
    OfMotion(usize),
}

/// A measured mode and the computed mode that corresponds to it.
pub(super) struct Datum {
    pub(super) motion: StackMotion,
    pub(super) family: usize,
    pub(super) which: ModeOfFamily,
    pub(super) frequency_hz: f64,
    /// Standard deviation of ln f.
    pub(super) relative_sd: f64,
    pub(super) shape: Option<ShapeData>,
}

/// The families of modes of a stack, and the measured data.
pub(super) struct FactorModel {
    pub(super) families: Vec<Family>,
    pub(super) data: Vec<Datum>,
    pub(super) unknowns: usize,
}

impl FactorModel {
    /// Number of data: frequencies and points of shapes, minus one per shape for its scale.
    pub(super) fn data_count(&self) -> usize {
        let of = |datum: &Datum| {
            1 + datum
                .shape
                .as_ref()
                .map_or(0, |shape| shape.displacement.len() - 1)
        };
        self.data.iter().map(of).sum()
    }

    /// Modes of the families that have measured modes; `None` if a decomposition fails.
    pub(super) fn modes(&self, factors: &[f64]) -> Option<Vec<Option<SymmetricEigen>>> {
        let of = |(at, family): (usize, &Family)| match self.data.iter().any(|datum| datum.family == at) {
            true => family.modes(factors).ok().map(Some),
            false => Some(None),
        };
        self.families.iter().enumerate().map(of).collect()
    }

    /// Order of a measured mode in its family.
    pub(super) fn order(&self, datum: &Datum, modes: &SymmetricEigen) -> Option<usize> {
        match datum.which {
            ModeOfFamily::Order(order) => Some(order),
            ModeOfFamily::OfMotion(number) => {
                let orders = self.families[datum.family].orders_of(modes, datum.motion);
                orders.get(number).copied()
            }
        }
    }

    /// The same for these factors.
    pub(super) fn order_at(&self, datum: &Datum, factors: &[f64]) -> Option<usize> {
        match datum.which {
            ModeOfFamily::Order(order) => Some(order),
            ModeOfFamily::OfMotion(_) => {
                let modes = self.families[datum.family].modes(factors).ok()?;
                self.order(datum, &modes)
            }
        }
    }

    /// Computed frequency of a measured mode, Hz.
    pub(super) fn frequency_hz(&self, datum: &Datum, factors: &[f64]) -> Option<f64> {
        let order = self.order_at(datum, factors)?;
        let square = self.families[datum.family].square_of(factors, order)?;
        Some(square.max(0.0).sqrt() / TAU)
    }

    /// Residuals (computed − measured)/sd of ln f, (s a − u)/sd of shapes, and their derivatives with respect to x; `None` if a mode has no
    /// frequency.
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
            let order = self.order(datum, modes)?;
            let square = modes.values.get(order).copied().filter(|square| *square > 0.0)?;
            let mode = modes.vectors.column(order);
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
                let response = response(shape, modes, order);
                let changes = forces.iter().map(|force| response.times(force));
                add_shape(shape, mode, changes, &mut residual, &mut jacobian);
            }
        }
        Some(Residuals { residual, jacobian })
    }
}

/// Relative difference below which two modes have one frequency: they turn into each other without force.
const ONE_VALUE: f64 = 1e-9;

/// Derivative of the displacements at the points of a shape with respect to forces on the stones, Σ_p (rows φ_p) φ_pᵀ / (λ_q − λ_p) over all other
/// modes, [points × d].
fn response(shape: &ShapeData, modes: &SymmetricEigen, order: usize) -> Matrix {
    let at_points = &shape.rows * &modes.vectors;
    let size = modes.values.len();
    let weighted = Matrix::from_fn(at_points.rows(), size, |i, p| {
        let apart = modes.values[order] - modes.values[p];
        match p == order || apart.abs() <= ONE_VALUE * modes.values[order].abs() {
            true => 0.0,
            false => at_points[(i, p)] / apart,
        }
    });
    &weighted * &modes.vectors.transpose()
}

/// Appends the residuals (s a − u)/sd, with the s that minimises their squares, and their derivatives.
fn add_shape(
    shape: &ShapeData,
    mode: &[f64],
    changes: impl Iterator<Item = Vec<f64>>,
    residual: &mut Vec<f64>,
    jacobian: &mut Matrix,
) {
    let over_sd =
        |values: &[f64]| -> Vec<f64> { values.iter().zip(&shape.sd).map(|(v, sd)| v / sd).collect() };
    let computed = over_sd(&shape.rows.times(mode));
    let measured = over_sd(&shape.displacement);
    let square = product(&computed, &computed);
    let scale = product(&computed, &measured) / square;
    let first = residual.len();
    residual.extend(computed.iter().zip(&measured).map(|(a, u)| scale * a - u));
    for (g, change) in changes.enumerate() {
        let change = over_sd(&change);
        let scale_change = (product(&change, &measured) - 2.0 * scale * product(&change, &computed)) / square;
        for (i, (da, a)) in change.iter().zip(&computed).enumerate() {
            jacobian[(first + i, g)] = scale * da + scale_change * a;
        }
    }
}

pub(super) fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
