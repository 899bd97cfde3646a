//! Prepares a structure, its random loads and its points at a set of frequencies. The effect of any mass dampers on its floors then takes
//! microseconds, for any number of degrees of freedom.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | ω, w | `omega`, `weight` | nodes of an integral over frequency | nodes |
//! | G_cc | `own` | receptances between u, v, θ of the floors with dampers | c × c |
//! | G_pc | `to_point` | receptances from the floors to the points | p × c |
//! | a_cl | `felt` | −(absolute acceleration) of the floors per unit load: ω² G_cl − e_c | c × l |
//! | G_pl | `free` | motion of the points without dampers per unit load | p × l |

use super::gust_rms::{are_gusts, gust_factor, in_parts};
use super::judged::{Judged, judge};
use super::{AttachedDamper, DamperError, DamperSite, ModalSynthesis, PlacedDamper};
use crate::dynamics::{LinearSystem, RandomInput, RandomLoad};
use crate::numeric::adaptive_nodes;
use dolmen_linalg::Complex64;
use std::f64::consts::{PI, TAU};

/// The design problem: points whose motion is to be reduced, and floors that may carry dampers.
#[derive(Clone, Debug, PartialEq)]
pub struct DamperProblem {
    /// The structure without dampers.
    pub structure: LinearSystem,
    /// Independent random loads on the structure.
    pub loads: Vec<RandomLoad>,
    /// Displacements to be reduced; each is a row over the structure.
    pub points: Vec<Vec<f64>>,
    /// Floors that may carry dampers.
    pub sites: Vec<DamperSite>,
    /// Fixed dampers, which are part of the structure.
    pub fixed: Vec<AttachedDamper>,
}

/// Resolution of the frequencies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanOptions {
    /// Tolerance of the variances without dampers and with expected dampers, by a conservative error estimate; default 1e-4 (our choice).
    /// Standard deviations are then accurate to 1e-5, and mostly to 1e-9. This holds for any damping above `damping_least` and frequencies
    /// within 30 % of the expected ones.
    pub relative_tolerance: f64,
    /// Smallest damping ratio of a damper; default 0.01 (our choice: no real spring stays below it for long). Lighter damping needs more
    /// frequencies.
    pub damping_least: f64,
}

impl Default for PlanOptions {
    fn default() -> Self {
        PlanOptions {
            relative_tolerance: 1e-4,
            damping_least: 0.01,
        }
    }
}

/// The prepared problem.
#[derive(Clone, Debug)]
pub struct Plan {
    problem: DamperProblem,
    pub(super) synthesis: ModalSynthesis,
    in_modes: InModes,
    pub(super) nodes: Vec<Table>,
    without: Vec<f64>,
    damping_least: f64,
    tuning_range_hz: [f64; 2],
}

/// Rows over the structure in modal coordinates.
#[derive(Clone, Debug)]
struct InModes {
    /// u, v, θ of each site.
    places: Vec<Vec<f64>>,
    points: Vec<Vec<f64>>,
    loads: Vec<Vec<f64>>,
}

impl InModes {
    fn of(problem: &DamperProblem, synthesis: &ModalSynthesis) -> Self {
        let unit = |at: usize| {
            let mut row = vec![0.0; problem.structure.degrees_of_freedom()];
            row[at] = 1.0;
            synthesis.in_modes(&row)
        };
        let firsts = problem.sites.iter().map(|site| site.first_degree_of_freedom);
        InModes {
            places: firsts.flat_map(|at| at..at + 3).map(unit).collect(),
            points: problem.points.iter().map(|row| synthesis.in_modes(row)).collect(),
            loads: problem
                .loads
                .iter()
                .map(|load| synthesis.modal_load(&load.input))
                .collect(),
        }
    }
}

