//! The effect of dampers on a structure, from the assembled matrices.

use super::gust_rms::{are_gusts, gust_rms};
use super::{AttachedDamper, DampedSystem, DamperError};
use crate::dynamics::{
    FrequencyIntegral, LinearSystem, RandomLoad, ResponseRow, rms_by_integral, rms_by_lyapunov,
};

/// The effect of dampers.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// Standard deviation of each point's displacement.
    pub point_rms: Vec<f64>,
    /// Standard deviation of each damper's stroke, the displacement of its mass relative to its place, m.
    pub stroke_rms_m: Vec<f64>,
}

/// The effect of any dampers on a structure, from the assembled matrices.
///
/// # Errors
/// [`DamperError`] if a damper or a load is out of its range.
pub fn judge(
    structure: &LinearSystem,
    loads: &[RandomLoad],
    points: &[Vec<f64>],
    dampers: &[AttachedDamper],
) -> Result<Judged, DamperError> {
    let damped = DampedSystem::new(structure, dampers)?;
    if are_gusts(loads) {
        loads.iter().try_for_each(|load| load.spectrum.check())?;
        let mut all = gust_rms(structure, loads, points, dampers)?;
        let stroke_rms_m = all.split_off(points.len());
        return Ok(Judged {
            point_rms: all,
            stroke_rms_m,
        });
    }
    let loads: Vec<RandomLoad> = loads.iter().map(|load| damped.load(load)).collect();
    let mut rows: Vec<ResponseRow> = points
        .iter()
        .map(|row| ResponseRow::displacement(damped.row(row)))
        .collect();
    rows.extend(
        (0..dampers.len())
            .filter_map(|k| damped.stroke_row(k))
            .map(ResponseRow::displacement),
    );
    let mut all = rms(&damped.system, &loads, &rows)?;
    let stroke_rms_m = all.split_off(points.len());
    Ok(Judged {
        point_rms: all,
        stroke_rms_m,
    })
}

fn rms(system: &LinearSystem, loads: &[RandomLoad], rows: &[ResponseRow]) -> Result<Vec<f64>, DamperError> {
    match rms_by_lyapunov(system, loads, rows) {
        Err(crate::dynamics::DynamicsError::NotRational) => {
            let options = FrequencyIntegral {
                relative_tolerance: 1e-7,
                ..FrequencyIntegral::default()
            };
            Ok(rms_by_integral(system, loads, rows, &options)?)
        }
        other => Ok(other?),
    }
}
