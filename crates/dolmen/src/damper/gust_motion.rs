//! What a turbulent wind makes of a structure with dampers: means and standard deviations, by an integral over frequency.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | E | `columns` | what a force on each strip of the face does to the structure | n × strips |
//! | S_F(n) | `GustFace::force_density_n2_hz` | one-sided cross spectra of the forces on the strips | strips × strips |
//! | H(n) | `ModalSynthesis` | receptance of structure and dampers | n × n |
//! | m_k | `moments` | ∫ (2πn)^2k Re[H E S_F Eᵀ H*] dn: of displacements, velocities, accelerations and their rates | n + strokes, squared |
//! | ν, g | `up_crossing_hz`, `peak_factor` | rate of crossing the mean upwards; Davenport's factor | Hz, |

use super::{AttachedDamper, DamperError, DamperKind, ModalSynthesis};
use crate::dynamics::{DynamicsError, LinearSystem, RandomInput};
use crate::numeric::{Node, adaptive_nodes};
use crate::structure::wind::GustFace;
use dolmen_linalg::{Complex64, Matrix, solve};
use std::f64::consts::TAU;

/// Of each variance of a degree of freedom, of its acceleration and of each stroke. Our choice: standard deviations to 1e-5.
const TOLERANCE: f64 = 2e-5;
const INTERVALS_MOST: usize = 4000;
/// The integral begins at this part of V/L, the rest is taken as flat: 1e-6 of the variance of the gusts.
const LOWEST: f64 = 1e-4;
/// It ends at this multiple of the highest frequency there is, from where densities fall as n^(−5/3 − 2) under a structure that is all mass.
const HIGHEST: f64 = 100.0;
/// A mode with less than this part of the largest variance of any needs no peak of its own. Our choice.
const UNSEEN: f64 = 1e-9;
/// Euler's constant: Davenport (1964), the mean of the largest of a Gaussian process.
const EULER: f64 = 0.577_215_664_901_532_9;

/// A random response about its mean.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct GustPeak {
    /// Mean.
    pub mean: f64,
    /// Standard deviation, σ.
    pub rms: f64,
    /// Crossings of the mean upwards, Hz.
    pub up_crossing_hz: f64,
    /// g of Davenport, of the ten minutes.
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
        // a process that crosses less than e times has no peak beyond the first: √2 + 0.58/√2
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
    /// Strokes of the dampers about their means, m: z − z₀ of a mass, w of a liquid column, the elongation of a dashpot; then the rise of
    /// the liquids of columns on springs.
    pub strokes: Vec<GustPeak>,
    /// m_0 to m_3 of the structure, n × n each.
    moments: [Matrix; 4],
    duration_s: f64,
    /// Frequencies that the integral was taken over.
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

    /// Acceleration of a point along the direction in which its standard deviation is largest, from its rows along x and y.
    pub fn largest_acceleration(&self, [x, y]: [&[f64]; 2]) -> GustPeak {
        let of = |a: &[f64], b: &[f64]| self.moments[2].form(a, b);
        let angle = 0.5 * (2.0 * of(x, y)).atan2(of(x, x) - of(y, y));
        let (sin, cos) = angle.sin_cos();
        let row: Vec<f64> = x.iter().zip(y).map(|(x, y)| cos * x + sin * y).collect();
        self.acceleration(&row)
    }
}