/// Receptances at one frequency, each matrix row by row.
#[derive(Clone, Debug)]
pub(super) struct Table {
    pub(super) omega: f64,
    pub(super) densities: Vec<f64>, // 2 w S of each load
    pub(super) own: Vec<Complex64>,
    pub(super) to_point: Vec<Complex64>,
    pub(super) felt: Vec<Complex64>,
    pub(super) moved: Vec<Complex64>, // G_cl
    pub(super) free: Vec<Complex64>,
}

impl Plan {
    /// Prepares a problem. `expected` are dampers similar to those to be judged: the frequencies are chosen so that the variances with these
    /// dampers, and with lighter damping, meet the tolerance.
    ///
    /// # Errors
    /// [`DamperError`] if a row, a site or a load does not fit the structure, or if the tolerance needs too many frequencies.
    pub fn new(
        problem: DamperProblem,
        expected: &[PlacedDamper],
        options: &PlanOptions,
    ) -> Result<Self, DamperError> {
        let n = problem.structure.degrees_of_freedom();
        for site in &problem.sites {
            site.check(n)?;
        }
        if problem.points.is_empty() {
            return Err(DamperError::NoPoints);
        }
        let without = judge(
            &problem.structure,
            &problem.loads,
            &problem.points,
            &problem.fixed,
        )?
        .point_rms;
        if let Some(point) = without.iter().position(|rms| rms.is_nan() || *rms <= 0.0) {
            return Err(DamperError::Still { point: point + 1 });
        }
        let synthesis = ModalSynthesis::new(&problem.structure, n)?.with_fixed(&problem.fixed)?;
        let mut plan = Plan {
            in_modes: InModes::of(&problem, &synthesis),
            problem,
            synthesis,
            nodes: Vec::new(),
            without,
            damping_least: options.damping_least,
            tuning_range_hz: [0.0, f64::INFINITY],
        };
        plan.choose_frequencies(expected, options)?;
        Ok(plan)
    }

    /// The same problem with another site only, prepared for dampers there. The modes are those of this plan.
    ///
    /// # Errors
    /// As in [`Plan::new`].
    pub(super) fn on_site(
        &self,
        site: DamperSite,
        expected: &[PlacedDamper],
        options: &PlanOptions,
    ) -> Result<Self, DamperError> {
        site.check(self.problem.structure.degrees_of_freedom())?;
        let problem = DamperProblem {
            sites: vec![site],
            ..self.problem.clone()
        };
        let mut plan = Plan {
            in_modes: InModes::of(&problem, &self.synthesis),
            problem,
            synthesis: self.synthesis.clone(),
            nodes: Vec::new(),
            without: self.without.clone(),
            ..*self
        };
        plan.choose_frequencies(expected, options)?;
        Ok(plan)
    }

    /// The problem as given.
    pub fn problem(&self) -> &DamperProblem {
        &self.problem
    }

    /// Standard deviations of the points with the fixed dampers only.
    pub fn without(&self) -> &[f64] {
        &self.without
    }

    pub(super) fn damping_least(&self) -> f64 {
        self.damping_least
    }

    /// Range of damper frequencies, Hz: from half the lowest to 1.5 times the highest mode that has at least 1 % of the variance of some point.
    pub fn tuning_range_hz(&self) -> [f64; 2] {
        self.tuning_range_hz
    }

    /// Number of frequencies of the integrals.
    pub fn frequencies(&self) -> usize {
        self.nodes.len()
    }

