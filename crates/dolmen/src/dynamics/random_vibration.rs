//! Standard deviations of the response of a linear structure to random loads, by Lyapunov's equation or by an integral over
//! frequency.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | y | state | x, ẋ and the states of the shaping filters |
//! | h | `row` | the response as a combination of degrees of freedom, n values |
//! | S | `Spectrum`, `SpectralMatrix` | two-sided spectral density; σ² = ∫ S dω over all ω |

use super::linear_system::fits;
use super::random_load::{RandomInput, RandomLoad, SpectralMatrix};
use super::{DynamicsError, LinearSystem};
use crate::numeric::{adaptive_nodes, lyapunov};
use dolmen_linalg::{Complex64, Matrix};

/// Kind of response.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// Displacement relative to the base.
    Displacement,
    /// Velocity relative to the base.
    Velocity,
    /// Absolute acceleration.
    Acceleration,
}

/// A response quantity: a linear combination of degrees of freedom.
#[derive(Clone, Debug, PartialEq)]
pub struct ResponseRow {
    /// Coefficient of each degree of freedom, n values.
    pub row: Vec<f64>,
    /// Displacement, velocity or acceleration.
    pub motion: Motion,
}

impl ResponseRow {
    /// A displacement.
    pub fn displacement(row: Vec<f64>) -> Self {
        ResponseRow {
            row,
            motion: Motion::Displacement,
        }
    }
}

/// Options of the integral over frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrequencyIntegral {
    /// Relative tolerance of each variance; default 1e-9 (our choice).
    pub relative_tolerance: f64,
    /// Largest number of intervals, each with 15 points; default 20 000 (our choice).
    pub intervals_most: usize,
}

impl Default for FrequencyIntegral {
    fn default() -> Self {
        FrequencyIntegral {
            relative_tolerance: 1e-9,
            intervals_most: 20_000,
        }
    }
}

/// Standard deviations by Lyapunov's equation A P + P Aᵀ + B Bᵀ = 0. The filters of coloured loads are additional states.
///
/// # Errors
/// [`DynamicsError::NotRational`] for a load given as a table; [`DynamicsError::Unbounded`] for the acceleration under a white-noise
/// force; [`DynamicsError::Unstable`] if there is no steady state.
///
/// # Limits
/// Agrees with [`rms_by_integral`] to 1e-9 on the structures of the tests. The computing time grows with the cube of the number of
/// states.
///
/// # Example
/// ```
/// use dolmen::dynamics::{LinearSystem, RandomInput, RandomLoad, ResponseRow, Spectrum, rms_by_lyapunov};
/// use dolmen_linalg::Matrix;
/// let one = |x: f64| Matrix::from_rows(&[[x]]);
/// let system = LinearSystem::new(one(1.0), one(0.04), one(1.0))?;
/// let load = RandomLoad { input: RandomInput::Force(vec![1.0]), spectrum: Spectrum::unit_white() };
/// let rms = rms_by_lyapunov(&system, &[load], &[ResponseRow::displacement(vec![1.0])])?;
/// assert!((rms[0] - 12.5_f64.sqrt()).abs() < 1e-12); // σ² = 1 / 4ζω³
/// # Ok::<(), dolmen::dynamics::DynamicsError>(())
/// ```
pub fn rms_by_lyapunov(
    system: &LinearSystem,
    loads: &[RandomLoad],
    responses: &[ResponseRow],
) -> Result<Vec<f64>, DynamicsError> {
    let n = system.degrees_of_freedom();
    check(system, loads, responses)?;
    let structure = system.state_matrix()?;
    let filters: Vec<_> = loads.iter().map(|load| load.spectrum.filter()).collect();
    let states = 2 * n
        + filters
            .iter()
            .flatten()
            .map(|filter| filter.b.len())
            .sum::<usize>();
    let mut a = Matrix::zeros(states, states);
    for j in 0..2 * n {
        a.column_mut(j)[..2 * n].copy_from_slice(structure.column(j));
    }
    let mut q = Matrix::zeros(states, states);
    let mut at = 2 * n;
    let mut fastest = 0.0_f64;
    let mut direct = false; // whether white noise acts on the structure as a force, without a filter
    for (load, filter) in loads.iter().zip(&filters) {
        let accelerations = accelerations(system, &load.input)?;
        match filter {
            Some(filter) => {
                let m = filter.b.len();
                for i in 0..m {
                    for j in 0..m {
                        a[(at + i, at + j)] = filter.a[(i, j)];
                        q[(at + i, at + j)] += filter.b[i] * filter.b[j];
                    }
                    for (k, acceleration) in accelerations.iter().enumerate() {
                        a[(n + k, at + i)] = acceleration * filter.c[i];
                    }
                }
                at += m;
            }
            None => {
                let intensity = match load.spectrum {
                    super::Spectrum::White { density } => std::f64::consts::TAU * density,
                    _ => return Err(DynamicsError::NotRational),
                };
                direct |= matches!(load.input, RandomInput::Force(_));
                for i in 0..n {
                    for j in 0..n {
                        q[(n + i, n + j)] += intensity * accelerations[i] * accelerations[j];
                    }
                }
            }
        }
        fastest = load.spectrum.breaks_rad_s().into_iter().fold(fastest, f64::max);
    }
    if direct && responses.iter().any(|r| r.motion == Motion::Acceleration) {
        return Err(DynamicsError::Unbounded {
            quantity: "the acceleration under a white-noise force",
            why: "such a force has no end of power at high frequencies: give it a corner (low pass)",
        });
    }
    let omega = system.modes()?.angular_frequency_rad_s;
    let shift = (omega[0] * omega[n - 1].max(fastest)).sqrt();
    let p = lyapunov(&a, &q, shift)?.ok_or(DynamicsError::Unstable)?;
    let variance = |row: &[f64]| p.form(row, row).max(0.0).sqrt();
    Ok(responses
        .iter()
        .map(|response| {
            let mut row = vec![0.0; states];
            match response.motion {
                Motion::Displacement => row[..n].copy_from_slice(&response.row),
                Motion::Velocity => row[n..2 * n].copy_from_slice(&response.row),
                Motion::Acceleration => {
                    // ẍ of the state equation, relative to the base
                    for (i, of) in response.row.iter().enumerate() {
                        for (j, entry) in row.iter_mut().enumerate() {
                            *entry += of * a[(n + i, j)];
                        }
                    }
                    let mut at = 2 * n;
                    for (load, filter) in loads.iter().zip(&filters) {
                        let Some(filter) = filter else { continue };
                        if let RandomInput::Base(influence) = &load.input {
                            let moves: f64 = influence.iter().zip(&response.row).map(|(e, h)| e * h).sum();
                            for (i, c) in filter.c.iter().enumerate() {
                                row[at + i] += moves * c;
                            }
                        }
                        at += filter.b.len();
                    }
                }
            }
            variance(&row)
        })
        .collect())
}

