//! The observer of a structure with measured inputs: a vector autoregression, least squares over all samples.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | l, m, p | `outputs`, `inputs`, `lags` | channels, inputs, past samples | |
//! | z_t | a row of `regressors` | past of the outputs, then present and past of the inputs | K = p l + (p + 1) m |
//! | Θ | `coefficients` | y_t = Θᵀ z_t + e_t | K × l |
//! | dΘ | `changes` | change of Θ by one block of time | K × l |
//! | Σ | `innovation` | covariance of e | l × l |

use crate::modal::ModalError;
use dolmen_linalg::{Matrix, cholesky, solve_lower, solve_lower_transposed};
use std::ops::Range;

/// Channels of equal length, each divided by its own standard deviation.
pub(super) struct Measured {
    pub(super) outputs: Vec<Vec<f64>>,
    pub(super) inputs: Vec<Vec<f64>>,
}

pub(super) struct Observer {
    pub(super) outputs: usize,
    pub(super) inputs: usize,
    pub(super) lags: usize,
    pub(super) coefficients: Matrix,
    /// One change for each block of time; the sum of their squares is the variance.
    pub(super) changes: Vec<Matrix>,
    pub(super) innovation: Matrix,
    /// Correlations of the inputs at lag 0, m × m.
    pub(super) of_inputs: Matrix,
}

pub(super) struct Fit {
    pub(super) lags: usize,
    pub(super) blocks: usize,
    /// Assumed noise over the standard deviation of a channel: it keeps the observer of a noise-free record stable.
    pub(super) noise: f64,
}

/// Number of coefficients of an observer of this size.
pub(super) fn coefficients_of(outputs: usize, inputs: usize, lags: usize) -> usize {
    lags * (outputs + inputs) + inputs
}

/// ```text
/// Θ = (Σ_t z_t z_tᵀ + ν² diag)⁻¹ Σ_t z_t y_tᵀ;   dΘ_b = (…)⁻¹ (Σ_{t in b} z_t e_tᵀ - their mean over the blocks)
/// ```
/// The contribution of unmeasured forces to e is white, so the scores of blocks of time are independent, however short. So the
/// changes of the coefficients are valid for a record of variable strength, such as an earthquake (White 1980).
///
/// # Errors
/// [`ModalError::Linalg`].
pub(super) fn observe(of: &Measured, fit: &Fit) -> Result<Observer, ModalError> {
    let (outputs, inputs) = (of.outputs.len(), of.inputs.len());
    let size = coefficients_of(outputs, inputs, fit.lags);
    let spans = spans(of.outputs[0].len(), fit);
    let (mut normal, mut right) = (Matrix::zeros(size, size), Matrix::zeros(size, outputs));
    for span in &spans {
        let (z, y) = (regressors(of, fit.lags, span), targets(of, span));
        add(&mut normal, &z.transpose_times(&z));
        add(&mut right, &z.transpose_times(&y));
    }
    for i in 0..size {
        normal[(i, i)] *= 1.0 + fit.noise * fit.noise;
    }
    let lower = cholesky(&normal)?;
    let solved = |b: Matrix| -> Result<Matrix, ModalError> {
        Ok(solve_lower_transposed(&lower, solve_lower(&lower, b)?)?)
    };
    let coefficients = solved(right)?;
    let (mut scores, mut mean) = (Vec::with_capacity(spans.len()), Matrix::zeros(size, outputs));
    let mut innovation = Matrix::zeros(outputs, outputs);
    let share = 1.0 / spans.len() as f64;
    let mut samples = 0;
    for span in &spans {
        let z = regressors(of, fit.lags, span);
        let mut rest = targets(of, span);
        let told = &z * &coefficients;
        for (e, told) in rest.as_mut_slice().iter_mut().zip(told.as_slice()) {
            *e -= told;
        }
        add(&mut innovation, &rest.transpose_times(&rest));
        samples += rest.rows();
        let score = z.transpose_times(&rest);
        add(&mut mean, &score.scaled(share));
        scores.push(score);
    }
    let mut changes = Vec::with_capacity(scores.len());
    for mut score in scores {
        for (s, mean) in score.as_mut_slice().iter_mut().zip(mean.as_slice()) {
            *s -= mean;
        }
        changes.push(solved(score)?);
    }
    Ok(Observer {
        outputs,
        inputs,
        lags: fit.lags,
        coefficients,
        changes,
        innovation: innovation.scaled(1.0 / samples as f64),
        of_inputs: products(&of.inputs),
    })
}

/// Samples with a complete past, in blocks of time.
fn spans(samples: usize, fit: &Fit) -> Vec<Range<usize>> {
    let whole = samples - fit.lags;
    let edge = |b: usize| fit.lags + whole * b / fit.blocks;
    (0..fit.blocks).map(|b| edge(b)..edge(b + 1)).collect()
}

fn regressors(of: &Measured, lags: usize, span: &Range<usize>) -> Matrix {
    let (outputs, inputs) = (of.outputs.len(), of.inputs.len());
    let mut z = Matrix::zeros(span.len(), coefficients_of(outputs, inputs, lags));
    let past = (1..=lags).flat_map(|lag| of.outputs.iter().map(move |of| (lag, of)));
    let driven = (0..=lags).flat_map(|lag| of.inputs.iter().map(move |of| (lag, of)));
    for (column, (lag, samples)) in past.chain(driven).enumerate() {
        z.column_mut(column)
            .copy_from_slice(&samples[span.start - lag..span.end - lag]);
    }
    z
}

fn targets(of: &Measured, span: &Range<usize>) -> Matrix {
    let mut y = Matrix::zeros(span.len(), of.outputs.len());
    for (column, samples) in of.outputs.iter().enumerate() {
        y.column_mut(column).copy_from_slice(&samples[span.clone()]);
    }
    y
}

fn add(sum: &mut Matrix, more: &Matrix) {
    for (sum, more) in sum.as_mut_slice().iter_mut().zip(more.as_slice()) {
        *sum += more;
    }
}

/// Mean products of series of equal length.
fn products(of: &[Vec<f64>]) -> Matrix {
    Matrix::from_fn(of.len(), of.len(), |i, j| {
        let sum: f64 = of[i].iter().zip(&of[j]).map(|(a, b)| a * b).sum();
        sum / of[i].len() as f64
    })
}