    /// Modal mass of a mode (index from 0), kg, with its shape scaled to 1 at a place along a direction. For modes with a common frequency, this
    /// is the smallest modal mass over all their combinations, 1/Σ b².
    ///
    /// # Errors
    /// [`DamperError::ModeStill`] if the mode does not move that place in that direction.
    pub fn modal_mass_kg(&self, mode: usize, damper: &PlacedDamper) -> Result<f64, DamperError> {
        if mode >= self.synthesis.omega_rad_s().len() {
            return Err(DamperError::Argument {
                argument: "mode",
                given: mode as f64 + 1.0,
                allowed: "one of the modes of the structure",
            });
        }
        let row = damper
            .attached(&self.problem.sites, self.problem.structure.degrees_of_freedom())?
            .row;
        let shape = self.synthesis.shapes().column(mode);
        // modes with a common frequency all take part, in the combination that moves the place most
        let near = |j: &usize| {
            (self.synthesis.omega_rad_s()[*j] / self.synthesis.omega_rad_s()[mode] - 1.0).abs()
                < ONE_FREQUENCY
        };
        let together = (0..self.synthesis.omega_rad_s().len()).filter(near);
        let moves = together
            .map(|j| {
                row.iter()
                    .zip(self.synthesis.shapes().column(j))
                    .map(|(a, p)| a * p)
                    .sum::<f64>()
            })
            .fold(0.0, f64::hypot);
        let site = &self.problem.sites[damper.site];
        let local: Vec<f64> = shape[site.first_degree_of_freedom..][..3].to_vec();
        // the floor's largest motion is at a corner; it is the scale for the motion of a still place
        let corners = site.corners_m.iter().flat_map(|corner| {
            [0.0, 90.0].map(|degrees| {
                let a = site.coefficients(*corner, degrees);
                (0..3).map(|i| a[i] * local[i]).sum::<f64>().abs()
            })
        });
        let most = corners.fold(0.0, f64::max);
        if moves.abs() <= STILL * most || moves == 0.0 {
            let only = match (local[0].abs() > STILL * most, local[1].abs() > STILL * most) {
                (true, false) if local[2].abs() * extent(site) <= STILL * most => "it moves only in x here",
                (false, true) if local[2].abs() * extent(site) <= STILL * most => "it moves only in y here",
                _ => "its centre lies here",
            };
            return Err(DamperError::ModeStill {
                mode: mode + 1,
                x_m: damper.place_m[0],
                y_m: damper.place_m[1],
                direction_degrees: damper.direction_degrees,
                only,
            });
        }
        Ok(1.0 / (moves * moves))
    }

    /// Frequency of a mode (index from 0), Hz.
    pub fn mode_frequency_hz(&self, mode: usize) -> Option<f64> {
        self.synthesis.omega_rad_s().get(mode).map(|omega| omega / TAU)
    }

    /// Standard deviations of the points with dampers, from the assembled matrices: by Lyapunov's equation, or by integration over frequency if
    /// a load is a table.
    ///
    /// # Errors
    /// [`DamperError`] if a damper is out of its range.
    pub fn exact(&self, dampers: &[PlacedDamper]) -> Result<Judged, DamperError> {
        let structure = &self.problem.structure;
        let n = structure.degrees_of_freedom();
        let attached: Vec<AttachedDamper> = dampers
            .iter()
            .map(|damper| damper.attached(&self.problem.sites, n))
            .collect::<Result<_, _>>()?;
        let all: Vec<AttachedDamper> = attached.iter().chain(&self.problem.fixed).cloned().collect();
        let mut judged = judge(structure, &self.problem.loads, &self.problem.points, &all)?;
        judged.stroke_rms_m.truncate(dampers.len());
        Ok(judged)
    }

    /// Standard deviations of the points and strokes of the dampers, from the prepared frequencies.
    ///
    /// # Errors
    /// [`DamperError`] if a damper is out of its range.
    pub fn judge(&self, dampers: &[PlacedDamper]) -> Result<Judged, DamperError> {
        let n = self.problem.structure.degrees_of_freedom();
        for damper in dampers {
            damper.attached(&self.problem.sites, n)?.kind.check()?;
        }
        Ok(self.at_nodes(dampers))
    }

    pub(super) fn coordinates(&self) -> usize {
        3 * self.problem.sites.len()
    }

