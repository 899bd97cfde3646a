//! Response of a structure with dampers to turbulent wind: means and standard deviations, integrated over frequency.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | E | `columns` | load on the structure per unit force on each strip of the face | n × strips |
//! | S_F(n) | `GustFace::force_density_n2_hz` | one-sided cross spectra of the strip forces | strips × strips |
//! | H(n) | `ModalSynthesis` | receptance of structure and dampers | n × n |
//! | m_k | `moments` | ∫ (2πn)^2k Re[H E S_F Eᵀ H*] dn: of displacements, velocities, accelerations and their rates | n + strokes, squared |
//! | ν, g | `up_crossing_hz`, `peak_factor` | rate of upward crossings of the mean; Davenport's factor | Hz, |

use super::gust_row::{GustQuantity, GustRow};
use super::gust_strokes::strokes_under;
use super::{AttachedDamper, DamperError, DamperKind, ModalSynthesis};
use crate::dynamics::{DynamicsError, LinearSystem, SystemModes};
use crate::numeric::{Node, adaptive_nodes};
use crate::structure::wind::GustFace;
use dolmen_linalg::{Matrix, solve};
use std::f64::consts::TAU;

/// Tolerance of the variance of each mode, of its acceleration and of each stroke, by a conservative error estimate. Standard deviations are
/// then accurate to 2e-5. Our choice.
const TOLERANCE: f64 = 5e-4;
const INTERVALS_MOST: usize = 4000;
/// The integral begins at this fraction of V/L. Below it the spectrum is taken as constant; that part holds 1e-6 of the gust variance.
const LOWEST: f64 = 1e-4;
/// The integral ends at this multiple of the highest frequency of modes and dampers. Above it inertia dominates the response, and densities
/// fall as n^(−5/3 − 2).
const HIGHEST: f64 = 100.0;
/// The integral does not resolve the peak of a mode with less than this fraction of the largest variance: such a variance is rounding, because
/// the wind does not excite the mode. Our choice.
const UNSEEN: f64 = 1e-6;
const ROUNDING: f64 = 1e-22;
/// Euler's constant, in the mean largest value of a Gaussian process (Davenport 1964).
const EULER: f64 = 0.577_215_664_901_532_9;

/// A random response about its mean.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct GustPeak {
    /// Mean.
    pub mean: f64,
    /// Standard deviation, σ.
    pub rms: f64,
    /// Rate of upward crossings of the mean, Hz.
    pub up_crossing_hz: f64,
    /// Davenport's peak factor g over ten minutes.
    pub peak_factor: f64,
}

impl GustPeak {
    /// |mean| + g σ.
    pub fn peak(&self) -> f64 {
        self.mean.abs() + self.peak_factor * self.rms
    }

    fn of(mean: f64, variance: f64, rate_variance: f64, duration_s: f64) -> Self {
        let rms = variance.max(0.0).sqrt();
        let up_crossing_hz = match rms > 0.0 {
            true => rate_variance.max(0.0).sqrt() / (TAU * rms),
            false => 0.0,
        };
        // below e crossings, g keeps its value at e crossings: √2 + 0.58/√2
        let spread = (2.0 * (up_crossing_hz * duration_s).ln().max(1.0)).sqrt();
        GustPeak {
            mean,
            rms,
            up_crossing_hz,
            peak_factor: match rms > 0.0 {
                true => spread + EULER / spread,
                false => 0.0,
            },
        }
    }
}

/// The motion of a structure and its dampers in the wind.
#[derive(Clone, Debug, PartialEq)]
pub struct GustMotion {
    /// Mean of each degree of freedom of the structure, m or rad.
    pub mean: Vec<f64>,
    /// Strokes of the dampers about their means, m: z − z₀ of a mass, w of a liquid column, the elongation of a dashpot; then the liquid rises
    /// of columns on springs.
    pub strokes: Vec<GustPeak>,
    /// m_0 to m_3 of the structure, n × n each.
    moments: [Matrix; 4],
    duration_s: f64,
    /// Number of frequencies of the integral.
    pub frequencies: usize,
}

impl GustMotion {
    /// Displacement of a row over the structure.
    pub fn displacement(&self, row: &[f64]) -> GustPeak {
        let mean = row.iter().zip(&self.mean).map(|(a, x)| a * x).sum();
        let of = |k: usize| self.moments[k].form(row, row);
        GustPeak::of(mean, of(0), of(1), self.duration_s)
    }

