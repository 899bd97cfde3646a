//! Time history of a structure with dampers in turbulent wind.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | c_k | `GustForces::line_n` | amplitudes of the strip forces at one spectral line | strips |
//! | E | `columns` | load on the structure per unit force on each strip | n × strips |
//! | H(n) | `ModalSynthesis` | receptance of structure and dampers | n × n |
//! | x(t) | `GustHistory::values` | x̄ + Σ_k Re[r H(n_k) E c_k e^(2πi n_k t)] for each row r | rows |

use super::gust_row::{GustQuantity, GustRow};
use super::gust_strokes::strokes_under;
use super::{AttachedDamper, DamperError, DamperKind, ModalSynthesis};
use crate::dynamics::{DynamicsError, LinearSystem};
use crate::numeric::CosineSum;
use crate::structure::wind::{GustForces, GustTimes};
use dolmen_linalg::{Complex64, Matrix, solve};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Least ratio of ζ f of a mode to the line spacing at which equally spaced lines represent the resonance: the sum over the lines is within 2
/// e^(−2π · 1.5) = 1.6e-4 of the integral.
const DAMPED_PERIODS: f64 = 1.5;
/// Largest number of samples in a period. Our choice.
const SAMPLES_MOST: f64 = 4e6;

/// Time history of a structure in wind.
#[derive(Clone, Debug, PartialEq)]
pub struct GustHistory {
    /// Times of the samples.
    pub times: GustTimes,
    /// Value of each row at each time.
    pub values: Vec<Vec<f64>>,
    /// Strokes over time for each case of columns, m: of the dampers, then the liquid rises of columns on springs.
    pub strokes: Vec<Vec<Vec<f64>>>,
}

/// Sampling times of a wind history over `duration_s`, and its period. The period is at least twice the duration. It is also long enough for the
/// lines to represent every resonance: 1.5 periods of each mode and damper over its damping ratio.
///
/// # Errors
/// [`DamperError::Argument`] for a duration or step that is not positive, a mode or damper without damping, or more than 4 million samples;
/// [`DamperError::Dynamics`] if the modes cannot be computed.
pub fn gust_times(
    structure: &LinearSystem,
    dampers: &[AttachedDamper],
    duration_s: f64,
    time_step_s: f64,
) -> Result<GustTimes, DamperError> {
    for (argument, given) in [("duration_s", duration_s), ("time_step_s", time_step_s)] {
        if !(given > 0.0 && given.is_finite()) {
            return Err(DamperError::Argument {
                argument,
                given,
                allowed: "positive",
            });
        }
    }
    let least_hz = least_decay_hz(structure, dampers)?;
    if least_hz.is_nan() || least_hz <= 0.0 {
        return Err(DamperError::Argument {
            argument: "damping_ratio",
            given: 0.0,
            allowed: "above 0",
        });
    }
    let period_s = (2.0 * duration_s).max(DAMPED_PERIODS / least_hz);
    let samples = period_s / time_step_s;
    if samples > SAMPLES_MOST {
        return Err(DamperError::Argument {
            argument: "samples of the history",
            given: samples,
            allowed: "at most 4 000 000",
        });
    }
    Ok(GustTimes::new(duration_s, time_step_s, period_s))
}

/// The smallest product of frequency and damping ratio over modes and dampers, Hz.
fn least_decay_hz(structure: &LinearSystem, dampers: &[AttachedDamper]) -> Result<f64, DamperError> {
    let modes = structure.modes()?;
    let own = (0..modes.angular_frequency_rad_s.len()).map(|j| 0.5 * modes.damping[(j, j)] / TAU);
    let attached = dampers.iter().flat_map(|damper| match damper.kind {
        DamperKind::TunedMass {
            frequency_hz,
            damping_ratio,
            ..
        }
        | DamperKind::LiquidColumn {
            frequency_hz,
            damping_ratio,
            ..
        } => vec![frequency_hz * damping_ratio],
        DamperKind::LiquidColumnMass {
            frequency_hz,
            damping_ratio,
            liquid_frequency_hz,
            liquid_damping_ratio,
            ..
        } => vec![
            frequency_hz * damping_ratio,
            liquid_frequency_hz * liquid_damping_ratio,
        ],
        DamperKind::Viscous { .. } => Vec::new(),
    });
    Ok(own.chain(attached).fold(f64::INFINITY, f64::min))
}