/// The motion in a turbulent wind over `duration_s`, the ten minutes of the mean; one answer for each of several `columns`, as where the
/// same forces act off the middle of the face.
///
/// ```text
/// mean: K x̄ = E F̄                                          columns: a list of strips of n values each
/// m_k = ∫₀^∞ (2πn)^2k Re[H E S_F Eᵀ H*] dn,  σ² = r m_0 rᵀ,  σ_ẍ² = r m_2 rᵀ
/// ν = √(r m_1 rᵀ/r m_0 rᵀ)/2π,  g = √(2 ln νT) + 0.5772/√(2 ln νT)
/// ```
///
/// # Errors
/// [`DamperError::Wind`] for a face that cannot be; [`DamperError`] if a damper cannot be or the integral needs too many frequencies;
/// [`DynamicsError::Entries`] for columns that do not fit.
///
/// # Limits
/// Variances to 2e-5 of the integral, by rules of 7 and 15 points that agree to it (measured beside closed forms: 1e-6). Gaussian gusts;
/// what [`GustFace::force_density_n2_hz`] leaves out.
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
    let blown = Blown {
        synthesis,
        dampers,
        face,
        columns,
        n,
    };
    let nodes = blown.nodes(structure)?;
    columns
        .iter()
        .enumerate()
        .map(|(case, of)| {
            let forces = face.mean_forces_n();
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

struct Blown<'a> {
    synthesis: ModalSynthesis,
    dampers: &'a [AttachedDamper],
    face: &'a GustFace,
    columns: &'a [Vec<Vec<f64>>],
    n: usize,
}

impl Blown<'_> {
    /// Motion of the structure, then of the dampers, under a unit of force on each strip.
    fn transfer(&self, case: usize, hz: f64) -> Result<Vec<Vec<Complex64>>, DamperError> {
        let omega = TAU * hz;
        let each = self.columns[case].iter();
        each.map(|column| {
            let mut x = self.synthesis.moved(omega, &RandomInput::Force(column.clone()))?;
            let mut liquids = Vec::new();
            for damper in self.dampers {
                let place: Complex64 = damper.row.iter().zip(&x).map(|(a, x)| x * *a).sum();
                let felt = omega * omega * place;
                match damper.kind {
                    DamperKind::Viscous { .. } => x.push(place),
                    _ => x.push(felt * damper.kind.stroke_per_acceleration(omega)),
                }
                if let DamperKind::LiquidColumnMass {
                    length_ratio,
                    liquid_frequency_hz,
                    liquid_damping_ratio,
                    ..
                } = damper.kind
                {
                    let own = TAU * liquid_frequency_hz;
                    let link = Complex64::new(
                        own * own - omega * omega,
                        2.0 * liquid_damping_ratio * own * omega,
                    );
                    let carrier = place + x.last().copied().unwrap_or(Complex64::ZERO);
                    liquids.push(-length_ratio * omega * omega * carrier / link);
                }
            }
            // rows of the dampers are over the structure alone, so that the order of what follows is free
            x.extend(liquids);
            Ok(x)
        })
        .collect()
    }

    /// Degrees of freedom of the structure and strokes.
    fn size(&self) -> usize {
        let liquids = self.dampers.iter();
        let liquids = liquids.filter(|damper| matches!(damper.kind, DamperKind::LiquidColumnMass { .. }));
        self.n + self.dampers.len() + liquids.count()
    }

    /// Frequencies of the integral, in ln n.
    fn nodes(&self, structure: &LinearSystem) -> Result<Vec<Node>, DamperError> {
        let winds = || self.face.strips.iter().map(|strip| strip.wind);
        let slow = winds().map(|wind| wind.mean_speed_m_s / wind.length_m);
        let mut stands_out = self.peaks_hz(structure)?;
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
            match self.watched(log.exp()) {
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
        // below: flat, ∫₀^n S dn = n S(n), which in ln n is the value itself
        nodes.push(Node {
            x: lowest.ln(),
            weight: 1.0,
        });
        Ok(nodes)
    }

    /// The least height of a strip or breadth, m.
    fn least_m(&self) -> f64 {
        let strips = self.face.strips.iter();
        strips.fold(f64::INFINITY, |least, strip| {
            least.min(strip.breadth_m).min(strip.top_m - strip.bottom_m)
        })
    }

    /// Frequencies of modes that the wind makes swing, and of the dampers, Hz, ascending; at least one.
    fn peaks_hz(&self, structure: &LinearSystem) -> Result<Vec<f64>, DamperError> {
        let modes = structure.modes()?;
        let omegas = &modes.angular_frequency_rad_s;
        let mut seen = vec![0.0_f64; omegas.len()];
        for columns in self.columns {
            for (j, seen) in seen.iter_mut().enumerate() {
                let shape = modes.shapes.column(j);
                let pushed: Vec<f64> = columns
                    .iter()
                    .map(|column| column.iter().zip(shape).map(|(a, phi)| a * phi).sum())
                    .collect();
                let density = self.face.force_density_n2_hz(omegas[j] / TAU);
                // of its acceleration, ω² of that of its displacement: π S/(2 c) with S two-sided
                *seen =
                    seen.max(density.form(&pushed, &pushed) / modes.damping[(j, j)].max(f64::MIN_POSITIVE));
            }
        }
        let most = seen.iter().copied().fold(0.0, f64::max);
        let kept = omegas
            .iter()
            .zip(&seen)
            .filter(|(_, seen)| **seen > UNSEEN * most);
        let mut all: Vec<f64> = kept.map(|(omega, _)| omega / TAU).collect();
        for damper in self.dampers {
            all.extend(damper.kind.own_frequencies_hz());
        }
        if all.is_empty() {
            all.push(omegas[0] / TAU);
        }
        all.sort_by(f64::total_cmp);
        Ok(all)
    }

    /// What the integral must hold to the tolerance: variance of each degree of freedom, of its acceleration, and of each stroke.
    fn watched(&self, hz: f64) -> Result<Vec<f64>, DamperError> {
        let density = self.face.force_density_n2_hz(hz);
        let quick = (TAU * hz).powi(4);
        let mut all = Vec::new();
        for case in 0..self.columns.len() {
            let transfer = self.transfer(case, hz)?;
            let pushed = loaded(&transfer, &density);
            for i in 0..self.size() {
                let own: f64 = transfer
                    .iter()
                    .zip(&pushed)
                    .map(|(x, y)| (y[i] * x[i].conj()).re)
                    .sum();
                all.push(hz * own);
                if i < self.n {
                    all.push(hz * quick * own);
                }
            }
        }
        Ok(all)
    }

    /// m_0 to m_3, structure and strokes.
    fn moments(&self, case: usize, nodes: &[Node]) -> Result<[Matrix; 4], DamperError> {
        let size = self.size();
        let mut moments = [(); 4].map(|()| Matrix::zeros(size, size));
        for node in nodes {
            let hz = node.x.exp();
            let transfer = self.transfer(case, hz)?;
            let pushed = loaded(&transfer, &self.face.force_density_n2_hz(hz));
            let square = (TAU * hz).powi(2);
            for i in 0..size {
                for j in 0..=i {
                    let own: f64 = transfer
                        .iter()
                        .zip(&pushed)
                        .map(|(x, y)| (y[i] * x[j].conj()).re)
                        .sum();
                    let mut value = node.weight * hz * own;
                    for moment in &mut moments {
                        moment[(i, j)] += value;
                        value *= square;
                    }
                }
            }
        }
        for moment in &mut moments {
            for i in 0..size {
                for j in 0..i {
                    moment[(j, i)] = moment[(i, j)];
                }
            }
        }
        Ok(moments)
    }

    fn answer(
        &self,
        mean: Vec<f64>,
        moments: &[Matrix; 4],
        (duration_s, frequencies): (f64, usize),
    ) -> GustMotion {
        let n = self.n;
        let stretched = |damper: &AttachedDamper| match damper.kind {
            DamperKind::Viscous { .. } => damper.row.iter().zip(&mean).map(|(a, x)| a * x).sum(),
            _ => 0.0,
        };
        let strokes = (n..self.size()).map(|i| {
            let mean = self.dampers.get(i - n).map_or(0.0, stretched);
            GustPeak::of(mean, moments[0][(i, i)], moments[1][(i, i)], duration_s)
        });
        GustMotion {
            strokes: strokes.collect(),
            mean: mean.clone(),
            moments: moments.each_ref().map(|moment| moment.block(0, 0, n, n)),
            duration_s,
            frequencies,
        }
    }
}

/// X S of the motions under each strip and the cross spectra of the strips.
fn loaded(transfer: &[Vec<Complex64>], density: &Matrix) -> Vec<Vec<Complex64>> {
    let size = transfer.first().map_or(0, Vec::len);
    let strips = transfer.len();
    let column = |j: usize| {
        let mut sum = vec![Complex64::ZERO; size];
        for (k, x) in transfer.iter().enumerate() {
            let factor = density[(k, j)];
            sum.iter_mut().zip(x).for_each(|(sum, x)| *sum += factor * x);
        }
        sum
    };
    (0..strips).map(column).collect()
}
