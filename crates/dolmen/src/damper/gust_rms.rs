//! Standard deviations of the response to turbulent wind, in modal coordinates. The results equal those of the assembled matrices, but much faster.

use super::{AttachedDamper, DamperError, DamperKind, ModalSynthesis};
use crate::dynamics::{LinearSystem, RandomInput, RandomLoad, Spectrum};
use crate::numeric::adaptive_nodes;
use crate::structure::wind::GustFace;
use dolmen_linalg::{Complex64, Matrix, symmetric_eigen};
use std::f64::consts::TAU;

/// Relative tolerance of each variance: the difference between the rules of 7 and 15 points. The integral is far more accurate. Our choice.
const TOLERANCE: f64 = 1e-5;
const INTERVALS_MOST: usize = 4000;
/// Ends of the integral: a fraction of the lowest frequency of gusts and structure, and a multiple of the highest frequency of the structure.
const ENDS: [f64; 2] = [1e-4, 30.0];

/// The face on which a force of turbulent wind acts.
fn face_of(load: &RandomLoad) -> Option<&GustFace> {
    match (&load.spectrum, &load.input) {
        (Spectrum::Gusts { face, .. }, RandomInput::Force(_)) => Some(face),
        _ => None,
    }
}

/// Whether all loads are forces of the same turbulent wind.
pub(super) fn are_gusts(loads: &[RandomLoad]) -> bool {
    let first = loads.first().and_then(face_of);
    first.is_some() && loads.iter().all(|load| face_of(load) == first)
}

/// Factor A of the two-sided cross spectra D = A Aᵀ of the loads at one circular frequency: D_lm = φ_lᵀ S_F φ_m/4π, loads × loads. The shapes φ are
/// orthonormal, so the loads together represent the whole force field.
///
/// # Errors
/// [`DamperError`] if the decomposition fails.
pub(super) fn gust_factor(loads: &[RandomLoad], omega: f64) -> Result<Matrix, DamperError> {
    // all loads act on the same face
    let face = loads.iter().find_map(face_of);
    let density = face.map(|face| face.force_density_n2_hz((omega / TAU).max(face.lowest_hz())));
    let shape_of = |l: usize| match &loads[l].spectrum {
        Spectrum::Gusts { shape, .. } => shape.as_slice(),
        _ => &[],
    };
    let of = |l: usize, m: usize| match &density {
        Some(density) => density.form(shape_of(l), shape_of(m)) / (2.0 * TAU),
        None => 0.0,
    };
    let found = symmetric_eigen(&Matrix::from_fn(loads.len(), loads.len(), of))?;
    let count = loads.len();
    // each pair of strips has its own mean speed, so an eigenvalue may be slightly negative
    Ok(Matrix::from_fn(count, count, |i, j| {
        found.vectors[(i, j)] * found.values[j].max(0.0).sqrt()
    }))
}

/// Transforms responses to the loads into responses to independent loads: multiplies each row, with one value per load, by A.
pub(super) fn in_parts(rows: &[Complex64], factor: &Matrix) -> Vec<Complex64> {
    let count = factor.rows();
    let each = rows.chunks_exact(count).flat_map(|row| {
        let part = |j: usize| -> Complex64 { row.iter().zip(factor.column(j)).map(|(x, a)| x * *a).sum() };
        (0..count).map(part).collect::<Vec<Complex64>>()
    });
    each.collect()
}

/// Standard deviations of the points, followed by those of the damper strokes.
///
/// # Errors
/// [`DamperError`] if a row or damper has the wrong length, or if the integral needs too many frequencies.
pub(super) fn gust_rms(
    structure: &LinearSystem,
    loads: &[RandomLoad],
    points: &[Vec<f64>],
    dampers: &[AttachedDamper],
) -> Result<Vec<f64>, DamperError> {
    let n = structure.degrees_of_freedom();
    let synthesis = ModalSynthesis::new(structure, n)?.with_fixed(dampers)?;
    let in_modes =
        |rows: &[Vec<f64>]| -> Vec<Vec<f64>> { rows.iter().map(|row| synthesis.in_modes(row)).collect() };
    let points = in_modes(points);
    let places: Vec<Vec<f64>> = dampers
        .iter()
        .map(|damper| synthesis.in_modes(&damper.row))
        .collect();
    let pushed: Vec<Vec<f64>> = loads
        .iter()
        .map(|load| synthesis.modal_load(&load.input))
        .collect();
    let along =
        |row: &[f64], eta: &[Complex64]| -> Complex64 { row.iter().zip(eta).map(|(a, x)| x * *a).sum() };
    let density = |omega: f64| -> Result<Vec<f64>, DamperError> {
        let mut moved = vec![Complex64::ZERO; (points.len() + dampers.len()) * loads.len()];
        for (l, pushed) in pushed.iter().enumerate() {
            let eta = synthesis.receptance(omega, pushed)?;
            let own = points.iter().map(|row| along(row, &eta));
            let strokes = dampers.iter().zip(&places).map(|(damper, row)| {
                let place = along(row, &eta);
                match damper.kind {
                    DamperKind::Viscous { .. } => place,
                    _ => omega * omega * place * damper.kind.stroke_per_acceleration(omega),
                }
            });
            for (i, x) in own.chain(strokes).enumerate() {
                moved[i * loads.len() + l] = x;
            }
        }
        let parts = in_parts(&moved, &gust_factor(loads, omega)?);
        let rows = parts.chunks_exact(loads.len());
        let sums: Vec<f64> = rows.map(|row| row.iter().map(|x| x.norm_sqr()).sum()).collect();
        Ok(sums)
    };
    let mut breaks: Vec<f64> = structure.modes()?.angular_frequency_rad_s;
    breaks.extend(
        dampers
            .iter()
            .flat_map(|damper| damper.kind.own_frequencies_hz())
            .map(|hz| TAU * hz),
    );
    breaks.extend(loads.iter().flat_map(|load| load.spectrum.breaks_rad_s()));
    breaks.sort_by(f64::total_cmp);
    let (first, last) = (breaks[0] * ENDS[0], breaks[breaks.len() - 1] * ENDS[1]);
    breaks.extend([first, last]);
    breaks.sort_by(f64::total_cmp);
    let logs: Vec<f64> = breaks.iter().map(|omega| omega.ln()).collect();
    let mut fault = None;
    let looked = adaptive_nodes(&logs, TOLERANCE, INTERVALS_MOST, |log| match density(log.exp()) {
        Ok(values) => Some(values.into_iter().map(|s| s * log.exp()).collect()),
        Err(stopped) => {
            fault = Some(stopped);
            None
        }
    });
    let nodes = looked.ok_or(fault.unwrap_or(DamperError::TooManyFrequencies {
        intervals: INTERVALS_MOST,
    }))?;
    // below the first frequency the density is taken as constant
    let mut sums: Vec<f64> = density(first)?.into_iter().map(|s| s * first).collect();
    for node in nodes {
        let omega = node.x.exp();
        let values = density(omega)?;
        let each = sums.iter_mut().zip(values);
        each.for_each(|(sum, value)| *sum += node.weight * omega * value);
    }
    Ok(sums.into_iter().map(|half| (2.0 * half).sqrt()).collect())
}
