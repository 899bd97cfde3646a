//! Starting points of the search for stiffness.

use super::{SpringModel, Sprung};
use crate::structure::{MeasuredMode, StructureError};
use dolmen_linalg::{LinalgError, Matrix, solve, solve_least_squares};

/// Range of the scattered starts, as ln of the stiffness over the prior: e^±4 = 55 and 1/55. The joints of one pole
/// differ by as much (our choice).
const SCATTER: f64 = 4.0;

/// Points of ln k: a low-discrepancy sequence around the prior. Returns points `first` to `first + count`; point 0
/// is the prior.
///
/// # Source
/// Roberts, M. (2018) The unreasonable effectiveness of quasirandom sequences: x_i = frac(½ + i g^(−j)), with g the
/// positive root of g^(n+1) = g + 1.
pub(super) fn scattered_starts(prior: &[f64], first: usize, count: usize) -> Vec<Vec<f64>> {
    const HALVINGS: usize = 60; // halvings of [1, 2], to the last bit
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

/// ln k from the linear equations of the modes whose points determine the whole shape; `None` if there are no such
/// modes, or if a stiffness is not positive.
///
/// ```text
/// k_i (b_iᵀ φ) = (B⁻¹ (ω² M φ − K_0 φ))_i               one equation a spring and mode, linear in k
/// ```
pub(super) fn linear_estimate(
    structure: &impl Sprung,
    model: &SpringModel,
    modes: &[MeasuredMode],
) -> Result<Option<Vec<f64>>, StructureError> {
    let n = model.parts();
    let (mut above, mut below) = (vec![0.0; n], vec![0.0; n]);
    for mode in modes {
        let Some(shape) = whole_shape(structure, n, mode)? else {
            continue;
        };
        let omega = std::f64::consts::TAU * mode.frequency_hz;
        let inertia = model.mass.times(&shape);
        let pairs = inertia.iter().zip(model.rest.times(&shape));
        let force: Vec<f64> = pairs.map(|(m, rest)| omega * omega * m - rest).collect();
        let held = solve(&model.springs, &Matrix::from_column(&force))?;
        // the forces of a mode increase with ω², so its squared equations get the weight ω⁻⁴
        let weight = omega.powi(-4);
        for i in 0..n {
            let extension = model.extension(i, &shape);
            above[i] += weight * extension * held[(i, 0)];
            below[i] += weight * extension * extension;
        }
    }
    let k: Vec<f64> = above.iter().zip(&below).map(|(a, b)| a / b).collect();
    let usable = k.iter().all(|&k| k > 0.0 && k.is_finite());
    Ok(usable.then(|| k.iter().map(|k| k.ln()).collect()))
}

/// All coordinates of a mode from its measured points, by least squares; `None` if the points do not determine them.
fn whole_shape(
    structure: &impl Sprung,
    coordinates: usize,
    mode: &MeasuredMode,
) -> Result<Option<Vec<f64>>, StructureError> {
    if mode.shape.len() < coordinates {
        return Ok(None);
    }
    let sensors = mode.shape.iter().map(|point| structure.sensor(point.height_m));
    let sensors: Vec<Vec<f64>> = sensors.collect::<Result<_, _>>()?;
    let points: Vec<f64> = mode.shape.iter().map(|point| point.displacement).collect();
    let matrix = Matrix::from_fn(points.len(), coordinates, |p, i| sensors[p][i]);
    match solve_least_squares(&matrix, &Matrix::from_column(&points)) {
        Ok(shape) => Ok(Some(shape.column(0).to_vec())),
        Err(LinalgError::Singular { .. }) => Ok(None), // a part has no sensor
        Err(fault) => Err(fault.into()),
    }
}