    pub(super) fn table(&self, omega: f64, weight: f64) -> Result<Table, DamperError> {
        let problem = &self.problem;
        let c = self.coordinates();
        let InModes {
            places,
            points,
            loads: loaded,
        } = &self.in_modes;
        let along =
            |row: &[f64], eta: &[Complex64]| -> Complex64 { row.iter().zip(eta).map(|(a, x)| x * *a).sum() };
        let mut own = vec![Complex64::ZERO; c * c];
        let mut to_point = vec![Complex64::ZERO; points.len() * c];
        for (j, place) in places.iter().enumerate() {
            let eta = self.synthesis.receptance(omega, place)?;
            for (i, other) in places.iter().enumerate() {
                own[i * c + j] = along(other, &eta);
            }
            for (p, point) in points.iter().enumerate() {
                to_point[p * c + j] = along(point, &eta);
            }
        }
        let loads = problem.loads.len();
        let mut felt = vec![Complex64::ZERO; c * loads];
        let mut moved = felt.clone();
        let mut free = vec![Complex64::ZERO; points.len() * loads];
        for (l, (load, modal)) in problem.loads.iter().zip(loaded).enumerate() {
            let eta = self.synthesis.loaded_by(omega, &load.input, modal)?;
            for (k, place) in places.iter().enumerate() {
                let base = match &load.input {
                    RandomInput::Force(_) => 0.0,
                    RandomInput::Base(e) => e[problem.sites[k / 3].first_degree_of_freedom + k % 3],
                };
                moved[k * loads + l] = along(place, &eta);
                felt[k * loads + l] = omega * omega * moved[k * loads + l] - base;
            }
            for (p, point) in points.iter().enumerate() {
                free[p * loads + l] = along(point, &eta);
            }
        }
        if are_gusts(&problem.loads) {
            let factor = gust_factor(&problem.loads, omega)?;
            return Ok(Table {
                omega,
                densities: vec![2.0 * weight; loads],
                own,
                to_point,
                felt: in_parts(&felt, &factor),
                moved: in_parts(&moved, &factor),
                free: in_parts(&free, &factor),
            });
        }
        Ok(Table {
            omega,
            densities: problem
                .loads
                .iter()
                .map(|load| 2.0 * weight * load.spectrum.density(omega))
                .collect(),
            own,
            to_point,
            felt,
            moved,
            free,
        })
    }

    /// Whether each mode has more than this fraction of the variance of some point, so that the integral must resolve its peak.
    fn modes_seen(&self, part: f64) -> Vec<bool> {
        let damping = self.synthesis.damping();
        let mut seen = vec![false; self.synthesis.omega_rad_s().len()];
        for load in &self.problem.loads {
            let pushed = self.synthesis.modal_load(&load.input);
            for (row, rms) in self.problem.points.iter().zip(&self.without) {
                let moved = self.synthesis.in_modes(row);
                for (j, seen) in seen.iter_mut().enumerate() {
                    let omega = self.synthesis.omega_rad_s()[j];
                    // π S φ² q²/(ζ ω³) on both sides of 0, with c = 2 ζ ω
                    let variance = 2.0 * PI * load.spectrum.density(omega) * (moved[j] * pushed[j]).powi(2)
                        / (damping[(j, j)] * omega * omega);
                    *seen |= variance.is_nan() || variance > part * rms * rms;
                }
            }
        }
        seen
    }