/// Standard deviations by σ² = 2 ∫ h(ω) S(ω) h*(ω) dω over ω > 0, with adaptive intervals. Each frequency needs one solution of the
/// structure's equations.
///
/// # Errors
/// [`DynamicsError::Unbounded`] as for [`rms_by_lyapunov`]; [`DynamicsError::Integral`] if the tolerance needs too many intervals.
pub fn rms_by_integral(
    system: &LinearSystem,
    loads: &[RandomLoad],
    responses: &[ResponseRow],
    options: &FrequencyIntegral,
) -> Result<Vec<f64>, DynamicsError> {
    check(system, loads, responses)?;
    let white = |load: &RandomLoad| {
        matches!(load.spectrum, super::Spectrum::White { .. }) && matches!(load.input, RandomInput::Force(_))
    };
    if loads.iter().any(white) && responses.iter().any(|r| r.motion == Motion::Acceleration) {
        return Err(DynamicsError::Unbounded {
            quantity: "the acceleration under a white-noise force",
            why: "such a force has no end of power at high frequencies: give it a corner (low pass)",
        });
    }
    let mut breaks: Vec<f64> = loads
        .iter()
        .flat_map(|load| load.spectrum.breaks_rad_s())
        .collect();
    let density = |w: f64| -> Result<Vec<f64>, DynamicsError> {
        let mut sums = vec![0.0; responses.len()];
        for load in loads {
            let s = load.spectrum.density(w);
            if s == 0.0 {
                continue;
            }
            for (sum, h) in sums.iter_mut().zip(transfer(system, &load.input, responses, w)?) {
                *sum += s * h.norm_sqr();
            }
        }
        Ok(sums)
    };
    integrate(system, &mut breaks, None, options, density)
}

/// Standard deviations under correlated loads, by an integral over frequency.
///
/// # Errors
/// [`DynamicsError::Matrix`] if the spectral matrix is invalid; otherwise as in [`rms_by_integral`].
pub fn rms_by_spectral_matrix(
    system: &LinearSystem,
    loads: &SpectralMatrix,
    responses: &[ResponseRow],
    options: &FrequencyIntegral,
) -> Result<Vec<f64>, DynamicsError> {
    loads.check()?;
    for input in &loads.inputs {
        accelerations(system, input)?;
    }
    let mut breaks = loads.angular_frequency_rad_s.clone();
    let last = breaks.last().copied();
    let density = |w: f64| -> Result<Vec<f64>, DynamicsError> {
        let Some(s) = loads.at(w) else {
            return Ok(vec![0.0; responses.len()]);
        };
        let h: Vec<Vec<Complex64>> = loads
            .inputs
            .iter()
            .map(|input| transfer(system, input, responses, w))
            .collect::<Result<_, _>>()?;
        Ok((0..responses.len())
            .map(|r| {
                let mut sum = Complex64::ZERO;
                for (i, hi) in h.iter().enumerate() {
                    for (j, hj) in h.iter().enumerate() {
                        sum += hi[r] * s[(i, j)] * hj[r].conj();
                    }
                }
                sum.re
            })
            .collect())
    };
    integrate(system, &mut breaks, last, options, density)
}