    /// Acceleration of a row over the structure; its mean is 0.
    pub fn acceleration(&self, row: &[f64]) -> GustPeak {
        let of = |k: usize| self.moments[k].form(row, row);
        GustPeak::of(0.0, of(2), of(3), self.duration_s)
    }

    /// The quantity of a requested row, for its case of columns.
    pub fn of(&self, row: &GustRow) -> GustPeak {
        match row.quantity {
            GustQuantity::Displacement => self.displacement(&row.row),
            GustQuantity::Acceleration => self.acceleration(&row.row),
        }
    }

    /// Row for the acceleration of a point in the direction with the largest standard deviation, from its rows along x and y.
    pub fn most_accelerated(&self, [x, y]: [&[f64]; 2]) -> Vec<f64> {
        let of = |a: &[f64], b: &[f64]| self.moments[2].form(a, b);
        let angle = 0.5 * (2.0 * of(x, y)).atan2(of(x, x) - of(y, y));
        let (sin, cos) = angle.sin_cos();
        x.iter().zip(y).map(|(x, y)| cos * x + sin * y).collect()
    }
}

/// Motion in turbulent wind over `duration_s`, the ten minutes of the mean. The result has one answer for each set of `columns`, so that the
/// same forces can also act off the centre of the face.
///
/// ```text
/// mean: K x̄ = E F̄                                          columns: a list of strips of n values each
/// m_k = ∫₀^∞ (2πn)^2k Re[H E S_F Eᵀ H*] dn,  σ² = r m_0 rᵀ,  σ_ẍ² = r m_2 rᵀ
/// ν = √(r m_1 rᵀ/r m_0 rᵀ)/2π,  g = √(2 ln νT) + 0.5772/√(2 ln νT)
/// ```
///
/// # Errors
/// [`DamperError::Wind`] if the face is out of its range; [`DamperError`] if a damper is out of its range, or if the integral needs too many
/// frequencies; [`DynamicsError::Entries`] for columns that do not fit.
///
/// # Limits
/// Quadrature rules of 7 and 15 points agree to 5e-4 of each variance; other quadratures give variances within 5e-5. Gusts are Gaussian. See
/// also the limits of [`GustFace::force_density_n2_hz`].
///
/// # Source
/// Davenport A. G. (1961) Proc. ICE 19:449–472, (1964) Proc. ICE 28:187–196; receptances after eqs 4 to 9 of Hwang, Min & Hong.
pub fn gust_motion(
    structure: &LinearSystem,
    dampers: &[AttachedDamper],
    face: &GustFace,
    columns: &[Vec<Vec<f64>>],
    duration_s: f64,
) -> Result<Vec<GustMotion>, DamperError> {
    face.check()?;
    let n = structure.degrees_of_freedom();
    let entries = |given: usize, needed: usize| match given == needed {
        true => Ok(()),
        false => Err(DynamicsError::Entries {
            argument: "columns",
            given,
            needed,
        }),
    };
    for of in columns {
        entries(of.len(), face.strips.len())?;
        of.iter().try_for_each(|column| entries(column.len(), n))?;
    }
    let synthesis = ModalSynthesis::new(structure, n)?.with_fixed(dampers)?;
    let in_modes = |of: &Vec<Vec<f64>>| of.iter().map(|column| synthesis.in_modes(column)).collect();
    let mut blown = GustResponse {
        loads: columns.iter().map(in_modes).collect(),
        places: dampers
            .iter()
            .map(|damper| synthesis.in_modes(&damper.row))
            .collect(),
        modes: structure.modes()?,
        active: Vec::new(),
        synthesis,
        dampers,
        face,
    };
    let seen = blown.seen();
    let are_coupled = !dampers.is_empty() || !blown.synthesis.is_classical();
    blown.active = (0..n).filter(|j| are_coupled || seen[*j] > 0.0).collect();
    let nodes = blown.nodes(&seen)?;
    let forces = face.mean_forces_n();
    columns
        .iter()
        .enumerate()
        .map(|(case, of)| {
            let mut load = vec![0.0; n];
            for (force, column) in forces.iter().zip(of) {
                load.iter_mut().zip(column).for_each(|(sum, a)| *sum += force * a);
            }
            let mean = solve(structure.stiffness(), &Matrix::from_column(&load))?
                .column(0)
                .to_vec();
            let moments = blown.moments(case, &nodes)?;
            Ok(blown.answer(mean, &moments, (duration_s, nodes.len())))
        })
        .collect()
}