    fn choose_frequencies(
        &mut self,
        expected: &[PlacedDamper],
        options: &PlanOptions,
    ) -> Result<(), DamperError> {
        const INTERVALS_MOST: usize = 4000;
        let excited: Vec<f64> = self
            .modes_seen(EXCITED)
            .into_iter()
            .zip(self.synthesis.omega_rad_s())
            .filter(|(seen, _)| *seen)
            .map(|(_, omega)| omega / TAU)
            .collect();
        let lowest = excited.iter().copied().fold(f64::INFINITY, f64::min);
        let highest = excited.iter().copied().fold(0.0, f64::max);
        self.tuning_range_hz = match excited.is_empty() {
            true => [0.0, f64::INFINITY],
            false => [RANGE[0] * lowest, RANGE[1] * highest],
        };
        let points = self.problem.points.len();
        let trials = trial_dampers(expected, &excited, options.damping_least);
        let mut breaks = vec![0.0];
        let given = expected.iter().map(|damper| damper.frequency_hz);
        let highest_hz = given.chain(excited).fold(0.0, f64::max);
        let seen = self.modes_seen(SEEN * options.relative_tolerance);
        for (omega, seen) in self.synthesis.omega_rad_s().iter().zip(seen) {
            if seen || *omega < 3.0 * TAU * highest_hz {
                breaks.push(*omega);
            }
        }
        breaks.extend(
            self.problem
                .loads
                .iter()
                .flat_map(|load| load.spectrum.breaks_rad_s()),
        );
        breaks.sort_by(f64::total_cmp);
        let top = 3.0 * breaks.last().copied().unwrap_or(1.0);
        breaks.push(top);
        let fault = std::cell::RefCell::new(None);
        let value = |omega: f64, weight: f64| -> Option<Vec<f64>> {
            match self.table(omega, weight) {
                Ok(table) => Some(
                    trials
                        .iter()
                        .flat_map(|dampers| {
                            self.at_node(&table, &self.damper_rows(dampers))
                                .into_iter()
                                .take(points)
                        })
                        .collect(),
                ),
                Err(stopped) => {
                    *fault.borrow_mut() = Some(stopped);
                    None
                }
            }
        };
        let mut chosen = Vec::new();
        for (range, inverse) in [(breaks, false), (vec![0.0, 1.0 / top], true)] {
            let at = |x: f64| match inverse {
                false => value(x, 1.0),
                true => value(1.0 / x, 1.0 / (x * x)),
            };
            let nodes = adaptive_nodes(&range, options.relative_tolerance, INTERVALS_MOST, at);
            let nodes = nodes.ok_or_else(|| {
                fault
                    .borrow_mut()
                    .take()
                    .unwrap_or(DamperError::TooManyFrequencies {
                        intervals: INTERVALS_MOST,
                    })
            })?;
            for node in nodes {
                chosen.push(match inverse {
                    false => self.table(node.x, node.weight)?,
                    true => self.table(1.0 / node.x, node.weight / (node.x * node.x))?,
                });
            }
        }
        chosen.sort_by(|a, b| a.omega.total_cmp(&b.omega));
        self.nodes = chosen;
        Ok(())
    }
}

/// Dampers for which the integrands must be resolved: none, each alone tuned to every frequency of the building, and each at and near its
/// expected tuning.
fn trial_dampers(
    expected: &[PlacedDamper],
    excited_hz: &[f64],
    damping_least: f64,
) -> Vec<Vec<PlacedDamper>> {
    let mut trials: Vec<Vec<PlacedDamper>> = vec![Vec::new()];
    for damper in expected {
        // the damper may be far out of tune, or tuned to any of these frequencies
        for &frequency_hz in excited_hz {
            trials.push(vec![PlacedDamper {
                frequency_hz,
                ..*damper
            }]);
        }
        trials.push(vec![*damper]);
        for factor in [0.8, 1.0, 1.2] {
            trials.push(vec![PlacedDamper {
                damping_ratio: damping_least,
                frequency_hz: factor * damper.frequency_hz,
                ..*damper
            }]);
        }
    }
    trials
}

/// The integral does not resolve the peak of a mode with less than this fraction of the tolerance in every variance. Our choice.
const SEEN: f64 = 1e-3;
/// A damper may be tuned to any mode with this fraction of the variance of some point. The frequency range is `RANGE[0]` times the lowest to
/// `RANGE[1]` times the highest of these modes. Our choice.
const EXCITED: f64 = 0.01;
const RANGE: [f64; 2] = [0.5, 1.5];
/// Modes with frequencies closer than this (relative) have a common frequency: any combination of their shapes is a mode.
const ONE_FREQUENCY: f64 = 1e-6;
/// A place that moves less than this fraction of the floor's largest motion is still.
const STILL: f64 = 1e-6;

fn extent(site: &DamperSite) -> f64 {
    let [x, y] = site.extent_m();
    (x[1] - x[0]).max(y[1] - y[0])
}