/// A range of the integral, with the ends of its intervals.
enum Range<'a> {
    /// Integrated over ω.
    Frequency(&'a [f64]),
    /// Integrated over 1/ω.
    Inverse(&'a [f64]),
}

/// Square root of 2 ∫ from 0 to ∞ (or to `last`). Above all peaks the variable is 1/ω.
fn integrate(
    system: &LinearSystem,
    breaks: &mut Vec<f64>,
    last: Option<f64>,
    options: &FrequencyIntegral,
    density: impl Fn(f64) -> Result<Vec<f64>, DynamicsError>,
) -> Result<Vec<f64>, DynamicsError> {
    breaks.push(0.0);
    breaks.extend(system.poles()?.iter().map(|pole| pole.angular_frequency_rad_s));
    let top = 3.0 * breaks.iter().copied().fold(0.0, f64::max);
    match last {
        Some(last) => breaks.retain(|w| *w <= last),
        None => breaks.push(top),
    }
    breaks.sort_by(f64::total_cmp);
    let mut fault = None;
    let mut value = |w: f64, factor: f64| match density(w) {
        Ok(values) => Some(values.into_iter().map(|s| s * factor).collect::<Vec<f64>>()),
        Err(stopped) => {
            fault = Some(stopped);
            None
        }
    };
    let mut sums: Vec<f64> = Vec::new();
    let tail = [0.0, 1.0 / top];
    let ranges: &[Range] = match last {
        Some(_) => &[Range::Frequency(breaks)],
        None => &[Range::Frequency(breaks), Range::Inverse(&tail)],
    };
    for range in ranges {
        let mut at = |x: f64| match range {
            Range::Frequency(_) => value(x, 1.0),
            Range::Inverse(_) => value(1.0 / x, 1.0 / (x * x)),
        };
        let (Range::Frequency(ends) | Range::Inverse(ends)) = range;
        let nodes = adaptive_nodes(ends, options.relative_tolerance, options.intervals_most, &mut at);
        let Some(nodes) = nodes else {
            return Err(fault.unwrap_or(DynamicsError::Integral {
                intervals: options.intervals_most,
            }));
        };
        for node in nodes {
            let values = at(node.x).unwrap_or_default();
            sums.resize(values.len(), 0.0);
            for (sum, value) in sums.iter_mut().zip(values) {
                *sum += 2.0 * node.weight * value;
            }
        }
    }
    Ok(sums.into_iter().map(f64::sqrt).collect())
}

/// Responses to one unit load at one frequency.
fn transfer(
    system: &LinearSystem,
    input: &RandomInput,
    responses: &[ResponseRow],
    w: f64,
) -> Result<Vec<Complex64>, DynamicsError> {
    let load = match input {
        RandomInput::Force(force) => force.clone(),
        RandomInput::Base(influence) => system.mass().times(influence).iter().map(|f| -f).collect(),
    };
    let x = system.frequency_response(w, &load)?;
    Ok(responses
        .iter()
        .map(|response| {
            let moved: Complex64 = response.row.iter().zip(&x).map(|(h, x)| x * *h).sum();
            match response.motion {
                Motion::Displacement => moved,
                Motion::Velocity => Complex64::new(0.0, w) * moved,
                Motion::Acceleration => {
                    let base = match input {
                        RandomInput::Force(_) => 0.0,
                        RandomInput::Base(e) => e.iter().zip(&response.row).map(|(e, h)| e * h).sum(),
                    };
                    -w * w * moved + base
                }
            }
        })
        .collect())
}

/// Accelerations under a unit load: M⁻¹ times the load, n values.
fn accelerations(system: &LinearSystem, input: &RandomInput) -> Result<Vec<f64>, DynamicsError> {
    let n = system.degrees_of_freedom();
    match input {
        RandomInput::Force(force) => {
            fits("force", force, n)?;
            let x = dolmen_linalg::solve(system.mass(), &Matrix::from_column(force))?;
            Ok(x.column(0).to_vec())
        }
        RandomInput::Base(influence) => {
            fits("influence", influence, n)?;
            Ok(influence.iter().map(|e| -e).collect())
        }
    }
}

fn check(
    system: &LinearSystem,
    loads: &[RandomLoad],
    responses: &[ResponseRow],
) -> Result<(), DynamicsError> {
    if loads.is_empty() {
        return Err(DynamicsError::Entries {
            argument: "loads",
            given: 0,
            needed: 1,
        });
    }
    for load in loads {
        load.spectrum.check()?;
        accelerations(system, &load.input)?;
    }
    for response in responses {
        fits("row", &response.row, system.degrees_of_freedom())?;
    }
    Ok(())
}