/// All matrices in modal coordinates of the structure, followed by the strokes of the dampers.
struct GustResponse<'a> {
    synthesis: ModalSynthesis,
    modes: SystemModes,
    dampers: &'a [AttachedDamper],
    face: &'a GustFace,
    /// Φᵀ of the column of each strip, for each case.
    loads: Vec<Vec<Vec<f64>>>,
    /// Row of each damper in modal coordinates.
    places: Vec<Vec<f64>>,
    /// Active modes: all modes if dampers or damping couple them, otherwise those that the wind excites.
    active: Vec<usize>,
}

impl GustResponse<'_> {
    /// Motion of the active modes, then of the dampers, per unit force on each strip: real and imaginary parts, each strips × motions.
    fn transfer(&self, case: usize, hz: f64) -> Result<[Matrix; 2], DamperError> {
        let strips = self.loads[case].len();
        let mut parts = [(); 2].map(|()| Matrix::zeros(strips, self.size()));
        for (strip, load) in self.loads[case].iter().enumerate() {
            let eta = self.synthesis.receptance(TAU * hz, load)?;
            let moved = self.active.iter().map(|j| eta[*j]).chain(strokes_under(
                self.dampers,
                &self.places,
                &eta,
                TAU * hz,
            ));
            for (i, x) in moved.enumerate() {
                parts[0][(strip, i)] = x.re;
                parts[1][(strip, i)] = x.im;
            }
        }
        Ok(parts)
    }

    fn size(&self) -> usize {
        let liquids = self.dampers.iter();
        let liquids = liquids.filter(|damper| matches!(damper.kind, DamperKind::LiquidColumnMass { .. }));
        self.active.len() + self.dampers.len() + liquids.count()
    }

    /// Frequencies of the integral, in ln n.
    fn nodes(&self, seen: &[f64]) -> Result<Vec<Node>, DamperError> {
        let winds = || self.face.strips.iter().map(|strip| strip.wind);
        let slow = winds().map(|wind| wind.mean_speed_m_s / wind.length_m);
        let most = seen.iter().copied().fold(0.0, f64::max);
        let told: Vec<bool> = seen.iter().map(|seen| *seen > UNSEEN * most).collect();
        let mut stands_out = self.peaks_hz(&told);
        let gusts =
            winds().map(|wind| wind.mean_speed_m_s / (self.face.coherence_decay.max(1.0) * self.least_m()));
        let highest = stands_out.iter().copied().chain(gusts).fold(0.0, f64::max);
        let lowest = LOWEST * slow.clone().fold(f64::INFINITY, f64::min).min(stands_out[0]);
        stands_out.extend(slow);
        stands_out.extend([lowest, HIGHEST * highest]);
        stands_out.sort_by(f64::total_cmp);
        let breaks: Vec<f64> = stands_out.iter().map(|hz| hz.ln()).collect();
        let mut fault = None;
        let looked = adaptive_nodes(&breaks, TOLERANCE, INTERVALS_MOST, |log| {
            match self.watched(log.exp(), &told) {
                Ok(values) => Some(values),
                Err(stopped) => {
                    fault = Some(stopped);
                    None
                }
            }
        });
        let mut nodes = looked.ok_or(fault.unwrap_or(DamperError::TooManyFrequencies {
            intervals: INTERVALS_MOST,
        }))?;
        // below the first frequency S is constant: ∫₀^n S dn = n S(n), which is the integrand in ln n, so its weight is 1
        nodes.push(Node {
            x: lowest.ln(),
            weight: 1.0,
        });
        Ok(nodes)
    }

    /// The smallest height or breadth of a strip, m.
    fn least_m(&self) -> f64 {
        let strips = self.face.strips.iter();
        strips.fold(f64::INFINITY, |least, strip| {
            least.min(strip.breadth_m).min(strip.top_m - strip.bottom_m)
        })
    }

    /// Excitation of each mode by the wind: the largest variance of its acceleration at resonance over all cases.
    fn seen(&self) -> Vec<f64> {
        let omegas = &self.modes.angular_frequency_rad_s;
        let mut seen = vec![0.0_f64; omegas.len()];
        for (j, seen) in seen.iter_mut().enumerate() {
            let density = self.face.force_density_n2_hz(omegas[j] / TAU);
            for loads in &self.loads {
                let pushed: Vec<f64> = loads.iter().map(|load| load[j]).collect();
                // ω² times the variance of its displacement: π S/(2 c) with S two-sided
                let damping = self.modes.damping[(j, j)].max(f64::MIN_POSITIVE);
                *seen = seen.max(density.form(&pushed, &pushed) / damping);
            }
        }
        let most = seen.iter().copied().fold(0.0, f64::max);
        // the wind excites a cross-wind mode only by rounding errors
        seen.iter()
            .map(|own| if *own > ROUNDING * most { *own } else { 0.0 })
            .collect()
    }

    /// Frequencies of the resolved modes and of the dampers, Hz, in ascending order; at least one.
    fn peaks_hz(&self, told: &[bool]) -> Vec<f64> {
        let omegas = &self.modes.angular_frequency_rad_s;
        let kept = omegas.iter().zip(told).filter(|(_, told)| **told);
        let mut all: Vec<f64> = kept.map(|(omega, _)| omega / TAU).collect();
        for damper in self.dampers {
            all.extend(damper.kind.own_frequencies_hz());
        }
        if all.is_empty() {
            all.push(omegas[0] / TAU);
        }
        all.sort_by(f64::total_cmp);
        all
    }

    /// The quantities that the integral must give to the tolerance: variance of each resolved mode, of its acceleration, and of each stroke.
    fn watched(&self, hz: f64, told: &[bool]) -> Result<Vec<f64>, DamperError> {
        let density = self.face.force_density_n2_hz(hz);
        let quick = (TAU * hz).powi(4);
        let mut all = Vec::new();
        for case in 0..self.loads.len() {
            let parts = self.transfer(case, hz)?;
            let pushed = parts.each_ref().map(|part| &density * part);
            for i in 0..self.size() {
                if self.active.get(i).is_some_and(|mode| !told[*mode]) {
                    continue;
                }
                let each = parts.iter().zip(&pushed);
                let own: f64 = each.map(|(x, y)| dot(x.column(i), y.column(i))).sum();
                all.push(hz * own);
                if i < self.active.len() {
                    all.push(hz * quick * own);
                }
            }
        }
        Ok(all)
    }

    /// m_0 to m_3 of active modes and strokes.
    fn moments(&self, case: usize, nodes: &[Node]) -> Result<[Matrix; 4], DamperError> {
        let size = self.size();
        let mut moments = [(); 4].map(|()| Matrix::zeros(size, size));
        for node in nodes {
            let hz = node.x.exp();
            let density = self.face.force_density_n2_hz(hz);
            let square = (TAU * hz).powi(2);
            for part in self.transfer(case, hz)? {
                let own = part.transpose_times(&(&density * &part));
                let mut factor = node.weight * hz;
                for moment in &mut moments {
                    let sums = moment.as_mut_slice().iter_mut().zip(own.as_slice());
                    sums.for_each(|(sum, value)| *sum += factor * value);
                    factor *= square;
                }
            }
        }
        Ok(moments)
    }

    /// Transforms a matrix from modal coordinates to degrees of freedom.
    fn of_structure(&self, modal: &Matrix) -> Matrix {
        let n = self.modes.shapes.rows();
        let shapes = Matrix::from_fn(n, self.active.len(), |i, k| {
            self.modes.shapes[(i, self.active[k])]
        });
        let active = modal.block(0, 0, self.active.len(), self.active.len());
        &(&shapes * &active) * &shapes.transpose()
    }

    fn answer(
        &self,
        mean: Vec<f64>,
        moments: &[Matrix; 4],
        (duration_s, frequencies): (f64, usize),
    ) -> GustMotion {
        let first = self.active.len();
        let stretched = |damper: &AttachedDamper| match damper.kind {
            DamperKind::Viscous { .. } => dot(&damper.row, &mean),
            _ => 0.0,
        };
        let strokes = (first..self.size()).map(|i| {
            let mean = self.dampers.get(i - first).map_or(0.0, stretched);
            GustPeak::of(mean, moments[0][(i, i)], moments[1][(i, i)], duration_s)
        });
        GustMotion {
            strokes: strokes.collect(),
            moments: moments.each_ref().map(|moment| self.of_structure(moment)),
            mean,
            duration_s,
            frequencies,
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