/// Motion under one wind history. `columns` holds one set for each case, as in [`gust_motion`](super::gust_motion).
///
/// Each spectral line of the wind produces a steady motion of structure and dampers, given by their receptances. So the motion is exact for
/// these forces, has no transient, and is periodic like the forces.
///
/// # Errors
/// [`DynamicsError::Entries`] for columns, rows or cases that do not fit; [`DamperError`] if a damper is out of its range, or if a line
/// coincides with an undamped mode.
///
/// # Limits
/// Structure and dampers are linear: no stops; head loss is a damping ratio. The difference to time stepping (Newmark, steps of 2 ms) is 2e-4 of
/// the largest value.
pub fn gust_history(
    structure: &LinearSystem,
    dampers: &[AttachedDamper],
    columns: &[Vec<Vec<f64>>],
    rows: &[GustRow],
    gusts: &GustForces,
) -> Result<GustHistory, DamperError> {
    let n = structure.degrees_of_freedom();
    let strips = gusts.mean_n.len();
    let entries = |argument, given: usize, needed: usize| match given == needed {
        true => Ok(()),
        false => Err(DynamicsError::Entries {
            argument,
            given,
            needed,
        }),
    };
    for of in columns {
        entries("columns", of.len(), strips)?;
        of.iter()
            .try_for_each(|column| entries("columns", column.len(), n))?;
    }
    for row in rows {
        entries("rows", row.row.len(), n)?;
        entries("cases", row.case.max(columns.len() - 1), columns.len() - 1)?;
    }
    let synthesis = ModalSynthesis::new(structure, n)?.with_fixed(dampers)?;
    let in_modes = |of: &[f64]| synthesis.in_modes(of);
    let cases = columns
        .iter()
        .map(|of| Case::new(structure, of, gusts, &in_modes));
    let wanted = RequestedRows {
        cases: cases.collect::<Result<_, DamperError>>()?,
        rows: rows.iter().map(|row| in_modes(&row.row)).collect(),
        asked: rows,
        places: dampers.iter().map(|damper| in_modes(&damper.row)).collect(),
        synthesis: &synthesis,
        dampers,
    };
    wanted.in_time(gusts)
}

struct Case {
    /// Φᵀ of the column of each strip.
    loads: Vec<Vec<f64>>,
    /// Mean of each degree of freedom.
    mean: Vec<f64>,
}

impl Case {
    fn new(
        structure: &LinearSystem,
        columns: &[Vec<f64>],
        gusts: &GustForces,
        in_modes: &dyn Fn(&[f64]) -> Vec<f64>,
    ) -> Result<Self, DamperError> {
        let mut load = vec![0.0; structure.degrees_of_freedom()];
        for (force, column) in gusts.mean_n.iter().zip(columns) {
            load.iter_mut().zip(column).for_each(|(sum, a)| *sum += force * a);
        }
        let mean = solve(structure.stiffness(), &Matrix::from_column(&load))?;
        Ok(Case {
            loads: columns.iter().map(|column| in_modes(column)).collect(),
            mean: mean.column(0).to_vec(),
        })
    }

    /// Motion of the modes under the forces of one spectral line.
    fn moved(
        &self,
        synthesis: &ModalSynthesis,
        omega: f64,
        forces: &[Complex64],
    ) -> Result<Vec<Complex64>, DamperError> {
        let modes = self.loads.first().map_or(0, Vec::len);
        let mut parts = [vec![0.0; modes], vec![0.0; modes]];
        for (force, load) in forces.iter().zip(&self.loads) {
            for (part, size) in parts.iter_mut().zip([force.re, force.im]) {
                part.iter_mut().zip(load).for_each(|(sum, a)| *sum += size * a);
            }
        }
        let [real, imaginary] = parts;
        let mut eta = synthesis.receptance(omega, &real)?;
        for (x, y) in eta.iter_mut().zip(synthesis.receptance(omega, &imaginary)?) {
            *x += Complex64::I * y;
        }
        Ok(eta)
    }
}

