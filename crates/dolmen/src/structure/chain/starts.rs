//! Where the search for joint stiffness starts.

use super::Chain;
use crate::structure::{MeasuredMode, StructureError};
use dolmen_linalg::{LinalgError, Matrix, solve_least_squares};

/// Stiffness over the prior of the scattered starts, at most and at least, as a logarithm: e^±4 = 55 and 1/55. Stone
/// joints of one pole differ by that much (our choice).
const SCATTER: f64 = 4.0;

/// The prior and a low-discrepancy scatter of ln k around it: points `first` to `first + count` of the sequence,
/// of which point 0 is the prior.
///
/// # Source
/// Roberts, M. (2018) The unreasonable effectiveness of quasirandom sequences: x_i = frac(½ + i g^(−j)), with g the
/// positive root of g^(n+1) = g + 1.
pub(super) fn scattered_starts(prior: &[f64], first: usize, count: usize) -> Vec<Vec<f64>> {
    const HALVINGS: usize = 60; // of [1, 2] to the last bit
    let n = prior.len() as i32;
    let (mut low, mut high) = (1.0_f64, 2.0_f64);
    for _ in 0..HALVINGS {
        let g = 0.5 * (low + high);
        if g.powi(n + 1) > g + 1.0 {
            high = g;
        } else {
            low = g;
        }
    }
    let point = |i: usize| -> Vec<f64> {
        let coordinate = |(j, p): (usize, &f64)| {
            let unit = (0.5 + i as f64 * low.powi(-(j as i32 + 1))).fract();
            p + SCATTER * (2.0 * unit - 1.0)
        };
        prior.iter().enumerate().map(coordinate).collect()
    };
    (first..first + count.max(1)).map(point).collect()
}

/// ln k from the linear equations of the modes whose points give the whole shape; `None` if there are none or a
/// stiffness comes out not positive.
///
/// ```text
/// k_i (θ_i − θ_{i−1}) = Σ_{j≥i} (ω² M θ + G θ − s c cᵀ θ)_j        one equation a joint and mode, linear in k
/// ```
pub(super) fn linear_estimate(
    chain: &Chain,
    modes: &[MeasuredMode],
) -> Result<Option<Vec<f64>>, StructureError> {
    let n = chain.links().len();
    let mass = chain.mass_matrix();
    let (mut above, mut below) = (vec![0.0; n], vec![0.0; n]);
    for mode in modes {
        let Some(theta) = rotations(chain, mode)? else {
            continue;
        };
        let omega = std::f64::consts::TAU * mode.frequency_hz;
        let inertia = mass.times(&theta);
        let taken = chain.not_springs_times(&theta)?;
        let mut moment = 0.0;
        for i in (0..n).rev() {
            moment += omega * omega * inertia[i] + taken[i];
            let turn = theta[i] - if i == 0 { 0.0 } else { theta[i - 1] };
            // moments of a mode grow with ω²: weigh each mode's equations by it
            let weight = omega.powi(-4);
            above[i] += weight * turn * moment;
            below[i] += weight * turn * turn;
        }
    }
    let k: Vec<f64> = above.iter().zip(&below).map(|(a, b)| a / b).collect();
    let usable = k.iter().all(|&k| k > 0.0 && k.is_finite());
    Ok(usable.then(|| k.iter().map(|k| k.ln()).collect()))
}

/// Rotations of all links from a mode's points, by least squares; `None` if the points do not give them.
fn rotations(chain: &Chain, mode: &MeasuredMode) -> Result<Option<Vec<f64>>, StructureError> {
    let n = chain.links().len();
    if mode.shape.len() < n {
        return Ok(None);
    }
    let levers = mode.shape.iter().map(|point| chain.lever_m_rad(point.height_m));
    let levers: Vec<Vec<f64>> = levers.collect::<Result<_, _>>()?;
    let points: Vec<f64> = mode.shape.iter().map(|point| point.displacement).collect();
    let matrix = Matrix::from_fn(points.len(), n, |p, i| levers[p][i]);
    match solve_least_squares(&matrix, &Matrix::from_column(&points)) {
        Ok(theta) => Ok(Some(theta.column(0).to_vec())),
        Err(LinalgError::Singular { .. }) => Ok(None), // no sensor on some link
        Err(fault) => Err(fault.into()),
    }
}