struct RequestedRows<'a> {
    cases: Vec<Case>,
    /// The row in modal coordinates.
    rows: Vec<Vec<f64>>,
    asked: &'a [GustRow],
    places: Vec<Vec<f64>>,
    synthesis: &'a ModalSynthesis,
    dampers: &'a [AttachedDamper],
}

impl RequestedRows<'_> {
    fn in_time(&self, gusts: &GustForces) -> Result<GustHistory, DamperError> {
        let times = gusts.times;
        let lines = (0..times.lines()).into_par_iter().map(|line| {
            let omega = TAU * times.frequency_hz(line);
            self.at_line(omega, gusts.line_n(line))
        });
        let lines: Vec<Vec<Complex64>> = lines.collect::<Result<_, DamperError>>()?;
        let sum = CosineSum::new(times.samples);
        let means = self.means();
        let all = means.par_iter().enumerate().map(|(i, mean)| {
            let amplitudes: Vec<Complex64> = lines.iter().map(|line| line[i]).collect();
            let mut values = sum
                .first(&amplitudes, times.looked_at)
                .ok_or(DamperError::Dynamics(DynamicsError::Unstable))?;
            values.iter_mut().for_each(|value| *value += mean);
            Ok(values)
        });
        let mut all = all.collect::<Result<Vec<Vec<f64>>, DamperError>>()?.into_iter();
        let values: Vec<Vec<f64>> = all.by_ref().take(self.rows.len()).collect();
        let rest: Vec<Vec<f64>> = all.collect();
        let each = rest.len() / self.cases.len().max(1);
        let strokes = (0..self.cases.len()).map(|case| rest[case * each..(case + 1) * each].to_vec());
        Ok(GustHistory {
            times,
            values,
            strokes: strokes.collect(),
        })
    }

    /// Amplitudes of the rows, then of the strokes, of each case.
    fn at_line(&self, omega: f64, forces: &[Complex64]) -> Result<Vec<Complex64>, DamperError> {
        let moved = self
            .cases
            .iter()
            .map(|case| case.moved(self.synthesis, omega, forces));
        let moved: Vec<Vec<Complex64>> = moved.collect::<Result<_, DamperError>>()?;
        let rows = self.rows.iter().zip(self.asked).map(|(row, asked)| {
            let eta = &moved[asked.case];
            let own: Complex64 = row.iter().zip(eta).map(|(a, x)| x * *a).sum();
            match asked.quantity {
                GustQuantity::Displacement => own,
                GustQuantity::Acceleration => -omega * omega * own,
            }
        });
        let mut all: Vec<Complex64> = rows.collect();
        for eta in &moved {
            all.extend(strokes_under(self.dampers, &self.places, eta, omega));
        }
        Ok(all)
    }

    /// Mean values in the same order: a dashpot elongates with its floors; masses and liquids have no mean stroke.
    fn means(&self) -> Vec<f64> {
        let along =
            |row: &[f64], case: &Case| -> f64 { row.iter().zip(&case.mean).map(|(a, x)| a * x).sum() };
        let rows = self.asked.iter().map(|asked| match asked.quantity {
            GustQuantity::Displacement => along(&asked.row, &self.cases[asked.case]),
            GustQuantity::Acceleration => 0.0,
        });
        let mut all: Vec<f64> = rows.collect();
        for case in &self.cases {
            all.extend(self.dampers.iter().map(|damper| match damper.kind {
                DamperKind::Viscous { .. } => along(&damper.row, case),
                _ => 0.0,
            }));
            let apart = |damper: &&AttachedDamper| matches!(damper.kind, DamperKind::LiquidColumnMass { .. });
            all.extend(self.dampers.iter().filter(apart).map(|_| 0.0));
        }
        all
    }
}
